package carom.suite;

import java.io.IOException;
import java.lang.reflect.AnnotatedElement;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * A class of tests and what is to run of it.
 *
 * @param name its full name
 * @param methods a pattern of its methods to run; empty: all
 * @param part which of these, see {@link Needs} and {@link Alone}
 * @param optimized whether it needs the JVM's second compiler, see {@link Optimized}
 */
record TestClass(String name, String methods, Part part, boolean optimized) {
  /**
   * The engine's classes, which call the vector kernels: these are slow otherwise. Its laws and
   * truths ask what a step does, for which any kernels do.
   */
  static final Pattern OPTIMIZED = Pattern.compile("carom[.]physics[.](?!laws[.]|truth[.]).*");

  enum Part {
    /** What isn't marked: it computes. */
    COMPUTING,
    /** What is marked with {@link Needs}. */
    NEEDING,
    /** What is marked with {@link Alone}. */
    ALONE
  }

  private static final Pattern NAME = Pattern.compile("[^$]*Tests?[.]class");

  /**
   * Finds the test classes of a folder of compiled classes, sorted by name.
   *
   * @param only patterns as those of Gradle's {@code --tests}: a class with or without its package,
   *     then perhaps a method, with {@code *} for anything; empty: all classes
   */
  static List<TestClass> find(Path folder, List<String> only) throws IOException {
    List<Path> files;
    try (Stream<Path> all = Files.walk(folder)) {
      files = all.filter(file -> NAME.matcher(file.getFileName().toString()).matches()).toList();
    }
    List<TestClass> found = new ArrayList<>();
    for (Path file : files.stream().sorted().toList()) {
      String path = folder.relativize(file).toString();
      String name = path.substring(0, path.length() - ".class".length()).replaceAll("[/\\\\]", ".");
      String methods = methods(name, only);
      if (methods != null) {
        Class<?> type = load(name);
        if (!Modifier.isAbstract(type.getModifiers())) {
          Set<Part> parts = EnumSet.of(part(type));
          Stream.of(type.getDeclaredMethods()).forEach(m -> parts.add(part(m, part(type))));
          boolean optimized =
              OPTIMIZED.matcher(name).matches() || type.isAnnotationPresent(Optimized.class);
          parts.forEach(part -> found.add(new TestClass(name, methods, part, optimized)));
        }
      }
    }
    return found;
  }

  /** Returns whether a method of it belongs to its part. */
  boolean has(Method method) {
    return part(method, part(load(name))) == part;
  }

  /** Returns whether it is that part of its class that is marked as the class. */
  boolean isOfTheClass() {
    return part(load(name)) == part;
  }

  private static Part part(Class<?> type) {
    return part(type, Part.COMPUTING);
  }

  private static Part part(AnnotatedElement marked, Part otherwise) {
    if (marked.isAnnotationPresent(Alone.class)) {
      return Part.ALONE;
    }
    return marked.isAnnotationPresent(Needs.class) ? Part.NEEDING : otherwise;
  }

  private static Class<?> load(String name) {
    try {
      return Class.forName(name, false, TestClass.class.getClassLoader());
    } catch (ClassNotFoundException e) {
      throw new IllegalStateException("cannot load class=" + name, e);
    }
  }

  /** Returns the pattern of the methods that are asked for; null: the class isn't. */
  private static String methods(String name, List<String> only) {
    if (only.isEmpty()) {
      return "";
    }
    List<String> methods = new ArrayList<>();
    for (String pattern : only) {
      int dot = pattern.lastIndexOf('.');
      if (matches(name, pattern)) {
        return "";
      }
      if (dot > 0 && matches(name, pattern.substring(0, dot))) {
        methods.add(regex(pattern.substring(dot + 1)));
      }
    }
    return methods.isEmpty() ? null : String.join("|", methods);
  }

  private static boolean matches(String name, String pattern) {
    return name.matches("(.*\\.)?" + regex(pattern));
  }

  private static String regex(String pattern) {
    return pattern.replace("$", "\\$").replace(".", "\\.").replace("*", ".*");
  }
}
