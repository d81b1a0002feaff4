package carom.server.config;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParseResult;

/**
 * Goal: command line over environment over file over default, each with its origin. Method: a small
 * program with settings of each kind.
 */
final class SettingsLayersTest {
  @TempDir private Path folder;
  private Path file;

  /** A program with a setting of each kind. */
  @CommandLine.Command(name = "program")
  static final class Program {
    @Option(names = "--data", defaultValue = "no-such-folder", description = "Data.")
    String data;

    @Option(names = "--config", paramLabel = "FILE", description = "File.")
    String config;

    @Option(names = "--print-config", description = "Prints.")
    boolean print;

    @Option(
        names = "--tick-rate",
        paramLabel = "HZ",
        defaultValue = "60",
        description = "Steps (${DEFAULT-VALUE}).")
    int tickRate;

    @Option(
        names = "--grace",
        paramLabel = "S",
        defaultValue = "30",
        description = "Waits (${DEFAULT-VALUE}).")
    int grace;

    @Option(names = "--latency", paramLabel = "MS", description = "Delay (none).")
    Double latency;

    @Option(names = "--name", defaultValue = "two words", description = "Name.")
    String name;

    @Option(names = "--room", description = "Rooms.")
    List<String> rooms = new ArrayList<>();

    @Option(
        names = "--web",
        arity = "0..1",
        negatable = true,
        fallbackValue = "true",
        defaultValue = "true",
        description = "Page (${DEFAULT-VALUE}).")
    boolean web;

    @Option(names = "--help", usageHelp = true)
    boolean help;
  }

  private final Program program = new Program();
  private EffectiveSettings settings;

  @BeforeEach
  void chooseFile() {
    file = folder.resolve("carom.conf");
  }

  private SettingsLayers layers(Map<String, String> environment, String... args)
      throws BadSettingException {
    CommandLine commandLine = new CommandLine(program);
    SettingsLayers layers =
        new SettingsLayers(commandLine.getCommandSpec(), Arrays.asList(args), environment);
    ParseResult parsed = commandLine.parseArgs(layers.arguments());
    settings = layers.settings(parsed);
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
    assertEquals("flag", program.name);
    assertEquals("command line", origin("name"));
    assertEquals(20, program.grace);
    assertEquals("environment CAROM_GRACE", origin("grace"));
    assertEquals(30, program.tickRate);
    assertEquals(file + ": 2", origin("tick-rate"));
    assertNull(program.latency);
    assertEquals("default", origin("latency"));
    assertEquals("Steps.", settings.find("tick-rate").orElseThrow().doc());
    assertTrue(settings.find("config").isEmpty() && settings.find("help").isEmpty());
  }

  @Test
  void switchesTakeTheWordsOfHocon() throws Exception {
    for (String word : List.of("no", "off", "false", "OFF")) {
      write("web = " + word + "\n");
      read();
      assertFalse(program.web, word);
    }
    for (String word : List.of("yes", "on", "true")) {
      write("web = " + word + "\n");
      read();
      assertTrue(program.web, word);
    }
    layers(Map.of("CAROM_DATA", folder.resolve("none").toString(), "CAROM_WEB", "off"));
    assertFalse(program.web);
  }

  @Test
  void numbersHaveUnitsInEveryLayer() throws Exception {
    write("grace = 2 min\n");
    layers(Map.of("CAROM_DATA", folder.toString(), "CAROM_LATENCY", "0.25s"), "--tick-rate=30hz");
    assertEquals(120, program.grace);
    assertEquals(250.0, program.latency);
    assertEquals(30, program.tickRate);
    for (String bad : List.of("1 parsec", "0.5 s", "1.2.3", "x", "99999999 h")) {
      CommandLine.ParameterException e =
          assertThrows(CommandLine.ParameterException.class, () -> read("--grace", bad));
      assertTrue(e.getMessage().contains("'" + bad + "' is "), e.getMessage());
    }
  }

  @Test
  void aListIsARepeatedFlagAndTheCommandLineReplacesIt() throws Exception {
    write("room = [\"a=arena\", \"b=platformer\"]\n");
    read();
    assertEquals(List.of("a=arena", "b=platformer"), program.rooms);
    String printed = settings.file();
    assertTrue(printed.contains("\nroom = [\"a=arena\", \"b=platformer\"]\n"), printed);
    program.rooms.clear();
    read("--room", "c=arena");
    assertEquals(List.of("c=arena"), program.rooms);
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
    assertEquals("two words", program.name, "an empty variable counts as none");
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
    SettingsLayers layers = read("--tick-rate", "5");
    assertEquals(
        "grace is set by " + file + ": 1", layers.origins("--grace=99 is outside 0..9, see --x"));
    assertEquals("", layers.origins("--tick-rate=5 is outside, or --grace-other"));
  }

  @Test
  void thePrintedFileHoldsWhatIsSetAndReadsBackAsTheSameSettings() throws Exception {
    write("tick-rate = 30\n");
    read("--name", "it's \"quoted\" = #1", "--latency", "40 ms");
    String printed = settings.file();
    assertTrue(printed.contains("# Steps.\ntick-rate = 30 Hz\n"), printed);
    assertTrue(printed.contains("# Waits.\n#grace = 30 s\n"), printed);
    // It names its own data folder, in which it was found.
    assertTrue(printed.contains("\ndata = "), printed);
    write(printed);
    read();
    assertEquals(30, program.tickRate);
    assertEquals("it's \"quoted\" = #1", program.name);
    assertEquals(40.0, program.latency);
    assertEquals(printed, settings.file());

    // The defaults in the comments are those of the program.
    write(printed.replaceAll("(?m)^#(?=[a-z-]+ = [^<])", "").replaceAll("(?m)^data = .*$", ""));
    read();
    assertEquals(30, program.grace);
    assertFalse(origin("grace").equals("default"));
  }
}
