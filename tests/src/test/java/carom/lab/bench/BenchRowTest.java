package carom.lab.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.lab.measure.BenchRow;
import carom.lab.measure.Entrant;
import carom.lab.measure.Scaling;
import carom.lab.measure.Times;
import carom.sim.scene.SceneReport;
import carom.suite.Needs;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Rows survive their way between processes, gates see what is wrong, and tables mark it. */
@Needs("waits")
class BenchRowTest {
  private static final Entrant CAROM = new Entrant("carom", "vector", 2);

  private static BenchRow row(Entrant entrant, double ms) {
    Times times = Times.of(new double[] {ms / 1e3}, new double[] {ms / 1e3}, 1, 0);
    return BenchRow.of("large_pyramid", entrant, 5050, times)
        .withHash(0xabc)
        .withEnd(3, 5050, end(10, 0.01f, 0));
  }

  private static SceneReport end(double energy, float depth, int nans) {
    return new SceneReport(energy, 0, 50, 1, nans, 9, 2, depth, 0, 0.5f);
  }

  @Test
  void jsonReadsBackAsTheSameRow() throws IOException {
    BenchRow full =
        row(CAROM, 2)
            .withStages(Map.of("pairs", 0.25))
            .withRatios(Map.of("jbox2d", 17.0))
            .withScaling(new Scaling(1.5, 1.8, 0.8))
            .withFault("a \"quoted\" fault");
    assertEquals(full, BenchRow.ofJson(full.toJson()));
    BenchRow failed = BenchRow.failed("gas_1k", Entrant.of("dyn4j"), "no such thing");
    assertEquals(failed, BenchRow.ofJson(failed.toJson()));
    String older = full.toJson().replaceAll("\"(speedUp|ceiling|share)\":[0-9.]+,", "");
    assertFalse(BenchRow.ofJson(older).scaling().isMeasured(), "programs of others lack these");
    assertThrows(IOException.class, () -> BenchRow.ofJson("{\"scene\":\"gas_1k\"}"));
    assertThrows(IOException.class, () -> BenchRow.ofJson("Exception in thread"));
  }

  @Test
  void timesAreMedianAndNinetyNinthOfAHundred() {
    double[] seconds = new double[200];
    for (int i = 0; i < seconds.length; i++) {
      seconds[i] = (200 - i) / 1e3;
    }
    Times times = Times.of(seconds, seconds.clone(), 200, 1000);
    assertEquals(101, times.medianMs(), 1e-9);
    assertEquals(198, times.p99Ms(), 1e-9);
    assertEquals(5, times.allocatedBytes());
  }

  @Test
  void gatesNameWhatIsWrong() {
    Gate gate = Gate.still(500, 105);
    assertEquals("", gate.fault(end(10, 0.01f, 0), 5));
    assertTrue(gate.fault(end(501, 0.01f, 0), 5).contains("kinetic energy"));
    assertTrue(gate.fault(end(10, 0.11f, 0), 5).contains("penetration"));
    assertTrue(gate.fault(end(10, 0.01f, 1), 5).contains("not finite"));
    assertTrue(gate.joined(0.4).fault(end(10, 0.01f, 0), 5).contains("joint gap"));
    assertTrue(gate.asleepBut(4).fault(end(10, 0.01f, 0), 5).contains("5 bodies are awake"));
    assertTrue(Gate.elastic(100, 105).fault(end(90, 0.01f, 0), 5).contains("below"));
    assertTrue(Gate.still(500, 49).fault(end(10, 0.01f, 0), 5).contains("distance"));
  }

  /** Two worlds of one thread each are a ceiling; the thread that measures is one of the two. */
  @Test
  void scalingIsMeasuredBesideTheSharedWorld() {
    BenchScene scene = BenchScene.of("gas_1k");
    try (ScalingMeter meter = new ScalingMeter(scene.scene(), 2, 3)) {
      assertFalse(meter.result().isMeasured());
      meter.slice(new double[] {1, 2, 3});
      meter.slice(new double[] {1, 2, 3, 4, 5});
      Scaling scaling = meter.result();
      assertTrue(scaling.isMeasured());
      assertTrue(scaling.speedUp() > 0 && scaling.ceiling() > 0 && scaling.share() > 0);
      String table = BenchTable.plain(List.of(row(CAROM, 2).withScaling(scaling)));
      assertTrue(table.contains("speed-up  ceiling  share"), table);
    }
    assertTrue(scene.isBusy());
    assertFalse(BenchScene.of("asleep_20k").isBusy());
  }

  @Test
  void whatTheEngineDoesNotUseHasATableOfItsOwn() {
    List<String> lines =
        BenchTable.plain(List.of(row(Entrant.of("lab_cache"), 1), row(CAROM, 2))).lines().toList();
    assertTrue(lines.get(1).contains(CAROM.toString()), lines.toString());
    assertEquals("", lines.get(2));
    assertTrue(lines.get(3).contains("lab (not in the engine)"), lines.toString());
    assertTrue(lines.get(4).contains("lab_cache"), lines.toString());
  }

  @Test
  void figuresOfRunsThatFailedAreMarked() {
    BenchRow peer = row(Entrant.of("dyn4j"), 64).withFault("kinetic energy J 9e4 above 500");
    BenchRow carom = row(CAROM, 2).withRatios(Map.of("dyn4j", 32.0));
    assertTrue(carom.counts());
    assertFalse(peer.counts());
    String table = BenchTable.plain(List.of(carom, peer));
    assertTrue(table.contains(" 2.000 "), table);
    assertTrue(table.contains("64.000!"), table);
    assertTrue(table.contains("32.00!"), "in the table of ratios: " + table);
    assertTrue(BenchTable.markdown(List.of(peer)).contains("64.000! |"));
  }
}
