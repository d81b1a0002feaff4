package carom.server.config;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.options.Flags;
import carom.options.NetworkConditions;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import picocli.CommandLine.ParseResult;

/**
 * Goal: command line over environment over file over default, each with its origin. Method: the
 * server's settings.
 */
final class SettingsLayersTest {
  @TempDir private Path folder;
  private Path file;

  private ServerConfig program;
  private EffectiveSettings settings;

  @BeforeEach
  void chooseFile() {
    file = folder.resolve("carom.conf");
  }

  private SettingsLayers layers(Map<String, String> environment, String... args)
      throws BadSettingException {
    CommandLine commandLine = new CommandLine(CommandLine.Model.CommandSpec.create());
    Flags.add(commandLine.getCommandSpec(), ServerConfig.ROWS);
    Flags.add(commandLine.getCommandSpec(), ServerConfig.ONLY_FLAGS);
    ParseResult parsed = commandLine.parseArgs(args);
    Map<String, List<String>> given = Flags.given(parsed, ServerConfig.ROWS);
    given.putAll(Flags.given(parsed, ServerConfig.ONLY_FLAGS));
    SettingsLayers layers = new SettingsLayers(given, environment, Map.of());
    settings = layers.settings();
    program = settings.config();
    return layers;
  }

  private void write(String text) throws IOException {
    Files.writeString(file, text);
  }

  private SettingsLayers read(String... args) throws BadSettingException {
    return layers(Map.of("CAROM_DATA", folder.toString()), args);
  }

  private String refused(String... args) {
    return assertThrows(BadSettingException.class, () -> read(args)).getMessage();
  }

  private String origin(String name) {
    return settings.find(name).orElseThrow().origin();
  }

  @Test
  void eachLayerWinsOverTheOnesBelowAndSaysWhereItIs() throws Exception {
    write("# comment\ntick-rate = 30\ngrace = 10\nname = file\n");
    Map<String, String> environment =
        Map.of("CAROM_DATA", folder.toString(), "CAROM_GRACE", "20", "CAROM_NAME", "variable");
    SettingsLayers layers = layers(environment, "--name", "flag");
    assertEquals(file, layers.file());
    assertEquals("flag", program.get(ServerConfig.NAME));
    assertEquals("command line", origin("name"));
    assertEquals(20, program.get(ServerConfig.GRACE));
    assertEquals("environment CAROM_GRACE", origin("grace"));
    assertEquals(30, program.get(ServerConfig.TICK_RATE));
    assertEquals(file + ": 2", origin("tick-rate"));
    assertEquals("default", origin("latency"));
    assertEquals("Simulation steps per second, 10..240.", ServerConfig.TICK_RATE.doc());
    assertTrue(settings.find("config").isEmpty() && settings.find("help").isEmpty());
  }

  @Test
  void switchesTakeTheWordsOfHocon() throws Exception {
    for (String word : List.of("no", "off", "false", "OFF")) {
      write("web = " + word + "\n");
      read();
      assertFalse(program.get(ServerConfig.WEB), word);
    }
    for (String word : List.of("yes", "on", "true")) {
      write("web = " + word + "\n");
      read();
      assertTrue(program.get(ServerConfig.WEB), word);
    }
    layers(Map.of("CAROM_DATA", folder.resolve("none").toString(), "CAROM_WEB", "off"));
    assertFalse(program.get(ServerConfig.WEB));
  }

  @Test
  void numbersHaveUnitsInEveryLayer() throws Exception {
    write("grace = 2 min\n");
    layers(Map.of("CAROM_DATA", folder.toString(), "CAROM_LATENCY", "0.25s"), "--tick-rate=30hz");
    assertEquals(120, program.get(ServerConfig.GRACE));
    assertEquals(250.0, NetworkConditions.impairment(program).latencyMs());
    assertEquals(30, program.get(ServerConfig.TICK_RATE));
    for (String bad : List.of("1 parsec", "0.5 s", "1.2.3", "x", "99999999 h")) {
      Exception e = assertThrows(IllegalArgumentException.class, () -> read("--grace", bad));
      assertTrue(e.getMessage().contains("--grace=" + bad + " is "), e.getMessage());
    }
  }

