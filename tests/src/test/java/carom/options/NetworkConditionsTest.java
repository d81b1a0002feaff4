package carom.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.transport.Impairment;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;

/** Goal: flags become the network they name. Method: command lines and what comes of them. */
final class NetworkConditionsTest {
  @CommandLine.Command
  private static final class Program {
    @CommandLine.Mixin private final NetworkConditions conditions = new NetworkConditions();

    NetworkConditions conditions() {
      return conditions;
    }
  }

  private static NetworkConditions parse(String... args) {
    Program program = new Program();
    new CommandLine(program).setCaseInsensitiveEnumValuesAllowed(true).parseArgs(args);
    return program.conditions();
  }

  @Test
  void withoutFlagsNothingIsBad() {
    assertFalse(parse().isBad());
    assertFalse(parse("--network-seed", "9", "--burst", "3").isBad(), "bursts of nothing");
    assertEquals(Impairment.NONE.withSeed(9), parse("--network-seed", "9").impairment());
  }

  @Test
  void eachFlagSetsItsCondition() {
    NetworkConditions all =
        parse(
            "--loss=2",
            "--burst=3",
            "--latency=40",
            "--jitter=5",
            "--reorder=6",
            "--duplicate=7",
            "--bandwidth=64",
            "--network-seed=8");
    assertNull(all.problem());
    assertTrue(all.isBad());
    assertEquals(
        Impairment.NONE
            .withSeed(8)
            .withBursts(2, 3)
            .withLatency(40, 5)
            .withReorder(6, 7)
            .withBandwidth(64),
        all.impairment());
  }

  @Test
  void presetsHaveNamesAndGiveWayToSingleFlags() {
    for (NetworkConditions.Preset preset : NetworkConditions.Preset.values()) {
      NetworkConditions chosen = parse("--network", preset.toString());
      assertEquals(preset.impairment(), chosen.impairment());
      assertEquals(preset != NetworkConditions.Preset.NONE, chosen.isBad());
    }
    Impairment mobile = parse("--network", "mobile").impairment();
    assertEquals(
        mobile.withBursts(0, mobile.burst()),
        parse("--network", "mobile", "--loss", "0").impairment());
    assertThrows(CommandLine.ParameterException.class, () -> parse("--network", "carrier-pigeon"));
  }

  @ParameterizedTest
  @CsvSource({
    "--loss, 100.5, 0..100",
    "--loss, NaN, 0..100",
    "--burst, 0.5, 1..1000",
    "--latency, -1, 0..10000",
    "--jitter, 10001, 0..10000",
    "--reorder, 101, 0..100",
    "--duplicate, -0.1, 0..100",
    "--bandwidth, 0.5, 1..1000000",
  })
  void whatIsOutOfRangeIsNamed(String flag, String value, String range) {
    String problem = parse(flag + "=" + value).problem();
    assertTrue(problem.startsWith(flag + "=" + Double.valueOf(value)), problem);
    assertTrue(problem.endsWith(" is outside " + range), problem);
  }
}
