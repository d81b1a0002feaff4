package carom.lab.bench;

import static java.nio.charset.StandardCharsets.UTF_8;

import carom.lab.measure.BenchRow;
import carom.lab.measure.Entrant;
import carom.lab.measure.Turns;
import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.nio.file.Files;
import java.util.List;

/** One entrant's process, seen from the command that lets them take turns; see {@link Turns}. */
final class BenchProcess implements AutoCloseable {
  private final String job;
  private final Entrant entrant;
  private final File errors;
  private final Process process;
  private final OutputStream turns;
  private final BufferedReader answers;
  private BenchRow row;

  /**
   * Starts it. It does nothing until it gets its first {@link #turn}.
   *
   * @param job what it measures
   * @param entrant who it is
   * @param command to run
   * @throws IOException if there is no such program
   */
  BenchProcess(String job, Entrant entrant, List<String> command) throws IOException {
    this.job = job;
    this.entrant = entrant;
    errors = File.createTempFile("carom-bench", ".err");
    try {
      process = new ProcessBuilder(command).redirectError(errors).start();
    } catch (IOException e) {
      Files.deleteIfExists(errors.toPath());
      throw e;
    }
    turns = process.getOutputStream();
    answers = new BufferedReader(new InputStreamReader(process.getInputStream(), UTF_8));
  }

  Entrant entrant() {
    return entrant;
  }

  /**
   * Lets it measure a slice, and waits until it passes its turn on or ends.
   *
   * @return whether it has more to do; if not, there is a {@link #row}
   */
  boolean turn() throws IOException, InterruptedException {
    try {
      turns.write('\n');
      turns.flush();
    } catch (IOException e) {
      // It has ended; what it said before tells why.
    }
    String last = "";
    for (String line = answers.readLine(); line != null; line = answers.readLine()) {
      if (line.equals(Turns.PASSED)) {
        return true;
      }
      last = line.isBlank() ? last : line;
    }
    int status = process.waitFor();
    row = status == 0 ? rowOf(last) : BenchRow.failed(job, entrant, fault(status));
    return false;
  }

  /** Returns what somebody else's program says amiss costs its row, not those of all others. */
  private BenchRow rowOf(String json) {
    try {
      return BenchRow.ofJson(json);
    } catch (IOException e) {
      return BenchRow.failed(job, entrant, e.getMessage());
    }
  }

  /** Returns the result, once a {@link #turn} was the last one. */
  BenchRow row() {
    return row;
  }

  /** Returns the first line that looks like an exception. */
  private String fault(int status) throws IOException {
    return Files.readAllLines(errors.toPath()).stream()
        .filter(line -> line.contains("Exception") || line.contains("Error"))
        .findFirst()
        .map(line -> line.replaceFirst("^Exception in thread \"[^\"]*\" ", ""))
        .orElse("ended with status " + status);
  }

  /** Ends it if it still runs. Any thread. */
  @Override
  public void close() {
    process.destroyForcibly();
    errors.delete();
  }
}
