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

/** The process of one entrant, for the command that hands out the turns; see {@link Turns}. */
final class BenchProcess implements AutoCloseable {
  private final String job;
  private final Entrant entrant;
  private final SceneFile scene;
  private final File errors;
  private final Process process;
  private final OutputStream turns;
  private final BufferedReader answers;
  private BenchRow row;

  /**
   * Starts the process. It does nothing until its first {@link #turn}.
   *
   * @param job the job that it measures
   * @param entrant the entrant that it measures
   * @param command the command to run
   * @param scene the scene as the program was given it, closed with this; or null
   * @throws IOException if there is no such program
   */
  BenchProcess(String job, Entrant entrant, List<String> command, SceneFile scene)
      throws IOException {
    this.job = job;
    this.entrant = entrant;
    this.scene = scene;
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
   * Lets the process measure a slice, and waits until it gives the turn back or ends.
   *
   * @return whether it has more to measure; if not, {@link #row} returns the result
   */
  boolean turn() throws IOException, InterruptedException {
    try {
      turns.write('\n');
      turns.flush();
    } catch (IOException e) {
      // The process has ended; its output tells why.
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

  /** Returns the row in a process's last line. A malformed line costs this row only. */
  private BenchRow rowOf(String json) {
    try {
      BenchRow read = BenchRow.ofJson(json);
      return scene == null ? read : scene.judged(read);
    } catch (IOException e) {
      return BenchRow.failed(job, entrant, e.getMessage());
    }
  }

  /** Returns the result, after the last {@link #turn}. */
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

  /** Ends the process if it still runs. Any thread. */
  @Override
  public void close() {
    process.destroyForcibly();
    errors.delete();
    if (scene != null) {
      scene.close();
    }
  }
}
