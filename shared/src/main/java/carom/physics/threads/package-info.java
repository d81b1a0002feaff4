/**
 * How a world's step is shared among threads: {@link carom.physics.threads.Workers}, the hook that
 * the engine uses, and {@link carom.physics.threads.WorkerThreads}, an implementation for whoever
 * has no pool of their own. The number of threads never shows in a result.
 */
package carom.physics.threads;
