package carom.game;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.Iterator;
import java.util.List;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.function.Consumer;

/**
 * Finds what the jars on the class path and of {@link GameJars} bring by {@code META-INF/services}:
 * games, and what belongs to games. One that is broken keeps no other from being found. Stateless;
 * any thread.
 */
public final class JarServices {
  /** Most errors before the search ends. A jar that cannot be read may fail at every question. */
  private static final int MAX_ERRORS = 100;

  private JarServices() {}

  /**
   * Returns new instances of all services of a type that can be loaded.
   *
   * @param broken hears what is wrong with each of the others
   */
  public static <T> List<T> all(Class<T> type, Consumer<Error> broken) {
    List<T> services = new ArrayList<>();
    Iterator<T> found = ServiceLoader.load(type, GameJars.loader()).iterator();
    for (int errors = 0; errors <= MAX_ERRORS; ) {
      try {
        if (!found.hasNext()) {
          break;
        }
        services.add(found.next());
      } catch (ServiceConfigurationError | LinkageError e) {
        errors++;
        broken.accept(e);
      }
    }
    // Those of --games go before the installation's.
    services.sort(
        Comparator.comparing(service -> service.getClass().getClassLoader() != GameJars.loader()));
    return services;
  }
}
