package carom.lab.bench;

import static java.nio.charset.StandardCharsets.UTF_8;

import carom.lab.measure.BenchJob;
import carom.lab.measure.BenchRow;
import carom.lab.measure.Entrant;
import carom.lab.measure.Measurement;
import carom.lab.measure.Times;
import carom.options.Lab;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * The job that times the start of a server with a level of 10,000 bodies, from the start of the
 * process to the end of the first tick, by the clock. In an installation it starts {@code
 * bin/carom-server}, as users do; in a build it starts the class.
 */
record StartupJob() implements BenchJob {
  /** Name of the main class, which is started by name because it uses this package. */
  private static final String SERVER = "carom.server.ServerMain";

  private static final int COLUMNS = 100;
  private static final int ROWS = 100;
  private static final int STARTS = 7;
  private static final String READY = "ready ";

  @Override
  public String name() {
    return "startup_10k";
  }

  @Override
  public List<Entrant> entrants(Choice wanted) {
    return List.of(Entrant.of(Entrant.CAROM));
  }

  @Override
  public BenchRow run(Entrant entrant, Measurement measurement) {
    int starts = measurement.quick() ? 3 : STARTS;
    double[] seconds = new double[starts];
    try {
      Path level = Files.createTempFile("carom-bench", ".json");
      try {
        Files.writeString(level, level());
        for (int i = 0; i < starts; i++) {
          seconds[i] = start(level);
        }
      } finally {
        Files.delete(level);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    Times times = Times.of(seconds, seconds.clone(), starts, Double.NaN);
    return BenchRow.of(name(), entrant, COLUMNS * ROWS, times);
  }

  /** Returns a level with stacks of boxes on a floor. */
  private static String level() {
    return String.format(
        Locale.ROOT,
        """
        {"name":"Crates","game":"platformer","gravity":[0,-10],
         "bounds":{"min":[-100,-10],"max":[100,120]},
         "spawns":[{"name":"player","at":[-90,1]},{"name":"flag","at":[90,1]}],
         "statics":[{"name":"floor","at":[0,-1],"shape":{"type":"box","width":200,"height":2}}],
         "bodies":[{"name":"crate","at":[-74.25,0.5],"shape":{"type":"box","width":1,"height":1},
           "repeat":{"columns":%d,"rows":%d,"step":[1.5,1]}}]}
        """,
        COLUMNS,
        ROWS);
  }

  private static List<String> program() {
    Path script = installed();
    if (Files.isExecutable(script)) {
      return List.of(script.toString());
    }
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-Xms256m", "-XX:+UseSerialGC", "-Dkryo.unsafe=false"));
    command.addAll(List.of("--add-exports", "java.base/jdk.internal.module=ALL-UNNAMED"));
    command.addAll(List.of("-cp", Lab.classPath(), SERVER));
    return command;
  }

  /** Returns the path of the start script if this class is in a jar of an installation. */
  private static Path installed() {
    try {
      URL mine = StartupJob.class.getProtectionDomain().getCodeSource().getLocation();
      return Path.of(mine.toURI()).resolveSibling("../../bin/carom-server").normalize();
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e); // the JVM made it
    }
  }

  private static double start(Path level) throws IOException {
    List<String> command = new ArrayList<>(program());
    command.addAll(List.of("--tcp-port=0", "--udp-port=0"));
    command.addAll(List.of("--log-level=error", "--level=" + level));
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
    long begin = System.nanoTime();
    Process server = builder.start();
    StringBuilder said = new StringBuilder();
    try (BufferedReader in =
        new BufferedReader(new InputStreamReader(server.getInputStream(), UTF_8))) {
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        if (line.startsWith(READY)) {
          return (System.nanoTime() - begin) * 1e-9;
        }
        said.append(line).append(System.lineSeparator());
      }
    } finally {
      server.destroyForcibly();
    }
    throw new IOException("the server ended before it was ready: " + said);
  }
}
