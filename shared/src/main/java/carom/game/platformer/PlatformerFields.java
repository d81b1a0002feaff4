package carom.game.platformer;

import static carom.sim.event.Audience.ALL;
import static carom.sim.event.Audience.NOBODY;
import static carom.sim.event.Audience.OWNER;
import static carom.sim.field.Scope.ACCOUNT;
import static carom.sim.field.Scope.MATCH;

import carom.sim.field.Count;
import carom.sim.field.Countdown;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.Real;
import java.util.List;

/** The state of the platformer: what is saved, hashed and sent. */
final class PlatformerFields {
  /** Most coins of a level. */
  static final int MAX_COINS = 1_024;

  // Of a player. Input writes them, so that clients predict jumps.
  static final Count CAN_JUMP = Field.count("canJump", 0, 1_000); // ticks after an edge
  static final Countdown WANTS_JUMP = Field.countdown("wantsJump"); // also before landing
  static final Countdown DROPS = Field.countdown("drops"); // one-way platforms don't hold
  static final Flag JUMPING = Field.flag("jumping");

  // Of a player without a body: when and at which spawn it comes back.
  static final Countdown RESPAWN = Field.countdown("respawn").to(OWNER);
  static final Count RESPAWN_PLACE = Field.count("respawnPlace", 0, 65_535).to(NOBODY);

  // Of a player who has passed a checkpoint: its place, to which the player comes back.
  static final Flag CHECKED = Field.flag("checked").to(NOBODY);
  static final Real CHECK_X = Field.real("checkX").to(NOBODY);
  static final Real CHECK_Y = Field.real("checkY").to(NOBODY);

  // Of an account.
  static final Count WINS = Field.count("wins").of(ACCOUNT).to(ALL);
  static final Count BEST_MS =
      Field.count("bestMs", 0, 3_600_000).of(ACCOUNT).to(ALL).lowestIsBest();

  // Of the match.
  static final EntityRef FLAG = Field.entity("flag").of(MATCH).to(ALL);
  static final Count FLAG_PLACE = Field.count("flagPlace", 0, 65_535).of(MATCH).to(NOBODY);
  static final Countdown FLAG_WAIT = Field.countdown("flagWait").of(MATCH).to(ALL);
  static final EntityRef COIN = Field.entity("coin").of(MATCH).to(NOBODY).times(MAX_COINS);
  static final Countdown COIN_WAIT =
      Field.countdown("coinWait").of(MATCH).to(NOBODY).times(MAX_COINS);

  private PlatformerFields() {}

  /** Returns all of them. */
  static List<Field<?>> all() {
    return List.of(
        CAN_JUMP,
        WANTS_JUMP,
        DROPS,
        JUMPING,
        RESPAWN,
        RESPAWN_PLACE,
        CHECKED,
        CHECK_X,
        CHECK_Y,
        WINS,
        BEST_MS,
        FLAG,
        FLAG_PLACE,
        FLAG_WAIT,
        COIN,
        COIN_WAIT);
  }
}
