package carom.game.shooter;

import static carom.sim.event.Audience.ALL;
import static carom.sim.event.Audience.NOBODY;
import static carom.sim.event.Audience.OWNER;
import static carom.sim.field.Scope.ACCOUNT;
import static carom.sim.field.Scope.ENTITY;
import static carom.sim.field.Scope.MATCH;

import carom.sim.field.Choice;
import carom.sim.field.Count;
import carom.sim.field.Countdown;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.PlayerRef;
import carom.sim.field.Ratio;
import java.util.List;

/** The state of the shooter: what is saved, hashed and sent. */
public final class ShooterFields {
  /** Most pick-ups of a level. */
  static final int MAX_PICKUPS = 24;

  /**
   * Damage that a player has taken; the more, the further blows throw it, and at most it is out.
   */
  public static final Count DAMAGE = Field.count("damage", 0, 100).to(ALL);

  /** Lives that a player has left, with the present one. */
  public static final Count LIVES =
      Field.count("lives", 0, ShooterGame.LIVES).to(ALL).startsAt(ShooterGame.LIVES);

  /** Ticks for which nothing harms a player who has come back. */
  public static final Countdown SAFE = Field.countdown("safe").to(ALL);

  /** Weapon that a player holds. */
  public static final Choice<Weapon> WEAPON = Field.choice("weapon", Weapon.class);

  /** Shots left; 0 of what is endless. */
  public static final Count AMMO = Field.count("ammo", 0, 99);

  /** Ticks until a player who is out is back. */
  public static final Countdown OUT = Field.countdown("out").to(OWNER);

  /** Flag of the last seconds of a match. Triggers of levels say what they bring. */
  public static final Flag SUDDEN = Field.flag("sudden").of(MATCH).to(ALL);

  /** Strength left of a body of the level that breaks; 0 of what doesn't. */
  public static final Ratio COVER = Field.ratio("cover", 100).of(ENTITY);

  /** Matches that an account has won. */
  public static final Count WINS = Field.count("wins").of(ACCOUNT).to(ALL);

  // Of a player. Input writes them, so that clients predict jumps and shots.
  static final Countdown GROUNDED = Field.countdown("grounded"); // also shortly after an edge
  static final Countdown WANTS_JUMP = Field.countdown("wantsJump"); // also before landing
  static final Flag AIR_JUMP = Field.flag("airJump"); // the second jump is left
  static final Flag JUMPING = Field.flag("jumping");
  static final Countdown DROPS = Field.countdown("drops"); // one-way platforms don't hold
  static final Countdown RELOAD = Field.countdown("reload");

  // Of a player who took a medkit: rules say so, the server heals.
  static final Flag HEALS = Field.flag("heals");

  // Of a player, the server's: the one that a fall is put down to, and what is left of it.
  static final PlayerRef HIT_BY = Field.player("hitBy").to(NOBODY);
  static final Countdown BLAMED = Field.countdown("blamed").to(NOBODY);
  static final EntityRef RAGDOLL = Field.entity("ragdoll").to(NOBODY);
  static final Countdown FADES = Field.countdown("fades").to(NOBODY);

  // Of cover.
  static final Flag BROKEN = Field.flag("broken").of(ENTITY).to(NOBODY); // goes after the tick

  // Of a shot.
  static final Choice<Weapon> FIRED_BY = Field.choice("firedBy", Weapon.class).of(ENTITY);
  static final Countdown FUEL = Field.countdown("fuel").of(ENTITY);

  // Of a pick-up, and of the places where they are.
  static final Count PLACE = Field.count("place", 0, MAX_PICKUPS - 1).of(ENTITY);
  static final EntityRef PICKUP = Field.entity("pickup").of(MATCH).to(NOBODY).times(MAX_PICKUPS);
  static final Countdown PICKUP_WAIT =
      Field.countdown("pickupWait").of(MATCH).to(ALL).times(MAX_PICKUPS);

  private ShooterFields() {}

  /** Returns all of them. */
  static List<Field<?>> all() {
    return List.of(
        DAMAGE,
        LIVES,
        SAFE,
        WEAPON,
        AMMO,
        OUT,
        WINS,
        SUDDEN,
        COVER,
        GROUNDED,
        WANTS_JUMP,
        AIR_JUMP,
        JUMPING,
        DROPS,
        RELOAD,
        HEALS,
        HIT_BY,
        BLAMED,
        RAGDOLL,
        FADES,
        BROKEN,
        FIRED_BY,
        FUEL,
        PLACE,
        PICKUP,
        PICKUP_WAIT);
  }
}
