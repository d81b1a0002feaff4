package carom.suite;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Marks a test class, or a method of one, that shares the machine with no other test, because it
 * measures or keeps every core busy. {@link SuiteMain} runs what is marked one after another when
 * all the rest is done. What only needs sockets, processes, windows or a clock says {@link Needs}.
 */
@Documented
@Inherited
@Target({ElementType.TYPE, ElementType.METHOD})
@Retention(RetentionPolicy.RUNTIME)
public @interface Alone {
  /** Returns why, such as {@code "measures"}. */
  String value();
}
