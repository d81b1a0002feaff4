package carom.sim.field;

/**
 * A field for a time in ticks that runs down by itself, see {@link Field#countdown}. It is stored
 * as the tick at which it is over, so both sides count alike and a running time costs nothing.
 */
public final class Countdown extends IntField<Countdown> {
  Countdown(Spec spec) {
    super(spec);
  }

  /**
   * Returns a time in ticks, rounded, and at least 1.
   *
   * @param tickRate ticks per second
   */
  public static int ticks(float seconds, int tickRate) {
    return Math.max(1, Math.round(seconds * tickRate));
  }

  @Override
  boolean lasts() {
    return false;
  }

  @Override
  Countdown with(Spec changed) {
    return new Countdown(changed);
  }

  @Override
  int decode(int word, int tick) {
    return Math.max(0, word - tick);
  }

  @Override
  int encode(int value, int tick) {
    if (value < 0 || value > Integer.MAX_VALUE - tick) {
      throw outside(value, " ticks of 0.." + (Integer.MAX_VALUE - tick));
    }
    return value == 0 ? 0 : tick + value;
  }

  @Override
  int clamp(long value) {
    return (int) Math.max(0, Math.min(Integer.MAX_VALUE / 2, value));
  }

  @Override
  public String show(int word) {
    return word == 0 ? "over" : "until tick " + word;
  }
}
