package carom.server.metrics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.server.room.StageTimes;
import org.junit.jupiter.api.Test;

/** Goal: each reader sees each tick once, whatever others read. */
final class CountersTest {
  @Test
  void readersOfTickTimesDontDisturbEachOther() {
    Counters counters = new Counters();
    Counters.TickReader one = counters.tickReader();
    counters.tickTook(1_000_000);
    Counters.TickReader two = counters.tickReader();
    counters.tickTook(9_000_000);
    assertEquals(2, counters.total().count());
    assertEquals(2, one.take().count());
    assertEquals(1, two.take().count());
    assertEquals(0, one.take().maxNs());
    counters.tickTook(2_000_000);
    assertEquals(1, counters.histogram(1_000_000, 3_000_000).atMost().get(0));
    Counters.TickTimes last = two.take();
    assertEquals(1, last.count());
    assertEquals(2_000_000, last.maxNs(), 20_000);
    assertEquals(2_000_000, last.p50Ns(), 20_000);
    assertEquals(2_000_000, one.take().p99Ns(), 20_000);
  }

  @Test
  void stagesShareTheTime() {
    long[] now = {0};
    StageTimes stages = new StageTimes(() -> now[0]);
    for (int turn = 0; turn < 2; turn++) {
      now[0] += 1_000; // between the turns
      stages.begin();
      now[0] += 5;
      stages.end(TurnStage.STEP);
      now[0] += 7;
      stages.end(TurnStage.SNAPSHOTS);
    }
    assertEquals(10, stages.totalNs(TurnStage.STEP));
    assertEquals(14, stages.totalNs(TurnStage.SNAPSHOTS));
    assertEquals(0, stages.totalNs(TurnStage.PICTURE));
  }
}
