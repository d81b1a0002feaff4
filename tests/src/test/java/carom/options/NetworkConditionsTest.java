package carom.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;

/** Goal: flags become the network they name. Method: command lines and what comes of them. */
final class NetworkConditionsTest {
  private static ServerConfig parse(String... args) {
    CommandLine program = new CommandLine(CommandLine.Model.CommandSpec.create());
    Flags.add(program.getCommandSpec(), NetworkConditions.ROWS);
    return Flags.read(new ServerConfig(), program.parseArgs(args), NetworkConditions.ROWS);
  }

  private static boolean isBad(String... args) {
    return NetworkConditions.isBad(parse(args));
  }

  private static Impairment impairment(String... args) {
    return NetworkConditions.impairment(parse(args));
  }

  @Test
  void withoutFlagsNothingIsBad() {
    assertFalse(isBad());
    assertFalse(isBad("--network-seed", "9", "--burst", "3"), "bursts of nothing");
    assertEquals(Impairment.NONE.withSeed(9), impairment("--network-seed", "9"));
  }

  @Test
  void eachFlagSetsItsCondition() {
    ServerConfig all =
        parse(
            "--loss=2",
            "--burst=3",
            "--latency=40",
            "--jitter=5",
            "--reorder=6",
            "--duplicate=7",
            "--bandwidth=64",
            "--network-seed=8");
    assertTrue(NetworkConditions.isBad(all));
    assertEquals(
        Impairment.NONE
            .withSeed(8)
            .withBursts(2, 3)
            .withLatency(40, 5)
            .withReorder(6, 7)
            .withBandwidth(64),
        NetworkConditions.impairment(all));
  }

  @Test
  void presetsHaveNamesAndGiveWayToSingleFlags() {
    for (NetworkConditions.Preset preset : NetworkConditions.Preset.values()) {
      assertEquals(preset.impairment(), impairment("--network", preset.toString()));
      assertEquals(preset != NetworkConditions.Preset.NONE, isBad("--network", preset.toString()));
    }
    Impairment mobile = impairment("--network", "mobile");
    assertEquals(
        mobile.withBursts(0, mobile.burst()), impairment("--network", "mobile", "--loss", "0"));
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
    String problem = assertThrows(BadFlag.class, () -> parse(flag + "=" + value)).getMessage();
    assertTrue(problem.startsWith(flag + "=" + value + " is "), problem);
    assertTrue(value.equals("NaN") || problem.contains(" is outside " + range), problem);
  }
}
