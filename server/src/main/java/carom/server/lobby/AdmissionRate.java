package carom.server.lobby;

import java.util.HashMap;
import java.util.Map;

/**
 * Limits how often clients of one address may join: {@value #LEAST_BURST} times at once, or as many
 * times as the server has seats if that is more, then {@value #PER_SECOND} times per second. A
 * crowd behind one address joins unhindered, but a client that joins and leaves in a loop can't
 * flood the log and the screens of others. One thread; keeps at most {@value #MAX_ADDRESSES}
 * addresses.
 */
final class AdmissionRate {
  static final int LEAST_BURST = 256;
  static final int PER_SECOND = 4;

  private static final int MAX_ADDRESSES = 4_096;
  private static final double NS_PER_S = 1e9;

  private final Map<String, Bucket> buckets = new HashMap<>();
  private final int burst;

  /**
   * Creates a limit that has counted no joins.
   *
   * @param places seats of the server
   */
  AdmissionRate(int places) {
    burst = Math.max(LEAST_BURST, places);
  }

  /** The number of joins that an address has left: a token bucket. */
  private final class Bucket {
    private double tokens = burst;
    private long sinceNs;

    private void fill(long nowNs) {
      tokens = Math.min(burst, tokens + (nowNs - sinceNs) / NS_PER_S * PER_SECOND);
      sinceNs = nowNs;
    }
  }

  /** Returns the part of {@code Link.remote} that all links of one machine share. */
  static String address(String remote) {
    int port = remote.lastIndexOf(':');
    return port < 0 ? remote : remote.substring(0, port);
  }

  /** Returns whether one more client of this address may join now. */
  boolean allows(String address, long nowNs) {
    Bucket bucket = buckets.get(address);
    if (bucket == null) {
      return true;
    }
    bucket.fill(nowNs);
    return bucket.tokens >= 1;
  }

  /** Counts a client of this address that has joined. */
  void count(String address, long nowNs) {
    if (buckets.size() >= MAX_ADDRESSES && !buckets.containsKey(address)) {
      buckets.values().removeIf(b -> isFull(b, nowNs));
      if (buckets.size() >= MAX_ADDRESSES) {
        buckets.clear(); // so many active addresses are no loop of one client: forget, don't grow
      }
    }
    Bucket bucket = buckets.computeIfAbsent(address, a -> new Bucket());
    bucket.fill(nowNs);
    bucket.tokens--;
  }

  private boolean isFull(Bucket bucket, long nowNs) {
    bucket.fill(nowNs);
    return bucket.tokens >= burst;
  }
}
