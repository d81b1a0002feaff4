package carom.server.threads;

/** A thread that a {@link Watchdog} looks at. Any thread may ask. */
interface WatchedThread {
  /** Returns the thread itself. */
  Thread thread();

  /** Returns whether the thread takes a long nap, and will tell when it is awake. */
  boolean rests();

  /** Sets what the thread does first after a long nap. */
  void onAwake(Runnable newOnAwake);
}
