package carom.net.transport;

/** The unexpected errors that a transport survived; each is a bug. Any thread. */
public final class SurvivedErrors {
  private long count;
  private long nextReported = 1;
  private Throwable last;

  /** Creates none. */
  public SurvivedErrors() {}

  /** Notes an error. */
  public synchronized void add(Throwable error) {
    last = error;
    count++;
  }

  /** Returns the number of errors so far. */
  public synchronized long get() {
    return count;
  }

  /** Returns the last error, or null before the first. */
  public synchronized Throwable last() {
    return last;
  }

  /** Takes an error to report: the 1st, 10th, 100th and so on, once; else null. */
  public synchronized Throwable take() {
    if (count < nextReported) {
      return null;
    }
    while (count >= nextReported) {
      nextReported *= 10;
    }
    return last;
  }
}
