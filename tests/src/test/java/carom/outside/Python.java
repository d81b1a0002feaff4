package carom.outside;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/** Python with packages that others wrote, installed by pip into the build folder. */
public final class Python {
  private static final long INSTALL_S = 240;
  private static final long RUN_S = 60;

  private final Path folder;
  private final Path environment;

  /**
   * Installs packages, once in each build folder; skips the test where there is no Python.
   *
   * @param folder takes what programs print
   * @param name of the folder of the packages below the build folder
   * @param packages with their versions, such as {@code rcon==2.4.9}
   */
  public Python(Path folder, String name, List<String> packages) throws Exception {
    this.folder = folder;
    environment = Path.of("build", name).toAbsolutePath();
    Path done = environment.resolve("packages.txt");
    if (Files.exists(done) && Files.readAllLines(done).equals(packages)) {
      return;
    }
    Ran ran;
    try {
      ran = run(INSTALL_S, List.of("python3", "-m", "venv", "--clear", environment.toString()));
    } catch (IOException e) {
      ran = new Ran(-1, e.getMessage());
    }
    if (ran.status != 0) {
      assertFalse(System.getenv("CI") != null, "CI has no Python: .ci/run installs it: " + ran);
      System.err.println("SKIPPED: no python3 with venv and pip here, so no stock client asks");
    }
    assumeTrue(ran.status == 0, "no python3 with venv and pip: " + ran.text);
    Stream<String> pip = Stream.of(program(), "-m", "pip", "install", "-q");
    ran = run(INSTALL_S, Stream.concat(pip, packages.stream()).toList());
    assertEquals(0, ran.status, ran.text);
    Files.write(done, packages);
  }

  /** A program's exit code and what it printed. */
  private record Ran(int status, String text) {}

  private String program() {
    return environment.resolve("bin/python").toString();
  }

  private Ran run(long seconds, List<String> command) throws Exception {
    Path output = folder.resolve("output.txt");
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().put("PYTHONIOENCODING", "utf-8");
    Process process = builder.redirectErrorStream(true).redirectOutput(output.toFile()).start();
    if (!process.waitFor(seconds, TimeUnit.SECONDS)) {
      process.destroyForcibly().waitFor();
      throw new IOException(command + " takes more than " + seconds + " s");
    }
    return new Ran(process.exitValue(), Files.readString(output));
  }

  /** Runs a script, and returns what it prints. It must end well. */
  public String run(Path script, Object... arguments) throws Exception {
    List<String> command = new ArrayList<>(List.of(program(), script.toString()));
    Stream.of(arguments).map(String::valueOf).forEach(command::add);
    Ran ran = run(RUN_S, command);
    assertEquals(0, ran.status, ran.text);
    return ran.text;
  }
}
