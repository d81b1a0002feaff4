package carom.server.thin.plain;

/** A message of stock KryoNet itself, by which it keeps its connection. */
sealed interface PlainControl {

  /** Asks that datagrams from its sender count as those of a connection. */
  record RegisterUdp(int id) implements PlainControl {}

  /** Asks for an answer, or is one. */
  record Ping(int id, boolean isReply) implements PlainControl {}

  /** Says that the client is there. */
  record KeepAlive() implements PlainControl {}
}
