package carom.server.threads;

/**
 * Work that a {@link DutyPool} does turn by turn, such as that of a room. Its turns never overlap,
 * and each sees what the ones before it wrote, whichever threads run them. The thread that has the
 * duty calls every method, but for {@link #progress}.
 */
public interface Duty {
  /** Does the work that is due. */
  void turn(long nowNs);

  /**
   * Returns the time until a turn is needed, nanoseconds; {@link Long#MAX_VALUE} if none is until
   * {@link DutyPool.Shift#wake}.
   */
  long napNs(long nowNs);

  /**
   * Returns whether links may bring something meanwhile, so that a turn is worth while every
   * {@value TurnSchedule#POLL_MS} ms.
   */
  boolean hasLinks();

  /** Returns a number that changes whenever a long turn gets on; the watchdog's thread. */
  int progress();

  /** Returns whether the duty can't go on. */
  boolean hasFailed();

  /** Makes the duty fail and logs why. */
  void fail(String why);

  /** Says goodbye to all clients. Does nothing after {@link #fail}. */
  void close(long nowNs);

  /** Returns whether no link is left. */
  boolean isDeserted();

  /** Closes the remaining links. */
  void closeLinks();
}
