package carom.net.kryo;

import java.util.concurrent.atomic.AtomicLong;

/**
 * What a server's transport has seen, for the operator. Safe from any thread; each value only
 * grows.
 */
public final class KryoServerCounters {

  /** TCP connections that came in. */
  public final AtomicLong accepted = new AtomicLong();

  /** Of those, the ones that became an open link. */
  public final AtomicLong opened = new AtomicLong();

  /** Of those, the ones turned away because of a cap. */
  public final AtomicLong refused = new AtomicLong();

  /** Of those, the ones that didn't finish the handshake in time. */
  public final AtomicLong expired = new AtomicLong();

  /**
   * Links closed because of silence, a flood, a full inbox or outbox, or bytes that mean nothing.
   */
  public final AtomicLong expelled = new AtomicLong();

  /** Datagrams from addresses that belong to no link, the handshake's own ones excluded. */
  public final AtomicLong strangeDatagrams = new AtomicLong();

  /** Datagrams from links that mean nothing. */
  public final AtomicLong malformedDatagrams = new AtomicLong();

  /** Datagrams dropped because their link sent too many. */
  public final AtomicLong excessDatagrams = new AtomicLong();

  /** Unexpected errors on the network thread; it went on. See {@link #lastError}. */
  public final AtomicLong errors = new AtomicLong();

  private volatile Throwable lastError;

  KryoServerCounters() {}

  /** Returns the newest of {@link #errors}, or null. */
  public Throwable lastError() {
    return lastError;
  }

  /** Returns the values that aren't 0 and should be, in words. */
  String troubles() {
    StringBuilder text = new StringBuilder();
    append(text, refused, "refused");
    append(text, expired, "never finished the handshake");
    append(text, expelled, "expelled");
    append(text, strangeDatagrams, "datagrams of strangers");
    append(text, malformedDatagrams, "malformed datagrams");
    append(text, excessDatagrams, "datagrams too many");
    append(text, errors, "errors");
    return text.toString();
  }

  private static void append(StringBuilder text, AtomicLong value, String meaning) {
    long count = value.get();
    if (count > 0) {
      text.append(text.length() == 0 ? "" : ", ").append(count).append(' ').append(meaning);
    }
  }

  void error(Throwable error) {
    lastError = error;
    errors.incrementAndGet();
  }
}
