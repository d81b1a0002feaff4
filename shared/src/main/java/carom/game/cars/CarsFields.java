package carom.game.cars;

import static carom.sim.event.Audience.ALL;
import static carom.sim.event.Audience.NOBODY;
import static carom.sim.field.Scope.ENTITY;
import static carom.sim.field.Scope.MATCH;

import carom.sim.field.Count;
import carom.sim.field.Countdown;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.Ratio;
import java.util.List;

/** The state of the race: what is saved, hashed and sent. */
public final class CarsFields {
  /** Most gates of a level, and most rings. */
  static final int MAX_MARKS = 60;

  /** Most bridges of a level. */
  static final int MAX_BRIDGES = 8;

  /** Most crates of a level. */
  static final int MAX_CRATES = 32;

  /** Nitro that a car has left, 0..1. */
  public static final Ratio NITRO = Field.ratio("nitro", 200).startsAt(0.5f);

  /** Flag of a car that burns nitro. */
  public static final Flag BOOSTS = Field.flag("boosts");

  /** Lap that a car drives, from 1 on; one more than there are once it has finished. */
  public static final Count LAP = Field.count("lap", 1, CarsGame.LAPS + 1).to(ALL).startsAt(1);

  /** Number of gates that a car has passed in this lap. */
  public static final Count GATE = Field.count("gate", 0, MAX_MARKS).to(ALL);

  /** Place of a car in the race, 1 for the first. */
  public static final Count PLACE = Field.count("place", 1, 1024).to(ALL).startsAt(1);

  /** Ticks for which a car that was towed has to wait. */
  public static final Countdown HELD = Field.countdown("held");

  // Of a player. Input writes them, so that clients predict all that a car does.
  static final Count RING = Field.count("ring", 0, MAX_MARKS); // the next one that counts
  static final Flag OVER = Field.flag("over"); // the top of a loop
  static final Countdown HELP = Field.countdown("help"); // until a car is towed
  static final Countdown SKY = Field.countdown("sky"); // runs while it flies; 0 on the ground
  static final Count QUARTER = Field.count("quarter", 0, 3); // of a turn, in which it is
  static final Count TURNED = Field.count("turned", -80, 80).startsAt(0); // quarters in this flight

  // Of a bridge.
  static final EntityRef BRIDGE = Field.entity("bridge").of(MATCH).to(NOBODY).times(MAX_BRIDGES);
  static final Flag BROKEN = Field.flag("broken").of(MATCH).to(NOBODY).times(MAX_BRIDGES);
  static final Countdown MENDS = Field.countdown("mends").of(MATCH).to(NOBODY).times(MAX_BRIDGES);

  // Of crates, and of the places where they are. Rules say when one breaks.
  static final Count PLACE_OF = Field.count("placeOf", 0, MAX_CRATES - 1).of(ENTITY);
  static final EntityRef CRATE = Field.entity("crate").of(MATCH).to(NOBODY).times(MAX_CRATES);
  static final Countdown CRATE_WAIT =
      Field.countdown("crateWait").of(MATCH).to(ALL).times(MAX_CRATES);

  private CarsFields() {}

  /** Returns all of them. */
  static List<Field<?>> all() {
    return List.of(
        NITRO,
        BOOSTS,
        LAP,
        GATE,
        PLACE,
        RING,
        OVER,
        HELD,
        HELP,
        SKY,
        QUARTER,
        TURNED,
        BRIDGE,
        BROKEN,
        MENDS,
        PLACE_OF,
        CRATE,
        CRATE_WAIT);
  }
}
