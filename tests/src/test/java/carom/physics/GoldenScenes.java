package carom.physics;

import static carom.physics.Scenes.DT;
import static carom.physics.Scenes.disc;

import carom.physics.effects.Buoyancy;
import carom.physics.effects.Explosion;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Compound;
import carom.physics.geometry.Polygon;
import carom.physics.math.Aabb;
import java.util.function.Supplier;

/**
 * Scenes whose results are committed, bit for bit; a program, too, that prints them in another
 * process or on another JDK.
 */
enum GoldenScenes {
  STACK(300, 40, () -> Scenes.stack(10)),
  PYRAMID(200, 10, () -> Scenes.pyramid(12)),
  PILE(400, 20, () -> Scenes.pile(120, 5)),
  GAS(300, 30, () -> Scenes.gas(12, 9, 1)),
  SPIN(300, 60, GoldenScenes::spinner),
  NET(200, 10, () -> JointTest.grid(20)),
  JOINTS(300, 40, () -> JointLifeTest.zoo(3)),
  BELTS(300, 60, SurfaceTest::belts),
  CHAINS(300, 40, GoldenScenes::chains),
  ROUND(300, 30, GoldenScenes::round),
  BULLETS(120, 40, GoldenScenes::bullets),
  SLEEPERS(400, 60, GoldenScenes::sleepers),
  EDITS(300, 40, () -> Scenes.pile(60, 8)),
  WATER(240, 40, GoldenScenes::water),
  EULER(300, 40, GoldenScenes::euler);

  private final int steps;
  private final int few;
  private final Supplier<World<String>> scene;

  GoldenScenes(int steps, int few, Supplier<World<String>> scene) {
    this.steps = steps;
    this.few = few;
    this.scene = scene;
  }

  World<String> start() {
    return scene.get();
  }

  /** Prints a line for each scene; "small" makes it short enough for the interpreter. */
  public static void main(String[] args) {
    System.out.print(results(args.length > 0));
  }

  static String results(boolean small) {
    StringBuilder text = new StringBuilder();
    for (GoldenScenes golden : values()) {
      text.append(golden.result(small)).append('\n');
    }
    return text.toString();
  }

  /** Name, hash of the state, and hash of all events in their order. */
  String result(boolean small) {
    World<String> w = start();
    Ear ear = new Ear();
    w.listener(ear);
    w.jointListener(j -> ear.hear(7, j.index(), j.generation()));
    for (int i = 0; i < (small ? few : steps); i++) {
      step(w, i);
    }
    return name() + " " + Long.toHexString(w.stateHash()) + " " + Long.toHexString(ear.hash);
  }

  /** One tick with what belongs to the scene, a function of world and tick. */
  void step(World<String> w, int tick) {
    switch (this) {
      case EDITS -> edit(w, tick);
      case WATER -> {
        new Buoyancy(new Aabb(-9, -9, 9, 2), 1.5f).drag(1).angularDrag(1).flow(1, 0).apply(w, DT);
        if (tick % 100 == 60) {
          new Explosion(0, 0, 4).impulse(3).explode(w);
        }
      }
      default -> {}
    }
    w.step(DT);
  }

  /** Bodies come, go, jump, change and rest. */
  private static void edit(World<String> w, int tick) {
    Scenes.Rng r = new Scenes.Rng(tick);
    Body<String> b = w.body(3 + r.below(57));
    BodyType[] types = BodyType.values();
    switch (tick % 9) {
      case 0 -> disc(w, r.in(-4, 4), r.in(6, 12), .3f, Material.DEFAULT).setVelocity(0, -5);
      case 2 -> {
        if (b != null && tick % 4 == 0) {
          w.destroyBody(b);
        }
      }
      case 4 -> {
        if (b != null) {
          b.setType(types[r.below(3)]);
        }
      }
      case 6 -> {
        if (b != null) {
          b.setEnabled(!b.isEnabled());
        }
      }
      case 8 -> {
        if (b != null) {
          b.setPose(r.in(-4, 4), r.in(1, 9), r.in(-3, 3));
          b.applyImpulse(r.in(-1, 1), 1, b.x(), b.y() + .1f);
        }
      }
      default -> {}
    }
  }

  /** Writes down what it hears, in order. */
  private static final class Ear implements CollisionListener<String> {
    long hash = 17;

    void hear(int what, int one, int two) {
      hash = (hash * 31 + what) * 0x9E3779B97F4A7C15L + one * 65_537L + two;
      hash ^= hash >>> 29;
    }

    private void hear(int what, Collision<String> c) {
      hear(what, c.self().index(), c.other().index());
    }

