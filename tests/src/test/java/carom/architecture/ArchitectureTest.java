package carom.architecture;

import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.tngtech.archunit.ArchConfiguration;
import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.PackageMatcher;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/**
 * Holds the code to the house plan of docs/ARCHITECTURE.md: which package may see which. {@link
 * ExactCodeTest} says what the bit-exact part must never touch.
 */
final class ArchitectureTest {
  /** The product's classes, which are read when a test looks at them first. */
  static final class Product {
    static final JavaClasses CAROM = ArchConfiguration.withThreadLocalScope(Product::read);

    private Product() {}

    /** Imports the product. Of libraries and the JDK the names are enough. */
    private static JavaClasses read(ArchConfiguration configuration) {
      configuration.setResolveMissingDependenciesFromClassPath(false);
      return new ClassFileImporter()
          .withImportOption(new ImportOption.DoNotIncludeTests())
          .withImportOption(location -> !location.contains("carom/testkit/"))
          .withImportOption(location -> !location.contains("carom/fixtures/"))
          .withImportOption(location -> !location.contains("carom/lab/"))
          .importPackages("carom");
    }
  }

  /** Packages of Carom each package may use, besides itself. */
  private static final Map<String, Set<String>> ALLOWED = new TreeMap<>();

  private static final Map<String, PackageMatcher> MATCHERS = new TreeMap<>();

