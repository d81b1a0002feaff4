package carom.server.access;

import java.net.Inet6Address;
import java.net.InetAddress;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.LongSupplier;

/**
 * Limits how often an address may try to log in. After {@value #MOST} wrong tries an address waits
 * until a minute after the first of them; of IPv6, the /64 network counts as one address. When all
 * addresses together have had {@value #MOST_OF_ALL} wrong tries in a minute, those with a wrong one
 * wait. One that has none may always try, so that strangers lock no operator out. Any thread.
 */
public final class LoginThrottle {
  /** Wrong tries of one address in a minute. */
  public static final int MOST = 5;

  /** Wrong tries of all addresses in a minute. */
  public static final int MOST_OF_ALL = 100;

  private static final long MINUTE_NS = 60_000_000_000L;
  private static final int MAX_ADDRESSES = 1_024;
  private static final int NETWORK_BYTES = 8;

  private final LongSupplier clock;
  private long wrongTries;
  private final Tries all;

  /** The oldest address goes when there are too many. */
  private final Map<String, Tries> byAddress =
      new LinkedHashMap<>() {
        private static final long serialVersionUID = 1;

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, Tries> eldest) {
          return size() > MAX_ADDRESSES;
        }
      };

  /** Wrong tries since a moment, which begins anew after a minute. */
  private static final class Tries {
    private final int most;
    private long beginNs;
    private int wrong;

    Tries(int most, long nowNs) {
      this.most = most;
      beginNs = nowNs;
    }

    boolean areTooMany(long nowNs) {
      return wrong >= most && nowNs - beginNs < MINUTE_NS;
    }

    boolean hasAny(long nowNs) {
      return wrong > 0 && nowNs - beginNs < MINUTE_NS;
    }

    void add(long nowNs) {
      if (nowNs - beginNs >= MINUTE_NS) {
        beginNs = nowNs;
        wrong = 0;
      }
      wrong++;
    }
  }

  /**
   * Creates a throttle that knows of no try.
   *
   * @param clock monotonic nanoseconds
   */
  public LoginThrottle(LongSupplier clock) {
    this.clock = clock;
    all = new Tries(MOST_OF_ALL, clock.getAsLong());
  }

  /** Returns whether an address must wait before it may try again. */
  public synchronized boolean mustWait(InetAddress address) {
    Tries tries = byAddress.get(key(address));
    long nowNs = clock.getAsLong();
    if (tries == null) {
      return false;
    }
    return tries.areTooMany(nowNs) || all.areTooMany(nowNs) && tries.hasAny(nowNs);
  }

  /** Notes that an address knew the secret: its wrong tries were mistakes. */
  public synchronized void right(InetAddress address) {
    byAddress.remove(key(address));
  }

  /** Notes that an address tried a wrong secret. */
  public synchronized void wrong(InetAddress address) {
    long nowNs = clock.getAsLong();
    byAddress.computeIfAbsent(key(address), key -> new Tries(MOST, nowNs)).add(nowNs);
    all.add(nowNs);
    wrongTries++;
  }

  /** Returns the number of wrong tries since the start. */
  public synchronized long wrongTries() {
    return wrongTries;
  }

  private static String key(InetAddress address) {
    byte[] bytes = address.getAddress();
    return Arrays.toString(
        address instanceof Inet6Address ? Arrays.copyOf(bytes, NETWORK_BYTES) : bytes);
  }
}
