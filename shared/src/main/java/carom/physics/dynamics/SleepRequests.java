package carom.physics.dynamics;

import java.util.Arrays;

/** The requests to wake or sleep that callbacks make, kept until bodies may change state again. */
final class SleepRequests {
  /** Request to wake a body. */
  static final int WAKE = 0;

  /** Request to wake a body and all that touches it. */
  static final int DISTURB = 1;

  /** Request to put a body's island to sleep. */
  static final int SLEEP = 2;

  private static final int KINDS = 3;

  /** The requests in their order, each body * {@value #KINDS} + kind. */
  private long[] list = new long[8];

  private int count;

  /** Appends a request. */
  void add(int body, int what) {
    if (count == list.length) {
      list = Arrays.copyOf(list, count * 2);
    }
    list[count++] = (long) body * KINDS + what;
  }

  /** Returns the number of requests. */
  int count() {
    return count;
  }

  /** Returns the body of a request. */
  int body(int i) {
    return (int) (list[i] / KINDS);
  }

  /** Returns the kind of a request. */
  int what(int i) {
    return (int) (list[i] % KINDS);
  }

  /** Forgets all requests. */
  void clear() {
    count = 0;
  }
}