  static {
    allow("carom.tiled", "carom.sim.level", "carom.text");
    allow("carom.physics.math");
    allow("carom.physics.archive");
    allow("carom.physics.geometry", "carom.physics.math", "carom.physics.archive");
    allow("carom.physics.collision", "carom.physics.math", "carom.physics.geometry");
    allow("carom.physics.threads");
    allow("carom.physics.broadphase", "carom.physics.math");
    allow("carom.physics.simd");
    allow("carom.physics.settings", "carom.physics.math", "carom.physics.archive");
    allow("carom.physics.profile");
    // The one layout of exact rows: the physics, the simulation and what carries rows over the wire
    // see it, and it sees none of them.
    allow("carom.physics.rows", "carom.physics.math");
    stage("store", "archive", "math", "simd", "threads");
    stage("body", "settings", "archive", "math", "geometry", "broadphase", "dynamics.store");
    stage(
        "contact",
        "settings",
        "archive",
        "math",
        "geometry",
        "collision",
        "broadphase",
        "simd",
        "dynamics.store",
        "dynamics.body");
    stage(
        "pairs",
        "settings",
        "math",
        "geometry",
        "broadphase",
        "dynamics.store",
        "dynamics.body",
        "dynamics.contact");
    stage(
        "narrow",
        "settings",
        "math",
        "geometry",
        "collision",
        "broadphase",
        "simd",
        "dynamics.store",
        "dynamics.body",
        "dynamics.contact");
    stage(
        "domain",
        "threads",
        "dynamics.body",
        "dynamics.contact",
        "dynamics.pairs",
        "settings",
        "math",
        "dynamics.store");
    stage(
        "solver",
        "settings",
        "simd",
        "dynamics.jointtree",
        "dynamics.domain",
        "dynamics.store",
        "dynamics.body",
        "dynamics.contact",
        "dynamics.pairs");
    stage("joint", "settings", "archive", "math", "rows", "dynamics.store", "dynamics.body");
    stage(
        "jointsolver",
        "settings",
        "math",
        "simd",
        "dynamics.store",
        "dynamics.body",
        "dynamics.contact",
        "dynamics.solver",
        "dynamics.domain",
        "dynamics.joint",
        "dynamics.jointtree");
    stage("jointtree", "dynamics.store", "dynamics.body", "dynamics.domain", "dynamics.joint");
    stage(
        "continuous",
        "settings",
        "math",
        "geometry",
        "collision",
        "broadphase",
        "dynamics.store",
        "dynamics.body",
        "dynamics.contact",
        "dynamics.pairs",
        "dynamics.domain");
    stage(
        "simd",
        "math",
        "collision",
        "simd",
        "dynamics.store",
        "dynamics.contact",
        "dynamics.narrow",
        "dynamics.solver",
        "dynamics.domain",
        "dynamics.jointsolver");
    allow(
        "carom.physics.dynamics",
        "carom.physics.*",
        "carom.physics.broadphase.*",
        "carom.physics.dynamics.*");
    allow("carom.physics", "carom.physics..");
    allow("carom.physics.effects", "carom.physics..");
    allow("carom.physics.mover", "carom.physics..");
    allow("carom.physics.particles", "carom.physics..");
    allow("carom.sim.event", "carom.physics.math");
    allow("carom.sim.pool", "carom.physics..");
    allow("carom.sim.message", "carom.physics.math", "carom.text");
    allow(
        "carom.sim.level",
        "carom.physics..",
        "carom.sim.field",
        "carom.sim.event",
        "carom.sim.pool",
        "carom.text");
    allow("carom.sim.phase");
    allow("carom.sim.spawn");
    allow(
        "carom.sim.field",
        "carom.physics.math",
        "carom.physics.archive",
        "carom.sim.event",
        "carom.sim.phase",
        "carom.sim.spawn");
    allow(
        "carom.sim.entity",
        "carom.physics..",
        "carom.sim.field",
        "carom.sim.level",
        "carom.sim.message",
        "carom.sim.spawn",
        "carom.sim.phase",
        "carom.sim.pool");
    allow(
        "carom.sim.outbox",
        "carom.physics",
        "carom.physics.math",
        "carom.sim.entity",
        "carom.sim.event",
        "carom.sim.level",
        "carom.sim.message",
        "carom.sim.spawn");
    allow(
        "carom.sim.ruling",
        "carom.physics..",
        "carom.sim.entity",
        "carom.sim.field",
        "carom.sim.phase",
        "carom.sim.level");
    allow(
        "carom.sim",
        "carom.physics..",
        "carom.sim.level",
        "carom.sim.event",
        "carom.sim.field",
        "carom.sim.message",
        "carom.sim.entity",
        "carom.sim.pool",
        "carom.sim.ruling",
        "carom.sim.spawn",
        "carom.sim.phase",
        "carom.sim.outbox");
    allow(
        "carom.sim.near",
        "carom.physics..",
        "carom.sim",
        "carom.sim.entity",
        "carom.sim.level",
        "carom.sim.event",
        "carom.sim.field",
        "carom.sim.spawn");
    allow(
        "carom.net.field",
        "carom.sim.message",
        "carom.net.protocol",
        "carom.net.snapshot.table",
        "carom.sim.event",
        "carom.sim.field",
        "carom.sim.pool");
    allow(
        "carom.sim.scene",
        "carom.physics..",
        "carom.sim",
        "carom.sim.entity",
        "carom.sim.level",
        "carom.sim.event",
        "carom.sim.pool",
        "carom.text");
    allow("carom.game", "carom.physics..", "carom.sim..", "carom.text");
    game("arena");
    game("cars");
    game("platformer");
    game("playground");
    game("rockets");
    game("shooter");
    allow("carom.net.codec", "carom.physics.simd");
    allow("carom.net.snapshot.ledger", "carom.net.codec");
    allow(
        "carom.net.snapshot.frame",
        "carom.net.codec",
        "carom.net.protocol",
        "carom.net.snapshot.ledger");
    allow(
        "carom.net.snapshot.exact",
        "carom.net.codec",
        "carom.net.protocol",
        "carom.net.snapshot.frame",
        "carom.net.snapshot.ledger",
        "carom.physics.rows"); // codes rows field by field, and sees no world
    allow(
        "carom.net.snapshot.table",
        "carom.net.codec",
        "carom.net.snapshot.frame",
        "carom.net.snapshot.ledger",
        "carom.physics.rows"); // what a joint was made with
    allow("carom.net.snapshot", "carom.net.codec", "carom.net.protocol", "carom.net.snapshot.*");
    allow("carom.net.protocol", "carom.net.codec", "carom.physics.rows", "carom.text");
    allow("carom.text");
    allow("carom.net.transport", "carom.net.protocol");
    allow("carom.net.admission");
    allow("carom.net.seal", "carom.text");
    allow(
        "carom.net.frame",
        "carom.net.protocol",
        "carom.net.transport",
        "carom.net.seal",
        "carom.net.admission",
        "carom.text");
    allow(
        "carom.net.kryo",
        "carom.net.protocol",
        "carom.net.transport",
        "carom.net.seal",
        "carom.net.frame",
        "carom.net.admission",
        "carom.net.codec",
        "carom.text");
    allow(
        "carom.net.kryo.server",
        "carom.net.kryo",
        "carom.net.protocol",
        "carom.net.transport",
        "carom.net.seal",
        "carom.net.frame",
        "carom.net.admission");
    allow("carom.options", "carom.net.transport", "carom.text");
    allow(
        "carom.replay",
        "carom.text",
        "carom.sim",
        "carom.sim.entity",
        "carom.sim.field",
        "carom.sim.level",
        "carom.sim.message",
        "carom.physics",
        "carom.physics.archive",
        "carom.game");
    allow(
        "carom.server..",
        "carom.server..",
        "carom.net..",
        "carom.options",
        "carom.text",
        "carom.replay",
        "carom.sim..",
        "carom.game",
        "carom.physics..",
        "carom.tiled");
    allow(
        "carom.client..",
        "carom.client..",
        "carom.text",
        "carom.net..",
        "carom.options",
        "carom.replay",
        "carom.sim..",
        "carom.game",
        "carom.game.arena", // looks and brains know the fields of their games
        "carom.game.cars",
        "carom.game.platformer",
        "carom.game.playground",
        "carom.game.rockets",
        "carom.game.shooter",
        "carom.physics..");
    // The one that knows both: it starts a server in the client's process.
    allow(
        "carom.launcher",
        "carom.game",
        "carom.options",
        "carom.text",
        "carom.server..",
        "carom.client",
        "carom.client.app",
        "carom.client.bots",
        "carom.net.kryo",
        "carom.net.kryo.server",
        "carom.net.transport",
        "carom.sim.level",
        "carom.physics.threads");
  }

