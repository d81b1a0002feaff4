package carom.server.thin.plain;

import carom.net.transport.NetworkCounter;
import carom.net.transport.SurvivedErrors;
import carom.net.transport.Troubles;
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
  final SurvivedErrors errors = new SurvivedErrors();

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
        new NetworkCounter(
            "plain.errors",
            "Unexpected errors on the thread for stock KryoNet, which it survived. Each is a bug.",
            errors::get));
  }

  private static NetworkCounter counter(String name, String help, AtomicLong value) {
    return new NetworkCounter("plain." + name, help, value::get);
  }

  /** Returns the values that should be 0 and aren't, in words. */
  String troubles() {
    return new Troubles()
        .add(refused.get(), "refused")
        .add(foreign.get(), "from outside private networks")
        .add(evicted.get(), "gave way before they joined")
        .add(expired.get(), "never joined")
        .add(expelled.get(), "expelled")
        .add(strangeDatagrams.get(), "datagrams from unknown addresses")
        .add(malformedDatagrams.get(), "malformed datagrams")
        .add(excessDatagrams.get(), "excess datagrams")
        .add(errors.get(), "errors")
        .under("plain port: ");
  }
}