  @Test
  void aListIsARepeatedFlagAndTheCommandLineReplacesIt() throws Exception {
    write("room = [\"a=arena\", \"b=platformer\"]\n");
    read();
    assertEquals(List.of("a=arena", "b=platformer"), program.get(ServerConfig.ROOM));
    String printed = settings.file();
    assertTrue(printed.contains("\nroom = [\"a=arena\", \"b=platformer\"]\n"), printed);
    read("--room", "c=arena");
    assertEquals(List.of("c=arena"), program.get(ServerConfig.ROOM));
    write("grace = [1, 2]\n");
    assertTrue(refused().contains("grace takes one value"), refused());
  }

  @Test
  void unknownNamesAreRefusedWithTheNearestOne() throws Exception {
    write("\n\ntikc-rate = 30\n");
    assertTrue(refused().contains(file + ": 3: unknown setting=tikc-rate"), refused());
    assertTrue(refused().contains("did you mean \"tick-rate\"?"), refused());
    write("network { latency = 3 }\n");
    assertTrue(refused().contains("plain lines"), refused());
    write("data = elsewhere\n");
    assertTrue(refused().contains("--data or CAROM_DATA"), refused());
    write("config = elsewhere\n");
    assertTrue(refused().contains("unknown setting=config"), refused());
  }

  @Test
  void unknownVariablesAreNamedButDoNotStopTheServer() throws Exception {
    // Kubernetes makes CAROM_PORT and such for a service named carom.
    SettingsLayers layers = layers(Map.of("CAROM_GRACEE", "1", "CAROM_NAME", "", "OTHER", "2"));
    assertEquals(1, layers.warnings().size());
    assertTrue(layers.warnings().get(0).contains("did you mean \"CAROM_GRACE\"?"));
    assertEquals("Carom", program.get(ServerConfig.NAME), "an empty variable counts as none");
  }

  @Test
  void fileThatCannotBeReadIsNamedWithWhatToDo() throws Exception {
    String missing = folder.resolve("missing.conf").toString();
    assertTrue(refused("--config", missing).contains("config=" + missing));
    assertTrue(refused("--config", missing).contains("--print-config writes one"));
    assertTrue(refused("--config", folder.toString()).contains("it is a folder"));
    write("grace = [\n");
    assertTrue(refused().startsWith(file.toString()), refused());
    write("grace = ${nowhere}\n");
    assertTrue(refused().startsWith(file.toString()), refused());
    Files.write(file, "name = \u00e9".getBytes(StandardCharsets.ISO_8859_1));
    assertTrue(refused().contains("UTF-8"), refused());
    Files.delete(file);
    assertNull(read().file(), "the usual file need not be there");
  }

  @Test
  void errorsTellWhichLayerSetTheFlagTheyName() throws Exception {
    write("grace = 99\n");
    SettingsLayers layers = read("--tick-rate", "50");
    assertEquals(
        "grace is set by " + file + ": 1", layers.origins("--grace=99 is outside 0..9, see --x"));
    assertEquals("", layers.origins("--tick-rate=5 is outside, or --grace-other"));
  }

  @Test
  void thePrintedFileHoldsWhatIsSetAndReadsBackAsTheSameSettings() throws Exception {
    write("tick-rate = 30\n");
    read("--name", "it's \"quoted\" = #1", "--latency", "40 ms");
    String printed = settings.file();
    assertTrue(
        printed.contains("# Simulation steps per second, 10..240.\ntick-rate = 30 Hz\n"), printed);
    assertTrue(printed.contains("waits, 0..600.\n#grace = 30 s\n"), printed);
    // It names its own data folder, in which it was found.
    assertTrue(printed.contains("\ndata = "), printed);
    write(printed);
    read();
    assertEquals(30, program.get(ServerConfig.TICK_RATE));
    assertEquals("it's \"quoted\" = #1", program.get(ServerConfig.NAME));
    assertEquals(40.0, NetworkConditions.impairment(program).latencyMs());
    assertEquals(printed, settings.file());

    // The defaults in the comments are those of the program.
    write(printed.replaceAll("(?m)^#(?=[a-z-]+ = [^<])", "").replaceAll("(?m)^data = .*$", ""));
    read();
    assertEquals(30, program.get(ServerConfig.GRACE));
    assertFalse(origin("grace").equals("default"));
  }
}