  /** Allows what a stage of the step may use; names are those below {@code carom.physics}. */
  private static void stage(String name, String... to) {
    String[] full = new String[to.length];
    for (int i = 0; i < to.length; i++) {
      full[i] = "carom.physics." + to[i];
    }
    allow("carom.physics.dynamics." + name, full);
  }

  /** Allows what a game that ships may use; the name is the one below {@code carom.game}. */
  private static void game(String name) {
    allow(
        "carom.game." + name,
        "carom.physics..",
        "carom.sim",
        "carom.sim.entity",
        "carom.sim.outbox",
        "carom.sim.level",
        "carom.sim.event",
        "carom.sim.field",
        "carom.sim.message",
        "carom.sim.pool",
        "carom.sim.spawn");
  }

  private static void allow(String from, String... to) {
    ALLOWED.put(from, new TreeSet<>(Set.of(to)));
  }

  /** Returns whether the plan lets a package use another one; it has no say in the testkit. */
  static boolean isAllowed(String from, String to) {
    for (Map.Entry<String, Set<String>> row : ALLOWED.entrySet()) {
      if (matcher(row.getKey()).matches(from)) {
        return row.getValue().stream().anyMatch(name -> matcher(name).matches(to));
      }
    }
    return from.startsWith("carom.testkit") || from.equals("carom.plain");
  }

  private static PackageMatcher matcher(String name) {
    return MATCHERS.computeIfAbsent(name, PackageMatcher::of);
  }

  @Test
  void packagesUseOnlyWhatThePlanAllows() {
    ALLOWED.forEach(
        (from, to) -> {
          String[] allowed = new String[to.size() + 1];
          allowed[0] = from;
          int i = 1;
          for (String name : to) {
            allowed[i++] = name;
          }
          DescribedPredicate<JavaClass> foreign =
              resideInAPackage("carom..")
                  .and(DescribedPredicate.not(JavaClass.Predicates.resideInAnyPackage(allowed)));
          noClasses()
              .that()
              .resideInAPackage(from)
              .should()
              .dependOnClassesThat(foreign)
              .because(from + " may use only " + to)
              .check(Product.CAROM);
        });
  }

  @Test
  void everyPackageHasAPlaceInThePlan() {
    classes()
        .should()
        .resideInAnyPackage(ALLOWED.keySet().toArray(new String[0]))
        .because("a new package is entered in docs/ARCHITECTURE.md and here")
        .check(Product.CAROM);
  }

  @Test
  void packagesFormNoCycles() {
    slices().matching("carom.(**)").should().beFreeOfCycles().check(Product.CAROM);
  }

  @Test
  void socketLibraryHasOneHome() {
    onlyIn("carom.net.kryo..", "com.esotericsoftware..");
  }

  @Test
  void databasesHaveTwoHomes() {
    noClasses()
        .that()
        .resideOutsideOfPackages("carom.server.directory", "carom.server")
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage("org.postgresql..", "java.sql..", "org.h2..")
        .check(Product.CAROM);
  }

  @Test
  void windowToolkitHasOneHome() {
    onlyIn("carom.client.desktop..", "com.badlogicgames..", "org.lwjgl..", "javax.swing..");
    // Images without a display: carom level render.
    noClasses()
        .that()
        .resideOutsideOfPackages("carom.client.desktop..", "carom.server.level")
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage("java.awt..")
        .check(Product.CAROM);
  }

  @Test
  void serverAndClientNeverMeet() {
    noClasses()
        .that()
        .resideInAPackage("carom.server..")
        .should()
        .dependOnClassesThat()
        .resideInAPackage("carom.client..")
        .check(Product.CAROM);
    noClasses()
        .that()
        .resideInAPackage("carom.client..")
        .should()
        .dependOnClassesThat()
        .resideInAPackage("carom.server..")
        .check(Product.CAROM);
  }

  /** Commands that need the laboratory load it by name, from a folder of its own. */
  @Test
  void theLaboratoryIsNoPartOfTheProduct() {
    noClasses()
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage("carom.lab..", "carom.testkit..", "carom.fixtures..")
        .check(Product.CAROM);
  }

  @Test
  void theRulesSeeTheCode() {
    ArchRule wrong = noClasses().should().resideInAPackage("carom.physics");
    assertThrows(AssertionError.class, () -> wrong.check(Product.CAROM));
    assertEquals(0, Product.CAROM.stream().filter(c -> c.getName().endsWith("Test")).count());
  }

  private static void onlyIn(String home, String... libraries) {
    noClasses()
        .that()
        .resideOutsideOfPackage(home)
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage(libraries)
        .check(Product.CAROM);
  }
}