    @Override
    public void begin(Collision<String> c) {
      hear(1, c);
    }

    @Override
    public void end(Collision<String> c) {
      hear(2, c);
    }

    @Override
    public boolean preSolve(Collision<String> c) {
      hear(3, c);
      return true;
    }

    @Override
    public void postSolve(Collision<String> c) {
      hear(4, c);
      hear(5, Float.floatToIntBits(c.normalImpulse(0)), Float.floatToIntBits(c.tangentImpulse(0)));
    }

    @Override
    public void hit(Collision<String> c) {
      hear(6, c);
    }
  }

  /** A turning kinematic cross stirs discs. */
  static World<String> spinner() {
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

  /** Everything slides and rolls over hills in an arena of lines. */
  private static World<String> chains() {
    World<String> w = new World<>(new WorldDef());
    w.createBody(
        new BodyDef()
            .shape(
                Chain.open(-12, 8, -10, 2, -6, 0, -3, 1, 0, 0, 2, 0, 4, 1.5f, 8, 0, 10, 2, 12, 8)),
        "hills");
    w.createBody(
        new BodyDef().shape(Chain.loop(-2, 3, -1, 4, 1, 4, 2, 3, 0, 2.5f)).position(3, 2), "star");
    fill(w, 60, 12);
    return w;
  }

  /** Capsules and rounded polygons in a bin. */
  private static World<String> round() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    w.createBody(new BodyDef().shape(new Capsule(-5, 0, -5, 20, .5f)), "left");
    w.createBody(new BodyDef().shape(new Capsule(5, 0, 5, 20, .5f)), "right");
    fill(w, 90, 4);
    return w;
  }

  private static void fill(World<String> w, int bodies, float half) {
    Scenes.Rng r = new Scenes.Rng(bodies);
    for (int i = 0; i < bodies; i++) {
      BodyDef d =
          new BodyDef(BodyType.DYNAMIC)
              .position(r.in(-half + 1, half - 1), 5 + .2f * i)
              .angle(r.in(-3, 3))
              .velocity(r.in(-3, 3), 0);
      Material m = new Material(1, .5f, .2f, .02f, 0, 0);
      switch (i % 4) {
        case 0 -> d.shape(new Capsule(-.3f, 0, .3f, 0, .2f), m);
        case 1 -> d.shape(Polygon.rounded(.1f, 0, .3f, -.3f, -.2f, .3f, -.2f), m);
        case 2 -> d.shape(new Circle(.3f), m);
        default ->
            d.shape(Compound.of(new Capsule(-.3f, 0, .3f, 0, .1f), new Circle(.2f, .3f, .1f)), m);
      }
      w.createBody(d, "b" + i);
    }
  }

  /** Bullets through thin walls, bodies and each other. */
  private static World<String> bullets() {
    return bullets(new WorldDef());
  }

  static World<String> bullets(WorldDef def) {
    World<String> w = Scenes.floor(Material.DEFAULT, def);
    for (int i = 0; i < 6; i++) {
      w.createBody(new BodyDef().shape(new Box(.01f, 3)).position(6 + 4 * i, 3), "wall");
      Scenes.box(w, 4 + 4 * i, .5f, .3f, .5f, Material.DEFAULT);
    }
    Scenes.Rng r = new Scenes.Rng(4);
    for (int i = 0; i < 30; i++) {
      BodyDef d =
          new BodyDef(BodyType.DYNAMIC)
              .bullet(i % 2 == 0)
              .position(r.in(-8, 0), .3f + .2f * i)
              .velocity(r.in(50, 900), r.in(-20, 20))
              .angularVelocity(r.in(-50, 50));
      d.shape(i % 3 == 0 ? new Box(.1f, .03f) : new Circle(.05f), new Material(3, .3f, .5f));
      w.createBody(d, "bullet");
    }
    return w;
  }

  /** A pile that falls asleep, and a ball that comes late. */
  private static World<String> sleepers() {
    World<String> w = Scenes.pile(40, 6, new WorldDef().withSleeping(true));
    disc(w, 3, 300, .4f, new Material(20, .5f, .4f)).setVelocity(0, -25);
    return w;
  }

  /** Things that float. */
  private static World<String> water() {
    World<String> w = Scenes.floor(Material.DEFAULT);
    fill(w, 30, 6);
    return w;
  }

  /** The other integrator. */
  private static World<String> euler() {
    World<String> w = Scenes.pile(40, 9, new WorldDef().withIntegrator(Integrator.EXPLICIT_EULER));
    Body<String> ball = disc(w, 20, 5, .3f, Material.DEFAULT);
    w.createJoint(JointDef.revolute(null, ball, 22, 5));
    return w;
  }
}
