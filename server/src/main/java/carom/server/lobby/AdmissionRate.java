package carom.server.lobby;

import carom.net.admission.TokenBucket;
import java.util.HashMap;
import java.util.Map;

/**
 * Limits how often clients of one host may join: {@value #LEAST_BURST} times at once, or as many
 * times as the server has seats if that is more, then {@value #PER_SECOND} times per second. A
 * crowd behind one router joins unhindered, but a client that joins and leaves in a loop can't
 * flood the log and the screens of others. One thread; keeps at most {@value #MAX_HOSTS} hosts.
 */
final class AdmissionRate {
  static final int LEAST_BURST = 256;
  static final int PER_SECOND = 4;

  private static final int MAX_HOSTS = 4_096;

  private final Map<String, TokenBucket> buckets = new HashMap<>();
  private final int burst;

  /**
   * Creates a limit that has counted no joins.
   *
   * @param places seats of the server
   */
  AdmissionRate(int places) {
    burst = Math.max(LEAST_BURST, places);
  }

  /** Returns whether one more client of this host may join now. */
  boolean allows(String host, long nowNs) {
    TokenBucket bucket = buckets.get(host);
    return bucket == null || !bucket.isEmpty(nowNs);
  }

  /** Counts a client of this host that has joined. */
  void count(String host, long nowNs) {
    if (buckets.size() >= MAX_HOSTS && !buckets.containsKey(host)) {
      buckets.values().removeIf(bucket -> bucket.isFull(nowNs));
      if (buckets.size() >= MAX_HOSTS) {
        buckets.clear(); // so many active hosts are no loop of one client: forget, don't grow
      }
    }
    buckets.computeIfAbsent(host, h -> new TokenBucket(PER_SECOND, burst)).charge(nowNs);
  }
}
