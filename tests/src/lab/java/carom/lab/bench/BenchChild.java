package carom.lab.bench;

import carom.lab.measure.BenchJob;
import carom.lab.measure.BenchRow;
import carom.lab.measure.Entrant;
import carom.lab.measure.Measurement;
import carom.lab.measure.Turns;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.PrintStream;

/**
 * The program of a process in which one entrant does one job. Each entrant has its own JVM, so what
 * another one compiled or collected doesn't matter. The program measures only while it has the
 * turn, and its last line on standard output is the row.
 */
final class BenchChild {
  private BenchChild() {}

  /**
   * Runs the job and prints its row.
   *
   * @param args engine, kernels, threads, job, seconds of warm-up, seconds of the cap, whether
   *     quick
   */
  public static void main(String[] args) {
    Entrant entrant = new Entrant(args[0], args[1], Integer.parseInt(args[2]));
    BenchJob job = Jobs.of(args[3]);
    PrintStream out = System.out;
    Turns turns = new Turns(new FileInputStream(FileDescriptor.in), out);
    Measurement measurement =
        new Measurement(
            Double.parseDouble(args[4]),
            Double.parseDouble(args[5]),
            Boolean.parseBoolean(args[6]),
            turns);
    turns.take();
    BenchRow row;
    try {
      row = job.run(entrant, measurement);
    } catch (UnsupportedOperationException e) {
      row = BenchRow.failed(job.name(), entrant, "not possible: " + e.getMessage());
    }
    out.println();
    out.println(row.toJson());
    out.flush();
  }
}
