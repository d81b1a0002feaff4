package carom.physics;

import static carom.physics.Scenes.DT;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.archive.ArchiveException;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import java.time.Duration;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** A state saved after edits, before the next step sees to them, goes on as bytes to the bit. */
class EditedStateTest {
  private static final int ROUNDS = Integer.getInteger("carom.rounds", 80);

  private static final WorldDef DEF = new WorldDef().withSleepDelay(0.2f);

  private static byte[] bytes(World<?> w) {
    ArchiveWriter out = new ArchiveWriter();
    w.save(null).write(out);
    return out.toBytes();
  }

  private static World<String> copy(World<String> w) {
    World<String> copy = new World<>(w.firstDef());
    ArchiveReader in = new ArchiveReader(bytes(w));
    copy.restore(copy.read(in, slot -> "read"));
    assertTrue(in.isEmpty());
    return copy;
  }

  private static BodyDef brick(float x, float y) {
    return new BodyDef(BodyType.DYNAMIC).position(x, y).shape(new Box(0.5f, 0.25f));
  }

  private static World<String> wall() {
    World<String> w = new World<>(DEF);
    w.createBody(new BodyDef().position(0, -1).shape(new Box(20, 1)), "floor");
    w.createBody(
        new BodyDef().position(2, 0.5f).shape(new ShapeDef(new Circle(1)).withSensor(true)),
        "sensor");
    for (int i = 0; i < 24; i++) {
      int row = i / 6;
      w.createBody(brick(i % 6 * 1.01f + row % 2 * 0.5f - 3, 0.255f + row * 0.505f), "brick");
    }
    return w;
  }

  /** Bodies can't wake while callbacks run; what those asked for is done right afterwards. */
  @Test
  void whoHearsOfAnEndMayWakeAnother() {
    World<String> w = wall();
    Body<String> far = w.createBody(brick(15, 0.25f).awake(false), "far");
    Body<String> sensor = w.body(1);
    w.step(DT);
    assertFalse(far.awake());
    w.listener(
        new CollisionListener<>() {
          @Override
          public void end(Collision<String> contact) {
            far.wake();
          }
        });
    sensor.setSensor(0, false);
    assertTrue(far.awake());
    World<String> copy = copy(w);
    w.step(DT);
    copy.step(DT);
    assertEquals(w.stateHash(), copy.stateHash());
  }

  private static String edit(World<String> w, Random random) {
    Body<String> one = w.body(random.nextInt(w.slotCount()));
    Body<String> two = w.body(random.nextInt(w.slotCount()));
    if (one == null) {
      return "";
    }
    int what = random.nextInt(19);
    switch (what) {
      case 0 -> one.setVelocity(random.nextFloat() * 4 - 2, 1);
      case 1, 2 -> one.setType(BodyType.values()[random.nextInt(3)]);
      case 3 -> one.setEnabled(!one.isEnabled());
      case 4 -> one.setFilter(0, new Filter(1, random.nextInt(4) == 0 ? 0 : -1, 0));
      case 5 -> w.destroyBody(one);
      case 6, 7 -> one.sleep();
      case 8 -> {
        BodyDef def = brick(random.nextFloat() * 8 - 4, random.nextFloat() * 2.5f);
        w.createBody(def.awake(false), "asleep");
      }
      case 9 -> w.createBody(brick(random.nextFloat() * 8 - 4, 3.5f), "new");
      case 10 -> one.setPose(one.x() + random.nextFloat() * 0.2f - 0.1f, one.y(), 0);
      case 11 -> w.forEachBody(Body::sleep);
      case 12 -> {
        if (two != null && two != one) {
          w.createJoint(JointDef.revolute(one, two, one.x(), one.y()));
        }
      }
      case 13 -> one.addShape(new ShapeDef(new Circle(0.2f, random.nextFloat() - 0.5f, 0.2f)));
      case 14 -> {
        if (one.shapeCount() > 1) {
          one.removeShape(random.nextInt(one.shapeCount()));
        }
      }
      case 15 ->
          one.setMotionLocks(
              new MotionLocks(random.nextBoolean(), random.nextBoolean(), random.nextBoolean()));
      case 16 -> one.setSleepSpeed(random.nextFloat() * 0.2f);
      case 17 -> w.redefine(w.def().withGravity(random.nextFloat() * 4 - 2, -10));
      default -> one.wake();
    }
    return what + " of body=" + one.index() + " ";
  }

