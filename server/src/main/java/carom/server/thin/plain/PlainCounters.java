package carom.server.thin.plain;

import carom.net.transport.NetworkCounter;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;

/** Counters of the door, for the operator. Any thread; each value only grows. */
final class PlainCounters {
  final AtomicLong accepted = new AtomicLong();
  final AtomicLong joined = new AtomicLong();
  final AtomicLong refused = new AtomicLong();
  final AtomicLong foreign = new AtomicLong();
  final AtomicLong evicted = new AtomicLong();
  final AtomicLong expired = new AtomicLong();
  final AtomicLong expelled = new AtomicLong();
  final AtomicLong strangeDatagrams = new AtomicLong();
  final AtomicLong malformedDatagrams = new AtomicLong();
  final AtomicLong excessDatagrams = new AtomicLong();
  final AtomicLong errors = new AtomicLong();

  private volatile Throwable lastError;
  private long nextErrorCount = 1; // the accepting thread only

  void error(Throwable error) {
    lastError = error;
    errors.incrementAndGet();
  }

  /** Returns an error to report, the 1st, 10th, 100th and so on, or null. */
  Throwable nextError() {
    if (errors.get() < nextErrorCount) {
      return null;
    }
    nextErrorCount *= 10;
    return lastError;
  }

  List<NetworkCounter> all() {
    return List.of(
        counter("accepted", "TCP connections of stock KryoNet that came in.", accepted),
        counter("joined", "Connections of stock KryoNet that asked to join.", joined),
        counter("refused", "Connections of stock KryoNet refused because of a limit.", refused),
        counter(
            "foreign",
            "Connections of stock KryoNet from outside private networks, without --plain-open.",
            foreign),
        counter("evicted", "Connections of stock KryoNet that gave way before joining.", evicted),
        counter("expired", "Connections of stock KryoNet that didn't join in time.", expired),
        counter(
            "expelled",
            "Connections of stock KryoNet closed because of silence, a flood, a full queue, or"
                + " meaningless bytes.",
            expelled),
        counter(
            "datagrams.strange",
            "Datagrams to the port for stock KryoNet from unknown addresses.",
            strangeDatagrams),
        counter(
            "datagrams.malformed",
            "Meaningless datagrams of stock KryoNet's connections.",
            malformedDatagrams),
        counter(
            "datagrams.excess",
            "Datagrams of stock KryoNet dropped because the client sent too many.",
            excessDatagrams),
        counter(
            "errors",
            "Unexpected errors on the thread for stock KryoNet, which it survived. Each is a bug.",
            errors));
  }

  private static NetworkCounter counter(String name, String help, AtomicLong value) {
    return new NetworkCounter("plain." + name, help, value::get);
  }

  /** Returns the values that should be 0 and aren't, in words. */
  String troubles() {
    StringBuilder text = new StringBuilder();
    append(text, refused, "refused");
    append(text, foreign, "from outside private networks");
    append(text, evicted, "gave way before they joined");
    append(text, expired, "never joined");
    append(text, expelled, "expelled");
    append(text, strangeDatagrams, "datagrams from unknown addresses");
    append(text, malformedDatagrams, "malformed datagrams");
    append(text, excessDatagrams, "excess datagrams");
    append(text, errors, "errors");
    return text.length() == 0 ? "" : "plain port: " + text;
  }

  private static void append(StringBuilder text, AtomicLong value, String meaning) {
    long count = value.get();
    if (count > 0) {
      text.append(text.length() == 0 ? "" : ", ").append(count).append(' ').append(meaning);
    }
  }
}
