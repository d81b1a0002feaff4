package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.fixtures.Allocations;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.suite.Needs;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Equal calls give equal bits, wherever and however they are made. */
@Needs("processes")
final class DeterminismTest {
  private static final String VECTORS = "jdk.incubator.vector";

  /**
   * State and events of each scene after its steps; a change here is a decision that the commit
   * message explains.
   */
  private static final String GOLDEN =
      """
      STACK 429c1e025f2a29d3 2f8fd5b754627dcd
      PYRAMID a63cd6ae5a78d0b6 ec9f65103420e7f9
      PILE 964faafe6ac5411f faad2a4b7b2cfb6f
      GAS 2eebf1ba2efa5eb cfd33dfff6e739ae
      SPIN d48e105aa520e5f6 d88655c879555dec
      NET b4b495a92dedba4e 11
      JOINTS 6fabd3fe87a72dcd 52283b8ee282f7e
      BELTS 5fb390bcc7964f33 7e3906535740866a
      CHAINS e4b1f0325be7e7c4 fb68bd9a0cb4d34
      ROUND d03e3411ae6c326a ebc9702862e6e6c7
      BULLETS bb51965067cf1967 5f309de367f17ef4
      SLEEPERS aa7f40b706d7e41 c90edec9f1e4b853
      EDITS 9e9b64f4e8745b28 a03c636d2393ec21
      WATER 8004d870e5eea31d 499deec80b09dece
      EULER 5f8e94cf45f64eff 7637076c528c2b21
      """;

  /** The same process once more, now with compiled code. */
  @Test
  void goldenHashesHaveNotChangedAndEveryRunAgrees() {
    String early = GoldenScenes.results(true);
    assertEquals(GOLDEN, GoldenScenes.results(false));
    assertEquals(early, GoldenScenes.results(true));
  }

  /** With the vector kernels if this process is without, and without them if it has them. */
  @Test
  void freshProcessWithOtherKernelsAgrees() throws Exception {
    boolean vectors = ModuleLayer.boot().findModule(VECTORS).isPresent();
    List<String> option = vectors ? List.of() : List.of("--add-modules=" + VECTORS);
    assertEquals(GOLDEN, child(javaHome().resolve("bin/java"), option, false));
  }

  @Test
  void interpreterAgrees() throws Exception {
    assertEquals(
        GoldenScenes.results(true), child(javaHome().resolve("bin/java"), List.of("-Xint"), true));
  }

  /** C1 alone and C2 alone. */
  @ParameterizedTest
  @ValueSource(strings = {"-XX:TieredStopAtLevel=1", "-XX:-TieredCompilation"})
  void everyCompilerAgrees(String option) throws Exception {
    assertEquals(GOLDEN, child(javaHome().resolve("bin/java"), List.of(option), false));
  }

  /** Looks for JDKs that are installed side by side. */
  @Test
  void otherJdksAgree() throws Exception {
    List<Path> others = new ArrayList<>();
    try (var siblings = Files.list(javaHome().toRealPath().getParent())) {
      for (Path home : siblings.sorted().toList()) {
        Path java = home.resolve("bin/java");
        if (Files.isExecutable(java)
            && !home.toRealPath().equals(javaHome().toRealPath())
            && version(java) >= 17) {
          others.add(java);
        }
      }
    }
    assumeTrue(!others.isEmpty(), "no other JDK beside " + javaHome());
    for (Path java : others) {
      assertEquals(GOLDEN, child(java, List.of(), false), java.toString());
    }
  }

  private static Path javaHome() {
    return Path.of(System.getProperty("java.home"));
  }

