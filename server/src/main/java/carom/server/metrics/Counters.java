package carom.server.metrics;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicLongArray;
import org.HdrHistogram.Histogram;
import org.HdrHistogram.SingleWriterRecorder;

/**
 * A room's counters and tick times. The room's thread writes them without a lock or an allocation,
 * and any other thread may read them.
 *
 * <p>Tick times go into an HdrHistogram from 1 microsecond to 10 seconds with two digits.
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

  /** Returns the present value of a counter. Any thread. */
  public long get(Counter counter) {
    return values.getAcquire(counter.ordinal());
  }

  /** Records how long one tick took. The room's thread only. */
  public void tickTook(long durationNs) {
    tickTimes.recordValue(Math.max(0, Math.min(HIGHEST_NS, durationNs)));
  }

  /** Returns the tick times since the start. Any thread, one at a time. */
  public synchronized TickTimes total() {
    collect();
    return TickTimes.of(total);
  }

  /** Returns a reader of intervals, the first of which begins now. Any thread. */
  public TickReader tickReader() {
    return new TickReader();
  }

  private void collect() {
    interval = tickTimes.getIntervalHistogram(interval);
    total.add(interval);
  }

  /** Reads the tick times interval by interval, independent of other readers. Any thread. */
  public final class TickReader {
    private final Histogram since = new Histogram(LOWEST_NS, HIGHEST_NS, 2);
    private final Histogram seen = new Histogram(LOWEST_NS, HIGHEST_NS, 2);

    private TickReader() {
      take();
    }

    /** Returns the tick times since the last call, and begins another interval. */
    public TickTimes take() {
      synchronized (Counters.this) {
        collect();
        total.copyInto(since);
        since.subtract(seen);
        total.copyInto(seen);
        return TickTimes.of(since);
      }
    }
  }

  /**
   * Returns how many ticks since the start took at most so long, for each limit. Any thread, one at
   * a time.
   *
   * @param limitsNs limits, ns, rising
   */
  public synchronized TickHistogram histogram(long... limitsNs) {
    collect();
    List<Long> atMost =
        Arrays.stream(limitsNs).mapToObj(limit -> total.getCountBetweenValues(0, limit)).toList();
    return new TickHistogram(
        atMost, total.getTotalCount(), total.getMean() * total.getTotalCount());
  }

  /**
   * Tick times since the start.
   *
   * @param atMost number of ticks that took at most each limit
   * @param count number of ticks
   * @param sumNs time that all took, ns
   */
  public record TickHistogram(List<Long> atMost, long count, double sumNs) {}

  /**
   * The distribution of tick times.
   *
   * @param count number of ticks
   * @param p50Ns median, ns
   * @param p99Ns 99th percentile, ns
   * @param maxNs longest time, ns
   */
  public record TickTimes(long count, long p50Ns, long p99Ns, long maxNs) {
    private static final TickTimes NONE = new TickTimes(0, 0, 0, 0);

    private static TickTimes of(Histogram histogram) {
      if (histogram.getTotalCount() == 0) {
        return NONE;
      }
      return new TickTimes(
          histogram.getTotalCount(),
          histogram.getValueAtPercentile(50),
          histogram.getValueAtPercentile(99),
          histogram.getMaxValue());
    }

    /** Returns a text for log lines: {@code tick p50 0.21 p99 0.80 max 3.10 ms}. */
    @Override
    public String toString() {
      return String.format(
          Locale.ROOT, "tick p50 %.2f p99 %.2f max %.2f ms", p50Ns / 1e6, p99Ns / 1e6, maxNs / 1e6);
    }
  }
}
