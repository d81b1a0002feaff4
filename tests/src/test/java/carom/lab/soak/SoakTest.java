package carom.lab.soak;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * A fresh slice of a soak in every run: other seeds each time, unless {@code -Dcarom.seed} says.
 */
final class SoakTest {
  private static final long SEED = Long.getLong("carom.seed", System.nanoTime());

  @TempDir private Path folder;

  @Test
  void aServerAndSixteenClientsThatPredictLiveThroughHalfAMinute() throws Exception {
    soak(new Soak.Settings(SEED, 30, 16, true, folder));
  }

  @Test
  void aServerAndSixteenClientsLiveThroughThreeMinutes() throws Exception {
    soak(new Soak.Settings(SEED + 1, 180, 16, false, folder));
  }

  private static void soak(Soak.Settings settings) throws Exception {
    Soak soak = new Soak(settings);
    try {
      soak.run(Incident.script(settings.seed(), settings.seconds(), settings.clients()));
    } catch (AssertionError | RuntimeException e) {
      throw new AssertionError(
          "seed=%d at %.2f s; to see it again: -Dcarom.seed=%d (of the longer soak 1 less)"
              .formatted(settings.seed(), soak.elapsedS(), settings.seed()),
          e);
    }
  }

  @Test
  void equalSeedsGiveEqualScriptsAndLongerOnesGoOn() {
    List<Incident> script = Incident.script(SEED, 600, 16);
    assertEquals(script, Incident.script(SEED, 600, 16));
    List<Incident> shorter = Incident.script(SEED, 60, 16);
    assertEquals(script.subList(0, shorter.size()), shorter);
    Set<Incident.Kind> kinds = EnumSet.noneOf(Incident.Kind.class);
    script.forEach(incident -> kinds.add(incident.kind()));
    assertTrue(kinds.size() > 10, "kinds=" + kinds + " seed=" + SEED);
  }
}
