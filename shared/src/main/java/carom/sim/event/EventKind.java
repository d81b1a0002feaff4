package carom.sim.event;

/**
 * A kind of {@code Event}, such as a hit or a goal, registered in {@code Game.setUp} with {@link
 * EventKinds#add}. It says how the event looks and sounds, and never matters to the simulation.
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

  /** Returns the index in {@link EventKinds}, 0..255, which the wire carries. */
  public int index() {
    return index;
  }

  /** Returns the name, for logs and tests. */
  public String name() {
    return name;
  }

  /** Returns the colour of the flash, 0xrrggbb. */
  public int rgb() {
    return rgb;
  }

  /** Returns the radius of the flash in metres, or 0 for no flash. */
  public float radius() {
    return radius;
  }

  /** Returns a short text that rises from the place, such as "+1", or an empty one. */
  public String label() {
    return label;
  }

  /** Returns the sound. */
  public Sound sound() {
    return sound;
  }

  /**
   * Returns the {@code Event.strength} from which on the sound is loudest, or 0 if it always is.
   */
  public float fullStrength() {
    return fullStrength;
  }

  @Override
  public String toString() {
    return name;
  }
}
