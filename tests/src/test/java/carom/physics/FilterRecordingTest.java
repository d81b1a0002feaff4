package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.steps;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.archive.ArchiveException;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.threads.WorkerThreads;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/**
 * Worlds whose program decides which shapes meet are recorded, and replayed without the program.
 */
final class FilterRecordingTest {
  private static final int MUCH = 1 << 24;

  private static final CollisionFilter<String> SOME =
      (self, i, other, j) -> (3 * self.index() + other.index()) % 4 > 0;

  private static void assertReplays(World<?> w, List<Long> hashes, byte[] recording, String where) {
    WorldReplay replay = new WorldReplay(recording);
    for (int i = 0; i < hashes.size(); i++) {
      assertTrue(replay.step(), where + " step=" + i + ": " + replay.difference());
      assertEquals(hashes.get(i), replay.world().stateHash(), where + " step=" + i);
    }
    assertNull(replay.run(), where);
    assertEquals(w.stateHash(), replay.world().stateHash(), where);
  }

  /** Method: half of the recordings begin in the middle, when bodies touch, move and sleep. */
  @Test
  void aReplayNeedsNoFilterAndRecordingChangesNoBit() {
    for (int before : new int[] {0, 90, 700}) {
      World<String> plain = Scenes.pile(60, 5);
      World<String> w = Scenes.pile(60, 5);
      plain.collisionFilter(SOME);
      w.collisionFilter(SOME);
      steps(plain, before);
      steps(w, before);
      WorldRecorder recorder = new WorldRecorder(w, MUCH, 1);
      List<Long> hashes = new ArrayList<>();
      for (int i = 0; i < 150; i++) {
        if (i == 70) {
          plain.body(9).applyImpulse(1, 2);
          w.body(9).applyImpulse(1, 2);
        }
        plain.step(DT);
        w.step(DT);
        hashes.add(w.stateHash());
        assertEquals(plain.stateHash(), w.stateHash(), "before=" + before + " step=" + i);
      }
      assertReplays(w, hashes, recorder.finish(), "before=" + before);
    }
  }

  /** Something that a program with sides, refilters and filters of many kinds may do. */
  private static void change(World<String> w, int[] sides, SplittableRandom random) {
    List<Body<String>> all = new ArrayList<>();
    w.forEachBody(all::add);
    Body<String> body = all.get(random.nextInt(all.size()));
    boolean moves = body.type() == BodyType.DYNAMIC;
    switch (random.nextInt(8)) {
      case 0, 1, 2 -> {
        sides[body.index()] = random.nextInt(4);
        body.refilter();
      }
      case 3 -> body.applyImpulse(0.2f, 1);
      case 4 -> {
        if (moves && all.size() > 20) {
          w.destroyBody(body);
        }
      }
      case 5 -> {
        BodyDef d = new BodyDef(BodyType.DYNAMIC).position(random.nextInt(7) - 3, 6);
        sides[w.createBody(d.shape(new Circle(.3f)).shape(new Box(.1f, .4f)), "new").index()] = 1;
      }
      case 6 -> {
        if (moves) {
          body.addShape(new ShapeDef(new Circle(.15f)));
        }
      }
      default -> {
        if (body.shapeCount() > 1) {
          body.removeShape(0);
        }
      }
    }
  }

  private static CollisionFilter<String> bySides(int[] sides) {
    return (self, i, other, j) ->
        self.type() == BodyType.STATIC || sides[self.index()] + i % 2 != sides[other.index()];
  }

