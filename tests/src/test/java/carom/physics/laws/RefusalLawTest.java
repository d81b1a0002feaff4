package carom.physics.laws;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import carom.fixtures.WildCalls;
import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Queries;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.WorldRecorder;
import carom.physics.archive.ArchiveException;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Circle;
import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/**
 * The law of refused calls: a call that throws leaves everything as it was, and says what was
 * wrong. Calls are drawn at random from all public methods and constructors of the physics that
 * take arguments, with arguments that are null, not finite, huge, negative, or of another world;
 * between steps, in queries, and in callbacks of a step.
 */
class RefusalLawTest {
  /** Threads are another matter than a world's state. */
  private static final String THREADS = "workers";

  private final long seed = new Random().nextLong();
  private final Random random = new Random(seed);
  private final TreeSet<String> faults = new TreeSet<>();
  private final List<Executable> calls = new ArrayList<>();
  private WildWorld now = new WildWorld(random);
  private int refused;

  RefusalLawTest() {
    for (Class<?> type : WildWorld.types()) {
      List<Executable> all = new ArrayList<>(List.of(type.getDeclaredConstructors()));
      all.addAll(List.of(type.getDeclaredMethods()));
      all.removeIf(e -> e.isSynthetic() || !Modifier.isPublic(e.getModifiers()));
      all.removeIf(e -> e instanceof Constructor && Modifier.isAbstract(type.getModifiers()));
      all.removeIf(e -> e.getParameterCount() == 0 || e.getName().equals("equals"));
      all.removeIf(e -> type.isEnum() || e.getName().equals(THREADS));
      all.sort((a, b) -> a.toString().compareTo(b.toString()));
      calls.addAll(all);
    }
  }

  @Test
  void aCallThatIsRefusedBetweenStepsChangesNothing() {
    each(
        6,
        call -> {
          String before = now.state();
          Throwable thrown = now.call(call);
          check(call, thrown, before, now.state());
          if (thrown == null || !before.equals(now.state())) {
            now = new WildWorld(random);
          }
        });
  }

  @Test
  void aCallThatIsRefusedInAQueryChangesNothing() {
    calls.removeIf(e -> !isOfWorlds(e));
    each(
        6,
        call -> {
          String before = now.state();
          Throwable[] thrown = new Throwable[1];
          now.world.queryAabb(
              -50,
              -50,
              50,
              50,
              body -> {
                thrown[0] = now.call(call);
                return false;
              });
          check(call, thrown[0], before, now.state());
          if (thrown[0] == null || !before.equals(now.state())) {
            now = new WildWorld(random);
          }
        });
  }

  @Test
  void aCallThatIsRefusedInACallbackChangesNothing() {
    now.step((place, collision) -> {});
    String stepped = now.state();
    List<String> places = new ArrayList<>();
    now = new WildWorld(random);
    now.step((place, collision) -> places.add(place));
    assertTrue(new TreeSet<>(places).size() >= 6, () -> "callbacks: " + places);
    calls.removeIf(e -> !isOfWorlds(e));
    each(
        3,
        call -> {
          now = new WildWorld(random);
          int at = random.nextInt(places.size());
          int[] count = {0};
          Throwable[] thrown = new Throwable[1];
          now.step(
              (place, collision) -> {
                if (count[0]++ == at) {
                  now.collision = collision;
                  long before = now.world.stateHash();
                  thrown[0] = now.call(call);
                  if (thrown[0] != null && before != now.world.stateHash()) {
                    faults.add(name(call) + " in " + place + " changed the state at once");
                  }
                  now.collision = null;
                }
              });
          check(call, thrown[0], stepped, thrown[0] == null ? stepped : now.state());
        });
  }

  @Test
  void aQueryThatIsRefusedLeavesTheOneThatRuns() {
    Queries<String> queries = now.world.queries();
    List<String> expected = new ArrayList<>();
    queries.rayAll(-30, 0.5f, 60, 0, null, hit -> expected.add(hit.body() + " " + hit.x()));
    List<String> found = new ArrayList<>();
    queries.rayAll(
        -30,
        0.5f,
        60,
        0,
        null,
        hit -> {
          found.add(hit.body() + " " + hit.x());
          try {
            queries.containing(7, 7, null, other -> true);
            return fail("a query in a query");
          } catch (IllegalStateException e) {
            return true;
          }
        });
    assertTrue(expected.size() > 2, () -> "too few hits: " + expected);
    assertEquals(expected, found);
  }

