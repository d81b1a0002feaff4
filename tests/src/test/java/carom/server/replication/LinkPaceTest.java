package carom.server.replication;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ProtocolLimits;
import java.util.PriorityQueue;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** How fast a line is taken for. Method: lines of which the test knows how fast they are. */
final class LinkPaceTest {
  private static final int HZ = 60;
  private static final int MOST = 64_000;
  private static final int PAYLOAD = 150;
  private static final int WHOLE = PAYLOAD + ProtocolLimits.DATAGRAM_OVERHEAD_BYTES;

  private final LinkPace pace = new LinkPace(HZ, MOST);
  private long acked;
  private int now;
  private double lineFreeAt; // tick
  private double lineMs = 300; // there and back
  private final PriorityQueue<int[]> acks = new PriorityQueue<>((a, b) -> a[1] - b[1]);

  /**
   * Sends for some ticks whenever the pace allows it.
   *
   * @param jitterMs most that a datagram takes less or more than {@link #lineMs}
   * @param bytesPerSecond what the line carries; more waits in a queue
   */
  private void run(
      int ticks, double jitterMs, double lossPercent, double bytesPerSecond, SplittableRandom r) {
    for (int end = now + ticks; now < end; now++) {
      while (!acks.isEmpty() && acks.peek()[1] <= now) {
        int[] ack = acks.poll();
        acked += WHOLE;
        pace.acked(ack[1] - ack[0]);
      }
      pace.tick(acked);
      if (pace.allowance() >= PAYLOAD) {
        pace.sent(PAYLOAD, true);
        lineFreeAt = Math.max(lineFreeAt, now) + HZ * WHOLE / bytesPerSecond;
        if (r.nextDouble(100) >= lossPercent) {
          double ms = lineMs + r.nextDouble(-jitterMs, jitterMs);
          acks.add(new int[] {now, (int) Math.ceil(lineFreeAt + ms * HZ / 1_000)});
        }
      }
    }
  }

  private void silence(int ticks) {
    acks.clear();
    for (int i = 0; i < ticks; i++, now++) {
      pace.tick(acked);
      if (pace.allowance() >= PAYLOAD) {
        pace.sent(PAYLOAD, true);
      }
    }
  }

  /**
   * Goal: after a silence, a line with jitter is fast again soon, though few acks tell how fast it
   * is. Method: 200 seeds; most acks are lost.
   */
  @Test
  void aLineWithJitterIsFastAgainSoonAfterASilence() {
    int slow = 0;
    for (long seed = 1; seed <= 200; seed++) {
      LinkPaceTest line = new LinkPaceTest();
      SplittableRandom r = new SplittableRandom(seed);
      line.run(10 * HZ, 40, 60, 1e6, r);
      line.silence(3 * HZ);
      assertTrue(line.pace.bytesPerSecond() <= 3_000, "seed=" + seed);
      line.run(4 * HZ, 40, 60, 1e6, r);
      slow += line.pace.bytesPerSecond() < MOST / 4 ? 1 : 0;
    }
    assertTrue(slow <= 4, "slow=" + slow);
  }

  /**
   * Goal: a line that becomes longer, such as from a home network to a phone's, isn't taken for a
   * slow one. Method: 100 seeds, with jitter and loss; the empty line was 200 ms shorter before.
   */
  @Test
  void aLineThatBecomesLongerIsFastAgainInThreeSeconds() {
    int slow = 0;
    for (long seed = 1; seed <= 100; seed++) {
      LinkPaceTest line = new LinkPaceTest();
      SplittableRandom r = new SplittableRandom(seed);
      line.lineMs = 40;
      line.run(8 * HZ, 10, 1, 1e6, r);
      line.lineMs = 240;
      line.run(3 * HZ, 30, 5, 1e6, r);
      slow += line.pace.bytesPerSecond() < MOST / 4 ? 1 : 0;
    }
    assertTrue(slow <= 2, "slow=" + slow);
  }

  @ParameterizedTest
  @ValueSource(ints = {6_000, 12_000, 30_000})
  void aSlowLinesQueueStaysShort(int bytesPerSecond) {
    SplittableRandom r = new SplittableRandom(1);
    run(20 * HZ, 5, 2, bytesPerSecond, r);
    double longestMs = 0;
    for (int i = 0; i < 20 * HZ; i++) {
      run(1, 5, 2, bytesPerSecond, r);
      longestMs = Math.max(longestMs, (lineFreeAt - now) * 1_000 / HZ);
    }
    String about = "bytesPerSecond=" + bytesPerSecond + " longestMs=" + longestMs;
    assertTrue(longestMs < 800, about + " pace=" + pace.bytesPerSecond());
  }
}
