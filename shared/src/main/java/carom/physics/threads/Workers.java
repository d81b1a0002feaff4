package carom.physics.threads;

/**
 * Threads that carry out parts of a step side by side; given to a world by {@code World.workers}.
 * The engine makes no threads and decides nothing by them: every result is the same, bit for bit,
 * for any number of workers, whichever does a task, and when. Tasks of one run touch nothing in
 * common, or else decide themselves which one touches it first ({@code DomainPhases}). No task
 * needs another one to be under way.
 *
 * <p>A step makes some ten to a hundred runs, many of a few microseconds: an implementation should
 * keep its threads spinning for a while between two runs, and from {@link #stepBegins} to {@link
 * #stepEnds} for longer, and have the same thread do the tasks of the same number where it can,
 * since these are about the same part of the world. {@link WorkerThreads} is one.
 */
public interface Workers {
  /**
   * Returns how many threads may carry out tasks at once.
   *
   * @return the caller included, at least 1; always the same
   */
  int count();

  /**
   * Carries out every task once, on the calling thread and perhaps on others, in any order, and
   * returns when all are done. What the caller wrote before is visible to the tasks, and what they
   * wrote is visible to the caller afterwards. Must not allocate, and isn't called by tasks.
   *
   * @param tasks their number, at least 0
   * @param task what to do for each
   * @throws RuntimeException what one of the tasks threw, after all have ended; likewise errors
   */
  void run(int tasks, Task task);

  /**
   * Tells that a step began which is worth sharing: runs of the same thread follow, with serial
   * work in between that may take longer than an idle thread should otherwise spin for. A hint,
   * called by the thread that steps; does nothing unless overridden. The engine makes runs in
   * announced steps alone. Callbacks of the world run in between, on the same thread.
   */
  default void stepBegins() {}

  /**
   * Tells that the step's runs are over, also if it ends by an exception. Follows every {@link
   * #stepBegins} on the same thread; without one it does nothing.
   */
  default void stepEnds() {}

  /**
   * Tells that a task of the run that is on has waited for another one for some 100 microseconds: a
   * thread seems to have lost its processor. A hint, called by tasks, on any of the threads; does
   * nothing unless overridden.
   */
  default void waits() {}

  /** A piece of work that consists of independent tasks. */
  @FunctionalInterface
  interface Task {
    /**
     * Carries out one of them.
     *
     * @param task which, from 0
     * @param worker which thread this is, 0 to {@link Workers#count} - 1, 0 being the caller; no
     *     two at once have the same, so it may choose scratch memory, but nothing that shows
     */
    void run(int task, int worker);
  }
}
