package carom.server.thin.plain;

/**
 * Limits on what unknown programs may use at the door for stock KryoNet. Immutable; start from
 * {@link #DEFAULT}.
 *
 * @param maxConnections largest number of connections that have joined, 1..20,000
 * @param maxPerAddress largest number of them from one IPv4 address or one IPv6 /64 network; it
 *     counts as soon as half of {@code maxConnections} are open
 * @param maxWaiting largest number of connections that haven't joined, 1..4,096; one more makes the
 *     oldest give way, see {@link carom.net.admission.Entrance}
 * @param joinMillis time within which a connection must join, ms
 * @param idleMillis time without a complete message after which a connection closes, ms; stock
 *     KryoNet answers the server's pings by itself
 * @param framesPerSecond largest number of messages of one connection by TCP; one that sends more
 *     is closed
 * @param bytesPerSecond largest number of bytes of one connection by TCP; one that sends more is
 *     closed
 * @param datagramsPerSecond largest number of datagrams of one connection; those above are dropped
 * @param unsentBytes largest number of bytes that wait for a client that doesn't read; one message
 *     more closes the connection
 * @param stallMillis time after which a client that takes none of them is closed, ms
 */
record PlainLimits(
    int maxConnections,
    int maxPerAddress,
    int maxWaiting,
    int joinMillis,
    int idleMillis,
    int framesPerSecond,
    int bytesPerSecond,
    int datagramsPerSecond,
    int unsentBytes,
    int stallMillis) {

  /** Limits of a server. */
  public static final PlainLimits DEFAULT =
      new PlainLimits(
          /* maxConnections= */ 512,
          /* maxPerAddress= */ 128,
          /* maxWaiting= */ 64,
          /* joinMillis= */ 5_000,
          /* idleMillis= */ 20_000,
          /* framesPerSecond= */ 400,
          /* bytesPerSecond= */ 64 * 1_024,
          /* datagramsPerSecond= */ 400,
          /* unsentBytes= */ 256 * 1_024,
          /* stallMillis= */ 8_000);

  /** Returns a copy with other limits on the number of connections. */
  public PlainLimits withConnections(int max, int perAddress, int waiting) {
    return new PlainLimits(
        max,
        perAddress,
        waiting,
        joinMillis,
        idleMillis,
        framesPerSecond,
        bytesPerSecond,
        datagramsPerSecond,
        unsentBytes,
        stallMillis);
  }

  /** Returns a copy with other time limits, ms. */
  public PlainLimits withTimes(int join, int idle, int stall) {
    return new PlainLimits(
        maxConnections,
        maxPerAddress,
        maxWaiting,
        join,
        idle,
        framesPerSecond,
        bytesPerSecond,
        datagramsPerSecond,
        unsentBytes,
        stall);
  }
}
