package carom.lab.trace;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.Locale;

/**
 * The size and cost of a coded trace. An encoder and a separate decoder, which gets only the bytes,
 * run over the trace, and the decoded snapshots are compared with the originals.
 *
 * @param bodies number of bodies of the trace
 * @param snapshots number of snapshots sent
 * @param kbitPerSecond of all snapshots, whole bytes, 1 kbit = 1000 bits, with those before the
 *     first acknowledgement
 * @param meanBytes per snapshot
 * @param p99Bytes 99 of 100 snapshots have at most so many
 * @param maxBytes the largest; without a baseline, so mostly the first
 * @param unackedBytes of the first snapshots, before anything was acknowledged, in all
 * @param encodeNsPerBody processor time per body and snapshot
 * @param decodeNsPerBody the same of the decoder
 * @param exact whether every snapshot came out as it went in
 */
public record TraceReport(
    int bodies,
    int snapshots,
    double kbitPerSecond,
    double meanBytes,
    int p99Bytes,
    int maxBytes,
    int unackedBytes,
    double encodeNsPerBody,
    double decodeNsPerBody,
    boolean exact) {

  private static final int WARM_UP_SNAPSHOTS = 300;

  /**
   * Measures a trace. Snapshot n is its tick n hz / rate, rounded down. A part is run first, not
   * counted, so that the code is compiled when the time is taken.
   *
   * @param rate snapshots per second, 1..hz
   * @param lag how many snapshots the newest acknowledged one is behind, 1..{@link
   *     TraceCodec#MAX_LAG}
   * @param fields {@link TraceCodec#POSE} or {@link TraceCodec#FULL}
   * @throws IllegalArgumentException for numbers out of range, naming them
   */
  public static TraceReport of(Trace trace, int rate, int lag, int fields) {
    if (rate < 1 || rate > trace.hz()) {
      throw new IllegalArgumentException("rate=" + rate + " is outside 1.." + trace.hz() + " (hz)");
    }
    run(trace, rate, lag, fields, WARM_UP_SNAPSHOTS);
    return run(trace, rate, lag, fields, Integer.MAX_VALUE);
  }

  private static TraceReport run(Trace trace, int rate, int lag, int fields, int most) {
    int snapshots = (int) Math.min(most, ((long) trace.ticks() * rate - 1) / trace.hz() + 1);
    TraceCodec encoder = new TraceCodec(trace.bodies(), lag, rate, fields);
    TraceCodec decoder = new TraceCodec(trace.bodies(), lag, rate, fields);
    int[][] state = new int[fields][trace.bodies()];
    int[][] decoded = new int[fields][trace.bodies()];
    byte[] bytes = new byte[encoder.maxBytes()];
    int[] lengths = new int[snapshots];
    long total = 0;
    int unacked = 0;
    long encodeNs = 0;
    long decodeNs = 0;
    boolean exact = true;
    ThreadMXBean clock = ManagementFactory.getThreadMXBean();
    for (int n = 0; n < snapshots; n++) {
      trace.quantize((int) ((long) n * trace.hz() / rate), fields, state);
      long start = clock.getCurrentThreadCpuTime();
      int length = encoder.encode(state, bytes);
      long middle = clock.getCurrentThreadCpuTime();
      // The decoder gets an array that holds these bytes and no other.
      byte[] datagram = Arrays.copyOf(bytes, length);
      long again = clock.getCurrentThreadCpuTime();
      exact &= decoder.decode(datagram, length, decoded) && Arrays.deepEquals(state, decoded);
      decodeNs += clock.getCurrentThreadCpuTime() - again;
      encodeNs += middle - start;
      lengths[n] = length;
      total += length;
      unacked += n < lag ? length : 0;
    }
    Arrays.sort(lengths);
    double visits = (double) trace.bodies() * snapshots;
    return new TraceReport(
        trace.bodies(),
        snapshots,
        total * 8.0 * rate / snapshots / 1_000,
        (double) total / snapshots,
        lengths[(99 * snapshots + 99) / 100 - 1],
        lengths[snapshots - 1],
        unacked,
        encodeNs / visits,
        decodeNs / visits,
        exact);
  }

  /** Returns the report as one line of JSON with the names of the components. */
  public String toJson() {
    return String.format(
        Locale.ROOT,
        "{\"kbitPerSecond\":%.2f,\"meanBytes\":%.2f,\"p99Bytes\":%d,\"maxBytes\":%d,"
            + "\"encodeNsPerBody\":%.1f,\"decodeNsPerBody\":%.1f,\"exact\":%b,"
            + "\"bodies\":%d,\"snapshots\":%d,\"unackedBytes\":%d}",
        kbitPerSecond,
        meanBytes,
        p99Bytes,
        maxBytes,
        encodeNsPerBody,
        decodeNsPerBody,
        exact,
        bodies,
        snapshots,
        unackedBytes);
  }
}
