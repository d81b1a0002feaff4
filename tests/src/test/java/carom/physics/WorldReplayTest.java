package carom.physics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.archive.ArchiveException;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.MassData;
import carom.physics.math.Aabb;
import carom.physics.profile.StageListener;
import carom.physics.rows.BodyRow;
import carom.physics.rows.ExactRows;
import carom.physics.rows.JointDefRow;
import carom.physics.threads.Workers;
import carom.sim.scene.SceneRun;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Recordings of calls go on bit for bit, miss no call, and are refused when they are damaged. */
class WorldReplayTest {
  private static final float DT = 1 / 60f;
  private static final int MUCH = 1 << 26;

  /** Methods that change no state, though they return nothing. */
  private static final Set<String> QUIET =
      Set.of(
          "World.workers",
          "World.stageListener",
          "World.eventLists", // only tells
          "World.queryScope",
          "World.refuseDuringQuery",
          "World.seal",
          "World.readJoint",
          "World.readMotions",
          "World.queryAabb",
          "World.forEachJoint",
          "World.forEachBody",
          "World.forEachAwake",
          "World.forEachContact",
          "World.forEachTreeCell",
          "World.forEachAabb",
          "Body.readRow",
          "Body.aabb",
          "Body.forEachContact",
          "Body.forEachOverlap",
          "Body.forEachJoint",
          "Body.setShapeUser");

  private final List<Body<String>> bodies = new ArrayList<>();

  private World<String> world() {
    World<String> w = new World<>(new WorldDef());
    bodies.clear();
    w.createBody(new BodyDef(BodyType.STATIC).position(0, -1).shape(new Box(50, 1)), "floor");
    for (int i = 0; i < 12; i++) {
      bodies.add(
          w.createBody(
              new BodyDef(BodyType.DYNAMIC)
                  .position(i % 4 - 1.5f, 0.5f + Math.floorDiv(i, 4) * 1.02f)
                  .shape(i % 3 == 0 ? new Circle(0.5f) : new Box(0.5f, 0.5f)),
              "body" + i));
    }
    w.createJoint(JointDef.revolute(bodies.get(0), bodies.get(1), -1, 0.5f).motor(1, 5));
    w.createJoint(JointDef.distance(bodies.get(4), bodies.get(5), -1.5f, 1.5f, -0.5f, 1.5f));
    return w;
  }

  /** Calls something at random, as a game may do between steps or in a callback. */
  private static void call(World<String> w, SplittableRandom random) {
    List<Body<String>> all = new ArrayList<>();
    w.forEachBody(all::add);
    Body<String> body = all.get(random.nextInt(all.size()));
    float a = (float) (4 * random.nextDouble() - 2);
    float b = (float) (4 * random.nextDouble() - 2);
    switch (random.nextInt(16)) {
      case 0 -> body.setVelocity(a, b);
      case 1 -> body.applyForce(40 * a, 40 * b);
      case 2 -> body.applyForce(a, b, body.x() + 0.1f, body.y());
      case 3 -> body.applyImpulse(a, b, body.x(), body.y() - 0.2f);
      case 4 -> body.setMaterial(0, new Material(1, 0.5f + Math.abs(a) / 4, 0.2f));
      case 5 -> body.setAngularVelocity(a);
      case 6 -> body.setGravityScale(b);
      case 7 -> {
        if (body.type() == BodyType.DYNAMIC && all.size() > 8) {
          w.destroyBody(body);
        }
      }
      case 8 ->
          w.createBody(
              new BodyDef(BodyType.DYNAMIC)
                  .position(3 * a, 4 + b)
                  .bullet(a > 0)
                  .linearDamping(0.1f)
                  .shape(new Circle(0.3f)),
              "new");
      case 9 -> {
        Body<String> other = all.get(random.nextInt(all.size()));
        if (other != body) {
          w.createJoint(JointDef.distance(body, other, body.x(), body.y(), other.x(), other.y()));
        }
      }
      case 10 -> {
        if (w.jointCount() > 0) {
          w.forEachJoint(joint -> last = joint);
          w.destroyJoint(cast(last));
        }
      }
      case 11 -> body.setFilter(0, new Filter(1, a > 1 ? 0 : -1, 0));
      case 12 -> body.setSleepAllowed(a > 0);
      case 13 -> body.wake();
      case 14 -> body.setFixedRotation(a > 0);
      default -> body.applyTorque(a);
    }
  }

  private static Joint<?> last;

  @SuppressWarnings("unchecked")
  private static Joint<String> cast(Joint<?> joint) {
    return (Joint<String>) joint;
  }

