/**
 * Threads that share a world's step: {@link carom.physics.threads.Workers}, the hook that the
 * engine uses, and {@link carom.physics.threads.WorkerThreads}, an implementation for programs
 * without a thread pool of their own. The number of threads never shows in a result.
 */
package carom.physics.threads;
