package carom.server.metrics;

import java.util.Locale;
import java.util.concurrent.atomic.AtomicLongArray;
import org.HdrHistogram.Histogram;
import org.HdrHistogram.SingleWriterRecorder;

/**
 * A room's numbers: written by the room's thread without a lock or an allocation, read by any
 * other.
 *
 * <p>Tick times go into an HdrHistogram from 1 microsecond to 10 seconds with two digits. They are
 * kept per interval: whoever takes an interval gets what was recorded since it was taken before.
 */
public final class Counters {
  private static final Counter[] ALL = Counter.values();
  private static final long LOWEST_NS = 1_000;
  private static final long HIGHEST_NS = 10_000_000_000L;

  private final AtomicLongArray values = new AtomicLongArray(ALL.length);
  private final SingleWriterRecorder tickTimes = new SingleWriterRecorder(LOWEST_NS, HIGHEST_NS, 2);
  private final Histogram total = new Histogram(LOWEST_NS, HIGHEST_NS, 2);
  private Histogram interval;

  /** Creates counters at zero. */
  public Counters() {}

  /** Adds to a counter. The room's thread only. */
  public void add(Counter counter, long amount) {
    int index = counter.ordinal();
    values.setRelease(index, values.getPlain(index) + amount);
  }

  /** Sets a gauge. The room's thread only. */
  public void set(Counter gauge, long value) {
    values.setRelease(gauge.ordinal(), value);
  }

  /** The present value, from any thread. */
  public long get(Counter counter) {
    return values.getAcquire(counter.ordinal());
  }

  /** Records how long one tick took. The room's thread only. */
  public void tickTook(long durationNs) {
    tickTimes.recordValue(Math.max(0, Math.min(HIGHEST_NS, durationNs)));
  }

  /** Tick times since the last call of this method. Any thread, one at a time. */
  public synchronized TickTimes takeInterval() {
    interval = tickTimes.getIntervalHistogram(interval);
    total.add(interval);
    return TickTimes.of(interval);
  }

  /** Tick times since the start. Any thread, one at a time. */
  public synchronized TickTimes total() {
    interval = tickTimes.getIntervalHistogram(interval);
    total.add(interval);
    return TickTimes.of(total);
  }

  /**
   * How long ticks took.
   *
   * @param count number of ticks
   * @param p50Ns half of them took at most this, nanoseconds
   * @param p99Ns 99 % took at most this, nanoseconds
   * @param maxNs the longest, nanoseconds
   */
  public record TickTimes(long count, long p50Ns, long p99Ns, long maxNs) {
    private static TickTimes of(Histogram histogram) {
      return new TickTimes(
          histogram.getTotalCount(),
          histogram.getValueAtPercentile(50),
          histogram.getValueAtPercentile(99),
          histogram.getMaxValue());
    }

    /** For log lines: {@code tick p50 0.21 p99 0.80 max 3.10 ms}. */
    @Override
    public String toString() {
      return String.format(
          Locale.ROOT, "tick p50 %.2f p99 %.2f max %.2f ms", p50Ns / 1e6, p99Ns / 1e6, maxNs / 1e6);
    }
  }
}
