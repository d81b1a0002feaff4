package carom.net.kryo.server;

import carom.net.transport.NetworkCounter;
import carom.net.transport.SurvivedErrors;
import carom.net.transport.Troubles;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Counters of a server's transport, for the operator. Any thread may read them; each value only
 * grows.
 */
public final class KryoServerCounters {

  /** Number of TCP connections that came in. */
  public final AtomicLong accepted = new AtomicLong();

  /** Number of accepted connections that became an open link. */
  public final AtomicLong opened = new AtomicLong();

  /** Number of accepted connections that were refused because of a limit. */
  public final AtomicLong refused = new AtomicLong();

  /** Number of connections that gave way to newcomers before they had opened. */
  public final AtomicLong evicted = new AtomicLong();

  /** Number of accepted connections that did not finish the handshake in time. */
  public final AtomicLong expired = new AtomicLong();

  /**
   * Number of links closed because of silence, a flood, a full inbox or outbox, or meaningless
   * bytes.
   */
  public final AtomicLong expelled = new AtomicLong();

  /** Number of datagrams from addresses without a link, except those of the handshake. */
  public final AtomicLong strangeDatagrams = new AtomicLong();

  /** Number of datagrams that named a link and weren't sealed with its key. */
  public final AtomicLong forgedDatagrams = new AtomicLong();

  /** Number of genuine datagrams that came again, or too late to know. */
  public final AtomicLong replayedDatagrams = new AtomicLong();

  /** Number of times that a client went on from another address. */
  public final AtomicLong movedLinks = new AtomicLong();

  /** Number of meaningless datagrams from links. */
  public final AtomicLong malformedDatagrams = new AtomicLong();

  /** Number of datagrams dropped because their link sent too many. */
  public final AtomicLong excessDatagrams = new AtomicLong();

  /** Unexpected errors on the network thread, which it survived. */
  public final SurvivedErrors errors = new SurvivedErrors();

  KryoServerCounters() {}

  /** Returns all of them with what they count. */
  List<NetworkCounter> all() {
    return List.of(
        counter("accepted", "TCP connections that came in.", accepted),
        counter("opened", "Accepted connections that became an open link.", opened),
        counter("refused", "Accepted connections that were refused because of a limit.", refused),
        counter(
            "evicted", "Connections that gave way to newcomers before they had opened.", evicted),
        counter(
            "expired", "Accepted connections that did not finish the handshake in time.", expired),
        counter(
            "expelled",
            "Links closed because of silence, a flood, a full queue, or meaningless bytes.",
            expelled),
        counter(
            "datagrams.strange",
            "Datagrams from addresses without a link, except those of the handshake.",
            strangeDatagrams),
        counter(
            "datagrams.forged",
            "Datagrams that named a link and weren't sealed with its key.",
            forgedDatagrams),
        counter(
            "datagrams.replayed",
            "Datagrams that came again, or too late to know.",
            replayedDatagrams),
        counter("moved", "Times that a client went on from another address.", movedLinks),
        counter("datagrams.malformed", "Meaningless datagrams from links.", malformedDatagrams),
        counter(
            "datagrams.excess",
            "Datagrams dropped because their link sent too many.",
            excessDatagrams),
        new NetworkCounter(
            "errors",
            "Unexpected errors on the network thread, which it survived. Each is a bug.",
            errors::get));
  }

  private static NetworkCounter counter(String name, String help, AtomicLong value) {
    return new NetworkCounter(name, help, value::get);
  }

  /** Returns the values that should be 0 and aren't, in words. */
  public String troubles() {
    return new Troubles()
        .add(refused.get(), "refused")
        .add(evicted.get(), "gave way before they had opened")
        .add(expired.get(), "never finished the handshake")
        .add(expelled.get(), "expelled")
        .add(strangeDatagrams.get(), "datagrams from unknown addresses")
        .add(forgedDatagrams.get(), "forged datagrams")
        .add(malformedDatagrams.get(), "malformed datagrams")
        .add(excessDatagrams.get(), "excess datagrams")
        .add(errors.get(), "errors")
        .toString();
  }
}
