package carom.physics.truth;

import static carom.physics.truth.Lab.DT;
import static org.junit.jupiter.api.Assertions.assertEquals;
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
import carom.physics.QueryHit;
import carom.physics.ShapeDef;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Compound;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Segment;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Numbers that are none, or absurd, at every public entry: refused with an error that names value
 * and parameter, and without a trace in the world.
 */
final class BadInputTest {
  private static final List<Float> BAD =
      List.of(
          Float.NaN,
          Float.POSITIVE_INFINITY,
          Float.NEGATIVE_INFINITY,
          1e30f,
          -1e30f,
          Float.MAX_VALUE);

  /** A world with everything in it that entries can be called on. */
  private static final class Subject {
    final World<String> world = new World<>(new WorldDef());
    final Body<String> body;
    final Body<String> other;
    final Map<JointType, Joint<String>> joints = new EnumMap<>(JointType.class);

    Subject() {
      Lab.fixed(world, new Box(50, 1), 0, -1, 0, Material.DEFAULT);
      body = Lab.box(world, 0, .5, .5, .5, Material.DEFAULT);
      other = Lab.disc(world, 0, 1.5, .5, Material.DEFAULT);
      for (JointType type : JointType.values()) {
        Body<String> a = Lab.disc(world, 4 + 3 * type.ordinal(), 3, .3, Material.DEFAULT);
        Body<String> b = Lab.disc(world, 5 + 3 * type.ordinal(), 3, .3, Material.DEFAULT);
        JointDef<String> d = joint(type, a, b);
        if (d != null) {
          joints.put(type, world.createJoint(d));
        }
      }
      Lab.steps(world, 5);
    }

    /** Types with constructors of their own kind are left to their own tests. */
    private static JointDef<String> joint(JointType type, Body<String> a, Body<String> b) {
      return switch (type) {
        case REVOLUTE -> JointDef.revolute(a, b, a.x(), 3);
        case DISTANCE -> JointDef.distance(a, b, a.x(), 3, b.x(), 3);
        case PRISMATIC -> JointDef.prismatic(a, b, a.x(), 3, 1, 0);
        case WELD -> JointDef.weld(a, b, a.x(), 3);
        case WHEEL -> JointDef.wheel(a, b, b.x(), 3, 0, 1);
        case MOTOR -> JointDef.motor(a, b, 10, 10);
        case MOUSE -> JointDef.mouse(b, b.x(), 3, 10);
        default -> null;
      };
    }
  }

  /** Calls an entry with a value that isn't allowed. */
  private interface Call {
    void with(Subject s, float value);
  }

  private record Entry(String name, Call call, List<Float> bad) {
    @Override
    public String toString() {
      return name;
    }
  }

  private static final List<Entry> ENTRIES = new ArrayList<>();

  private static void entry(String name, Call call, float... more) {
    List<Float> bad = new ArrayList<>(BAD);
    for (float value : more) {
      bad.add(value);
    }
    ENTRIES.add(new Entry(name, call, bad));
  }

  static {
    worlds();
    definitions();
    bodies();
    jointDefinitions();
    joints();
    queries();
    shapes();
  }

  private static void worlds() {
    WorldDef d = new WorldDef();
    entry("def.gravityX", (s, v) -> d.withGravity(v, 0), 2e4f);
    entry("def.gravityY", (s, v) -> d.withGravity(0, v), -2e4f);
    entry("def.contactHertz", (s, v) -> d.withContactHertz(v), 0, -1);
    entry("def.contactDampingRatio", (s, v) -> d.withContactDampingRatio(v), 0, -1);
    entry("def.restitutionThreshold", (s, v) -> d.withRestitutionThreshold(v), -1);
    entry("def.maxPushSpeed", (s, v) -> d.withMaxPushSpeed(v), -1);
    entry("def.slop", (s, v) -> d.withSlop(v), -1, 2);
    entry("def.speculativeDistance", (s, v) -> d.withSpeculativeDistance(v), -1, 2);
    entry("def.aabbMargin", (s, v) -> d.withAabbMargin(v), -1, 20);
    entry("def.maxSpeed", (s, v) -> d.withMaxSpeed(v), 0, -1);
    entry("def.maxAngularSpeed", (s, v) -> d.withMaxAngularSpeed(v), 0, -1);
    entry("def.jointHertz", (s, v) -> d.withJointHertz(v), 0, -1);
    entry("def.jointDampingRatio", (s, v) -> d.withJointDampingRatio(v), 0, -1);
    entry("def.substeps", (s, v) -> d.withSubsteps(v > 0 ? 33 : 0));
    entry("world.dtSeconds", (s, v) -> s.world.step(v), 0, -1, .2f);
  }

