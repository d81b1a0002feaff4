package carom.physics.rows;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.JointType;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Shape;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Rows of joints: another world that takes jointed bodies over goes on alike, to the bit. */
final class JointRowsTest {
  private static final float DT = 1 / 60f;
  private static final int TICKS = 600;
  private static final Material RUBBER = new Material(1, 1.2f, 0.1f);

  /** Machines of bodies and joints; together they use every type of joint. */
  enum Machine {
    /** Wheels with limits, springs and motors. */
    CAR {
      @Override
      void build(Rig r) {
        Body<String> chassis = r.body(new Box(1.4f, 0.3f), 0, 1.4f);
        Body<String> rear = r.body(new Circle(0.45f), -1, 0.8f);
        Body<String> front = r.body(new Circle(0.45f), 1, 0.8f);
        r.joint(
            JointDef.wheel(chassis, rear, -1, 0.8f, 0, 1)
                .limits(-0.3f, 0.3f)
                .spring(4, 0.7f)
                .motor(-9, 20));
        r.joint(JointDef.wheel(chassis, front, 1, 0.8f, 0, 1).spring(5, 0.6f));
      }
    },

    /** Revolutes with limits. */
    RAGDOLL {
      @Override
      void build(Rig r) {
        Body<String> torso = r.body(new Capsule(0, -0.3f, 0, 0.3f, 0.17f), 0, 3);
        Body<String> head = r.body(new Circle(0.17f), 0, 3.65f);
        r.joint(JointDef.revolute(torso, head, 0, 3.45f).limits(-0.6f, 0.6f));
        for (int side = -1; side <= 1; side += 2) {
          Body<String> upper = r.body(new Capsule(0, 0, 0, -0.3f, 0.07f), side * 0.2f, 3.3f);
          Body<String> lower = r.body(new Capsule(0, 0, 0, -0.3f, 0.06f), side * 0.2f, 3);
          r.joint(JointDef.revolute(torso, upper, side * 0.2f, 3.3f).limits(-2.4f, 2.4f));
          r.joint(JointDef.revolute(upper, lower, side * 0.2f, 3).limits(0, 2.2f).spring(2, 0.4f));
        }
      }
    },

    /** Plain revolutes in a row, held by the world and by a static body. */
    BRIDGE {
      @Override
      void build(Rig r) {
        Body<String> last = null;
        for (int i = 0; i < 10; i++) {
          Body<String> plank = r.body(new Box(0.4f, 0.12f), -4.5f + i, 4);
          r.joint(JointDef.revolute(last, plank, -5 + i, 4).breaksAt(20_000, 1e6f));
          last = plank;
        }
        r.joint(JointDef.revolute(last, r.floor, 5, 4));
        r.body(new Circle(0.6f), 0.3f, 6);
      }
    },

    /** A static body among those that are taken over, which holds what rests beside a motor. */
    POST {
      @Override
      void build(Rig r) {
        Body<String> post = r.body(BodyType.STATIC, new Box(0.2f, 0.5f), -1.2f, 0.5f);
        Body<String> plank = r.body(new Box(1, 0.3f), 0, 0.3f);
        Body<String> fan = r.body(new Circle(0.1f), 0, 1.5f);
        r.joint(JointDef.revolute(post, plank, -1, 0.3f));
        r.joint(JointDef.revolute(plank, fan, 0, 1.5f).motor(20, 1));
      }
    },

    /** Gear and rack, a revolute that counts turns, a prismatic with limits. */
    GEARS {
      @Override
      void build(Rig r) {
        Body<String> one = r.body(new Circle(0.5f), -2, 3);
        Body<String> two = r.body(new Circle(1), 0, 3);
        Body<String> rack = r.body(new Box(0.2f, 1), 2, 3);
        r.joint(JointDef.revolute(null, one, -2, 3).limits(-40, 9).motor(8, 50));
        r.joint(JointDef.revolute(r.floor, two, 0, 3));
        r.joint(JointDef.prismatic(null, rack, 2, 3, 0, 1).limits(-1.5f, 2).spring(1, 0.1f));
        r.joint(JointDef.gear(one, two, -0.5f));
        r.joint(JointDef.rack(two, rack, 0, 1, 0.4f));
      }
    },

