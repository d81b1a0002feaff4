package carom.architecture;

import static com.tngtech.archunit.core.domain.JavaModifier.STATIC;
import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.suite.Alone;
import carom.suite.Needs;
import com.tngtech.archunit.ArchConfiguration;
import com.tngtech.archunit.core.domain.JavaCall;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaCodeUnit;
import com.tngtech.archunit.core.domain.JavaConstructorCall;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.lang.reflect.Modifier;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Goal: tests that only compute wait for nothing. Method: from each test class, through the helpers
 * of the tests and of the laboratory, look for calls that open sockets, start processes or windows,
 * or wait for a clock.
 */
final class NeedsTest {
  /** What needs the machine: of the JDK, and of the product the classes that are made of it. */
  private static final Pattern NEEDS =
      Pattern.compile(
          "java\\.lang\\.Thread\\.sleep|java\\.util\\.concurrent\\.TimeUnit\\.sleep"
              + "|java\\.lang\\.ProcessBuilder\\.start|java\\.lang\\.Runtime\\.exec"
              + "|java\\.net\\.(Socket|ServerSocket|DatagramSocket|MulticastSocket)\\.<init>"
              + "|java\\.nio\\.channels\\.\\w*(Socket|Datagram)Channel\\.open"
              + "|java\\.net\\.http\\.HttpClient\\.\\w+|java\\.net\\.URL\\.open\\w+"
              + "|com\\.sun\\.net\\.httpserver\\.HttpServer\\.create"
              + "|carom\\.net\\.kryo\\.(KryoClientTransport|ClientLink|AddressRace)\\.<init>"
              + "|carom\\.net\\.kryo\\.server\\.(Acceptor|KryoServerTransport|ServerNetwork)\\.<init>"
              + "|carom\\.net\\.datagram\\.(ClientDatagrams|DatagramPort)\\.<init>"
              + "|carom\\.server\\.ServerStart\\.<init>|carom\\.server\\.(Server|Carom)Main\\.main"
              + "|carom\\.server\\.query\\.(RemoteConsole|StatusQuery)\\.<init>|carom\\.server\\.command\\.ServerProbe\\.\\w+"
              + "|carom\\.server\\.web\\.WebServer\\.<init>"
              + "|carom\\.client\\.discovery\\.LanSearch\\.<init>"
              + "|carom\\.client\\.(bots\\.BotsMain|app\\.ClientMain)\\.main"
              + "|carom\\.client\\.desktop\\.DesktopLauncher\\.\\w+"
              + "|carom\\.launcher\\.LocalServers?\\.<init>");

  /** Waits that end when something happened, or never in a test. */
  private static final Set<String> HARMLESS = Set.of("carom.fixtures.Allocations");

  private static final Pattern OURS = Pattern.compile(".*/(tests|testkit)/build/.*");

  private final Map<String, String> needs = new HashMap<>();

  @Test
  void whatNeedsTheMachineSaysSo() {
    Map<String, String> missing = new TreeMap<>();
    for (JavaClass type : ArchConfiguration.withThreadLocalScope(NeedsTest::outside)) {
      String name = type.getFullName().replaceAll("[$].*", "");
      if (name.endsWith("Test") && isHelper(type) && !isMarked(type)) {
        type.getCodeUnits().stream()
            .map(this::need)
            .filter(Objects::nonNull)
            .findFirst()
            .ifPresent(need -> missing.put(name, need));
      }
    }
    assertEquals(Map.of(), missing, "classes that need @Needs, with what they call");
  }

  /** Imports all but the product. Of that and of the JDK the names are enough. */
  private static JavaClasses outside(ArchConfiguration configuration) {
    configuration.setResolveMissingDependenciesFromClassPath(false);
    return new ClassFileImporter()
        .withImportOption(location -> location.matches(OURS))
        .importPackages("carom");
  }

  private static boolean isMarked(JavaClass type) {
    for (Class<?> c = type.reflect(); c != null; c = c.getEnclosingClass()) {
      if (c.isAnnotationPresent(Needs.class)
          || c.isAnnotationPresent(Alone.class)
          || Modifier.isAbstract(c.getModifiers())) {
        return true; // of an abstract one those that extend it are looked at
      }
    }
    return false;
  }

  /** Returns the way to a call that needs the machine; null: there is none. */
  private String need(JavaCodeUnit code) {
    if (needs.containsKey(code.getFullName())) {
      return needs.get(code.getFullName());
    }
    needs.put(code.getFullName(), null); // circles end here
    if (code.isAnnotatedWith(Needs.class) || code.isAnnotatedWith(Alone.class)) {
      return null;
    }
    String found = null;
    for (JavaCall<?> call : code.getCallsFromSelf()) {
      String name = call.getTargetOwner().getFullName() + "." + call.getName();
      found = NEEDS.matcher(name).matches() ? name : through(call);
      if (found != null) {
        found = code.getOwner().getSimpleName() + "." + code.getName() + " > " + found;
        break;
      }
    }
    needs.put(code.getFullName(), found);
    return found;
  }

  /** Looks into what a helper's method calls; who makes a helper may call all its methods. */
  private String through(JavaCall<?> call) {
    JavaClass owner = call.getTargetOwner();
    if (!isHelper(owner)) {
      return null;
    }
    Stream<? extends JavaCodeUnit> next =
        call instanceof JavaConstructorCall
            ? owner.getCodeUnits().stream().filter(c -> !c.getModifiers().contains(STATIC))
            : call.getTarget().resolveMember().stream().map(JavaCodeUnit.class::cast);
    return next.map(this::need).filter(Objects::nonNull).findFirst().orElse(null);
  }

  /** Tests, fixtures, test kit and laboratory; the product's doors are listed in {@link #NEEDS}. */
  private static boolean isHelper(JavaClass type) {
    return type.getSource().isPresent()
        && OURS.matcher(type.getSource().get().getUri().toString()).matches()
        && !HARMLESS.contains(type.getFullName());
  }
}