  @Test
  void whatProgramsDoWithTheirFiltersIsComputedAgainBitForBit() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println("FilterRecordingTest seed=" + seed);
    for (int round = 0; round < 8; round++) {
      SplittableRandom random = new SplittableRandom(seed + round);
      World<String> w = Scenes.pile(50, seed + round);
      int[] sides = new int[4096];
      if (round % 2 == 0) {
        w.collisionFilter(bySides(sides));
      }
      steps(w, 40 * round);
      WorldRecorder recorder = new WorldRecorder(w, MUCH, round % 3);
      if (round > 3) {
        w.listener(
            new CollisionListener<>() {
              @Override
              public void begin(Collision<String> c) {
                if (random.nextInt(6) == 0) {
                  change(w, sides, random);
                }
              }
            });
      }
      WorldState saved = w.save(null);
      int[] savedSides = sides.clone();
      List<Long> hashes = new ArrayList<>();
      for (int i = 0; i < 240; i++) {
        if (random.nextInt(4) == 0) {
          change(w, sides, random);
        }
        switch (i) {
          case 60 -> w.collisionFilter(bySides(sides));
          case 100 -> {
            w.restore(saved);
            System.arraycopy(savedSides, 0, sides, 0, sides.length);
            if (round % 2 == 1) { // that state knows no filter
              w.collisionFilter(bySides(sides));
            }
          }
          case 130 -> w.collisionFilter(null);
          case 150 -> w.collisionFilter(SOME);
          case 180 -> w.collisionFilter(bySides(sides));
          default -> {}
        }
        w.step(DT);
        hashes.add(w.stateHash());
      }
      assertReplays(w, hashes, recorder.finish(), "seed=" + seed + " round=" + round);
    }
  }

  @Test
  void threadsShowNeitherInTheRecordingNorInTheReplay() {
    try (WorkerThreads workers = new WorkerThreads(2)) {
      List<Long> hashes = new ArrayList<>();
      byte[][] recordings = new byte[2][];
      for (int shared = 0; shared < 2; shared++) {
        World<String> w = Scenes.pile(800, 9);
        w.workers(shared == 1 ? workers : null);
        w.collisionFilter(SOME);
        WorldRecorder recorder = new WorldRecorder(w, MUCH, 1);
        hashes.clear();
        for (int i = 0; i < 60; i++) {
          w.step(DT);
          hashes.add(w.stateHash());
        }
        recordings[shared] = recorder.finish();
      }
      assertArrayEquals(recordings[0], recordings[1]);
      for (int shared = 0; shared < 2; shared++) {
        WorldReplay replay = new WorldReplay(recordings[0]);
        replay.world().workers(shared == 1 ? workers : null);
        for (long hash : hashes) {
          assertTrue(replay.step(), replay.difference());
          assertEquals(hash, replay.world().stateHash());
        }
      }
    }
  }

  private static World<String> heap() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    for (int i = 0; i < 6; i++) {
      Scenes.disc(w, 0.1f * i, 1 + i, .5f, Material.DEFAULT);
    }
    return w;
  }

  private static byte[] recorded(CollisionFilter<String> filter) {
    World<String> w = heap();
    w.collisionFilter(filter);
    WorldRecorder recorder = new WorldRecorder(w, MUCH, 1);
    steps(w, 200);
    return recorder.finish();
  }

  @Test
  void onlyRefusalsAndChangesTakeBytesAndEachPairOnce() {
    int none = recorded(null).length;
    assertEquals(none, recorded((self, i, other, j) -> true).length);
    int all = recorded((self, i, other, j) -> self.index() == 0).length;
    int pairs = 6 * 5 / 2;
    assertTrue(all > none && all <= none + 6 * pairs, "bytes=" + (all - none));
  }

  /** Goal: the answers in the file are what decides. Method: one refusal less is a difference. */
  @Test
  void withoutItsAnswersARecordingGoesAnotherWay() {
    byte[] bytes = recorded((self, i, other, j) -> self.index() == 0);
    assertNull(new WorldReplay(bytes).run());
    int allowed = 0;
    for (int i = 0; i < bytes.length - 6; i++) {
      // the pair of discs 1 and 2, refused within a call and before any callback
      if ((bytes[i] & 0xff) == (WorldRecorder.NESTED | Call.REFUSE_PAIR.ordinal())
          && bytes[i + 1] == 0
          && bytes[i + 2] == 2
          && bytes[i + 3] == 0
          && bytes[i + 4] == 4
          && bytes[i + 5] == 0) {
        bytes[i] = (byte) (WorldRecorder.NESTED | Call.ALLOW_PAIR.ordinal());
        allowed++;
      }
    }
    assertEquals(1, allowed);
    String difference = new WorldReplay(WorldReplayTest.sealed(bytes)).run();
    assertNotNull(difference);
    assertTrue(difference.contains("state hash"), difference);
  }

  @Test
  void damagedAnswersEndInAReasonOrADifference() {
    byte[] bytes = recorded((self, i, other, j) -> self.index() == 0);
    byte refuse = (byte) (WorldRecorder.NESTED | Call.REFUSE_PAIR.ordinal());
    int at = 0;
    while (bytes[at] != refuse || bytes[at + 1] != 0 || bytes[at + 3] != 0) {
      at++;
    }
    byte[] swapped = bytes.clone();
    swapped[at + 2] = 40;
    assertTrue(refusal(swapped).contains("bodies=20 and"), refusal(swapped));
    byte[] negative = bytes.clone();
    negative[at + 3] = 1;
    assertTrue(refusal(negative).contains("shapes=-1 and 0 of a pair"), refusal(negative));

    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println("FilterRecordingTest seed=" + seed);
    SplittableRandom random = new SplittableRandom(seed);
    for (int i = 0; i < 300; i++) {
      byte[] damaged = bytes.clone();
      damaged[at + random.nextInt(40)] = (byte) random.nextInt();
      String end;
      try {
        end = "" + new WorldReplay(WorldReplayTest.sealed(damaged)).run();
      } catch (ArchiveException e) {
        end = e.getMessage();
      }
      assertFalse(end.isEmpty(), "seed=" + seed);
    }
  }

  private static String refusal(byte[] bytes) {
    WorldReplay replay = new WorldReplay(WorldReplayTest.sealed(bytes));
    return assertThrows(ArchiveException.class, replay::run).getMessage();
  }

  @Test
  void answersStayWithinTheBoundOfTheRecording() {
    World<String> w = heap();
    w.collisionFilter((self, i, other, j) -> self.index() == 0);
    int start = new WorldRecorder(w, MUCH, 1).finish().length;
    WorldRecorder recorder = new WorldRecorder(w, start + 60, 0);
    steps(w, 200);
    assertTrue(recorder.isFull());
    byte[] bytes = recorder.finish();
    assertTrue(bytes.length <= start + 60, "bytes=" + bytes.length);
    assertNull(new WorldReplay(bytes).run());
  }
}
