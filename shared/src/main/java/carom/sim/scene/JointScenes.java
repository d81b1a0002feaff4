package carom.sim.scene;

import static carom.sim.scene.SceneBodies.fixed;
import static carom.sim.scene.SceneBodies.floor;
import static carom.sim.scene.SceneBodies.free;
import static carom.sim.scene.SceneBodies.trough;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Chain;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Polygon;
import carom.physics.geometry.Shape;
import java.util.List;

/** Makes the scenes of joints. */
final class JointScenes {
  private JointScenes() {}

  static List<Scene> all() {
    return List.of(
        new Scene(
            "bridge",
            "hinged planks carry a load until the weakest hinge breaks",
            new View(0, 4.5f, 28, 15),
            JointScenes::bridge),
        new Scene(
            "wrecking_ball",
            "a ball on a chain, two hundred times as heavy as a link, and a wall",
            new View(2, 6.5f, 26, 15),
            JointScenes::wreckingBall),
        new Scene(
            "car",
            "sprung wheels with motors on one-sided ground, there and back",
            new View(0, 4, 44, 20),
            JointScenes::car),
        new Scene(
            "ragdolls",
            "hinges with limits: six figures fall down the stairs",
            new View(0, 6, 28, 16),
            JointScenes::ragdolls),
        new Scene(
            "soft_wheel",
            "wheels made of springs roll over bumps",
            new View(0, 5, 34, 17),
            JointScenes::softWheels),
        new Scene(
            "springs",
            "the same weight on springs from undamped to overdamped",
            new View(0, 4, 16, 11),
            JointScenes::springs),
        new Scene(
            "ropes",
            "chains of links with weights at their ends, and ropes without any",
            new View(0, 4.5f, 22, 12),
            JointScenes::ropes),
        new Scene(
            "motors",
            "windmill, seesaw, lift, piston and a platform that follows its path",
            new View(0, 5.5f, 30, 15),
            JointScenes::motors));
  }

  private static <T> void bridge(SceneWorld<T> s) {
    fixed(s, new Box(3, 3), -13, 0, 0, SceneBodies.STONE);
    fixed(s, new Box(3, 3), 13, 0, 0, SceneBodies.STONE);
    int planks = 25;
    Body<T> left = null;
    for (int i = 0; i <= planks; i++) {
      float x = -10 + 20f * i / planks;
      Body<T> plank =
          i == planks ? null : free(s, new Box(0.38f, 0.12f), x + 0.4f, 2.85f, SceneColors.WOOD);
      Body<T> right = plank == null ? left : plank;
      s.joint(JointDef.revolute(plank == null ? null : left, right, x, 2.85f).breaksAt(900, 1e6f));
      left = plank;
    }
    s.eachTick(
        tick -> {
          if (tick % 90 == 60 && tick < 1500) {
            int k = tick / 90;
            float size = 0.4f + 0.05f * k;
            float x = (k * 7 % 5 - 2) * 1.6f;
            free(
                s,
                k % 2 == 0 ? new Box(size, size) : new Circle(size),
                x,
                11,
                SceneColors.of(SceneColors.bright(k)).withDensity(1.5f));
          }
        });
  }