  private static void definitions() {
    entry("bodyDef.x", (s, v) -> new BodyDef().position(v, 0), 2e7f);
    entry("bodyDef.y", (s, v) -> new BodyDef().position(0, v), -2e7f);
    entry("bodyDef.angle", (s, v) -> new BodyDef().angle(v));
    entry("bodyDef.velocityX", (s, v) -> new BodyDef().velocity(v, 0), 2e5f);
    entry("bodyDef.velocityY", (s, v) -> new BodyDef().velocity(0, v), -2e5f);
    entry("bodyDef.angularVelocity", (s, v) -> new BodyDef().angularVelocity(v), 2e5f);
    entry("bodyDef.linearDamping", (s, v) -> new BodyDef().linearDamping(v), -1);
    entry("bodyDef.angularDamping", (s, v) -> new BodyDef().angularDamping(v), -1);
    entry("bodyDef.gravityScale", (s, v) -> new BodyDef().gravityScale(v), 2e3f);
    Material m = Material.DEFAULT;
    entry("material.density", (s, v) -> m.withDensity(v), -1);
    entry("material.friction", (s, v) -> m.withFriction(v), -1, 200);
    entry("material.restitution", (s, v) -> m.withRestitution(v), -1, 3);
    entry("material.rollingResistance", (s, v) -> m.withRollingResistance(v), -1, 11);
    entry("material.tangentSpeed", (s, v) -> m.withTangentSpeed(v), 2e5f);
  }

  private static void bodies() {
    entry("body.x", (s, v) -> s.body.setPose(v, 0, 0), 2e7f);
    entry("body.y", (s, v) -> s.body.setPose(0, v, 0), 2e7f);
    entry("body.angle", (s, v) -> s.body.setPose(1, 2, v));
    entry("body.cos", (s, v) -> s.body.setPose(1, 2, v, 0));
    entry("body.sin", (s, v) -> s.body.setPose(1, 2, 0, v));
    entry("body.center.x", (s, v) -> s.body.setCenterPose(v, 0, 1, 0), 2e7f);
    entry("body.center.y", (s, v) -> s.body.setCenterPose(0, v, 1, 0), 2e7f);
    entry("body.center.cos", (s, v) -> s.body.setCenterPose(3, 0, v, 0));
    entry("body.center.sin", (s, v) -> s.body.setCenterPose(3, 0, 1, v));
    entry("body.velocityX", (s, v) -> s.body.setVelocity(v, 1), 2e5f);
    entry("body.velocityY", (s, v) -> s.body.setVelocity(1, v), 2e5f);
    entry("body.angularVelocity", (s, v) -> s.body.setAngularVelocity(v), 2e5f);
    entry("body.forceX", (s, v) -> s.body.applyForce(v, 1));
    entry("body.forceY", (s, v) -> s.body.applyForce(1, v));
    entry("body.force.px", (s, v) -> s.body.applyForce(1, 1, v, 0), 2e7f);
    entry("body.force.py", (s, v) -> s.body.applyForce(1, 1, 0, v), 2e7f);
    entry("body.impulseX", (s, v) -> s.body.applyImpulse(v, 1));
    entry("body.impulseY", (s, v) -> s.body.applyImpulse(1, v));
    entry("body.impulse.px", (s, v) -> s.body.applyImpulse(1, 1, v, 0), 2e7f);
    entry("body.impulse.py", (s, v) -> s.body.applyImpulse(1, 1, 0, v), 2e7f);
    entry("body.torque", (s, v) -> s.body.applyTorque(v));
    entry("body.angularImpulse", (s, v) -> s.body.applyAngularImpulse(v));
    entry("body.goalX", (s, v) -> s.body.seekVelocity(v, 1, 1), 2e5f);
    entry("body.goalY", (s, v) -> s.body.seekVelocity(1, v, 1), 2e5f);
    entry("body.seek.k", (s, v) -> s.body.seekVelocity(1, 1, v), -1);
    entry("body.seek.dtSeconds", (s, v) -> s.body.seekVelocity(1, 1, 1, v), 0, -1);
    entry("body.gravityScale", (s, v) -> s.body.setGravityScale(v), 2e3f);
    entry("body.linearDamping", (s, v) -> s.body.setLinearDamping(v), -1);
    entry("body.angularDamping", (s, v) -> s.body.setAngularDamping(v), -1);
  }

