package carom.net.snapshot.event;

import carom.net.codec.Quantizer;

/**
 * An event as the wire tells it. Mutable, used again; the numbers mean what {@code carom.sim.Event}
 * says.
 */
public final class EventRecord {
  /** No player, no entity. */
  public static final int NONE = -1;

  /** Lowest bits of a float that aren't sent. */
  static final int STRENGTH_SHIFT = 16;

  /** What happens: 0..255. */
  public int kind;

  /** The tick in which it happens; not negative. */
  public int tick;

  /** Whose doing it is: 0..1,023 or {@link #NONE}. */
  public int player;

  /** Whom it happens to: id, and generation above 16 bits; or {@link #NONE}. */
  public int first;

  /** Who else takes part; as {@link #first}. */
  public int second;

  /** Position in {@link Quantizer#POSITION_STEPS} per metre. */
  public int x;

  /** Position in {@link Quantizer#POSITION_STEPS} per metre. */
  public int y;

  /** The highest 16 bits of a finite float. */
  public int strength;

  /** Any number. */
  public int data;

  /** Creates an empty one. */
  public EventRecord() {}

  /** Sets the place, metres. */
  public void place(float metresX, float metresY) {
    x = Quantizer.position(metresX);
    y = Quantizer.position(metresY);
  }

  /** Sets how hard; towards zero, eight significant bits. What isn't finite becomes 0. */
  public void strength(float value) {
    strength = Float.isFinite(value) ? Float.floatToRawIntBits(value) >>> STRENGTH_SHIFT : 0;
  }

  /** How hard. */
  public float strengthOf() {
    return Float.intBitsToFloat(strength << STRENGTH_SHIFT);
  }

  /** Copies another one. */
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
