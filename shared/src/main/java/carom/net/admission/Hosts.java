package carom.net.admission;

import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * The hosts that have connections, and those that get none for a while. One thread counts
 * connections; any thread may refuse a host.
 */
public final class Hosts {
  /** Time for which a host is refused, s. */
  public static final int REFUSAL_SECONDS = 30;

  private static final long NANOS_PER_SECOND = 1_000_000_000L;
  private static final int MAX_REFUSED = 4_096;

  private final Map<String, Integer> connections = new HashMap<>();
  private final Map<String, Long> refusedUntil = new ConcurrentHashMap<>();

  /** Counts a connection of a host, and returns how many it has. */
  public int add(String host) {
    return connections.merge(host, 1, Integer::sum);
  }

  /** Counts a connection of a host no more. */
  public void remove(String host) {
    connections.computeIfPresent(host, (key, n) -> n == 1 ? null : n - 1);
  }

  /** Refuses a host for {@value #REFUSAL_SECONDS} s. It remembers {@value #MAX_REFUSED} hosts. */
  public void refuseForAWhile(String host, long now) {
    if (refusedUntil.size() >= MAX_REFUSED) {
      refusedUntil.values().removeIf(until -> now - until >= 0);
    }
    if (refusedUntil.size() < MAX_REFUSED) {
      refusedUntil.put(host, now + REFUSAL_SECONDS * NANOS_PER_SECOND);
    }
  }

  /** Returns whether a host is refused at a time of {@link System#nanoTime}. */
  public boolean isRefused(String host, long now) {
    Long until = refusedUntil.get(host);
    return until != null && now - until < 0;
  }
}