  private static int version(Path java) throws Exception {
    Process p = new ProcessBuilder(java.toString(), "-version").redirectErrorStream(true).start();
    String text = new String(p.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    p.waitFor();
    String number = text.replaceAll("(?s)^[^\"]*\"(\\d+).*$", "$1");
    return number.matches("\\d+") ? Integer.parseInt(number) : 0;
  }

  private static String child(Path java, List<String> options, boolean small)
      throws IOException, InterruptedException {
    List<String> command =
        new ArrayList<>(List.of(java.toString(), "-Xmx256m", "-XX:+UseSerialGC"));
    command.addAll(options);
    command.addAll(
        List.of("-cp", System.getProperty("java.class.path"), GoldenScenes.class.getName()));
    if (small) {
      command.add("small");
    }
    Process p = new ProcessBuilder(command).redirectError(new File("/dev/null")).start();
    String out = new String(p.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, p.waitFor(), command.toString());
    return out;
  }

  /** Every scene, restored at a random tick, goes on as it did. */
  @ParameterizedTest
  @EnumSource(GoldenScenes.class)
  void everySceneGoesOnAfterRestore(GoldenScenes golden) {
    World<String> w = golden.start();
    Scenes.Rng r = new Scenes.Rng(golden.ordinal());
    WorldState s = null;
    int tick = 0;
    for (int round = 0; round < 4; round++) {
      for (int i = 10 + r.below(30); i > 0; i--) {
        golden.step(w, tick++);
      }
      s = w.save(s);
      long at = w.stateHash();
      long[] expected = new long[20];
      for (int i = 0; i < expected.length; i++) {
        golden.step(w, tick + i);
        expected[i] = w.stateHash();
      }
      w.restore(s);
      String where = golden + " tick=" + tick;
      assertEquals(at, w.stateHash(), where);
      for (int i = 0; i < expected.length; i++) {
        golden.step(w, tick + i);
        assertEquals(expected[i], w.stateHash(), where + " step=" + i);
      }
      tick += expected.length;
    }
  }

  /** Restores at random ticks, with bodies created and destroyed in between. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void restoreContinuesBitForBit(long seed) {
    World<String> w = Scenes.pile(60, seed);
    Scenes.Rng r = new Scenes.Rng(seed * 77);
    WorldState state = null;
    steps(w, 60);
    for (int round = 0; round < 8; round++) {
      String where = "seed=" + seed + " round=" + round;
      steps(w, r.below(40));
      state = w.save(state);
      long at = w.stateHash();
      long[] expected = play(w, round, r.below(1000));
      disturb(w, r);
      steps(w, 5);
      disturb(w, r);
      w.restore(state);
      assertEquals(at, w.stateHash(), where);
      long again = expected[expected.length - 1];
      long[] actual = play(w, round, (int) again);
      for (int i = 0; i < expected.length - 1; i++) {
        assertEquals(expected[i], actual[i], where + " step=" + i);
      }
    }
  }

  /** Thirty steps with a body created and one destroyed; the last entry is the choice made. */
  private static long[] play(World<String> w, int round, int choice) {
    long[] hashes = new long[31];
    for (int i = 0; i < 30; i++) {
      if (i == 10) {
        Scenes.disc(w, choice % 7 - 3, 15, .3f, Material.DEFAULT).setVelocity(0, -5);
      }
      if (i == 20) {
        Body<String> victim = w.body(3 + (choice + round) % 40);
        if (victim != null) {
          w.destroyBody(victim);
        }
      }
      w.step(DT);
      hashes[i] = w.stateHash();
    }
    hashes[30] = choice;
    return hashes;
  }

  private static void disturb(World<String> w, Scenes.Rng r) {
    for (int i = 0; i < 10; i++) {
      Body<String> b = w.body(r.below(w.slotCount()));
      if (b == null) {
        continue;
      }
      switch (r.below(3)) {
        case 0 -> {
          if (b.type() == BodyType.DYNAMIC) {
            w.destroyBody(b);
          }
        }
        case 1 -> b.setPose(r.in(-4, 4), r.in(0, 20), r.in(-3, 3));
        default -> Scenes.box(w, r.in(-4, 4), r.in(5, 20), .2f, .3f, Material.DEFAULT);
      }
    }
  }

  @Test
  void restoreBringsBackHandlesAndUsers() {
    World<String> w = Scenes.space();
    Body<String> a = w.createBody(new BodyDef(BodyType.DYNAMIC).shape(new Circle(1)), "a");
    WorldState s = w.save(null);
    w.destroyBody(a);
    Body<String> b = w.createBody(new BodyDef(BodyType.DYNAMIC).shape(new Box(1, 1)), "b");
    Body<String> c = w.createBody(new BodyDef(BodyType.DYNAMIC).shape(new Box(1, 1)), "c");
    assertFalse(a.isValid());
    w.restore(s);
    assertTrue(a.isValid());
    assertFalse(b.isValid());
    assertFalse(c.isValid());
    assertSame(a, w.body(a.index()));
    assertEquals("a", w.body(0).user());
    assertEquals(1, w.bodyCount());
  }

  @Test
  void contactsSurviveSaveAndRestore() {
    World<String> w = Scenes.stack(3);
    steps(w, 60);
    WorldState s = w.save(null);
    String before = contacts(w.body(2));
    w.body(2).setPose(50, 50, 0);
    steps(w, 10);
    w.restore(s);
    assertEquals(before, contacts(w.body(2)));
  }

  private static String contacts(Body<String> b) {
    StringBuilder text = new StringBuilder();
    b.forEachContact(
        (other, nx, ny, impulse) ->
            text.append(other.index()).append(' ').append(ny).append(' ').append(impulse));
    return text.toString();
  }

  /**
   * Queries, debug drawing and teleports there and back change trees and boxes, not results; they
   * would keep bodies awake.
   */
  @Test
  void historyOfTheTreesChangesNothing() {
    WorldDef sleepless = new WorldDef().withSleeping(false);
    World<String> calm = Scenes.pile(80, 3, sleepless);
    World<String> busy = Scenes.pile(80, 3, sleepless);
    Scenes.Rng r = new Scenes.Rng(99);
    for (int i = 0; i < 200; i++) {
      for (int k = 0; k < 5; k++) {
        Body<String> b = busy.body(r.below(busy.slotCount()));
        float x = b.centerX();
        float y = b.centerY();
        float cos = b.cos();
        float sin = b.sin();
        b.setCenterPose(r.in(-900, 900), r.in(-900, 900), 1, 0);
        busy.queryAabb(-1000, -1000, 1000, 1000, other -> true);
        b.setCenterPose(x, y, cos, sin);
      }
      busy.forEachTreeCell((a, b, c, d, depth) -> {});
      calm.step(DT);
      busy.step(DT);
      assertEquals(calm.stateHash(), busy.stateHash(), "step " + i);
    }
  }

  @Test
  void marginOfBoxesChangesNothing() {
    World<String> thin = Scenes.pile(60, 3, new WorldDef().withAabbMargin(0));
    World<String> thick = Scenes.pile(60, 3, new WorldDef().withAabbMargin(2));
    for (int i = 0; i < 200; i++) {
      thin.step(DT);
      thick.step(DT);
      assertEquals(thin.stateHash(), thick.stateHash(), "step " + i);
    }
    thin = GoldenScenes.bullets(new WorldDef().withAabbMargin(0));
    thick = GoldenScenes.bullets(new WorldDef().withAabbMargin(2));
    for (int i = 0; i < 120; i++) {
      thin.step(DT);
      thick.step(DT);
      assertEquals(thin.stateHash(), thick.stateHash(), "bullets, step " + i);
    }
  }

  @Test
  void hashSeesOneBit() {
    World<String> a = Scenes.pile(20, 1);
    World<String> b = Scenes.pile(20, 1);
    assertEquals(a.stateHash(), b.stateHash());
    b.body(7).setVelocity(Math.nextUp(b.body(7).velocityX()), b.body(7).velocityY());
    assertNotEquals(a.stateHash(), b.stateHash());
  }

  /** After warm-up a step, a save, a restore and a hash allocate nothing. */
  @Test
  void steadyTickAllocatesNothing() throws InterruptedException {
    World<String> w = Scenes.pile(150, 4);
    int[] events = new int[1];
    w.listener(
        new CollisionListener<>() {
          @Override
          public boolean preSolve(Collision<String> c) {
            events[0] += c.pointCount();
            return true;
          }
        });
    WorldState s = null;
    for (int i = 0; i < 600; i++) {
      w.step(DT);
      s = w.save(s);
      w.restore(s);
      w.stateHash();
      w.body(5).forEachContact((other, nx, ny, impulse) -> {});
    }
    WorldState state = s;
    long least =
        Allocations.leastOnceCompiled(
            200,
            () -> {
              for (int i = 0; i < 60; i++) {
                w.step(DT);
                w.save(state);
                w.restore(state);
                w.stateHash();
              }
            });
    assertTrue(least < 200, "bytes in 60 steps: " + least);
  }
}
