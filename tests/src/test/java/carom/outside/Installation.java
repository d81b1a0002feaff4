package carom.outside;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The programs as people install and start them: by their scripts, each in a process and an
 * environment of its own. Closing it ends the processes that it started.
 */
final class Installation implements AutoCloseable {
  /** Flag of the JVM: most programs end before its second compiler has earned what it costs. */
  private static final String QUICK = "-XX:TieredStopAtLevel=1";

  private static final Path PROGRAMS = Path.of(System.getProperty("carom.install"), "bin");
  private static final Pattern READY = Pattern.compile("ready tcp=(\\S+) udp=(\\S+)");
  private static final long MOST_SECONDS = 60;

  /** A program that runs, or that has ended. */
  static final class Running {
    final Process process;
    private final Path output;

    private Running(Process process, Path output) {
      this.process = process;
      this.output = output;
    }

    /** Returns what it has written to standard output and standard error. */
    String output() throws IOException {
      return new String(Files.readAllBytes(output), StandardCharsets.UTF_8);
    }

    /** Waits until a text matches in its output, and returns the match; null when it has ended. */
    Matcher await(Pattern text) throws IOException, InterruptedException {
      long until = System.nanoTime() + TimeUnit.SECONDS.toNanos(MOST_SECONDS);
      while (System.nanoTime() - until < 0) {
        boolean ended = !process.isAlive();
        Matcher matcher = text.matcher(output());
        if (matcher.find()) {
          return matcher;
        }
        if (ended) {
          return null;
        }
        Thread.sleep(20);
      }
      throw new AssertionError("nothing like " + text + " came:\n" + output());
    }

    /** Waits until a server can be joined, and returns its TCP port; -1 when it has ended. */
    int port() throws IOException, InterruptedException {
      Matcher ready = await(READY);
      return ready == null ? -1 : Integer.parseInt(ready.group(1));
    }

    /** Writes a line to its standard input. */
    void type(byte[] line) throws IOException {
      OutputStream in = process.getOutputStream();
      in.write(line);
      in.write('\n');
      in.flush();
    }

    /** Writes a line in UTF-8 to its standard input. */
    void type(String line) throws IOException {
      type(line.getBytes(StandardCharsets.UTF_8));
    }

    /** Waits for its end and returns its exit code. */
    int end() throws IOException, InterruptedException {
      if (!process.waitFor(MOST_SECONDS, TimeUnit.SECONDS)) {
        throw new AssertionError("it still runs:\n" + output());
      }
      return process.exitValue();
    }
  }

  private final Path folder;
  private final List<Running> started = new ArrayList<>();

  /** Creates one whose programs start in a folder, into which their output goes, too. */
  Installation(Path folder) {
    this.folder = folder;
  }

  /**
   * Starts a program.
   *
   * @param environment variables beside those of the tests
   */
  Running start(Map<String, String> environment, String program, String... arguments)
      throws IOException {
    Path output = folder.resolve("output-" + started.size() + ".txt");
    List<String> command = new ArrayList<>(List.of(PROGRAMS.resolve(program).toString()));
    command.addAll(List.of(arguments));
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.directory(folder.toFile()).redirectErrorStream(true).redirectOutput(output.toFile());
    builder.environment().remove("JAVA_TOOL_OPTIONS");
    builder.environment().putAll(environment);
    builder.environment().merge("JAVA_OPTS", QUICK, (given, quick) -> given + " " + quick);
    Running running = new Running(builder.start(), output);
    started.add(running);
    return running;
  }

  /** Starts a server on free ports of this machine that keeps its files in a folder. */
  Running server(Map<String, String> environment, String data, String... arguments)
      throws IOException {
    List<String> all = new ArrayList<>(List.of("--tcp-port=0", "--udp-port=0", "--web-port=0"));
    all.addAll(List.of("--bind=127.0.0.1", "--data=" + data));
    all.addAll(List.of(arguments));
    return start(environment, "carom-server", all.toArray(new String[0]));
  }

  /** Returns a text in ISO 8859-1, which is no UTF-8 if the text has other letters than ASCII. */
  static byte[] latin(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  @Override
  public void close() {
    started.forEach(running -> running.process.destroyForcibly());
    started.forEach(running -> running.process.onExit().join());
  }
}
