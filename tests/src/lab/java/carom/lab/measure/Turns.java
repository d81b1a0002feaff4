package carom.lab.measure;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.io.UncheckedIOException;

/**
 * The turns of a measuring process to use the machine.
 *
 * <p>The entrants of a job are processes that live at the same time and take turns: all of them do
 * their first slice, then all their second one. What slows the machine for a second or a minute
 * then slows all of them alike, and their ratios hold. A byte on standard input gives the turn, the
 * line {@value #PASSED} on standard output gives it back, and so does ending. Not thread-safe.
 */
public final class Turns {
  /** The line that gives the turn back. */
  public static final String PASSED = "turn";

  private final InputStream in;
  private final PrintStream out;

  /**
   * Creates the turns of this process, which doesn't have the turn yet.
   *
   * @param in a byte on it gives the turn
   * @param out a line on it gives the turn back
   */
  public Turns(InputStream in, PrintStream out) {
    this.in = in;
    this.out = out;
  }

  /**
   * Waits for the turn.
   *
   * @throws UncheckedIOException if the process that gives the turn has ended
   */
  public void take() {
    try {
      if (in.read() < 0) {
        throw new IOException("no more turns");
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Gives the turn to the others and waits for the next one.
   *
   * @throws UncheckedIOException as {@link #take}
   */
  public void pass() {
    out.println(PASSED);
    out.flush();
    take();
  }
}
