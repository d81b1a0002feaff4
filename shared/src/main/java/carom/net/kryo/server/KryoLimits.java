package carom.net.kryo.server;

import carom.net.protocol.ProtocolLimits;

/**
 * Limits on what a server lets unknown clients use. It is immutable; start from {@link #DEFAULT}.
 *
 * @param maxConnections largest number of open links at once, 1..132,000; for a moment it may be
 *     exceeded by links that opened together. Keep the sum of this and the next well below the
 *     process's limit of open files
 * @param maxPending largest number of connections at once that have proven nothing, 1..4,096; a
 *     quarter as many again may exchange keys. One more makes the oldest give way, see {@link
 *     carom.net.admission.Entrance}. Each takes about 70 kB
 * @param maxPerAddress largest number of connections at once from one IPv4 address or one IPv6 /64
 *     network, 1..132,000; it counts as soon as half of {@code maxConnections} are open
 * @param handshakeMillis time limit for each of the three steps to an open link, 50..60,000 ms:
 *     registering, the exchange of keys, and answering a datagram. It holds while newcomers have to
 *     work; while most places are free, nobody pays for a slow line, and a client has eight times
 *     as long
 * @param idleMillis time without a complete frame over TCP after which a link closes, 100..600,000
 *     ms; clients send one every 2,000 ms
 * @param messagesPerSecond largest number of TCP frames per second from one link, 1..1,000,000; a
 *     link that sends more is closed, because reliable messages must not be dropped
 * @param datagramsPerSecond largest number of datagrams per second from one link, 1..1,000,000; the
 *     server drops those above
 * @param unreadMessages largest number of messages of one link that wait for {@code poll},
 *     1..65,536; one more closes the link
 * @param unreadDatagrams largest number of datagrams of one link that wait for {@code poll},
 *     1..65,536; one more is dropped
 * @param unsentBytes largest number of bytes that wait for a client that doesn't read, at most
 *     16,777,216; one message more closes the link
 */
public record KryoLimits(
    int maxConnections,
    int maxPending,
    int maxPerAddress,
    int handshakeMillis,
    int idleMillis,
    int messagesPerSecond,
    int datagramsPerSecond,
    int unreadMessages,
    int unreadDatagrams,
    int unsentBytes) {

  /** Largest number of links: what the largest rooms hold, those that wait and those that watch. */
  public static final int MAX_CONNECTIONS = 132_000;

  /** Multiple of {@code handshakeMillis} that a client has while most places are free. */
  static final int CALM_FACTOR = 8;

  /** Default limits of a server. */
  public static final KryoLimits DEFAULT =
      new KryoLimits(
          /* maxConnections= */ 320,
          /* maxPending= */ 1_024,
          /* maxPerAddress= */ 128,
          /* handshakeMillis= */ 2_000,
          /* idleMillis= */ 10_000,
          /* messagesPerSecond= */ ProtocolLimits.MAX_CLIENT_MESSAGES_PER_SECOND,
          /* datagramsPerSecond= */ ProtocolLimits.MAX_INPUT_DATAGRAMS_PER_SECOND,
          /* unreadMessages= */ 256,
          /* unreadDatagrams= */ 128,
          /* unsentBytes= */ 4 * ProtocolLimits.MAX_SERVER_MESSAGE_BYTES);

  /**
   * Checks the values.
   *
   * @throws IllegalArgumentException when a value is outside its range; the message names value and
   *     range
   */
  public KryoLimits {
    check("maxConnections", maxConnections, 1, MAX_CONNECTIONS);
    check("maxPending", maxPending, 1, 4_096);
    check("maxPerAddress", maxPerAddress, 1, MAX_CONNECTIONS);
    check("handshakeMillis", handshakeMillis, 50, 60_000);
    check("idleMillis", idleMillis, 100, 600_000);
    check("messagesPerSecond", messagesPerSecond, 1, 1_000_000);
    check("datagramsPerSecond", datagramsPerSecond, 1, 1_000_000);
    check("unreadMessages", unreadMessages, 1, 1 << 16);
    check("unreadDatagrams", unreadDatagrams, 1, 1 << 16);
    check("unsentBytes", unsentBytes, ProtocolLimits.MAX_SERVER_MESSAGE_BYTES + 64, 1 << 24);
  }

  private static void check(String name, int value, int min, int max) {
    if (value < min || value > max) {
      throw new IllegalArgumentException(
          name + "=" + value + " must be from " + min + " to " + max);
    }
  }

  /** Returns a copy with other limits on the number of connections. */
  public KryoLimits withConnections(int max, int perAddress) {
    return new KryoLimits(
        max,
        maxPending,
        perAddress,
        handshakeMillis,
        idleMillis,
        messagesPerSecond,
        datagramsPerSecond,
        unreadMessages,
        unreadDatagrams,
        unsentBytes);
  }

  /** Returns a copy with another limit on connections that have proven nothing. */
  public KryoLimits withPending(int max) {
    return new KryoLimits(
        maxConnections,
        max,
        maxPerAddress,
        handshakeMillis,
        idleMillis,
        messagesPerSecond,
        datagramsPerSecond,
        unreadMessages,
        unreadDatagrams,
        unsentBytes);
  }

  /** Returns a copy with other time limits, ms. */
  public KryoLimits withTimes(int handshake, int idle) {
    return new KryoLimits(
        maxConnections,
        maxPending,
        maxPerAddress,
        handshake,
        idle,
        messagesPerSecond,
        datagramsPerSecond,
        unreadMessages,
        unreadDatagrams,
        unsentBytes);
  }

  /** Returns a copy with other rate limits, per second and link. */
  public KryoLimits withRates(int messages, int datagrams) {
    return new KryoLimits(
        maxConnections,
        maxPending,
        maxPerAddress,
        handshakeMillis,
        idleMillis,
        messages,
        datagrams,
        unreadMessages,
        unreadDatagrams,
        unsentBytes);
  }

  /** Returns a copy with other inbox sizes. */
  public KryoLimits withInbox(int messages, int datagrams) {
    return new KryoLimits(
        maxConnections,
        maxPending,
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
