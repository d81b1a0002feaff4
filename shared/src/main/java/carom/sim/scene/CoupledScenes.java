package carom.sim.scene;

import static carom.sim.scene.SceneBodies.fixed;
import static carom.sim.scene.SceneBodies.floor;
import static carom.sim.scene.SceneBodies.free;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Polygon;
import java.util.List;

/** Makes the scenes of joints that couple two motions. */
final class CoupledScenes {
  /** Radius of the pitch circle per tooth, m. */
  private static final double MODULE = 0.125;

  /** Arc from tooth to tooth, m. */
  private static final double PITCH = 2 * Math.PI * MODULE;

  /** Height of a tooth above the pitch circle, m. */
  private static final float TOOTH = 0.12f;

  /** Filter that meets nothing, because the joints turn the wheels, not their teeth. */
  private static final Filter FOR_SHOW = new Filter(2, 0);

  private CoupledScenes() {}

  static List<Scene> all() {
    return List.of(
        new Scene(
            "gears",
            "a motor, four wheels and a rack that lifts; teeth are for show",
            new View(0, 5, 26, 14),
            CoupledScenes::gears),
        new Scene(
            "pulleys",
            "two weights, one in two strands, and a basket that fills until it sinks",
            new View(1, 5, 26, 12),
            CoupledScenes::pulleys));
  }

  /** A toothed wheel. The phase is the angle of a tooth at the start, rad. */
  private record Wheel<T>(
      Body<T> body, Joint<T> hinge, double x, double y, int teeth, double phase) {
    double radius() {
      return MODULE * teeth;
    }
  }

  private static <T> void gears(SceneWorld<T> s) {
    floor(s, 20);
    Wheel<T> drive = wheel(s, -9, 4, 10, 0, SceneColors.CORAL);
    Wheel<T> large = mesh(s, drive, 0, 24, SceneColors.STEEL);
    Wheel<T> small = mesh(s, large, Math.PI / 4, 8, SceneColors.AMBER);
    Wheel<T> pinion = mesh(s, small, 0, 16, SceneColors.TEAL);
    float x = (float) (pinion.x + pinion.radius());
    float y = (float) pinion.y - 1.8f;
    Material brass = SceneColors.of(SceneColors.VIOLET);
    BodyDef def = new BodyDef(BodyType.DYNAMIC).position(x, y);
    def.shape(new Box(0.15f, 4, 0.15f + TOOTH, 0), brass, FOR_SHOW);
    double teeth = pinion.phase * pinion.teeth / (2 * Math.PI);
    double gap = teeth - Math.floor(teeth) + 0.5;
    for (int i = -9; i < 9; i++) {
      double at = pinion.y - y + (i + gap) * PITCH;
      if (Math.abs(at) < 3.7) {
        def.shape(tooth(-1, 0, 0, (float) at), brass, FOR_SHOW);
      }
    }
    def.shape(new Box(1.7f, 0.15f, 1.9f, -2), brass);
    Body<T> rack = s.body(def);
    s.joint(JointDef.prismatic(null, rack, x, y, 0, 1));
    s.joint(JointDef.rack(pinion.body, rack, 0, 1, (float) pinion.radius()));
    for (int i = 0; i < 5; i++) {
      int row = i / 2;
      free(s, new Box(0.4f, 0.4f), x + 1.5f + i % 2, y - 1.4f + 0.8f * row, SceneColors.bright(i));
    }
    s.eachTick(tick -> drive.hinge.setMotor(tick % 300 < 150 ? -1.2f : 1.2f, 3000));
  }

  private static <T> Wheel<T> wheel(
      SceneWorld<T> s, double x, double y, int teeth, double phase, int rgb) {
    double radius = MODULE * teeth;
    BodyDef def = new BodyDef(BodyType.DYNAMIC).position((float) x, (float) y);
    for (int i = 0; i < teeth; i++) {
      double a = phase + 2 * Math.PI * i / teeth;
      float cos = (float) StrictMath.cos(a);
      float sin = (float) StrictMath.sin(a);
      def.shape(
          tooth(cos, sin, (float) radius * cos, (float) radius * sin),
          SceneColors.of(rgb),
          FOR_SHOW);
    }
    def.shape(new Circle((float) radius - TOOTH), SceneColors.of(rgb), FOR_SHOW);
    Body<T> body = s.body(def);
    Joint<T> hinge = s.joint(JointDef.revolute(null, body, (float) x, (float) y));
    return new Wheel<>(body, hinge, x, y, teeth, phase);
  }