  private static <T> void wreckingBall(SceneWorld<T> s) {
    floor(s, 40);
    Capsule link = new Capsule(-0.3f, 0, 0.3f, 0, 0.08f);
    Body<T> last = null;
    int links = 14;
    for (int i = 0; i < links; i++) {
      Body<T> body =
          s.body(
              new BodyDef(BodyType.DYNAMIC)
                  .shape(link, SceneColors.of(SceneColors.STEEL), Filter.DEFAULT.withGroup(-1))
                  .position(-0.3f - 0.6f * i, 12));
      s.joint(JointDef.revolute(last, body, -0.6f * i, 12));
      last = body;
    }
    Body<T> ball =
        free(s, new Circle(1.1f), -0.6f * links - 1, 12, SceneColors.of(0x39424f).withDensity(6));
    s.joint(JointDef.revolute(last, ball, -0.6f * links, 12));
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 12; j++) {
        int rgb = SceneColors.mix(SceneColors.CORAL, SceneColors.WOOD, (i + j) % 3 / 2f);
        free(s, new Box(0.4f, 0.3f), 3 + 0.81f * i, 0.3f + 0.6f * j, rgb);
      }
    }
  }

  private static <T> void car(SceneWorld<T> s) {
    int points = 101;
    float[] ground = new float[2 * points];
    for (int i = 0; i < points; i++) {
      float x = -25 + 0.5f * i;
      double bumps = 0.45 * StrictMath.sin(0.9 * x) + 0.25 * StrictMath.sin(2.3 * x);
      double rim = Math.max(0, Math.abs(x) - 16);
      ground[2 * i] = x;
      ground[2 * i + 1] = (float) (bumps + 0.12 * rim * rim);
    }
    s.body(new BodyDef().shape(Chain.open(ground), SceneBodies.STONE.withFriction(1)));
    Polygon chassis =
        Polygon.hull(
            -1.6f, -0.3f, 1.6f, -0.3f, 1.7f, 0.1f, 0.7f, 0.25f, 0.2f, 0.75f, -1.1f, 0.75f, -1.6f,
            0.2f);
    Body<T> car = free(s, chassis, -12, 3, SceneColors.CORAL);
    Material rubber = new Material(1, 1.5f, 0.1f).withTag(0x39424f);
    List<Joint<T>> axles =
        List.of(axle(s, car, -13, 2.5f, rubber), axle(s, car, -10.9f, 2.5f, rubber));
    for (int i = 0; i < 8; i++) {
      free(s, SceneBodies.smallShape(i), -3 + 1.3f * i, 3, SceneColors.bright(i));
    }
    s.eachTick(
        tick -> {
          float speed = tick % 720 < 360 ? -14 : 14;
          for (int i = 0; i < axles.size(); i++) {
            axles.get(i).setMotor(speed, 12);
          }
        });
  }

  private static <T> Joint<T> axle(SceneWorld<T> s, Body<T> car, float x, float y, Material m) {
    Body<T> wheel = free(s, new Circle(0.5f), x, y, m);
    return s.joint(
        JointDef.wheel(car, wheel, x, y, 0, 1).limits(-0.3f, 0.25f).spring(4, 0.7f).motor(0, 12));
  }

  private static <T> void ragdolls(SceneWorld<T> s) {
    for (int i = 0; i < 9; i++) {
      fixed(s, new Box(1.5f, 0.4f), -12 + 3 * i, 8.4f - i, 0, SceneBodies.STONE);
    }
    fixed(s, new Box(0.25f, 3), 13.8f, 2.5f, 0, SceneBodies.STONE);
    for (int i = 0; i < 6; i++) {
      ragdoll(s, -10 + 1.8f * i, 11 + 1.2f * (i % 3), i);
    }
  }

  /** Makes a figure of ten parts, 1.9 m tall, with its hips at (x, y). */
  private static <T> void ragdoll(SceneWorld<T> s, float x, float y, int number) {
    Filter own = Filter.DEFAULT.withGroup(-1 - number);
    Material shirt = SceneColors.of(SceneColors.bright(number));
    Material skin = SceneColors.of(0xf0c9a4);
    Material trousers = SceneColors.of(SceneColors.mix(SceneColors.bright(number), 0x1b2330, 0.6f));
    Body<T> torso = part(s, new Capsule(0, 0.1f, 0, 0.55f, 0.17f), x, y, shirt, own);
    torso.setVelocity(3, 1);
    Body<T> head = part(s, new Circle(0.17f), x, y + 0.92f, skin, own);
    s.joint(JointDef.revolute(torso, head, x, y + 0.74f).limits(-0.6f, 0.6f));
    for (int side = -1; side <= 1; side += 2) {
      float arm = x + side * 0.2f;
      Body<T> upper = part(s, new Capsule(0, 0, 0, -0.3f, 0.07f), arm, y + 0.6f, shirt, own);
      Body<T> lower = part(s, new Capsule(0, 0, 0, -0.3f, 0.06f), arm, y + 0.3f, skin, own);
      s.joint(JointDef.revolute(torso, upper, arm, y + 0.6f).limits(-2.4f, 2.4f));
      s.joint(JointDef.revolute(upper, lower, arm, y + 0.3f).limits(0, 2.2f));
      float leg = x + side * 0.09f;
      Body<T> thigh = part(s, new Capsule(0, 0, 0, -0.42f, 0.09f), leg, y, trousers, own);
      Body<T> shin = part(s, new Capsule(0, 0, 0, -0.42f, 0.08f), leg, y - 0.42f, trousers, own);
      s.joint(JointDef.revolute(torso, thigh, leg, y).limits(-0.8f, 1.6f));
      s.joint(JointDef.revolute(thigh, shin, leg, y - 0.42f).limits(-2.2f, 0));
    }
  }

  private static <T> Body<T> part(
      SceneWorld<T> s, Shape shape, float x, float y, Material m, Filter own) {
    return s.body(
        new BodyDef(BodyType.DYNAMIC).shape(shape, m, own).position(x, y).angularDamping(0.5f));
  }

  private static <T> void softWheels(SceneWorld<T> s) {
    fixed(s, new Box(9, 0.4f), -8, 3.4f, -0.28f, SceneBodies.STONE);
    floor(s, 30);
    for (int i = 0; i < 6; i++) {
      fixed(s, new Circle(0.5f), 2 + 2.4f * i, -0.2f, 0, SceneBodies.STONE);
    }
    fixed(s, new Box(0.4f, 2), 17, 2, 0, SceneBodies.STONE);
    softWheel(s, -13, 7.6f, 1.6f, 4, SceneColors.TEAL);
    softWheel(s, -9, 7, 1.3f, 8, SceneColors.VIOLET);
    softWheel(s, -5.5f, 6, 1.1f, 14, SceneColors.AMBER);
  }

  private static <T> void softWheel(
      SceneWorld<T> s, float x, float y, float radius, float hertz, int rgb) {
    int n = 20;
    Filter own = Filter.DEFAULT.withGroup(-Math.round(hertz));
    float half = radius * SceneBodies.PI / n;
    Body<T> hub = part(s, new Circle(0.25f * radius), x, y, SceneColors.of(SceneColors.STEEL), own);
    Body<T> first = null;
    Body<T> before = null;
    for (int i = 0; i < n; i++) {
      double a = 2 * Math.PI * i / n;
      float px = (float) (x + radius * StrictMath.cos(a));
      float py = (float) (y + radius * StrictMath.sin(a));
      Body<T> tread =
          s.body(
              new BodyDef(BodyType.DYNAMIC)
                  .shape(new Capsule(0, -half, 0, half, 0.12f), SceneColors.of(rgb), own)
                  .position(px, py)
                  .angle((float) a));
      s.joint(JointDef.distance(hub, tread, x, y, px, py).spring(hertz, 0.3f));
      if (before != null) {
        hinge(s, before, tread, x, y, radius, a - Math.PI / n);
      } else {
        first = tread;
      }
      before = tread;
    }
    hinge(s, before, first, x, y, radius, -Math.PI / n);
  }

  private static <T> void hinge(
      SceneWorld<T> s, Body<T> a, Body<T> b, float x, float y, float radius, double at) {
    float px = (float) (x + radius * StrictMath.cos(at));
    float py = (float) (y + radius * StrictMath.sin(at));
    s.joint(JointDef.revolute(a, b, px, py).spring(8, 0.5f));
  }

  private static <T> void springs(SceneWorld<T> s) {
    fixed(s, new Box(7, 0.2f), 0, 8.2f, 0, SceneBodies.STONE);
    float[] ratios = {0, 0.03f, 0.1f, 0.3f, 0.7f, 1, 3};
    for (int i = 0; i < ratios.length; i++) {
      float x = -6 + 2 * i;
      Body<T> weight =
          s.body(
              new BodyDef(BodyType.DYNAMIC)
                  .shape(new Box(0.5f, 0.5f), SceneColors.of(SceneColors.bright(i)))
                  .fixedRotation(true)
                  .position(x, 3.5f));
      s.joint(JointDef.distance(null, weight, x, 8, x, 3.5f).rest(2.5f).spring(0.8f, ratios[i]));
    }
  }

  private static <T> void ropes(SceneWorld<T> s) {
    fixed(s, new Box(11, 0.2f), 0, 10.2f, 0, SceneBodies.STONE);
    floor(s, 20);
    for (int k = 0; k < 5; k++) {
      float x = -9.5f + 3.6f * k;
      Body<T> last = null;
      int links = 7;
      for (int i = 0; i < links; i++) {
        float lx = x + 0.35f * i;
        Body<T> link =
            s.body(
                new BodyDef(BodyType.DYNAMIC)
                    .shape(
                        new Capsule(0, 0, 0.35f, 0, 0.07f),
                        SceneColors.of(SceneColors.bright(k)),
                        Filter.DEFAULT.withGroup(-1))
                    .position(lx, 9));
        s.joint(JointDef.revolute(last, link, lx, 9));
        last = link;
      }
      float end = x + 0.35f * links;
      float radius = 0.2f + 0.1f * k;
      Body<T> weight =
          free(s, new Circle(radius), end, 9, SceneColors.of(SceneColors.STEEL).withDensity(1.5f));
      s.joint(JointDef.revolute(last, weight, end, 9));
    }
    Body<T> lamp = free(s, new Box(0.7f, 0.3f), 8, 5, SceneColors.AMBER);
    s.joint(JointDef.rope(null, lamp, 7, 9, 7.4f, 5.3f, 4.2f));
    s.joint(JointDef.rope(null, lamp, 9, 9, 8.6f, 5.3f, 4.2f));
    lamp.setVelocity(4, 0);
  }

  private static <T> void motors(SceneWorld<T> s) {
    trough(s, 14, 5);
    Body<T> mill =
        s.body(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Box(2.2f, 0.12f), SceneColors.of(SceneColors.TEAL))
                .shape(new Box(0.12f, 2.2f), SceneColors.of(SceneColors.TEAL))
                .position(-10, 3.4f));
    s.joint(JointDef.revolute(null, mill, -10, 3.4f).motor(2, 400));
    Body<T> plank = free(s, new Box(2.4f, 0.12f), -4, 0.9f, SceneColors.WOOD);
    fixed(s, Polygon.of(-0.5f, 0, 0.5f, 0, 0, 0.75f), -4, 0, 0, SceneBodies.STONE);
    s.joint(JointDef.revolute(null, plank, -4, 0.9f).limits(-0.3f, 0.3f));
    Body<T> lift = free(s, new Box(1.2f, 0.15f), 1, 1, SceneColors.STEEL);
    Joint<T> rail =
        s.joint(JointDef.prismatic(null, lift, 1, 1, 0, 1).limits(-0.5f, 5).motor(1, 500));
    Body<T> crank = free(s, new Box(0.9f, 0.12f), 6, 2.5f, SceneColors.CORAL);
    s.joint(JointDef.revolute(null, crank, 5.2f, 2.5f).motor(3, 800));
    Body<T> rod = free(s, new Box(1.1f, 0.1f), 7.9f, 2.5f, SceneColors.AMBER);
    s.joint(JointDef.revolute(crank, rod, 6.8f, 2.5f));
    Body<T> piston = free(s, new Box(0.4f, 0.4f), 9, 2.5f, SceneColors.STEEL);
    s.joint(JointDef.revolute(rod, piston, 9, 2.5f));
    s.joint(JointDef.prismatic(null, piston, 9, 2.5f, 1, 0));
    Body<T> platform = free(s, new Box(1.3f, 0.15f), 8, 6, SceneColors.VIOLET);
    Joint<T> path = s.joint(JointDef.motor(null, platform, 3000, 3000));
    for (int i = 0; i < 14; i++) {
      free(s, SceneBodies.smallShape(i), -6 + 1.1f * i, 8 + i % 3, SceneColors.bright(i));
    }
    s.eachTick(
        tick -> {
          rail.setMotor(tick % 480 < 240 ? 1.2f : -1.2f, 500);
          double a = tick * 0.02;
          path.setTarget(
              (float) (8 + 3 * StrictMath.sin(a)), (float) (6.5 + 1 * StrictMath.sin(2 * a)));
        });
  }
}