    /** Slide, rope, rod, weld, and what draws bodies to a target. */
    CRANE {
      @Override
      void build(Rig r) {
        Body<String> trolley = r.body(new Box(0.5f, 0.2f), 0, 6);
        Body<String> hook = r.body(new Box(0.2f, 0.2f), 0, 4);
        Body<String> load = r.body(new Box(0.5f, 0.3f), 0, 3.4f);
        Body<String> left = r.body(new Box(0.3f, 0.3f), -4, 2);
        Body<String> right = r.body(new Box(0.3f, 0.4f), 4, 2);
        Body<String> drone = r.body(new Box(0.4f, 0.1f), 3, 5);
        r.joint(JointDef.prismatic(null, trolley, 0, 6, 1, 0).limits(-3, 3).motor(1, 300));
        r.joint(JointDef.rope(trolley, hook, 0, 6, 0, 4, 2.4f));
        r.joint(JointDef.weld(hook, load, 0, 3.7f).angularSpring(3, 0.3f));
        r.joint(JointDef.pulley(left, right, -4, 2, 4, 2, -4, 7, 4, 7, 1));
        r.joint(JointDef.motor(null, drone, 60, 30));
        r.joint(JointDef.mouse(left, -4, 2, 40));
        r.joint(JointDef.distance(right, drone, 4, 2, 3, 5).limits(1, 4).spring(2, 0.2f));
      }
    },

    /** A heavy load on a boom of welds that turns on a hinge, with a rod: a joint tree. */
    BOOM {
      @Override
      void build(Rig r) {
        Body<String> last = null;
        for (int i = 0; i < 12; i++) {
          Body<String> piece = r.body(new Box(0.25f, 0.1f), 0.5f * i, 6);
          r.joint(
              i == 0
                  ? JointDef.revolute(null, piece, -0.25f, 6)
                  : JointDef.weld(last, piece, 0.5f * i - 0.25f, 6));
          last = piece;
        }
        Body<String> load = r.body(new Box(1.5f, 1.5f), 5.5f, 3);
        r.joint(JointDef.distance(last, load, 5.5f, 6, 5.5f, 4.5f));
      }
    },

    /** A winch with a ratchet, a piston, a slide in a groove, and drag. */
    WINCH {
      @Override
      void build(Rig r) {
        Body<String> drum = r.body(new Circle(0.6f), 0, 4);
        Body<String> sled = r.body(new Box(0.4f, 0.2f), 3, 3);
        Body<String> piston = r.body(new Box(0.3f, 0.3f), -3, 3);
        Body<String> stone = r.body(new Circle(0.3f), -3, 1.5f);
        r.joint(JointDef.ratchet(r.floor, drum, 0, 4, 0.4f).motor(2, 40));
        r.joint(JointDef.groove(null, sled, 1.5f, 3.5f, 5, 2, 3, 3));
        r.joint(JointDef.friction(null, sled, 3, 3, 2, 1));
        r.joint(JointDef.distance(null, piston, -3, 6, -3, 3).limits(1, 4).motor(1, 60));
        r.joint(JointDef.friction(piston, stone, -3, 1.5f, 5, 1));
      }
    };

    abstract void build(Rig r);
  }

  /** A machine in a world of its own, on a floor with a step. */
  private static final class Rig {
    final World<String> world = new World<>(new WorldDef());
    final List<Body<String>> bodies = new ArrayList<>();
    final List<Joint<String>> joints = new ArrayList<>();
    final List<int[]> definitions = new ArrayList<>();
    final Body<String> floor;

    Rig() {
      floor = fixed(0, -1, 60, 1);
      fixed(6, 0, 0.5f, 0.15f);
      fixed(0, 500, 60, 1);
    }

    private Body<String> fixed(float x, float y, float halfWidth, float halfHeight) {
      BodyDef def = new BodyDef().shape(new Box(halfWidth, halfHeight), RUBBER);
      return world.createBody(def.position(x, y), "fixed");
    }

    Body<String> body(Shape shape, float x, float y) {
      return body(BodyType.DYNAMIC, shape, x, y);
    }

    Body<String> body(BodyType type, Shape shape, float x, float y) {
      BodyDef def = new BodyDef(type).shape(shape, RUBBER, Filter.DEFAULT);
      Body<String> body = world.createBody(def.position(x, y), "part" + bodies.size());
      bodies.add(body);
      return body;
    }

    void joint(JointDef<String> def) {
      Joint<String> joint = world.createJoint(def);
      int[] definition = new int[JointDefRow.INTS];
      world.readJoint(joint, definition, 0);
      joints.add(joint);
      definitions.add(definition);
    }

    ExactRows read() {
      ExactRows rows = new ExactRows();
      for (Body<String> body : bodies) {
        rows.addBody(body.index());
      }
      assertEquals(0, world.readRows(rows));
      assertEquals(0, rows.cutJoints());
      return rows;
    }

