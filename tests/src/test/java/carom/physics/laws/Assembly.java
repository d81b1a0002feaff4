package carom.physics.laws;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.JointDef;
import carom.physics.JointType;
import carom.physics.Material;
import carom.physics.MotionLocks;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Shape;
import carom.physics.math.Trig;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;

/**
 * An assembly of bodies and joints, drawn at random: a tree, star, ring or chain; of one kind of
 * joint or of all; 2 cm to 20 m large; with gravity or without; held, flying or dropped on a floor;
 * at rest or thrown. Nothing in it has energy of its own. Its parts don't collide with each other.
 *
 * <p>Each body is drawn from a seed of its own. So the assembly of n bodies begins as that of n - 1
 * does, and a case that fails is shrunk by leaving bodies away.
 */
final class Assembly {
  /** What a law is said of. */
  enum Kind {
    /** Hinges, welds, rods, ropes, limits, brakes, friction and gears. */
    RIGID,
    /** Springs of hinges, welds, sliders, wheels, rods and motors. */
    SPRUNG,
    /**
     * All of these, ropes, ratchets, grooves, racks and pulleys, springs with limits and brakes; in
     * ladders, too. The joints of one in four break.
     */
    MIXED;

    private int kinds() {
      return this == RIGID ? 10 : this == SPRUNG ? 8 : 26;
    }
  }

  static final float DT = 1f / 60;
  private static final String[] FORMS = {"tree", "star", "ring", "chain", "ladder"};
  private static final float GRAVITY = 10;

  final World<String> world;
  final int bodyCount;
  private final long seed;
  private final Kind kind;
  private final float size;
  private final boolean falls;
  private final boolean dropped;
  private final boolean held;
  private final int form;
  private final int one;
  private final double mostRatio;
  private final float speed;
  private final boolean breaks;
  private final List<Body<String>> bodies = new ArrayList<>();

  /** Draws an assembly, of which the first bodies are made; all for a number below 2. */
  Assembly(long seed, Kind kind, double mostRatio, int first) {
    this.seed = seed;
    this.kind = kind;
    Random r = new Random(seed * 0x9e3779b97f4a7c15L);
    r.nextInt();
    falls = r.nextInt(3) > 0;
    dropped = falls && r.nextBoolean();
    held = (falls && !dropped) || r.nextInt(4) == 0;
    size = (float) (0.02 * Math.pow(1000, r.nextDouble()));
    int drawn = 2 + r.nextInt(r.nextInt(4) == 0 ? 11 : 6);
    bodyCount = first >= 2 ? Math.min(first, drawn) : drawn;
    form = r.nextInt(kind == Kind.MIXED ? FORMS.length : FORMS.length - 1);
    one = r.nextInt(3) == 0 ? -1 : r.nextInt(kind.kinds());
    this.mostRatio = Math.pow(mostRatio, r.nextDouble());
    float fast = new float[] {0, 0.001f, 1, 5, 20}[r.nextInt(5)];
    speed = Math.min(fast * (float) Math.max(0.1, Math.sqrt(size)), 10 * size);
    breaks = kind == Kind.MIXED && r.nextInt(4) == 0;
    world = new World<>(new WorldDef().withGravity(0, falls ? -GRAVITY : 0).withSleeping(false));
    if (dropped) {
      BodyDef floor = new BodyDef(BodyType.STATIC).position(0, -1);
      world.createBody(floor.shape(new Box(2000, 1), new Material(1, 0.6f, 0)), "floor");
    }
    for (int i = 0; i < bodyCount; i++) {
      add(i, new Random(seed * 31 + i * 0x632be59bd9b4e019L), drawn);
    }
    if (form == 2 && bodyCount > 2) {
      join(new Random(seed), bodies.get(0), bodies.get(bodyCount - 1));
    }
  }

  /** Locks the motion of half of its bodies along axes that are drawn, and returns it. */
  Assembly locked() {
    Random r = new Random(seed * 0x5851f42d4c957f2dL);
    r.nextInt();
    for (Body<String> b : bodies) {
      MotionLocks locks = new MotionLocks(r.nextBoolean(), r.nextBoolean(), r.nextInt(3) == 0);
      if (r.nextBoolean()) {
        b.setMotionLocks(locks);
      }
    }
    return this;
  }

