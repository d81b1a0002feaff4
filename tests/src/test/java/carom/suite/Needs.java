package carom.suite;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Marks a test class, or a method of one, that needs more than its own thread: it opens sockets,
 * starts processes or windows, or waits for a clock. {@link SuiteMain} runs what is marked beside
 * other tests, and before what only computes. {@code NeedsTest} fails on what lacks the mark.
 */
@Documented
@Inherited
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
public @interface Needs {
  /** Returns what it needs, such as {@code "sockets"}. */
  String value();
}
