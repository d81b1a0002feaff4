package carom.net.kryo;

import carom.net.protocol.Limits;

/**
 * What a server lets strangers use. Immutable; {@link #DEFAULT} serves a full room.
 *
 * @param maxConnections connections at once, half-open ones included; keep it well below the
 *     process's limit of open files (KryoNet spins when it can't accept)
 * @param maxPerAddress connections at once from one IPv4 address or one IPv6 /64 network
 * @param handshakeMillis time for each of the two steps to an open link: registering UDP, and
 *     answering a datagram
 * @param idleMillis a link closes when no complete frame came over TCP for this long; clients send
 *     one every 2,000 ms
 * @param messagesPerSecond frames over TCP; a link that sends more is closed, because what is
 *     reliable must not be dropped
 * @param datagramsPerSecond datagrams from one link; what is more is dropped
 * @param unreadMessages messages that wait for {@code poll}; one more closes the link
 * @param unreadDatagrams datagrams that wait for {@code poll}; one more is dropped
 * @param unsentBytes bytes that wait for a client that doesn't read; one message more closes the
 *     link
 */
public record KryoLimits(
    int maxConnections,
    int maxPerAddress,
    int handshakeMillis,
    int idleMillis,
    int messagesPerSecond,
    int datagramsPerSecond,
    int unreadMessages,
    int unreadDatagrams,
    int unsentBytes) {

  /** For a room of {@link Limits#MAX_PLAYERS}. */
  public static final KryoLimits DEFAULT =
      new KryoLimits(
          320,
          128,
          2_000,
          10_000,
          Limits.MAX_CLIENT_MESSAGES_PER_SECOND,
          Limits.MAX_INPUT_DATAGRAMS_PER_SECOND,
          256,
          128,
          4 * Limits.MAX_SERVER_MESSAGE_BYTES);

  /**
   * Checks the values.
   *
   * @throws IllegalArgumentException names value and range
   */
  public KryoLimits {
    check("maxConnections", maxConnections, 1, 10_000);
    check("maxPerAddress", maxPerAddress, 1, 10_000);
    check("handshakeMillis", handshakeMillis, 50, 60_000);
    check("idleMillis", idleMillis, 100, 600_000);
    check("messagesPerSecond", messagesPerSecond, 1, 1_000_000);
    check("datagramsPerSecond", datagramsPerSecond, 1, 1_000_000);
    check("unreadMessages", unreadMessages, 1, 1 << 16);
    check("unreadDatagrams", unreadDatagrams, 1, 1 << 16);
    check("unsentBytes", unsentBytes, Limits.MAX_SERVER_MESSAGE_BYTES + 64, 1 << 24);
  }

  private static void check(String name, int value, int min, int max) {
    if (value < min || value > max) {
      throw new IllegalArgumentException(
          name + "=" + value + " must be from " + min + " to " + max);
    }
  }

  /** These limits with other caps on the number of connections. */
  public KryoLimits withConnections(int max, int perAddress) {
    return new KryoLimits(
        max,
        perAddress,
        handshakeMillis,
        idleMillis,
        messagesPerSecond,
        datagramsPerSecond,
        unreadMessages,
        unreadDatagrams,
        unsentBytes);
  }

  /** These limits with other times. */
  public KryoLimits withTimes(int handshake, int idle) {
    return new KryoLimits(
        maxConnections,
        maxPerAddress,
        handshake,
        idle,
        messagesPerSecond,
        datagramsPerSecond,
        unreadMessages,
        unreadDatagrams,
        unsentBytes);
  }

  /** These limits with other rates. */
  public KryoLimits withRates(int messages, int datagrams) {
    return new KryoLimits(
        maxConnections,
        maxPerAddress,
        handshakeMillis,
        idleMillis,
        messages,
        datagrams,
        unreadMessages,
        unreadDatagrams,
        unsentBytes);
  }

  /** These limits with other inbox sizes. */
  public KryoLimits withInbox(int messages, int datagrams) {
    return new KryoLimits(
        maxConnections,
        maxPerAddress,
        handshakeMillis,
        idleMillis,
        messagesPerSecond,
        datagramsPerSecond,
        messages,
        datagrams,
        unsentBytes);
  }
}