    /** Makes the joints of another rig's bodies here, and takes its state over. */
    void takeOver(Rig other) {
      ExactRows rows = other.read();
      for (int i = joints.size() - 1; i >= 0; i--) {
        world.destroyJoint(joints.get(i));
      }
      joints.clear();
      for (int i = 0; i < other.joints.size(); i++) {
        Joint<String> from = other.joints.get(i);
        joints.add(
            world.createJoint(
                twin(other, from.bodyA()), twin(other, from.bodyB()), other.definitions.get(i), 0));
        rows.setJointSlot(i, joints.get(i).index());
      }
      for (int i = 0; i < bodies.size(); i++) {
        rows.setSlot(i, bodies.get(i).index());
      }
      world.writeRows(rows);
    }

    private Body<String> twin(Rig other, Body<String> body) {
      return body == null
          ? null
          : body == other.floor ? floor : bodies.get(other.bodies.indexOf(body));
    }
  }

  /** Does to a rig what a game may do, at a tick; the same for equal numbers. */
  private static void rule(Rig r, long seed, int tick) {
    Random random = new Random(seed * 31 + tick);
    if (random.nextInt(40) > 0) {
      return;
    }
    Body<String> body = r.bodies.get(random.nextInt(r.bodies.size()));
    body.applyImpulse(random.nextFloat() * 4 - 2, random.nextFloat() * 4);
    Joint<String> joint = r.joints.get(random.nextInt(r.joints.size()));
    float number = random.nextFloat();
    switch (joint.type()) {
      case REVOLUTE, WHEEL -> {
        joint.setMotor(number * 8 - 4, 30);
        if (joint.ratio() == 0) {
          joint.setLimits(-0.4f - number, 0.4f + number);
        }
      }
      case PRISMATIC -> joint.setMotor(number * 4 - 2, 200);
      case DISTANCE -> joint.setSpring(1 + number, 0.5f);
      case MOUSE, MOTOR -> joint.setTarget(number * 4 - 2, 3 + number);
      case WELD -> joint.setSpring(number * 4, 0.5f);
      default -> joint.bodyA().applyAngularImpulse(number);
    }
  }

  @ParameterizedTest
  @EnumSource(Machine.class)
  void aWorldThatTakesJointedBodiesOverGoesOnAlike(Machine machine) {
    long seed = new Random().nextLong();
    Random random = new Random(seed);
    for (int run = 0; run < 6; run++) {
      boolean ruled = run % 2 == 0;
      int at = run == 5 ? 900 : random.nextInt(240);
      String where = machine + " seed=" + seed + " run=" + run + " at=" + at + " tick=";
      Rig one = new Rig();
      machine.build(one);
      for (int tick = 0; tick < at; tick++) {
        if (ruled) {
          rule(one, seed + run, tick);
        }
        one.world.step(DT);
      }
      Rig other = new Rig();
      for (int i = random.nextInt(5); i >= 0; i--) {
        other.world.createBody(
            new BodyDef(BodyType.DYNAMIC).shape(new Box(1, 1), RUBBER).position(3 * i, 502), "far");
      }
      machine.build(other);
      other.takeOver(one);
      for (int tick = at; tick < at + TICKS; tick++) {
        assertEquals(one.read().hash(), other.read().hash(), where + tick);
        if (ruled || tick == at + 300) {
          rule(one, seed + run, tick);
          rule(other, seed + run, tick);
        }
        one.world.step(DT);
        other.world.step(DT);
      }
      assertTrue(one.read().joints().count() == one.joints.size(), "none broke");
    }
  }

  @Test
  void theMachinesUseEveryTypeOfJointAndSomeSleep() {
    Set<JointType> seen = EnumSet.noneOf(JointType.class);
    boolean slept = false;
    for (Machine machine : Machine.values()) {
      Rig r = new Rig();
      machine.build(r);
      r.joints.forEach(joint -> seen.add(joint.type()));
      for (int i = 0; i < 900; i++) {
        r.world.step(DT);
      }
      ExactRows rows = r.read();
      for (int i = 0; i < rows.bodies().count(); i++) {
        slept |= rows.isAsleep(i);
      }
    }
    assertEquals(EnumSet.allOf(JointType.class), seen);
    assertTrue(slept, "the run that takes over after 900 ticks has bodies that sleep");
  }

