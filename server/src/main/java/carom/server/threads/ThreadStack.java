package carom.server.threads;

import java.util.Arrays;

/** The stack of another thread, in the form that logs print. It is never thrown. */
public final class ThreadStack extends Throwable {
  private static final long serialVersionUID = 1;

  private static final int MAX_FRAMES = 40;

  ThreadStack(String thread, StackTraceElement[] stack) {
    super("thread " + thread);
    setStackTrace(Arrays.copyOf(stack, Math.min(stack.length, MAX_FRAMES)));
  }

  /** Takes no time to note where it is made. */
  @Override
  public synchronized Throwable fillInStackTrace() {
    return this;
  }
}
