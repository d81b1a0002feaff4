package carom.physics;

import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Compound;
import carom.physics.geometry.Polygon;
import carom.physics.math.SimRandom;
import carom.sim.scene.BenchmarkScenes;
import carom.sim.scene.SceneWorld;

/** Worlds that several tests step. */
final class Scenes {
  static final float DT = 1 / 60f;

  private Scenes() {}

  static World<String> space() {
    return new World<>(new WorldDef().withGravity(0, 0));
  }

  /** A floor whose surface is y = 0. */
  static World<String> floor(Material material) {
    return floor(material, new WorldDef());
  }

  static World<String> floor(Material material, WorldDef def) {
    World<String> w = new World<>(def);
    w.createBody(floorDef(material), "floor");
    return w;
  }

  /** A static floor whose surface is y = 0. */
  static BodyDef floorDef(Material material) {
    return new BodyDef().shape(new Box(100, 1), material).position(0, -1);
  }

  static Body<String> disc(World<String> w, float x, float y, float radius, Material m) {
    return w.createBody(
        new BodyDef(BodyType.DYNAMIC).shape(new Circle(radius), m).position(x, y), "disc");
  }

  static Body<String> box(World<String> w, float x, float y, float hw, float hh, Material m) {
    return w.createBody(
        new BodyDef(BodyType.DYNAMIC).shape(new Box(hw, hh), m).position(x, y), "box");
  }

  static void steps(World<?> w, int n) {
    for (int i = 0; i < n; i++) {
      w.step(DT);
    }
  }

  static double kineticEnergy(World<?> w) {
    double[] sum = new double[1];
    w.forEachBody(
        b -> {
          double v2 = b.velocityX() * b.velocityX() + b.velocityY() * b.velocityY();
          double w2 = b.angularVelocity() * b.angularVelocity();
          sum[0] += 0.5 * (b.mass() * v2 + b.inertia() * w2);
        });
    return sum[0];
  }

  static float deepest(World<?> w) {
    float[] least = new float[1];
    w.forEachContact((x, y, nx, ny, s, impulse) -> least[0] = Math.min(least[0], s));
    return -least[0];
  }

  /** Rows of boxes on a floor. */
  static World<String> pyramid(int rows) {
    return pyramid(rows, new WorldDef());
  }

  static World<String> pyramid(int rows, WorldDef def) {
    World<String> w = new World<>(def);
    BenchmarkScenes.pyramid(rows).build(new SceneWorld<>(w, d -> w.createBody(d, d.type().name())));
    return w;
  }

  static World<String> stack(int boxes) {
    World<String> w = floor(Material.DEFAULT);
    for (int i = 0; i < boxes; i++) {
      box(w, 0, 0.5f + i, .5f, .5f, Material.DEFAULT);
    }
    return w;
  }

  /** Shapes of all kinds fall into a bin. */
  static World<String> pile(int bodies, long seed) {
    return pile(bodies, seed, new WorldDef());
  }

  static World<String> pile(int bodies, long seed, WorldDef def) {
    World<String> w = floor(Material.DEFAULT, def);
    w.createBody(new BodyDef().shape(new Box(1, 20)).position(-6, 20), "left");
    w.createBody(new BodyDef().shape(new Box(1, 20)).position(6, 20), "right");
    Rng r = new Rng(seed);
    for (int i = 0; i < bodies; i++) {
      BodyDef d =
          new BodyDef(BodyType.DYNAMIC)
              .position(r.in(-4, 4), 1 + 0.15f * i)
              .angle(r.in(-3, 3))
              .velocity(r.in(-2, 2), r.in(-2, 2));
      switch (i % 4) {
        case 0 -> d.shape(new Circle(.25f), new Material(1, .4f, .3f));
        case 1 -> d.shape(new Box(.3f, .2f));
        case 2 -> d.shape(Polygon.of(0, .35f, -.3f, .1f, -.2f, -.3f, .2f, -.3f, .3f, .1f));
        default ->
            d.shape(Compound.of(new Box(.3f, .1f, 0, 0), new Box(.1f, .3f, 0, .2f)))
                .shape(new Circle(.15f, .3f, 0), new Material(3, .2f, .5f));
      }
      w.createBody(d, "b" + i);
    }
    return w;
  }

  /** Frictionless elastic discs in a closed square. */
  static World<String> gas(int perSide, long seed, float threshold) {
    World<String> w =
        new World<>(new WorldDef().withGravity(0, 0).withRestitutionThreshold(threshold));
    Material m = new Material(1, 0, 1);
    float half = perSide * 0.9f;
    w.createBody(new BodyDef().shape(new Box(5, half + 10), m).position(-half - 5, 0), "wall");
    w.createBody(new BodyDef().shape(new Box(5, half + 10), m).position(half + 5, 0), "wall");
    w.createBody(new BodyDef().shape(new Box(half + 10, 5), m).position(0, -half - 5), "wall");
    w.createBody(new BodyDef().shape(new Box(half + 10, 5), m).position(0, half + 5), "wall");
    Rng r = new Rng(seed);
    for (int i = 0; i < perSide * perSide; i++) {
      int row = i / perSide;
      float x = (i % perSide - (perSide - 1) * 0.5f) * 1.8f + r.in(-.5f, .5f);
      float y = (row - (perSide - 1) * 0.5f) * 1.8f + r.in(-.5f, .5f);
      disc(w, x, y, .25f, m).setVelocity(r.in(-5, 5), r.in(-5, 5));
    }
    return w;
  }

  /** The simulation's random numbers, by short names. */
  static final class Rng {
    private final SimRandom random;

    Rng(long seed) {
      random = new SimRandom(seed);
    }

    long next() {
      return random.nextLong();
    }

    float in(float min, float max) {
      return random.between(min, max);
    }

    int below(int n) {
      return (int) Math.floorMod(next(), (long) n);
    }
  }
}
