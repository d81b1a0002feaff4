package carom.net.frame;

/**
 * The way that one end of a link sends its datagrams: by UDP, or over TCP while UDP is dead in
 * either direction. Both ends have one of these, and tell each other over TCP whether they hear the
 * other by UDP. So they change over and back within seconds, in the middle of a game too.
 *
 * <p>Over TCP nothing queues behind a stall: each end acknowledges what arrives, and a datagram is
 * sent only while the oldest one under way is younger than {@link #QUEUE_NANOS} and two round
 * trips. Otherwise it is lost here, as it would be on a full line, and the next one is newer.
 *
 * <p>Times are of {@link System#nanoTime}. Any thread may call it; nothing here allocates.
 */
public final class DatagramPath {
  /** Silence by UDP after which it counts as dead, in addition to two round trips, ns. */
  public static final long SILENCE_NANOS = 3_000_000_000L;

  /** Time for which datagrams may wait on a slow line, in addition to two round trips, ns. */
  public static final long QUEUE_NANOS = 250_000_000L;

  /** Largest number of datagrams under way over TCP. */
  public static final int MOST_UNDER_WAY = 512;

  private static final long ANSWER_NANOS = 40_000_000L;
  private static final long REPEAT_NANOS = 500_000_000L;
  private static final long PROBE_NANOS = 700_000_000L;
  private static final int COUNT_MASK = 0xffff;

  private final long[] sentAt = new long[MOST_UNDER_WAY];
  private long silenceNanos = SILENCE_NANOS;
  private long roundTripNanos = SILENCE_NANOS; // the shortest one known
  private boolean heardOnce;
  private long heardAt;
  private boolean peerHears = true;
  private boolean toldHears = true;
  private int sent;
  private int acknowledged;
  private int received;
  private int told;
  private boolean spoken;
  private long spokenAt;

  /** Creates the path of a link whose ends haven't heard each other by UDP. */
  public DatagramPath() {}

  /**
   * Notes how long the first answer of the link's other end took, so that a long way doesn't count
   * as silence or as a stall.
   */
  public synchronized void roundTrip(long nanos) {
    silenceNanos = SILENCE_NANOS + 2 * nanos;
    roundTripNanos = nanos;
  }

  /**
   * Notes a genuine datagram that came by UDP.
   *
   * @param showsHearing whether it shows that the other end hears this one by UDP
   */
  public synchronized void heardByUdp(boolean showsHearing, long now) {
    heardOnce = true;
    heardAt = now;
    peerHears |= showsHearing;
  }

  private boolean hears(long now) {
    return heardOnce && now - heardAt < silenceNanos;
  }

  /** Returns whether UDP has been silent for so long that this end should ask whether it works. */
  public synchronized boolean isQuiet(long now) {
    return !heardOnce || now - heardAt > PROBE_NANOS;
  }

  /** Returns whether datagrams go over TCP now. */
  public synchronized boolean isOverTcp(long now) {
    return !hears(now) || !peerHears;
  }

  /** Returns whether a datagram may go over TCP now; if not, it is lost. */
  public synchronized boolean isFree(long now) {
    int underWay = sent - acknowledged;
    return underWay == 0
        || underWay < MOST_UNDER_WAY
            && now - sentAt[acknowledged & MOST_UNDER_WAY - 1] < QUEUE_NANOS + 2 * roundTripNanos;
  }

  /**
   * Writes the head of a frame that is sent over TCP now: whether this end hears the other by UDP,
   * and how many datagrams have come over TCP, modulo 65,536.
   *
   * @param payload whether a datagram follows, or the frame only tells these two
   */
  public synchronized void write(byte[] head, boolean payload, long now) {
    toldHears = hears(now);
    head[0] = (byte) (toldHears ? 1 : 0);
    head[1] = (byte) (received >>> 8);
    head[2] = (byte) received;
    told = received;
    spoken = true;
    spokenAt = now;
    if (payload) {
      sentAt[sent & MOST_UNDER_WAY - 1] = now;
      sent++;
    }
  }

  /**
   * Reads the head of a frame that came over TCP.
   *
   * @return false when it acknowledges what was never sent
   */
  public synchronized boolean read(
      boolean hearsThis, int acknowledgement, boolean payload, long now) {
    int news = acknowledgement - acknowledged & COUNT_MASK;
    if (news > sent - acknowledged) {
      return false;
    }
    if (news > 0) {
      acknowledged += news;
      long taken = now - sentAt[acknowledged - 1 & MOST_UNDER_WAY - 1];
      roundTripNanos = Math.min(roundTripNanos, taken);
    }
    peerHears = hearsThis;
    received = received + (payload ? 1 : 0) & COUNT_MASK;
    return true;
  }

  /**
   * Returns whether a frame without a datagram is due over TCP: to acknowledge, or to tell the peer
   * that UDP doesn't work, or works again.
   */
  public synchronized boolean mustSpeak(long now) {
    long silence = spoken ? now - spokenAt : Long.MAX_VALUE;
    return (received != told || toldHears != hears(now)) && silence > ANSWER_NANOS
        || (!hears(now) || !peerHears) && silence > REPEAT_NANOS;
  }
}
