package carom.lab.figures;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.lab.measure.Figure;
import carom.suite.Needs;
import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: the table tells what was measured, and a limit that is missed can't be overlooked. Method:
 * figures made by hand, bad flags, and the jobs in virtual time, whose figures don't depend on the
 * machine.
 */
@Needs("processes")
class FiguresTest {
  @Test
  void aFigureComesBackFromJson() throws IOException {
    for (Figure figure :
        List.of(
            Figure.atMost(3, "a \"b\"", 2.5, "kbit/s").withNote("%d times", 7).of("job"),
            Figure.atLeast(99, "c", 98.9, "%").of("job"),
            Figure.shown("d", 1e9, "B").of("job"),
            Figure.failed("job", "no\nreason"))) {
      assertEquals(figure, Figure.ofJson(figure.toJson()));
    }
    assertThrows(IOException.class, () -> Figure.ofJson("{\"job\":\"x\"}"));
  }

  @Test
  void aLimitIsReachedOrMissed() {
    assertTrue(Figure.atMost(3, "", 3, "").reached());
    assertFalse(Figure.atMost(3, "", 3.001, "").reached());
    assertTrue(Figure.atLeast(99, "", 99, "").reached());
    assertFalse(Figure.atLeast(99, "", 98.99, "").reached());
    assertFalse(Figure.atMost(3, "", Double.NaN, "").reached(), "what wasn't measured is missed");
    assertFalse(Figure.failed("job", "why").reached());
    assertTrue(Figure.shown("", 1, "").reached());
  }

  @Test
  void theTableHasALineForEach() {
    String table =
        FigureTable.of(
            List.of(
                Figure.atMost(73, "codec", 42.61, "kbit/s").withNote("aim 40"),
                Figure.shown("naive", 281_750, "B/tick")));
    assertEquals(
        """
        | what | reach | measured | | note |
        | --- | --- | --- | --- | --- |
        | codec | <= 73 kbit/s | 42.6 kbit/s | reached | aim 40 |
        | naive |  | 281750 B/tick |  |  |
        """,
        table);
  }

  @Test
  void whatShipsNowhereHasATableOfItsOwn() {
    String table =
        FigureTable.of(
            List.of(
                Figure.shown("lab: a codec", 1, "").of(FigureJob.LAB_CODEC),
                Figure.shown("a snapshot", 2, "").of("snapshots")));
    assertEquals(
        """
        | what | reach | measured | | note |
        | --- | --- | --- | --- | --- |
        | a snapshot |  | 2 |  |  |

        | laboratory: in no server or client | reach | measured | | note |
        | --- | --- | --- | --- | --- |
        | lab: a codec |  | 1 |  |  |
        """,
        table);
  }

  @Test
  void anUnknownJobIsABadFlag() {
    assertEquals(2, FiguresMain.run("--only", "codex"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"snapshots", "naive", "budget", "entry"})
  void inVirtualTimeTheLimitsAreKept(String job) throws Exception {
    for (Figure figure : FigureJob.ALL.get(job).measure(true)) {
      assertTrue(figure.reached(), figure.toString());
      assertTrue(figure.value() >= 0, figure.toString());
    }
  }
}
