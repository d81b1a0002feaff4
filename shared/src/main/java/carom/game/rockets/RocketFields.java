package carom.game.rockets;

import static carom.sim.event.Audience.ALL;
import static carom.sim.event.Audience.NOBODY;
import static carom.sim.event.Audience.OWNER;
import static carom.sim.field.Scope.ACCOUNT;
import static carom.sim.field.Scope.ENTITY;
import static carom.sim.field.Scope.MATCH;

import carom.sim.field.Choice;
import carom.sim.field.Count;
import carom.sim.field.Countdown;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.PlayerRef;
import java.util.List;

/** The state of the rockets: what is saved, hashed and sent. */
public final class RocketFields {
  /** Health that a player has left. */
  public static final Count HEALTH = Field.count("health", 0, 100).to(ALL).startsAt(100);

  /** Weapon that a player holds. */
  public static final Choice<Weapon> WEAPON = Field.choice("weapon", Weapon.class);

  /** Shots left; 0 of what is endless. */
  public static final Count AMMO = Field.count("ammo", 0, 99);

  /** Flag of a player who holds the shield up. */
  public static final Flag SHIELDED = Field.flag("shielded");

  /** Ticks until the shield is full again; while it is held up, it empties. */
  public static final Countdown SPENT = Field.countdown("spent");

  /** Ticks until a player who is out is back. */
  public static final Countdown OUT = Field.countdown("out").to(OWNER);

  /** Matches that an account has won. */
  public static final Count WINS = Field.count("wins").of(ACCOUNT).to(ALL);

  // Of a player. Input writes them, so that clients predict shots.
  static final Countdown RELOAD = Field.countdown("reload");
  static final Flag SETS_OFF = Field.flag("setsOff"); // wants its shots to go off

  // Of a player who took a repair kit: rules say so, the server repairs.
  static final Flag REPAIRS = Field.flag("repairs");

  // Of a player who has no health left, the server's: it goes after the tick.
  static final PlayerRef WRECKED_BY = Field.player("wreckedBy").to(NOBODY);
  static final Choice<Weapon> WRECKED_WITH = Field.choice("wreckedWith", Weapon.class).to(NOBODY);

  // Of a shot.
  static final Choice<Weapon> FIRED_BY = Field.choice("firedBy", Weapon.class).of(ENTITY);
  static final Countdown FUEL = Field.countdown("fuel").of(ENTITY);

  // Of a rock, the damage that breaks it; of a pick-up, how long it lies there.
  static final Count STRENGTH = Field.count("strength", 0, 255).of(ENTITY).to(NOBODY);
  static final Countdown FADES = Field.countdown("fades").of(ENTITY).to(NOBODY);

  // Until another rock comes in.
  static final Countdown NEXT_ROCK = Field.countdown("nextRock").of(MATCH).to(NOBODY);

  private RocketFields() {}

  /** Returns all of them. */
  static List<Field<?>> all() {
    return List.of(
        RELOAD,
        SETS_OFF,
        HEALTH,
        OUT,
        WINS,
        FUEL,
        WEAPON,
        AMMO,
        SHIELDED,
        SPENT,
        REPAIRS,
        WRECKED_BY,
        WRECKED_WITH,
        FIRED_BY,
        STRENGTH,
        FADES,
        NEXT_ROCK);
  }
}
