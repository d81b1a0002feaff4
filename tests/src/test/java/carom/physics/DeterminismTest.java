package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import java.io.File;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Equal calls give equal bits, wherever and however they are made. */
final class DeterminismTest {
  /** Hashes after so many steps; a change here is a decision that the commit message explains. */
  private static final String GOLDEN =
      "stack 6732c48da8486058 pyramid a2ef4f83845400b8 pile badcd63e976f4c6f gas 52ed0c1a501cc3a8"
          + " spin 3a730ae71718a96b net 77ae10dec9308a76 joints 190955602e3b892a"
          + " belts c92b8f79ee0795b6";

  /** Prints the hashes of all scenes; also run in other processes and on other JDKs. */
  static final class Hashes {
    private Hashes() {}

    /** Steps the scenes; "small" makes it short enough for the interpreter. */
    public static void main(String[] args) {
      System.out.println(args.length > 0 ? small() : all());
    }

    static String all() {
      return "stack "
          + hash(Scenes.stack(10), 300)
          + " pyramid "
          + hash(Scenes.pyramid(12), 200)
          + " pile "
          + hash(Scenes.pile(120, 5), 400)
          + " gas "
          + hash(Scenes.gas(12, 9, 1), 300)
          + " spin "
          + hash(spinner(), 300)
          + " net "
          + hash(JointTest.grid(20), 200)
          + " joints "
          + hash(JointLifeTest.zoo(3), 300)
          + " belts "
          + hash(SurfaceTest.belts(), 300);
    }

    static String small() {
      return "pile "
          + hash(Scenes.pile(16, 5), 150)
          + " spin "
          + hash(spinner(), 60)
          + " net "
          + hash(JointTest.grid(6), 60);
    }

    private static String hash(World<?> w, int n) {
      steps(w, n);
      return Long.toHexString(w.stateHash());
    }

    /** A turning kinematic cross stirs discs. */
    private static World<String> spinner() {
      World<String> w = Scenes.floor(Material.DEFAULT);
      w.createBody(
          new BodyDef(BodyType.KINEMATIC)
              .shape(new Box(3, .2f))
              .shape(new Box(.2f, 3))
              .position(0, 3.5f)
              .angularVelocity(2),
          null);
      for (int i = 0; i < 30; i++) {
        w.createBody(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Circle(.2f), new Material(1, .3f, .5f))
                .position(-2 + (i % 10) * .45f, 7 + .5f * Math.floorDiv(i, 10)),
            null);
      }
      return w;
    }
  }

  @Test
  void goldenHashesHaveNotChanged() {
    assertEquals(GOLDEN, Hashes.all());
  }

  @Test
  void freshProcessAgrees() throws Exception {
    assertEquals(GOLDEN, child(javaHome().resolve("bin/java"), List.of(), false));
  }

  @Test
  void interpreterAgrees() throws Exception {
    assertEquals(Hashes.small(), child(javaHome().resolve("bin/java"), List.of("-Xint"), true));
  }

  @Test
  void firstCompilerAgrees() throws Exception {
    assertEquals(
        GOLDEN, child(javaHome().resolve("bin/java"), List.of("-XX:TieredStopAtLevel=1"), false));
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
    List<String> command = new ArrayList<>(List.of(java.toString(), "-Xmx256m"));
    command.addAll(options);
    command.addAll(List.of("-cp", System.getProperty("java.class.path"), Hashes.class.getName()));
    if (small) {
      command.add("small");
    }
    Process p = new ProcessBuilder(command).redirectError(new File("/dev/null")).start();
    String out = new String(p.getInputStream().readAllBytes(), StandardCharsets.UTF_8).trim();
    assertEquals(0, p.waitFor(), command.toString());
    return out;
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
  void steadyTickAllocatesNothing() {
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
    var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    long least = Long.MAX_VALUE;
    for (int attempt = 0; attempt < 5; attempt++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int i = 0; i < 60; i++) {
        w.step(DT);
        w.save(s);
        w.restore(s);
        w.stateHash();
      }
      least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
    }
    assertTrue(least < 200, "bytes in 60 steps: " + least);
  }
}
