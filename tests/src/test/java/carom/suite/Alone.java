package carom.suite;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Marks a test class, or a method of one, that shares the machine with no other test: it opens
 * sockets, starts processes or windows, or waits for a clock. {@link SuiteMain} runs what is marked
 * one after another when all the rest is done. The rest runs side by side, in virtual time or as
 * pure computation. {@code AloneTest} fails on what lacks the mark.
 */
@Documented
@Inherited
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
public @interface Alone {
  /** Returns what it needs, such as {@code "sockets"}. */
  String value();
}