  private static void jointDefinitions() {
    entry("revolute.anchorAX", (s, v) -> JointDef.revolute(s.body, s.other, v, 0), 2e7f);
    entry("revolute.anchorAY", (s, v) -> JointDef.revolute(s.body, s.other, 0, v), 2e7f);
    entry("distance.anchorAX", (s, v) -> JointDef.distance(s.body, s.other, v, 0, 0, 0));
    entry("distance.anchorAY", (s, v) -> JointDef.distance(s.body, s.other, 0, v, 0, 0));
    entry("distance.anchorBX", (s, v) -> JointDef.distance(s.body, s.other, 0, 0, v, 0));
    entry("distance.anchorBY", (s, v) -> JointDef.distance(s.body, s.other, 0, 0, 0, v));
    entry("rope.upper", (s, v) -> JointDef.rope(s.body, s.other, 0, 0, 1, 1, v), -1);
    entry("prismatic.axisX", (s, v) -> JointDef.prismatic(s.body, s.other, 0, 0, v, 0), 0);
    entry("prismatic.axisY", (s, v) -> JointDef.prismatic(s.body, s.other, 0, 0, 0, v), 0);
    entry("wheel.anchorAX", (s, v) -> JointDef.wheel(s.body, s.other, v, 0, 0, 1));
    entry("wheel.axisY", (s, v) -> JointDef.wheel(s.body, s.other, 0, 0, 0, v), 0);
    entry("weld.anchorAX", (s, v) -> JointDef.weld(s.body, s.other, v, 0));
    entry("motor.maxForce", (s, v) -> JointDef.motor(s.body, s.other, v, 0), -1);
    entry("motor.maxTorque", (s, v) -> JointDef.motor(s.body, s.other, 0, v), -1);
    entry("mouse.anchorAX", (s, v) -> JointDef.mouse(s.body, v, 0, 1));
    entry("mouse.maxForce", (s, v) -> JointDef.mouse(s.body, 0, 0, v), -1);
    entry("hinge.lower", (s, v) -> hinge(s).limits(v, 1), -2e4f);
    entry("hinge.upper", (s, v) -> hinge(s).limits(0, v), 2e4f, -1);
    entry("hinge.speed", (s, v) -> hinge(s).motor(v, 1), 2e5f);
    entry("hinge.max", (s, v) -> hinge(s).motor(1, v), -1);
    entry("hinge.hertz", (s, v) -> hinge(s).spring(v, 1), -1, 2e3f);
    entry("hinge.dampingRatio", (s, v) -> hinge(s).spring(1, v), -1, 200);
    entry("hinge.rest", (s, v) -> hinge(s).rest(v), 2e4f);
    entry("weld.hertz", (s, v) -> JointDef.weld(s.body, s.other, 0, 0).angularSpring(v, 1), -1);
  }

  private static JointDef<String> hinge(Subject s) {
    return JointDef.revolute(s.body, s.other, 0, 0);
  }

  private static void joints() {
    entry("joint.speed", (s, v) -> s.joints.get(JointType.REVOLUTE).setMotor(v, 1), 2e5f);
    entry("joint.max", (s, v) -> s.joints.get(JointType.REVOLUTE).setMotor(1, v), -1);
    entry("joint.lower", (s, v) -> s.joints.get(JointType.PRISMATIC).setLimits(v, 1), -2e6f);
    entry("joint.upper", (s, v) -> s.joints.get(JointType.PRISMATIC).setLimits(0, v), -1);
    entry("joint.hertz", (s, v) -> s.joints.get(JointType.WHEEL).setSpring(v, 1), -1, 2e3f);
    entry("joint.dampingRatio", (s, v) -> s.joints.get(JointType.WHEEL).setSpring(1, v), -1);
    entry("joint.rest", (s, v) -> s.joints.get(JointType.DISTANCE).setRest(v), -1);
    entry("joint.target.x", (s, v) -> s.joints.get(JointType.MOUSE).setTarget(v, 0), 2e7f);
    entry("joint.target.y", (s, v) -> s.joints.get(JointType.MOTOR).setTarget(0, v), 2e7f);
    entry("joint.angle", (s, v) -> s.joints.get(JointType.MOTOR).setTargetAngle(v));
  }

