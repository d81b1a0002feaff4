package carom.suite;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Inherited;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * Marks a test class that needs the JVM's second compiler, because it measures what is allocated,
 * or computes for long. The other classes run without, in half the processor's time; those of
 * {@link TestClass#OPTIMIZED} needn't be marked.
 */
@Documented
@Inherited
@Target(ElementType.TYPE)
@Retention(RetentionPolicy.RUNTIME)
public @interface Optimized {
  /** Returns why, such as {@code "measures allocation"}. */
  String value();
}
