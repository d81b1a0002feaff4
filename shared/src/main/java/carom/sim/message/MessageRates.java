package carom.sim.message;

import java.util.Arrays;

/**
 * Bounds how many messages of each kind one client sends: each kind's rate in the long run, and a
 * second's worth at once, at least four. Both ends use it. The server is a little more generous, so
 * that a client that keeps to its own bound loses nothing to a network that delivers in bursts.
 */
public final class MessageRates {
  private static final float LEAST_BURST = 4;
  private static final float SERVER_BURST = 2;

  private final MessageKinds kinds;
  private final float burst;
  private final float[] credit;
  private final double[] since;

  private MessageRates(MessageKinds kinds, float burst) {
    this.kinds = kinds;
    this.burst = burst;
    credit = new float[kinds.size()];
    since = new double[kinds.size()];
    Arrays.fill(credit, Float.MAX_VALUE);
  }

  /** Returns the bounds that a client keeps to. */
  public static MessageRates ofClient(MessageKinds kinds) {
    return new MessageRates(kinds, 1);
  }

  /** Returns the bounds that a server holds a client to. */
  public static MessageRates ofServer(MessageKinds kinds) {
    return new MessageRates(kinds, SERVER_BURST);
  }

  /**
   * Returns whether a message may go now, and counts it if so.
   *
   * @param seconds the present, by any clock that never goes back
   */
  public boolean take(MessageKind kind, double seconds) {
    int i = kinds.indexOf(kind);
    float most = burst * Math.max(LEAST_BURST, kind.perSecond());
    credit[i] = (float) Math.min(most, credit[i] + (seconds - since[i]) * kind.perSecond());
    since[i] = seconds;
    if (credit[i] < 1) {
      return false;
    }
    credit[i] -= 1;
    return true;
  }
}
