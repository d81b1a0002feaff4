package carom.sim.event;

import carom.sim.Event;
import carom.sim.Game;

/**
 * A kind of {@link Event}, such as a hit or a goal, registered in {@link Game#setUp} with {@link
 * EventKinds#add}. What it says is for eye and ear and never matters to the simulation.
 */
public final class EventKind {
  private final int index;
  private final String name;
  private final int rgb;
  private final float radius;
  private final String label;
  private final Sound sound;
  private final float fullStrength;

  EventKind(
      int index,
      String name,
      int rgb,
      float radius,
      String label,
      Sound sound,
      float fullStrength) {
    this.index = index;
    this.name = name;
    this.rgb = rgb;
    this.radius = radius;
    this.label = label;
    this.sound = sound;
    this.fullStrength = fullStrength;
  }

  /** The place in {@link EventKinds}, 0..255; what the wire carries. */
  public int index() {
    return index;
  }

  /** What the game calls it. */
  public String name() {
    return name;
  }

  /** Colour of the flash, 0xrrggbb. */
  public int rgb() {
    return rgb;
  }

  /** Radius of the flash, metres; 0 = none. */
  public float radius() {
    return radius;
  }

  /** Short text that rises from the place, such as "+1"; empty = none. */
  public String label() {
    return label;
  }

  /** What it sounds like. */
  public Sound sound() {
    return sound;
  }

  /** {@link Event#strength} from which on it is as loud as can be; 0 = it always is. */
  public float fullStrength() {
    return fullStrength;
  }

  @Override
  public String toString() {
    return name;
  }
}