  /** Makes a wheel whose teeth mesh with those of another one, in a direction from it, rad. */
  private static <T> Wheel<T> mesh(
      SceneWorld<T> s, Wheel<T> from, double direction, int teeth, int rgb) {
    double apart = from.radius() + MODULE * teeth;
    double ahead = (direction - from.phase) * from.teeth / (2 * Math.PI);
    double phase = direction + Math.PI - (0.5 - ahead) * 2 * Math.PI / teeth;
    Wheel<T> next =
        wheel(
            s,
            from.x + apart * StrictMath.cos(direction),
            from.y + apart * StrictMath.sin(direction),
            teeth,
            phase,
            rgb);
    s.joint(JointDef.gear(from.body, next.body, -(float) from.teeth / teeth));
    return next;
  }

  /** Returns a tooth that points in a direction, around a point of the pitch line. */
  private static Polygon tooth(float cos, float sin, float x, float y) {
    float root = 0.3f * (float) PITCH;
    float tip = 0.15f * (float) PITCH;
    float in = -1.3f * TOOTH;
    return Polygon.of(
        x + in * cos + root * sin,
        y + in * sin - root * cos,
        x + TOOTH * cos + tip * sin,
        y + TOOTH * sin - tip * cos,
        x + TOOTH * cos - tip * sin,
        y + TOOTH * sin + tip * cos,
        x + in * cos - root * sin,
        y + in * sin + root * cos);
  }

  private static <T> void pulleys(SceneWorld<T> s) {
    floor(s, 20);
    fixed(s, new Box(11, 0.2f), 1, 10.2f, 0, SceneBodies.STONE);
    hang(s, crate(s, -8, 1.5f, 1, 0), crate(s, -5, 4, 1.5f, 1), 1);
    hang(s, crate(s, -1, 5, 1, 2), crate(s, 2, 1.5f, 1.8f, 3), 2);
    Material wicker = SceneColors.of(SceneColors.WOOD);
    Body<T> basket =
        s.body(
            new BodyDef(BodyType.DYNAMIC)
                .shape(new Box(1, 0.08f, 0, -0.5f), wicker)
                .shape(new Box(0.08f, 0.6f, -1, 0), wicker)
                .shape(new Box(0.08f, 0.6f, 1, 0), wicker)
                .fixedRotation(true)
                .position(6, 5));
    hang(s, basket, crate(s, 10, 1.5f, 3, 4), 1);
    s.eachTick(
        tick -> {
          if (tick % 45 == 30 && tick < 45 * 14) {
            int k = tick / 45;
            Material ball = SceneColors.of(SceneColors.bright(k)).withDensity(1.2f);
            free(s, new Circle(0.25f), 5.5f + 0.25f * (k % 5), 8, ball);
          }
        });
  }

  private static <T> Body<T> crate(SceneWorld<T> s, float x, float y, float mass, int k) {
    return s.body(
        new BodyDef(BodyType.DYNAMIC)
            .shape(new Box(0.5f, 0.5f), SceneColors.of(SceneColors.bright(k)).withDensity(mass))
            .fixedRotation(true)
            .position(x, y));
  }

  /** Hangs two bodies on one rope, straight below two wheels under the beam. */
  private static <T> void hang(SceneWorld<T> s, Body<T> a, Body<T> b, float ratio) {
    float top = 9.6f;
    for (float x : new float[] {a.x(), b.x()}) {
      s.body(
          new BodyDef()
              .shape(new Circle(0.25f), SceneColors.of(SceneColors.STEEL), FOR_SHOW)
              .position(x, top));
    }
    float ay = a.y() + 0.5f;
    float by = b.y() + 0.5f;
    float length = top - ay + ratio * (top - by);
    s.joint(
        JointDef.pulley(a, b, a.x(), ay, b.x(), by, a.x(), top, b.x(), top, ratio)
            .limits(0, length));
  }
}