  private static void queries() {
    QueryHit<String> hit = new QueryHit<>();
    Circle c = new Circle(1);
    Transform t = new Transform();
    entry("query.minX", (s, v) -> s.world.queryAabb(v, 0, 1, 1, b -> true), 2e7f);
    entry("query.minY", (s, v) -> s.world.queryAabb(0, v, 1, 1, b -> true), 2e7f);
    entry("query.maxX", (s, v) -> s.world.queryAabb(0, 0, v, 1, b -> true), 2e7f);
    entry("query.maxY", (s, v) -> s.world.queryAabb(0, 0, 1, v, b -> true), 2e7f);
    entry("bodyAt.X", (s, v) -> s.world.bodyAt(v, 0), 2e7f);
    entry("bodyAt.Y", (s, v) -> s.world.bodyAt(0, v), 2e7f);
    entry("ray.x", (s, v) -> s.world.queries().rayClosest(v, 0, 1, 1, null, hit));
    entry("ray.y", (s, v) -> s.world.queries().rayAny(0, v, 1, 1, null));
    entry("ray.wayX", (s, v) -> s.world.queries().rayClosest(0, 0, v, 1, null, hit));
    entry("ray.wayY", (s, v) -> s.world.queries().rayAll(0, 0, 1, v, null, h -> true));
    entry("cast.x", (s, v) -> s.world.queries().shapeAny(c, pose(v, 0, 1, 0), 1, 1, null));
    entry("cast.cos", (s, v) -> s.world.queries().shapeAny(c, pose(0, 0, v, 0), 1, 1, null));
    entry("cast.sin", (s, v) -> s.world.queries().shapeAny(c, pose(0, 0, 0, v), 1, 1, null));
    entry("cast.wayX", (s, v) -> s.world.queries().shapeClosest(c, t, v, 1, null, hit));
    entry("box.minX", (s, v) -> s.world.queries().boxAll(area(v, 1), 1, 1, null, h -> true));
    entry("box.maxX", (s, v) -> s.world.queries().boxAll(area(0, v), 1, 1, null, h -> true));
    entry("overlap.y", (s, v) -> s.world.queries().overlaps(c, pose(0, v, 1, 0), null, h -> true));
    entry(
        "overlap.cos", (s, v) -> s.world.queries().overlaps(c, pose(0, 0, v, 0), null, h -> true));
    entry("point.x", (s, v) -> s.world.queries().containing(v, 0, null, h -> true));
    entry("nearest.y", (s, v) -> s.world.queries().nearest(0, v, 1, null, hit));
    entry("nearest.radius", (s, v) -> s.world.queries().nearest(0, 0, v, null, hit), -1);
  }

  private static Transform pose(float x, float y, float cos, float sin) {
    return new Transform().set(x, y, cos, sin);
  }

  private static Aabb area(float min, float max) {
    Aabb box = new Aabb();
    box.minX = min;
    box.minY = 0;
    box.maxX = max;
    box.maxY = 1;
    return box;
  }

  private static void shapes() {
    entry("circle radius", (s, v) -> new Circle(v), 0, -1, 1e-5f, 1e6f);
    entry("circle centerX", (s, v) -> new Circle(1, v, 0), 1e6f);
    entry("circle centerY", (s, v) -> new Circle(1, 0, v), 1e6f);
    entry("box halfWidth", (s, v) -> new Box(v, 1), 0, -1, 1e-5f, 1e6f);
    entry("box halfHeight", (s, v) -> new Box(1, v), 0, -1, 1e-5f, 1e6f);
    entry("box centerX", (s, v) -> new Box(1, 1, v, 0), 1e6f);
    entry("capsule x0", (s, v) -> new Capsule(v, 0, 1, 1, 1), 1e6f);
    entry("capsule y1", (s, v) -> new Capsule(0, 0, 1, v, 1), 1e6f);
    entry("capsule radius", (s, v) -> new Capsule(0, 0, 1, 1, v), 0, -1, 1e6f);
    entry("segment x0", (s, v) -> new Segment(v, 0, 1, 1), 1e6f);
    entry("segment y1", (s, v) -> new Segment(0, 0, 1, v), 1e6f);
    entry("polygon x1", (s, v) -> Polygon.of(0, 0, v, 0, 0, 1), 1e6f);
    entry("polygon y2", (s, v) -> Polygon.of(0, 0, 1, 0, 0, v), 1e6f);
    entry("polygon radius", (s, v) -> Polygon.rounded(v, 0, 0, 1, 0, 0, 1), -1, 1e6f);
    entry("polygon radius", (s, v) -> Polygon.regular(5, v), 0, -1, 1e6f);
    entry("chain x1", (s, v) -> Chain.open(0, 0, v, 0, 5, 5), 1e6f);
    entry("chain y0", (s, v) -> Chain.loop(0, v, 1, 0, 5, 5), 1e6f);
    List<Float> noDensities = List.of(Float.NaN, Float.POSITIVE_INFINITY, -1f);
    ENTRIES.add(new Entry("density", (s, v) -> new Circle(1).mass(v), noDensities));
  }

