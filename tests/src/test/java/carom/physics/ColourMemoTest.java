package carom.physics;

import static carom.physics.Scenes.DT;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.geometry.Box;
import carom.physics.threads.WorkerThreads;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * A world that goes on with the colours of steps before computes the bits of one that has none: of
 * a world made for this one step alone. In a wall that stands for runs of steps, so that colours
 * are kept, while all that they follow from changes in between: rows, points, masses, who is awake,
 * materials, vetoes, and the whole state.
 */
class ColourMemoTest {
  private static final int TICKS = 150;

  /** Whether contacts of some bodies are refused in the tick at hand. */
  private boolean vetoing;

  private World<String> wall() {
    World<String> w = new World<>(new WorldDef());
    w.createBody(new BodyDef().position(0, -1).shape(new Box(20, 1)), "floor");
    for (int i = 0; i < 60; i++) {
      int row = i / 12;
      w.createBody(brick(i % 12 * 1.01f + row % 2 * 0.5f - 6, 0.26f + row * 0.5f), "brick");
    }
    w.listener(
        new CollisionListener<>() {
          @Override
          public boolean preSolve(Collision<String> contact) {
            return !vetoing || contact.self().index() % 13 != 5;
          }
        });
    return w;
  }

  private static BodyDef brick(float x, float y) {
    return new BodyDef(BodyType.DYNAMIC).position(x, y).shape(new Box(0.5f, 0.25f));
  }

  private static void edit(World<String> w, Random random) {
    Body<String> one = w.body(1 + random.nextInt(w.slotCount() - 1));
    if (one == null) {
      return;
    }
    switch (random.nextInt(9)) {
      case 0 -> one.setVelocity(random.nextFloat() * 4 - 2, 3);
      case 1 -> one.setType(one.type() == BodyType.STATIC ? BodyType.DYNAMIC : BodyType.STATIC);
      case 2 -> one.setType(BodyType.KINEMATIC);
      case 3 -> one.setMaterial(0, new Material(2, random.nextFloat(), 0.5f));
      case 4 -> w.destroyBody(one);
      case 5 -> one.sleep();
      case 6 -> w.createBody(brick(random.nextFloat() * 10 - 5, 3.5f), "new");
      case 7 -> one.setFixedRotation(random.nextBoolean());
      default -> one.wake();
    }
  }

  /** The moving ones stay the same, and so does what is known of them alone. */
  @Test
  void bodiesThatDoNotMoveMayComeInAnyNumber() {
    for (int workers = 1; workers <= 2; workers++) {
      World<String> w = wall();
      try (WorkerThreads threads = new WorkerThreads(workers)) {
        w.workers(threads);
        for (int i = 0; i < 600; i++) {
          w.createBody(new BodyDef().position(i, -9).shape(new Box(0.4f, 0.4f)), "pillar");
          w.step(DT);
        }
      }
    }
  }

  @Test
  void worldsWithAndWithoutColoursOfBeforeAgree() throws Exception {
    for (long seed = 1; seed <= 3; seed++) {
      Random random = new Random(seed);
      World<String> w = wall();
      WorldState earlier = w.save(null);
      for (int tick = 0; tick < TICKS; tick++) {
        String where = "seed=" + seed + " tick=" + tick;
        switch (random.nextInt(12)) {
          case 0 -> w.save(earlier);
          case 1 -> w.restore(earlier);
          default -> {}
        }
        ArchiveWriter bytes = new ArchiveWriter();
        w.save(null).write(bytes);
        World<String> fresh = wall();
        fresh.restore(fresh.read(new ArchiveReader(bytes.toBytes()), slot -> "read"));
        if (random.nextInt(6) == 0) {
          long change = random.nextLong();
          edit(w, new Random(change));
          edit(fresh, new Random(change));
        }
        vetoing = random.nextInt(6) == 0;
        assertEquals(w.stateHash(), fresh.stateHash(), where);
        w.step(DT);
        fresh.step(DT);
        assertEquals(w.stateHash(), fresh.stateHash(), where);
      }
      assertTrue(w.bodyCount() > 20, "seed=" + seed);
    }
  }
}
