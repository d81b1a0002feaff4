package carom.plain;

/** A kind of events. */
public final class EventLook {
  /** Name. */
  public String name;

  /** Colour, 0xRRGGBB. */
  public int rgb;

  /** Radius of the picture, metres. */
  public float radius;

  /** Text of the picture. */
  public String label;

  /** Name of the sound. */
  public String sound;

  /** Strength of the loudest. */
  public float fullStrength;

  /** Creates one to be filled in. */
  public EventLook() {}
}