  static Stream<Arguments> entries() {
    return ENTRIES.stream()
        .flatMap(
            e -> {
              List<Arguments> all = new ArrayList<>();
              for (float v : e.bad) {
                all.add(Arguments.of(e, v));
              }
              return all.stream();
            });
  }

  @ParameterizedTest
  @MethodSource("entries")
  void whatIsNoSensibleNumberIsRefusedByName(Entry entry, float value) {
    Subject s = new Subject();
    long before = s.world.stateHash();
    String message =
        assertThrows(IllegalArgumentException.class, () -> entry.call.with(s, value)).getMessage();
    String last = entry.name.substring(entry.name.lastIndexOf('.') + 1);
    if (last.length() > 1) {
      last = last.substring(last.lastIndexOf(' ') + 1);
    }
    assertTrue(
        message.contains(last + "=") || message.contains("segment") || message.contains("area="),
        message);
    if (!entry.name.equals("def.substeps")) {
      assertTrue(message.contains(Float.toString(value)), message);
    }
    assertEquals(before, s.world.stateHash(), "left a trace");
    s.world.step(DT);
    Subject twin = new Subject();
    twin.world.step(DT);
    assertEquals(twin.world.stateHash(), s.world.stateHash(), "left a hidden trace");
  }

  @Test
  void degenerateGeometryIsRefused() {
    refused("area", () -> Polygon.of(0, 0, 1, 1, 2, 2));
    refused("area", () -> Polygon.of(3, 3, 3, 3, 3, 3));
    refused("width", () -> Polygon.of(0, 0, 1, 0, 1, .0005f));
    refused("length", () -> new Capsule(1, 1, 1, 1, .5f));
    refused("length", () -> new Segment(2, 3, 2, 3));
    refused("length", () -> Chain.open(0, 0, 1, 0, 1, 0, 2, 0));
    refused("points", () -> Chain.open(0, 0));
    refused("points", () -> Chain.loop(0, 0, 1, 1));
    refused("parts", Compound::of);
    refused("vertices", () -> Polygon.regular(2, 1));
    refused("vertices", () -> Polygon.regular(1000, 1));
    refused("even", () -> Polygon.of(0, 0, 1, 0, 1));
  }

  @Test
  void chainsThatCrossThemselvesAreRefused() {
    refused("segment=0 crosses segment=2", () -> Chain.open(0, 0, 4, 0, 4, 2, 2, -2));
    refused("crosses", () -> Chain.loop(0, 0, 2, 2, 2, 0, 0, 2));
    refused("segment=1 turns back on segment=0", () -> Chain.open(0, 0, 4, 0, 1, 0));
    refused("turns back", () -> Chain.loop(0, 0, 4, 0, 2, 0, 1, 0));
    assertEquals(4, Chain.loop(0, 0, 4, 0, 4, 3, 0, 3).parts().size());
    assertEquals(4, Chain.open(0, 0, 4, 0, 4, 3, 0, 3, 0, 0).parts().size(), "closed by hand");
    assertEquals(3, Chain.open(0, 0, 1, 1, 2, 0, 3, 1).parts().size());
  }

  private static void refused(String part, Runnable call) {
    String message = assertThrows(IllegalArgumentException.class, call::run).getMessage();
    assertTrue(message.contains(part), message);
  }