  private void add(int i, Random r, int drawn) {
    r.nextInt();
    float halfX = size * (0.2f + 0.8f * r.nextFloat()) / 2;
    float halfY = size * (0.1f + 0.9f * r.nextFloat()) / 2;
    Body<String> parent =
        switch (i == 0 ? -1 : form) {
          case -1 -> null;
          case 0 -> bodies.get(r.nextInt(i));
          case 1 -> bodies.get(0);
          case 4 -> bodies.get(i - (i == 1 ? 1 : 2));
          default -> bodies.get(i - 1);
        };
    float angle =
        switch (form) {
          case 0 -> r.nextFloat() * 2 * Trig.PI;
          case 1 -> 2 * Trig.PI * i / Math.max(1, drawn - 1);
          case 2 -> 2 * Trig.PI * i / drawn;
          case 4 -> i == 1 ? Trig.PI / 2 : 0;
          default -> 0;
        };
    float far = size * (r.nextInt(3) == 0 ? r.nextFloat() : 1);
    float x = parent == null ? 0 : parent.x() + Trig.cos(angle) * far;
    float y =
        parent == null ? (dropped ? size * (drawn + 1) : 0) : parent.y() + Trig.sin(angle) * far;
    Shape shape = r.nextBoolean() ? new Box(halfX, halfY) : new Circle(halfX);
    float area = shape instanceof Box ? 4 * halfX * halfY : Trig.PI * halfX * halfX;
    float mass = 0.3f * size * size * (r.nextInt(3) == 0 ? (float) mostRatio : 1);
    BodyDef def =
        new BodyDef(BodyType.DYNAMIC).position(x, y).angle(r.nextBoolean() ? 0 : r.nextFloat() * 6);
    if (r.nextBoolean()) {
      def.velocity(speed * (2 * r.nextFloat() - 1), speed * (2 * r.nextFloat() - 1));
      def.angularVelocity(r.nextBoolean() ? speed / size * (2 * r.nextFloat() - 1) : 0);
    }
    Material material = new Material(mass / area, 0.6f, 0);
    bodies.add(
        world.createBody(def.shape(shape, material, Filter.DEFAULT.withGroup(-1)), "body " + i));
    if (parent != null) {
      join(r, parent, bodies.get(i));
    } else if (held) {
      join(r, null, bodies.get(i));
    }
    if (form == 4 && i % 2 == 1 && i > 1) {
      join(r, bodies.get(i - 1), bodies.get(i));
    }
  }

  private void join(Random r, Body<String> a, Body<String> b) {
    float ax = a == null ? b.x() : a.x();
    float ay = a == null ? b.y() + size / 2 : a.y();
    float along = r.nextInt(4) > 0 ? r.nextFloat() : r.nextBoolean() ? -1 : 2;
    float x = ax + (b.x() - ax) * along;
    float y = ay + (b.y() - ay) * along;
    int which = one >= 0 ? one : r.nextInt(kind.kinds());
    int rigid = Kind.RIGID.kinds();
    JointDef<String> def =
        switch (kind) {
          case RIGID -> rigid(which, r, a, b, x, y);
          case SPRUNG -> sprung(which, r, a, b, x, y);
          case MIXED ->
              which < rigid
                  ? rigid(which, r, a, b, x, y)
                  : which < rigid + Kind.SPRUNG.kinds()
                      ? sprung(which - rigid, r, a, b, x, y)
                      : other(which - rigid - Kind.SPRUNG.kinds(), r, a, b, x, y);
        };
    if (breaks) {
      float weight = GRAVITY * b.mass() * (float) Math.pow(100, r.nextDouble());
      def.breaksAt(weight, weight * size);
    }
    world.createJoint(def);
  }

  private JointDef<String> rigid(
      int which, Random r, Body<String> a, Body<String> b, float x, float y) {
    float strong = 1e6f * size * size * size;
    float weak = r.nextBoolean() ? strong : 1e-6f * strong * r.nextFloat();
    float range = 0.5f * r.nextFloat();
    float turn = r.nextFloat() * 2 * Trig.PI;
    JointDef<String> slider = JointDef.prismatic(a, b, x, y, Trig.cos(turn), Trig.sin(turn));
    return switch (which) {
      case 0 -> JointDef.revolute(a, b, x, y);
      case 1 -> JointDef.weld(a, b, x, y);
      case 2 -> JointDef.revolute(a, b, x, y).limits(-range, range);
      case 3 -> JointDef.revolute(a, b, x, y).limits(0, 0);
      case 4 -> JointDef.revolute(a, b, x, y).motor(0, weak);
      case 5 -> slider.limits(-size * range, size * range);
      case 6 -> slider.motor(0, weak);
      case 7 -> JointDef.friction(a, b, x, y, weak, weak);
      case 8 -> JointDef.distance(a, b, x, y, b.x(), b.y() + 0.01f * size);
      default ->
          a == null ? JointDef.revolute(a, b, x, y) : JointDef.gear(a, b, 0.3f + 2 * r.nextFloat());
    };
  }

  private JointDef<String> sprung(
      int which, Random r, Body<String> a, Body<String> b, float x, float y) {
    float hertz = (float) (0.5 * Math.pow(240, r.nextDouble()));
    float damping = new float[] {0, 0.1f, 0.5f, 1, 5}[r.nextInt(5)];
    float turn = r.nextFloat() * 2 * Trig.PI;
    float cos = Trig.cos(turn);
    float sin = Trig.sin(turn);
    float strong = 1e6f * size * size * size;
    return switch (which) {
      case 0 -> JointDef.revolute(a, b, x, y).spring(hertz, damping);
      case 1 -> JointDef.weld(a, b, x, y).spring(hertz, damping);
      case 2 -> JointDef.weld(a, b, x, y).angularSpring(hertz, damping);
      case 3 -> JointDef.weld(a, b, x, y).spring(hertz, damping).angularSpring(hertz, damping);
      case 4 -> JointDef.prismatic(a, b, x, y, cos, sin).spring(hertz, damping);
      case 5 -> JointDef.wheel(a, b, x, y, cos, sin).spring(hertz, damping);
      case 6 -> JointDef.distance(a, b, x, y, b.x(), b.y() + 0.01f * size).spring(hertz, damping);
      default ->
          JointDef.motor(a, b, strong, strong).spring(hertz, damping).angularSpring(hertz, damping);
    };
  }

