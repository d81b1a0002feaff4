package carom.server.replication;

/**
 * Figures of what a line and a client's predictions have done since the link began. Differences of
 * two readings tell what they do now. Immutable.
 *
 * @param roundTripMs round trip, ms; 0 while it isn't known
 * @param bytesSent payload bytes of snapshots
 * @param settled datagrams that have arrived or were overtaken by one that has
 * @param acked datagrams that have arrived
 * @param predictedTicks ticks in which the client predicted entities beside its own body
 * @param mispredictions how often it then had another state than the server
 */
public record LinkFigures(
    int roundTripMs,
    long bytesSent,
    long settled,
    long acked,
    long predictedTicks,
    long mispredictions) {
  /** The figures of a session that never had a link. */
  public static final LinkFigures NONE = new LinkFigures(0, 0, 0, 0, 0, 0);
}