  @Test
  void whatIsSavedAfterEditsGoesOnInAnotherWorld() {
    long first = Long.getLong("carom.seed", 1);
    for (long seed = first; seed < first + 3; seed++) {
      Random random = new Random(seed);
      World<String> w = wall();
      for (int round = 0; round < ROUNDS; round++) {
        if (w.bodyCount() < 20) {
          w = wall();
        }
        StringBuilder edits = new StringBuilder("seed=" + seed + " round=" + round + " edits: ");
        for (int i = random.nextInt(4); i > 0; i--) {
          edits.append(edit(w, random));
        }
        String where = edits.toString();
        try {
          World<String> copy = copy(w);
          assertEquals(w.stateHash(), copy.stateHash(), where);
          for (int tick = random.nextInt(4); tick >= 0; tick--) {
            w.step(DT);
            copy.step(DT);
            assertEquals(w.stateHash(), copy.stateHash(), where);
          }
          assertArrayEquals(bytes(w), bytes(copy), where);
        } catch (RuntimeException e) {
          throw new AssertionError(where, e);
        }
      }
    }
  }

  /**
   * Damage in what only edits leave behind: refused, or a world that can be stepped and changed.
   */
  @Test
  void damagedBytesOfEditedWorldsAreRefusedOrCanBeUsed() {
    long seed = Long.getLong("carom.seed", 1);
    Random random = new Random(seed);
    World<String> w = wall();
    steps(w, 40);
    for (int i = 0; i < 8; i++) {
      edit(w, random);
    }
    byte[] good = bytes(w);
    int read = 0;
    for (int round = 0; round < 100; round++) {
      byte[] damaged = good.clone();
      for (int i = random.nextInt(3); i >= 0; i--) {
        damaged[random.nextInt(damaged.length)] = (byte) random.nextInt();
      }
      World<String> copy = new World<>(DEF);
      try {
        copy.restore(copy.read(new ArchiveReader(damaged), slot -> "read"));
        read++;
        use(copy);
      } catch (ArchiveException e) {
        assertEquals(0, copy.bodyCount());
      } catch (RuntimeException | Error e) {
        throw new AssertionError("seed=" + seed + " round=" + round, e);
      }
    }
    assertTrue(read > 5 && read < 95, "read=" + read);
  }

  private static void use(World<String> w) {
    w.step(DT);
    w.forEachBody(body -> body.setMaterial(0, Material.DEFAULT));
    w.step(DT);
    w.forEachBody(Body::wake);
    w.step(DT);
    w.stateHash();
  }

  private static void steps(World<?> w, int n) {
    for (int i = 0; i < n; i++) {
      w.step(DT);
    }
  }

  /** Two bricks, one on the other. */
  private static World<String> two() {
    World<String> w = new World<>(new WorldDef());
    w.createBody(new BodyDef().position(0, -1).shape(new Box(20, 1)), "floor");
    w.createBody(brick(0, 0.25f), "low");
    w.createBody(brick(0, 0.75f), "high");
    steps(w, 20);
    return w;
  }

  @Test
  void whatRestsOnADisabledBodyIsNotPutToSleepOnIt() {
    World<String> w = two();
    Body<String> high = w.body(2);
    w.body(1).setEnabled(false);
    high.sleep();
    assertTrue(high.awake());
    assertEquals(w.stateHash(), copy(w).stateHash());
    steps(w, 60);
    assertEquals(0.25f, high.y(), 0.02f);
  }

  @Test
  void aBodyThatBecameStaticHasNoContactLeftWithTheFloor() {
    World<String> w = two();
    w.body(1).setType(BodyType.STATIC);
    w.body(2).sleep();
    assertFalse(w.body(2).awake());
    World<String> copy = copy(w);
    for (World<String> each : List.of(w, copy)) {
      Body<String> floor = each.body(0);
      assertTimeoutPreemptively(
          Duration.ofSeconds(60), () -> floor.setMaterial(0, Material.DEFAULT));
      steps(each, 2);
    }
    assertEquals(w.stateHash(), copy.stateHash());
  }
}
