package carom.suite;

import java.io.Serializable;

/**
 * A thing that a {@link SuiteWorker} tells {@link SuiteMain}.
 *
 * @param kind what happened
 * @param test the test's name; of {@code CLASS_DONE}, the class's
 * @param seconds how long it took; of {@code CLASS_DONE}, all of the class
 * @param cpuSeconds what the process computed for {@code CLASS_DONE}, in all threads; else 0
 * @param text why it failed or was skipped; else empty
 */
record TestEvent(Kind kind, String test, double seconds, double cpuSeconds, String text)
    implements Serializable {
  enum Kind {
    STARTED,
    PASSED,
    FAILED,
    SKIPPED,
    CLASS_DONE
  }
}
