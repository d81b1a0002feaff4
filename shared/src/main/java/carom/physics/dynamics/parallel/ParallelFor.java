package carom.physics.dynamics.parallel;

import carom.physics.threads.Workers;

/**
 * Cuts a stage of the step into pieces for a world's {@link Workers}, or does it at once where
 * there are none or too little is to do.
 */
public final class ParallelFor implements Workers.Task {
  /**
   * Pieces that a stage must have to be shared: fewer aren't worth the microsecond that it takes to
   * hand some over and to wait for the end.
   */
  private static final int FEWEST_PIECES = 6;

  /** Steps with fewer moving bodies aren't shared: they take a fraction of a millisecond. */
  private static final int FEWEST_BODIES = 500;

  private Workers workers;
  private int count = 1;

  /** Whether a step is on that is worth sharing. */
  private boolean sharing;

  // The run at hand.
  private Range range;
  private int begin;
  private int size;
  private int pieces;

  /** A stage that can be done for a part of its elements. */
  @FunctionalInterface
  public interface Range {
    /**
     * Does it.
     *
     * @param from first element
     * @param to behind the last
     * @param worker number below {@link #count} that chooses scratch memory
     */
    void run(int from, int to, int worker);
  }

  /** Hires, or lets go with null. */
  public void use(Workers hired) {
    workers = hired;
    count = hired == null ? 1 : hired.count();
  }

  /** Threads, the caller included. */
  public int count() {
    return count;
  }

  /** Has the workers ready for a step, if it is worth it. */
  public void stepBegins(int bodies) {
    sharing = count > 1 && bodies >= FEWEST_BODIES;
    if (sharing) {
      workers.stepBegins();
    }
  }

  /** Must be called when nothing of the step is left to share. */
  public void stepEnds() {
    if (sharing) {
      sharing = false;
      workers.stepEnds();
    }
  }

  /** Whether a step is on that is shared. */
  public boolean isSharing() {
    return sharing;
  }

  /** Whether a stage of some elements is shared at all. */
  public boolean shares(int size, int grain) {
    return sharing && size / grain >= FEWEST_PIECES;
  }

  /**
   * Does a stage whose elements touch nothing in common.
   *
   * @param grain how many elements make a piece: a microsecond or two of work, so that nobody waits
   *     long for the last one, and taking it costs nothing beside it
   */
  public void run(int from, int to, int grain, Range stage) {
    size = to - from;
    if (!shares(size, grain)) {
      if (size > 0) {
        stage.run(from, to, 0);
      }
      return;
    }
    begin = from;
    pieces = size / grain;
    range = stage;
    workers.run(pieces, this);
  }

  /** Does so many pieces, large or small, where a step is shared by one worker each. */
  public void each(int number, Range stage) {
    if (!sharing || number == 1) {
      stage.run(0, number, 0);
      return;
    }
    begin = 0;
    size = number;
    pieces = number;
    range = stage;
    workers.run(number, this);
  }

  /** Returns the threads that share the steps, null for none. */
  public Workers workers() {
    return workers;
  }

  @Override
  public void run(int task, int worker) {
    int from = (int) ((long) size * task / pieces);
    int to = (int) ((long) size * (task + 1) / pieces);
    range.run(begin + from, begin + to, worker);
  }
}