  @Test
  void bodiesThatCannotBeAreRefusedAndLeaveNothingBehind() {
    Subject s = new Subject();
    long before = s.world.stateHash();
    int bodies = s.world.bodyCount();
    BodyDef weightless =
        new BodyDef(BodyType.DYNAMIC).shape(new Circle(1), Material.DEFAULT.withDensity(0));
    refused("mass=0.0", () -> s.world.createBody(weightless, "x"));
    BodyDef line = new BodyDef(BodyType.DYNAMIC).shape(new Segment(0, 0, 1, 0));
    refused("has no mass", () -> s.world.createBody(line, "x"));
    BodyDef heavy =
        new BodyDef(BodyType.DYNAMIC)
            .shape(new Box(1e5f, 1e5f), Material.DEFAULT.withDensity(1e9f));
    refused("mass=", () -> s.world.createBody(heavy, "x"));
    refused("null", () -> new BodyDef().shape(new ShapeDef(null, Material.DEFAULT)));
    refused("null", () -> new BodyDef().shape(new Circle(1), null));
    refused("null", () -> new BodyDef().shape(new Circle(1), Material.DEFAULT, (Filter) null));
    BodyDef crowd = new BodyDef();
    for (int i = 0; i < 2000; i++) {
      crowd.shape(new Circle(1));
    }
    refused("parts=2000", () -> s.world.createBody(crowd, "x"));
    assertEquals(before, s.world.stateHash());
    assertEquals(bodies, s.world.bodyCount());
  }

  /** Random calls with random nonsense among sane ones: only sane ones have an effect. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void nonsenseBetweenTheStepsChangesNothing(long seed) {
    SplittableRandom r = new SplittableRandom(seed);
    Subject fuzzed = new Subject();
    Subject calm = new Subject();
    for (int i = 0; i < 120; i++) {
      for (int k = 0; k < 5; k++) {
        Entry e = ENTRIES.get(r.nextInt(ENTRIES.size()));
        float v = BAD.get(r.nextInt(3));
        assertThrows(IllegalArgumentException.class, () -> e.call.with(fuzzed, v), e.name);
      }
      float f = (float) r.nextDouble(-5, 5);
      for (Subject s : List.of(fuzzed, calm)) {
        s.body.applyImpulse(f, 1, f, 2);
        s.world.step(DT);
      }
      String where = "seed=" + seed + " tick=" + i;
      assertEquals(calm.world.stateHash(), fuzzed.world.stateHash(), where);
    }
  }

  /** The largest numbers that are allowed, all at once: nothing becomes NaN, neighbours rest. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void absurdButAllowedNumbersInfectNobody(long seed) {
    SplittableRandom r = new SplittableRandom(seed);
    Subject s = new Subject();
    Body<String> far = Lab.box(s.world, 40, .5, .5, .5, Material.DEFAULT);
    Lab.steps(s.world, 60);
    float restX = far.x();
    List<Runnable> excesses =
        List.of(
            () -> s.body.applyForce(1e20f, -1e20f),
            () -> s.body.applyImpulse(-1e20f, 1e20f),
            () -> s.body.applyTorque(1e20f),
            () -> s.body.setVelocity(-1e5f, 1e5f),
            () -> s.body.setAngularVelocity(1e5f),
            () -> s.body.setPose(-Limits.MAX_POSITION, Limits.MAX_POSITION, 1e5f),
            () -> s.other.setPose(-Limits.MAX_POSITION, Limits.MAX_POSITION, 0),
            () -> s.joints.values().forEach(j -> j.setSpring(1e3f, 100)));
    for (int i = 0; i < 120; i++) {
      excesses.get(r.nextInt(excesses.size())).run();
      s.world.step(DT);
    }
    String where = "seed=" + seed;
    s.world.forEachBody(
        b -> {
          float[] all = {b.x(), b.y(), b.cos(), b.sin(), b.velocityX(), b.velocityY()};
          for (float v : all) {
            assertTrue(Float.isFinite(v), where + " " + b);
          }
          assertTrue(Float.isFinite(b.angularVelocity()), where + " " + b);
        });
    assertEquals(restX, far.x(), 1e-3, where + " neighbour");
    assertEquals(.5, far.y(), .01, where + " neighbour");
    assertEquals(Collections.emptyList(), notFinite(s.world), where);
  }

  private static List<String> notFinite(World<String> w) {
    List<String> found = new ArrayList<>();
    w.forEachContact(
        (x, y, nx, ny, separation, impulse) -> {
          if (!Float.isFinite(x + y + nx + ny + separation + impulse)) {
            found.add(x + " " + y + " " + impulse);
          }
        });
    w.forEachJoint(
        j -> {
          if (!Float.isFinite(j.forceX() + j.forceY() + j.torque())) {
            found.add(j.toString());
          }
        });
    return found;
  }
}