  @Test
  void aBodyThatIsRefusedIsNotThere() {
    World<String> world = new World<>(new WorldDef());
    BodyDef far = new BodyDef(BodyType.DYNAMIC);
    for (float center : new float[] {90_000, -1e7f, Float.NaN, Float.POSITIVE_INFINITY}) {
      IllegalArgumentException e =
          assertThrows(IllegalArgumentException.class, () -> far.mass(1, 1, center, 0));
      assertTrue(e.getMessage().startsWith("centerX=" + center), e.getMessage());
    }
    far.mass(1, 1, 30_000, 0).shape(new Circle(1, -80_000, 0));
    long before = world.stateHash();
    assertThrows(IllegalArgumentException.class, () -> world.createBody(far, "ghost"));
    assertEquals(before, world.stateHash());
    assertEquals(0, world.bodyCount());
    world.step(1 / 60f);
  }

  @Test
  void anUprightCapsuleIsAtLeastAsHighAsItsCaps() {
    float[][] refusedOnes = {{-1, 0.5f}, {0, 0.5f}, {0.9f, 0.5f}, {1, 0.5f}, {2, Float.NaN}};
    for (float[] size : refusedOnes) {
      IllegalArgumentException e =
          assertThrows(IllegalArgumentException.class, () -> Capsule.upright(size[0], size[1]));
      assertTrue(e.getMessage().contains("="), e.getMessage());
    }
    assertEquals(1, Capsule.upright(2, 0.5f).length());
  }

  @Test
  void aCallThatIsRefusedIsNotRecorded() {
    World<String> world = new World<>(new WorldDef());
    Body<String> body = world.createBody(new BodyDef(BodyType.DYNAMIC), "b");
    List<byte[]> recordings = new ArrayList<>();
    for (boolean wild : new boolean[] {false, true}) {
      WorldRecorder recorder = new WorldRecorder(world, 1 << 20, 1);
      for (Runnable call :
          List.<Runnable>of(
              () -> body.setVelocity(Float.NaN, 0),
              () -> body.applyForce(0, Float.NaN),
              () -> body.applyImpulse(1, 2, 3, Float.NaN),
              () -> body.setPose(0, Float.NaN, 0),
              () -> body.setGravityScale(Float.NaN),
              () -> world.createBody(null, "c"))) {
        try {
          if (wild) {
            call.run();
            fail("accepted");
          }
        } catch (IllegalArgumentException | NullPointerException e) {
          assertTrue(e.getMessage().contains("="), e.getMessage());
        }
      }
      recordings.add(recorder.finish());
    }
    assertEquals(recordings.get(0).length, recordings.get(1).length);
  }

  /** Returns whether a call may change a world: a definition or a shape is the same everywhere. */
  private static boolean isOfWorlds(Executable call) {
    String of = call.getDeclaringClass().getSimpleName();
    boolean definition = of.endsWith("Def") || call.getDeclaringClass().isRecord();
    return !definition && !Modifier.isStatic(call.getModifiers()) && call instanceof Method;
  }

  private interface Trial {
    void run(Executable call);
  }

  private void each(int rounds, Trial trial) {
    for (int round = 0; round < rounds; round++) {
      for (Executable call : calls) {
        trial.run(call);
      }
    }
    assertTrue(refused > calls.size() / 2, () -> "only " + refused + " calls were refused");
    assertTrue(faults.isEmpty(), () -> "seed=" + seed + "\n" + String.join("\n", faults));
  }

  private void check(Executable call, Throwable thrown, String before, String after) {
    if (thrown == null) {
      return;
    }
    refused++;
    if (!before.equals(after)) {
      faults.add(name(call) + " changed something, and threw " + thrown.getClass());
    }
    String text = thrown.getMessage() == null ? "" : thrown.getMessage();
    boolean says = text.contains("=") || text.contains("possible") || text.contains("other");
    says |= thrown instanceof ArchiveException; // names the place in the bytes
    if (WildCalls.complaint(thrown) != null || !says) {
      StackTraceElement[] trace = thrown.getStackTrace();
      faults.add(name(call) + " threw " + thrown + " at " + (trace.length > 0 ? trace[0] : ""));
    }
  }

  private static String name(Executable call) {
    String of = call.getDeclaringClass().getSimpleName();
    return of
        + (call instanceof Method ? "." + call.getName() : "")
        + Arrays.stream(call.getParameterTypes()).map(Class::getSimpleName).toList();
  }
}
