package carom.architecture;

import static carom.architecture.ArchitectureTest.Product.CAROM;
import static com.tngtech.archunit.core.domain.JavaCall.Predicates.target;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.nameMatching;
import static com.tngtech.archunit.core.domain.properties.HasOwner.Predicates.With.owner;
import static com.tngtech.archunit.lang.conditions.ArchConditions.callMethodWhere;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaCall;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaFieldAccess;
import org.junit.jupiter.api.Test;

/** Holds the bit-exact part to what it must never touch: clocks, threads, chance, hash order. */
final class ExactCodeTest {
  /** Everything a simulation's next state depends on. */
  private static final String[] EXACT = {
    "carom.physics..", "carom.sim..", "carom.game..", "carom.replay.."
  };

  private static final DescribedPredicate<JavaClass> NOT_THREADS =
      DescribedPredicate.describe(
          "classes other than WorkerThreads and DomainPhases",
          c ->
              !c.getName()
                  .matches(
                      "carom\\.physics\\.(threads\\.WorkerThreads|dynamics\\.domain\\.DomainPhases)(\\$.*)?"));

  /** What needs the Vector API, in a source folder of its own. */
  private static final String VECTORS =
      "carom\\.(physics\\.dynamics\\.simd\\.Vector\\w+|physics\\.simd\\.VectorWidth|net\\.codec\\.VectorColumns)";

  @Test
  void physicsNeedsOnlyTheLanguage() {
    classes()
        .that()
        .resideInAPackage("carom.physics..")
        .and()
        .haveNameNotMatching(VECTORS)
        .and(NOT_THREADS)
        .should()
        .onlyDependOnClassesThat()
        .resideInAnyPackage("carom.physics..", "java.lang..", "java.util", "java.util.function")
        .because("the engine is used alone, and must stay portable")
        .check(CAROM);
    noClasses()
        .should()
        .dependOnClassesThat()
        .haveNameMatching(VECTORS)
        .because("not every JVM can load it: it is found by name")
        .check(CAROM);
  }

  /** WorkerThreads is an optional helper that the engine itself never sees. */
  @Test
  void exactCodeNeverSeesTheThreadsThatHelpIt() {
    noClasses()
        .that()
        .resideInAnyPackage(EXACT)
        .and(NOT_THREADS)
        .should()
        .dependOnClassesThat()
        .haveNameMatching("carom\\.physics\\.threads\\.WorkerThreads(\\$.*)?")
        .because("it knows the hook Workers alone, whose runs show in no result")
        .check(CAROM);
  }

  @Test
  void exactCodeKnowsNeitherClockNorThreadNorChance() {
    noClasses()
        .that()
        .resideInAnyPackage(EXACT)
        .and(NOT_THREADS)
        .should()
        .dependOnClassesThat()
        .haveNameMatching(
            "java\\.util\\.(Random|SplittableRandom|Date|Timer|TimerTask)|java\\.util\\.concurrent\\..*|java\\.time\\..*"
                + "|java\\.lang\\.(Thread|ThreadLocal|Runtime)|java\\.util\\.stream\\..*")
        .check(CAROM);
    neverCalls("java.lang.System", "nanoTime|currentTimeMillis|identityHashCode");
  }

  @Test
  void exactCodeUsesNoFunctionWhoseLastBitDependsOnTheMachine() {
    neverCalls(
        "java.lang.Math",
        "sin|cos|tan|asin|acos|atan|atan2|exp|expm1|log|log10|log1p|pow|cbrt|sinh|cosh|tanh|hypot|random|fma");
  }

  @Test
  void exactCodeHasNoHashOrder() {
    noClasses()
        .that()
        .resideInAnyPackage(EXACT)
        .should()
        .dependOnClassesThat()
        .haveNameMatching("java\\.util\\.(HashMap|HashSet|IdentityHashMap|WeakHashMap|Hashtable)")
        .because("iteration order would leak into results; use arrays, lists or TreeMap")
        .check(CAROM);
  }

  /** Other lengths in one process make the JIT compiler box vectors, see docs/lab/kernels.md. */
  @Test
  void vectorsHaveOneLength() {
    noClasses()
        .should()
        .accessFieldWhere(JavaFieldAccess.Predicates.target(nameMatching("SPECIES_(64|128|MAX)")))
        .because("kernels use the preferred length")
        .check(CAROM);
    noClasses()
        .that()
        .haveNameNotMatching("carom\\.physics\\.dynamics\\.simd\\.Vector(Boxes|Contacts|Revolutes)")
        .should()
        .accessFieldWhere(JavaFieldAccess.Predicates.target(nameMatching("SPECIES_(256|512)")))
        .because("only these choose, as VectorModule.LANES says: the preferred one of both")
        .check(CAROM);
  }

  private static void neverCalls(String type, String methods) {
    DescribedPredicate<JavaCall<?>> banned =
        target(owner(DescribedPredicate.describe(type, owner -> owner.getName().equals(type))))
            .and(target(nameMatching(methods)))
            .forSubtype();
    noClasses().that().resideInAnyPackage(EXACT).should(callMethodWhere(banned)).check(CAROM);
  }
}