  @Test
  void aJointWithABodyThatIsNotListedIsLeftOutAndCountedApart() {
    Rig r = new Rig();
    Machine.CAR.build(r);
    ExactRows rows = new ExactRows();
    rows.addBody(r.bodies.get(0).index());
    rows.addBody(r.bodies.get(1).index());
    assertEquals(0, r.world.readRows(rows));
    assertEquals(1, rows.cutJoints());
    assertEquals(1, rows.joints().count());
    assertEquals(r.joints.get(0).index(), rows.jointSlot(0));
    assertEquals(0, rows.joints().get(0, JointRow.END_A));
    assertEquals(1, rows.joints().get(0, JointRow.END_B));
  }

  @Test
  void aBrokenJointIsGoneInBothWorldsAtTheSameTick() {
    Rig one = new Rig();
    Body<String> weight = one.body(new Box(0.5f, 0.5f), 0, 5);
    one.joint(JointDef.distance(null, weight, 0, 8, 0, 5).breaksAt(60, 10));
    Rig other = new Rig();
    Body<String> copy = other.body(new Box(0.5f, 0.5f), 0, 5);
    other.joint(JointDef.distance(null, copy, 0, 8, 0, 5));
    one.world.step(DT);
    other.takeOver(one);
    List<String> told = new ArrayList<>();
    one.world.jointListener(joint -> told.add("one"));
    other.world.jointListener(joint -> told.add("other"));
    weight.applyForce(0, -100);
    copy.applyForce(0, -100);
    one.world.step(DT);
    other.world.step(DT);
    assertEquals(List.of("one", "other"), told);
    assertEquals(0, one.world.jointCount() + other.world.jointCount());
    assertEquals(one.read().hash(), other.read().hash());
  }

  @Test
  void aDamagedDefinitionMakesNoJoint() {
    Rig r = new Rig();
    Machine.CAR.build(r);
    Body<String> a = r.bodies.get(1);
    Body<String> b = r.bodies.get(2);
    int before = r.world.jointCount();
    long seed = new Random().nextLong();
    Random random = new Random(seed);
    int refused = 0;
    for (int i = 0; i < 2_000; i++) {
      int[] definition = r.definitions.get(0).clone();
      definition[random.nextInt(JointDefRow.INTS)] = random.nextInt();
      Joint<String> made = null;
      try {
        made = r.world.createJoint(a, b, definition, 0);
      } catch (IllegalArgumentException e) {
        refused++;
        assertNotNull(e.getMessage());
      }
      if (made != null) {
        r.world.destroyJoint(made);
      }
      assertEquals(before, r.world.jointCount(), "seed=" + seed);
    }
    assertTrue(refused > 100, "refused=" + refused + " seed=" + seed);
    int[] type = r.definitions.get(0).clone();
    type[JointDefRow.TYPE] = JointType.GEAR.ordinal();
    assertThrows(
        IllegalArgumentException.class, () -> r.world.createJoint(null, b, type, 0), "a gear");
  }

  @Test
  void damagedRowsLeaveAWorldThatCanBeStepped() {
    long seed = new Random().nextLong();
    Random random = new Random(seed);
    for (int i = 0; i < 200; i++) {
      Rig one = new Rig();
      Machine.CRANE.build(one);
      ExactRows rows = one.read();
      for (int k = 0; k < 8; k++) {
        int field = 1 + random.nextInt(JointRow.INTS - 1);
        int value = random.nextInt(4) == 0 ? 0x7fc00000 : random.nextInt();
        rows.joints().set(random.nextInt(rows.joints().count()), field, value);
      }
      for (int k = 0; k < rows.bodies().count(); k++) {
        rows.setSlot(k, one.bodies.get(k).index());
      }
      one.world.writeRows(rows);
      one.world.step(DT);
      Joint<String> joint = one.joints.get(random.nextInt(one.joints.size()));
      assertTrue(joint.lower() <= joint.upper(), "seed=" + seed + " joint=" + joint);
    }
  }

  @Test
  void aWorldTellsOfJointsThatComeAndGo() {
    Rig r = new Rig();
    List<String> told = new ArrayList<>();
    r.world.jointListener(
        new carom.physics.JointListener<>() {
          @Override
          public void broke(Joint<String> joint) {}

          @Override
          public void created(Joint<String> joint) {
            told.add("+" + joint.index());
          }

          @Override
          public void destroyed(Joint<String> joint) {
            told.add("-" + joint.index());
          }
        });
    Machine.CAR.build(r);
    r.world.destroyBody(r.bodies.get(0));
    assertEquals(List.of("+0", "+1", "-1", "-0"), told);
  }
}
