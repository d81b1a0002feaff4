package carom.net.snapshot.frame;

import carom.net.codec.Quantizer;

/**
 * An event as it is sent. Mutable, reused; the numbers mean what {@code carom.sim.outbox.Event}
 * says.
 */
public final class EventRecord {
  /** Stands for no player or no entity. */
  public static final int NONE = -1;

  /** Number of a float's lowest bits that aren't sent. */
  static final int STRENGTH_SHIFT = 16;

  /** Kind of the event, 0..255. */
  public int kind;

  /** Tick in which the event happens; not negative. */
  public int tick;

  /** Player who caused the event, 0..1,023, or {@link #NONE}. */
  public int player;

  /** Entity that the event happens to: id, and generation above 16 bits; or {@link #NONE}. */
  public int first;

  /** Other entity that takes part, in the form of {@link #first}. */
  public int second;

  /** Position in {@link Quantizer#POSITION_STEPS} per metre. */
  public int x;

  /** Position in {@link Quantizer#POSITION_STEPS} per metre. */
  public int y;

  /** Strength as the highest 16 bits of a finite float. */
  public int strength;

  /** Number whose meaning depends on the kind. */
  public int data;

  /** Creates an empty record. */
  public EventRecord() {}

  /** Sets the position, metres. */
  public void place(float metresX, float metresY) {
    x = Quantizer.position(metresX);
    y = Quantizer.position(metresY);
  }

  /** Sets the strength, rounded towards zero to eight significant bits; not finite becomes 0. */
  public void strength(float value) {
    strength = Float.isFinite(value) ? Float.floatToRawIntBits(value) >>> STRENGTH_SHIFT : 0;
  }

  /** Returns the strength. */
  public float strengthOf() {
    return Float.intBitsToFloat(strength << STRENGTH_SHIFT);
  }

  /** Copies another record into this one. */
  public void set(EventRecord other) {
    kind = other.kind;
    tick = other.tick;
    player = other.player;
    first = other.first;
    second = other.second;
    x = other.x;
    y = other.y;
    strength = other.strength;
    data = other.data;
  }
}
