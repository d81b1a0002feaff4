package carom.physics.dynamics.store;

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

  /** Tells whether a step is on that is worth sharing. */
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
     * Does the stage for some elements.
     *
     * @param from first element
     * @param to behind the last
     * @param worker number below {@link #count} that chooses scratch memory
     */
    void run(int from, int to, int worker);
  }

  /** Sets the threads that share the next steps, null for none. */
  public void use(Workers threads) {
    workers = threads;
    count = threads == null ? 1 : threads.count();
  }

  /** Returns the number of threads, the caller included. */
  public int count() {
    return count;
  }

  /** Announces a step to the workers, if it has enough moving bodies to be shared. */
  public void stepBegins(int bodies) {
    sharing = count > 1 && bodies >= FEWEST_BODIES;
    if (sharing) {
      workers.stepBegins();
    }
  }

  /** Tells the workers that nothing of the step is left to share. Must follow each begin. */
  public void stepEnds() {
    if (sharing) {
      sharing = false;
      workers.stepEnds();
    }
  }

  /** Returns whether a step is on that is shared. */
  public boolean isSharing() {
    return sharing;
  }

  /** Returns whether a stage of some elements is shared at all. */
  public boolean shares(int size, int grain) {
    return sharing && size / grain >= FEWEST_PIECES;
  }

  /**
   * Does a stage whose elements touch nothing in common.
   *
   * @param grain how many elements make a piece: a microsecond or two of work, so that no thread
   *     waits long for the last one, and taking it costs nothing beside it
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

  /** Does a stage of a given number of pieces, each by one worker where the step is shared. */
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
