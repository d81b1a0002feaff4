package carom.physics.truth;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.WorldState;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Shape;
import carom.physics.threads.WorkerThreads;
import java.util.function.DoubleSupplier;

/** Apparatus of the experiments: worlds, bodies, meters. */
public final class Lab {
  static final float DT = 1 / 60f;

  /** Length of a substep of the default world, s. */
  static final double H = 1 / 240.0;

  /** Gravity of the default world, m/s^2. */
  static final double G = 10;

  static final Material ICE = new Material(1, 0, 0);

  /** Shapes of about half a metre that stand on y = 0 when their origin is at y = 0.5. */
  enum Solid {
    DISC(new Circle(.5f)),
    BOX(new Box(.5f, .5f)),
    CAPSULE(new Capsule(-.4f, 0, .4f, 0, .5f)),
    HEXAGON(Polygon.of(-.5f, -.5f, .5f, -.5f, .8f, 0, .5f, .5f, -.5f, .5f, -.8f, 0)),
    ROUNDED(Polygon.rounded(.1f, -.4f, -.4f, .4f, -.4f, .4f, .4f, -.4f, .4f));

    final Shape shape;

    Solid(Shape shape) {
      this.shape = shape;
    }
  }

  private Lab() {}

  static World<String> space() {
    return new World<>(new WorldDef().withSleeping(false).withGravity(0, 0));
  }

  /** Nothing bounces too slowly here. */
  static World<String> lively() {
    return new World<>(
        new WorldDef().withSleeping(false).withGravity(0, 0).withRestitutionThreshold(0));
  }

  /** Gravity and a floor at y = 0. */
  static World<String> floor(Material m) {
    World<String> w = new World<>(new WorldDef().withSleeping(false));
    fixed(w, new Box(1000, 1), 0, -1, 0, m);
    return w;
  }

  /**
   * A floor at y = 0 under gravity that is turned by an angle: physically a slope that falls to the
   * right.
   */
  static World<String> slope(double angle, Material m) {
    double gx = G * Math.sin(angle);
    double gy = -G * Math.cos(angle);
    World<String> w =
        new World<>(new WorldDef().withSleeping(false).withGravity((float) gx, (float) gy));
    fixed(w, new Box(1000, 1), 0, -1, 0, m);
    return w;
  }

  static Body<String> fixed(World<String> w, Shape s, double x, double y, double a, Material m) {
    return w.createBody(
        new BodyDef().shape(s, m).position((float) x, (float) y).angle((float) a), "fixed");
  }

  static Body<String> body(World<String> w, Shape s, double x, double y, Material m) {
    return w.createBody(
        new BodyDef(BodyType.DYNAMIC).shape(s, m).position((float) x, (float) y), "body");
  }

  static Body<String> disc(World<String> w, double x, double y, double r, Material m) {
    return body(w, new Circle((float) r), x, y, m);
  }

  static Body<String> box(World<String> w, double x, double y, double hw, double hh, Material m) {
    return body(w, new Box((float) hw, (float) hh), x, y, m);
  }

  /** A disc of radius 0.5 m and a given mass. */
  static Body<String> ball(World<String> w, double x, double y, double mass, Material m) {
    return disc(w, x, y, .5, m.withDensity((float) (mass / (Math.PI * .25))));
  }

  static void steps(World<?> w, int n) {
    for (int i = 0; i < n; i++) {
      w.step(DT);
    }
  }

  static void seconds(World<?> w, double s) {
    steps(w, (int) Math.round(s * 60));
  }

  static double speed(Body<?> b) {
    return Math.hypot(b.velocityX(), b.velocityY());
  }

  static double kinetic(Body<?> b) {
    double w2 = (double) b.angularVelocity() * b.angularVelocity();
    double v = speed(b);
    return .5 * (b.mass() * v * v + b.inertia() * w2);
  }

  static double kinetic(World<?> w) {
    double[] sum = new double[1];
    w.forEachBody(b -> sum[0] += kinetic(b));
    return sum[0];
  }

  /** Kinetic energy and that of height. */
  static double energy(World<?> w) {
    double[] sum = {kinetic(w)};
    w.forEachBody(
        b ->
            sum[0] -=
                (double) b.mass()
                    * b.gravityScale()
                    * (w.gravityX() * b.centerX() + w.gravityY() * b.centerY()));
    return sum[0];
  }

  /** Momentum x, y, angular momentum about the world's origin, and the sum of all |p|. */
  static double[] momentum(World<?> w) {
    double[] p = new double[4];
    w.forEachBody(
        b -> {
          double px = (double) b.mass() * b.velocityX();
          double py = (double) b.mass() * b.velocityY();
          p[0] += px;
          p[1] += py;
          p[2] += (double) b.inertia() * b.angularVelocity() + b.centerX() * py - b.centerY() * px;
          p[3] += Math.hypot(px, py);
        });
    return p;
  }

  /** Deepest overlap among all contacts of the last step, m. */
  static double deepest(World<?> w) {
    double[] least = new double[1];
    w.forEachContact((x, y, nx, ny, s, impulse) -> least[0] = Math.min(least[0], s));
    return -least[0];
  }

  /**
   * Seconds between two upward passages of zero, averaged over some periods; passages are found by
   * linear interpolation between ticks.
   */
  public static double period(World<?> w, DoubleSupplier q, int periods) {
    double last = q.getAsDouble();
    double first = -1;
    int passed = 0;
    for (int tick = 1; tick < 12_000; tick++) {
      w.step(DT);
      double now = q.getAsDouble();
      if (last < 0 && now >= 0) {
        double at = (tick - now / (now - last)) / 60;
        if (first < 0) {
          first = at;
        } else if (++passed == periods) {
          return (at - first) / periods;
        }
      }
      last = now;
    }
    throw new AssertionError("does not swing, q=" + last);
  }

  /**
   * Steps two worlds that are alike, the second on two threads, and takes the first back once: each
   * tick has the same bits whatever way it was reached.
   */
  static void assertGoesOnToTheBit(World<?> one, World<?> two, int backTo, int ticks) {
    try (WorkerThreads threads = new WorkerThreads(2)) {
      two.workers(threads);
      WorldState saved = null;
      long[] hashes = new long[ticks];
      for (int i = 0; i < ticks; i++) {
        if (i == backTo) {
          saved = one.save(null);
        }
        one.step(DT);
        two.step(DT);
        hashes[i] = one.stateHash();
        assertEquals(hashes[i], two.stateHash(), "tick " + i);
      }
      one.restore(saved);
      for (int i = backTo; i < ticks; i++) {
        one.step(DT);
        assertEquals(hashes[i], one.stateHash(), "tick " + i + " after restore");
      }
      two.workers(null);
    }
  }
}