  private JointDef<String> other(
      int which, Random r, Body<String> a, Body<String> b, float x, float y) {
    float hertz = (float) (0.5 * Math.pow(240, r.nextDouble()));
    float damping = r.nextBoolean() ? 0 : r.nextFloat();
    float range = 0.1f + 0.5f * r.nextFloat();
    float turn = r.nextFloat() * 2 * Trig.PI;
    float cos = Trig.cos(turn);
    float sin = Trig.sin(turn);
    float far = (float) Math.hypot(x - b.x(), y - b.y());
    JointDef<String> slider = JointDef.prismatic(a, b, x, y, cos, sin);
    JointDef<String> hinge = JointDef.revolute(a, b, x, y);
    return switch (which) {
      case 0 -> JointDef.rope(a, b, x, y, b.x(), b.y(), far + size * range);
      case 1 -> JointDef.ratchet(a, b, x, y, r.nextBoolean() ? range : -range);
      case 2 -> JointDef.groove(a, b, x, y, x + size * cos, y + size * sin, x, y);
      case 3 -> JointDef.wheel(a, b, x, y, cos, sin).spring(hertz, damping).motor(0, size);
      case 4 -> hinge.spring(hertz, damping).limits(-range, range);
      case 5 -> slider.spring(hertz, damping).limits(-size * range, size * range);
      case 6 -> a == null ? hinge : JointDef.rack(a, b, cos, sin, size * range);
      default ->
          a == null
              ? hinge
              : JointDef.pulley(
                  a, b, x, y, b.x(), b.y(), x, y + 2 * size, b.x(), b.y() + 3 * size, range);
    };
  }

  /** Returns whether nothing from outside acts on it. */
  boolean isFree() {
    return !falls && !held;
  }

  /** Returns whether it meets a floor. */
  boolean isDropped() {
    return dropped;
  }

  /** Returns its kinetic and potential energy, J. Springs hold none as it begins. */
  double energy() {
    double sum = 0;
    for (Body<String> b : bodies) {
      double vx = b.velocityX();
      double vy = b.velocityY();
      double w = b.angularVelocity();
      sum += 0.5 * b.mass() * (vx * vx + vy * vy) + 0.5 * b.inertia() * w * w;
      sum += falls ? b.mass() * GRAVITY * b.centerY() : 0;
    }
    return sum;
  }

  /** Returns the energy that is put in, J: what moves, and what can fall. */
  double given() {
    double sum = 0;
    for (Body<String> b : bodies) {
      double vx = b.velocityX();
      double vy = b.velocityY();
      double w = b.angularVelocity();
      sum += 0.5 * b.mass() * (vx * vx + vy * vy) + 0.5 * b.inertia() * w * w;
      sum += falls ? b.mass() * GRAVITY * size * (dropped ? bodyCount + 2 : 2 * bodyCount) : 0;
    }
    return sum;
  }

  /** Returns momentum along x and y, and angular momentum about the origin. */
  double[] momenta() {
    double[] sum = new double[3];
    for (Body<String> b : bodies) {
      double px = (double) b.mass() * b.velocityX();
      double py = (double) b.mass() * b.velocityY();
      sum[0] += px;
      sum[1] += py;
      sum[2] += b.centerX() * py - b.centerY() * px + (double) b.inertia() * b.angularVelocity();
    }
    return sum;
  }

  /** Returns the largest momentum that its bodies have apart, N s, and its reach, m. */
  double momentumScale() {
    double sum = 0;
    for (Body<String> b : bodies) {
      sum +=
          b.mass()
              * (Math.hypot(b.velocityX(), b.velocityY()) + size * Math.abs(b.angularVelocity()));
    }
    return sum;
  }

  float size() {
    return size;
  }

  /** Returns the widest gap of a hinge or rigid weld, m. */
  double widestGap() {
    double[] widest = new double[1];
    world.forEachJoint(
        j -> {
          if (j.type() == JointType.REVOLUTE
              || (j.type() == JointType.WELD && j.springHertz() == 0)) {
            double gap = Math.hypot(j.anchorBX() - j.anchorAX(), j.anchorBY() - j.anchorAY());
            widest[0] = Math.max(widest[0], gap);
          }
        });
    return widest[0];
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "seed=%d kind=%s form=%s joint=%d bodies=%d size=%.3f m ratio=%.0f speed=%.3f %s",
        seed,
        kind,
        FORMS[form],
        one,
        bodyCount,
        size,
        mostRatio,
        speed,
        dropped ? "dropped" : held ? falls ? "hanging" : "held" : "flying");
  }
}