  private static CollisionListener<String> meddler(World<String> w, SplittableRandom random) {
    return new CollisionListener<>() {
      @Override
      public void begin(Collision<String> c) {
        if (random.nextInt(4) == 0) {
          call(w, random);
        }
      }

      @Override
      public boolean preSolve(Collision<String> c) {
        return random.nextInt(12) > 0;
      }

      @Override
      public void postSolve(Collision<String> c) {
        if (random.nextInt(60) == 0) {
          c.self().applyImpulse(0.1f, 1);
        }
      }
    };
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 7})
  void whatAGameDoesIsComputedAgainBitForBit(int stepsPerHash) {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println("WorldReplayTest seed=" + seed);
    for (int round = 0; round < 5; round++) {
      SplittableRandom random = new SplittableRandom(seed + round);
      World<String> w = world();
      for (int i = 0; i < 20 * round; i++) {
        w.step(DT);
      }
      w.listener(round == 0 ? null : meddler(w, random));
      WorldRecorder recorder = new WorldRecorder(w, MUCH, stepsPerHash);
      WorldState saved = w.save(null);
      long[] hashes = new long[200];
      for (int i = 0; i < hashes.length; i++) {
        for (int k = random.nextInt(3); k > 0; k--) {
          call(w, random);
        }
        if (i == 120) {
          w.restore(saved);
        } else if (i == 150) {
          w.redefine(w.def().withGravity(1, -5));
        }
        w.step(DT);
        hashes[i] = w.stateHash();
      }
      WorldReplay replay = new WorldReplay(recorder.finish());
      String where = "seed=" + seed + " round " + round;
      for (int i = 0; i < hashes.length; i++) {
        boolean goesOn = replay.step();
        assertNull(replay.difference(), where);
        assertTrue(goesOn, where);
        assertEquals(hashes[i], replay.world().stateHash(), where + " step " + i);
      }
      assertFalse(replay.step());
      assertEquals(200, replay.steps());
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"bridge", "gears", "ragdolls", "mover", "one_way_platforms"})
  void scenesAreComputedAgainBitForBit(String name) {
    SceneRun run = carom.sim.scene.Scenes.get(name).start();
    WorldRecorder recorder = new WorldRecorder(run.world(), MUCH, 1);
    for (int i = 0; i < 200; i++) {
      run.step();
    }
    WorldReplay replay = new WorldReplay(recorder.finish());
    assertNull(replay.run());
    assertEquals(run.world().stateHash(), replay.world().stateHash());
    assertEquals(200, replay.steps());
  }

  // ---------------------------------------------------------------- no call is missed

  private Object argument(World<String> w, Class<?> type, String method) {
    if (type == float.class) {
      return method.equals("World.step") || method.endsWith("moveTo") ? DT : 0.0625f;
    } else if (type == int.class) {
      return 0;
    } else if (type == boolean.class) {
      return !method.equals("Body.setSleepAllowed") && !method.equals("Body.setEnabled");
    } else if (type == int[].class) {
      int[] row = new int[Math.max(JointDefRow.INTS, BodyRow.INTS)];
      if (method.equals("World.createJoint")) {
        w.readJoint(w.joint(0), row, 0);
      } else {
        bodies.get(2).readRow(row, 0);
        row[0] ^= 1;
      }
      return row;
    } else if (type == Body.class) {
      return method.equals("World.createJoint") && w.moves() >= 0 ? pick() : bodies.get(3);
    } else if (type == Joint.class) {
      return w.joint(1);
    } else if (type == BodyDef.class && method.equals("World.createChain")) {
      return new BodyDef();
    } else if (type == BodyDef.class) {
      return new BodyDef(BodyType.DYNAMIC).position(0, 9).shape(new Circle(0.4f));
    } else if (type == JointDef.class) {
      return JointDef.weld(bodies.get(6), bodies.get(7), 0, 2);
    } else if (type == WorldDef.class) {
      return w.def().withGravity(1, 1);
    } else if (type == BodyType.class) {
      return BodyType.KINEMATIC;
    } else if (type == Material.class) {
      return new Material(2, 0.9f, 0.1f);
    } else if (type == Filter.class) {
      return new Filter(4, 8, 0);
    } else if (type == ShapeDef.class) {
      return new ShapeDef(new Circle(0.2f), Material.DEFAULT);
    } else if (type == ChainDef.class) {
      return ChainDef.open(-5, 30, 0, 30, 5, 30);
    } else if (type == MotionLocks.class) {
      return new MotionLocks(true, false, false);
    } else if (type == MassData.class) {
      return new MassData(1, 1, 0, 0);
    } else if (type == WorldState.class) {
      return saved == null ? w.save(null) : saved;
    } else if (type == ExactRows.class) {
      ExactRows rows = new ExactRows();
      rows.addBody(bodies.get(2).index());
      w.readRows(rows);
      BodyDef twin = new BodyDef(BodyType.DYNAMIC).position(20, 9).shape(new Box(0.5f, 0.5f));
      rows.setSlot(0, w.createBody(twin, "twin").index());
      return rows;
    } else if (type == float[][].class) {
      return new float[World.MOTION][4];
    } else if (type == Aabb.class) {
      return new Aabb();
    } else if (type == String.class || type == Object.class) {
      return "text";
    } else if (type == Workers.class
        || type == StageListener.class
        || type == QueryFilter.class
        || type == Poses.class
        || type == ArchiveReader.class
        || type == IntFunction.class
        || type == CollisionListener.class
        || type == CollisionFilter.class
        || type == EventLists.class
        || type == JointListener.class) {
      return null;
    } else if (type == Consumer.class) {
      return (Consumer<Object>) ignored -> {};
    } else if (type == BodyVisitor.class) {
      return (BodyVisitor<String>) body -> true;
    } else if (type == BodyContactVisitor.class) {
      return (BodyContactVisitor<String>) (other, x, y, impulse) -> {};
    } else if (type == ContactVisitor.class) {
      return (ContactVisitor) (x, y, nx, ny, separation, impulse) -> {};
    } else if (type == carom.physics.broadphase.CellVisitor.class) {
      return (carom.physics.broadphase.CellVisitor) (minX, minY, maxX, maxY, depth) -> {};
    } else if (type == AabbVisitor.class) {
      return (AabbVisitor) (minX, minY, maxX, maxY) -> {};
    }
    throw new AssertionError(method + " takes a " + type + ": add a sample to this test");
  }

  private WorldState saved;
  private int picked;

  private Body<String> pick() {
    return bodies.get(8 + picked++ % 2);
  }

  private Object target(World<String> w, Class<?> of, String method) {
    if (of == World.class) {
      return w;
    } else if (of == Body.class) {
      return bodies.get(2);
    }
    return switch (method) {
      case "Joint.setTarget", "Joint.setTargetAngle" ->
          w.createJoint(JointDef.motor(bodies.get(6), bodies.get(9), 10, 10));
      default -> w.joint(0);
    };
  }

  private static byte[] bytes(World<String> w) {
    ArchiveWriter writer = new ArchiveWriter();
    w.save(null).write(writer);
    return writer.toBytes();
  }

  /**
   * Goal: a method that a later change adds can't be forgotten. Method: every public method of
   * World, Body and Joint is called. One that returns nothing, or makes something, must make the
   * recording longer, unless it is listed as quiet; all others must leave the state as it is.
   */
  @Test
  void everyMethodThatChangesAWorldIsRecorded() throws Exception {
    int recorded = 0;
    for (Class<?> of : List.of(World.class, Body.class, Joint.class)) {
      Method[] methods = of.getDeclaredMethods();
      Arrays.sort(methods, Comparator.comparing(Method::toString));
      for (Method method : methods) {
        String name = of.getSimpleName() + "." + method.getName();
        boolean open = Modifier.isPublic(method.getModifiers()) && !method.isSynthetic();
        if (!open || Modifier.isStatic(method.getModifiers())) {
          continue;
        }
        World<String> w = world();
        for (int i = 0; i < 3; i++) {
          w.step(DT);
        }
        saved = w.save(null);
        w.step(DT);
        bodies.get(3).setAngularVelocity(0.5f);
        Object target = target(w, of, name);
        WorldRecorder recorder = new WorldRecorder(w, MUCH, 1);
        Object[] arguments = new Object[method.getParameterCount()];
        for (int i = 0; i < arguments.length; i++) {
          arguments[i] = argument(w, method.getParameterTypes()[i], name);
        }
        int before = recorder.length();
        byte[] state = bytes(w);
        String refused = "";
        try {
          method.invoke(target, arguments);
        } catch (InvocationTargetException e) {
          refused = " was refused: " + e.getCause();
        }
        boolean longer = recorder.length() > before;
        boolean changes =
            method.getReturnType() == void.class || method.getName().startsWith("create");
        if (changes && !QUIET.contains(name)) {
          assertTrue(longer, method + " isn't recorded" + refused);
          recorded++;
        } else {
          boolean same = Arrays.equals(state, bytes(w));
          assertTrue(same && !longer, method + " changes the world and isn't recorded");
        }
        WorldReplay replay = new WorldReplay(recorder.finish());
        assertNull(replay.run(), method + refused);
        assertEquals(w.stateHash(), replay.world().stateHash(), method + " is another call again");
      }
    }
    assertTrue(recorded >= 50, "recorded=" + recorded);
  }

  // ---------------------------------------------------------------- what is refused

  private byte[] recording(int stepsPerHash) {
    World<String> w = world();
    WorldRecorder recorder = new WorldRecorder(w, MUCH, stepsPerHash);
    for (int i = 0; i < 30; i++) {
      bodies.get(i % 5).setVelocity(i, 1);
      bodies.get(i % 7).applyForce(3, 4);
      w.step(DT);
    }
    return recorder.finish();
  }

  /** Gives changed bytes the hash that belongs to them. */
  static byte[] sealed(byte[] bytes) {
    long hash = WorldRecorder.hashOf(bytes, bytes.length - 8);
    for (int i = 0; i < 8; i++) {
      bytes[bytes.length - 1 - i] = (byte) (hash >>> 8 * i);
    }
    return bytes;
  }

  @Test
  void theFirstCallThatDiffersIsNamed() {
    for (int stepsPerHash : new int[] {0, 1}) {
      byte[] bytes = recording(stepsPerHash);
      int at = find(bytes, Float.floatToRawIntBits(17f));
      bytes[at + 3] ^= 64;
      String difference = new WorldReplay(sealed(bytes)).run();
      assertNotNull(difference);
      assertTrue(difference.startsWith("call " + (stepsPerHash == 0 ? 52 : 54)), difference);
      assertTrue(difference.contains("in step 18"), difference);
      assertTrue(
          difference.contains(stepsPerHash == 0 ? "set velocity body=3 17.0" : "step"), difference);
    }
  }

  private static int find(byte[] bytes, int value) {
    for (int i = bytes.length - 4; i >= 0; i--) {
      int found =
          (bytes[i] & 0xff) << 24
              | (bytes[i + 1] & 0xff) << 16
              | (bytes[i + 2] & 0xff) << 8
              | bytes[i + 3] & 0xff;
      if (found == value) {
        return i;
      }
    }
    throw new AssertionError("value isn't in the recording");
  }

  private static String refusal(byte[] bytes) {
    return assertThrows(ArchiveException.class, () -> new WorldReplay(bytes)).getMessage();
  }

  @Test
  void tornForeignAndOldRecordingsAreRefusedWithTheReason() {
    byte[] bytes = recording(1);
    for (int length = 0; length < bytes.length; length += 1 + length / 40) {
      String message = refusal(Arrays.copyOf(bytes, length));
      assertTrue(message.contains(length < 16 ? "recording" : "torn"), message);
    }
    byte[] foreign = bytes.clone();
    foreign[0] ^= 1;
    assertTrue(refusal(foreign).contains("no recording"), refusal(foreign));
    byte[] format = bytes.clone();
    format[11] = 99;
    assertTrue(refusal(format).contains("format=99"), refusal(format));
    byte[] old = bytes.clone();
    old[15] = 1;
    assertTrue(refusal(old).contains("physics version=1,"), refusal(old));
    byte[] damaged = bytes.clone();
    damaged[bytes.length / 2] ^= 8;
    assertTrue(refusal(damaged).contains("damaged"), refusal(damaged));
  }

  @Test
  void damagedRecordingsEndInAReasonOrADifference() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println("WorldReplayTest seed=" + seed);
    SplittableRandom random = new SplittableRandom(seed);
    byte[] bytes = recording(1);
    for (int i = 0; i < 400; i++) {
      byte[] damaged = bytes.clone();
      damaged[16 + random.nextInt(bytes.length - 25)] = (byte) random.nextInt();
      String end;
      try {
        end = "" + new WorldReplay(sealed(damaged)).run();
      } catch (ArchiveException e) {
        end = e.getMessage();
      }
      assertFalse(end.isEmpty(), "seed=" + seed);
    }
  }

  @Test
  void aRecordingStopsAtItsBound() {
    World<String> w = world();
    int start = new WorldRecorder(w, MUCH, 1).finish().length;
    WorldRecorder recorder = new WorldRecorder(w, start + 500, 1);
    for (int i = 0; i < 100; i++) {
      w.body(1).setVelocity(1, 2);
      w.step(DT);
    }
    assertTrue(recorder.isFull());
    byte[] bytes = recorder.finish();
    assertTrue(bytes.length <= start + 500 && bytes.length > start + 400, "" + bytes.length);
    WorldReplay replay = new WorldReplay(bytes);
    assertNull(replay.run());
    assertTrue(replay.steps() >= 15 && replay.steps() < 40, "steps=" + replay.steps());
    assertThrows(IllegalArgumentException.class, () -> new WorldRecorder(w, 1024, 1));
    assertThrows(IllegalArgumentException.class, () -> new WorldRecorder(w, 1, 1));
  }
}
