package carom.sim.scene;

import static carom.sim.scene.SceneBodies.fixed;
import static carom.sim.scene.SceneBodies.free;
import static carom.sim.scene.SceneBodies.trough;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Polygon;
import carom.physics.math.Transform;
import carom.physics.particles.Emitter;
import carom.physics.particles.ParticleDef;
import carom.physics.particles.Particles;
import java.util.List;

/** Makes the scenes of water and sand among bodies. */
final class ParticleScenes {
  private static final int SAND = 0xe0b872;

  private ParticleScenes() {}

  static List<Scene> all() {
    return List.of(
        new Scene(
            "dam_break",
            "a gate opens, and 1,600 particles of water carry the crates away",
            new View(0, 4, 27, 13),
            ParticleScenes::damBreak),
        new Scene(
            "water_wheel",
            "water turns a wheel and fills a pool with crates in it",
            new View(0, 5, 24, 12),
            ParticleScenes::waterWheel),
        new Scene(
            "hourglass",
            "sand runs through the neck; twice a minute the glass is turned over",
            new View(0, 6, 20, 13),
            ParticleScenes::hourglass));
  }

  private static void damBreak(SceneWorld<?> s) {
    trough(s, 12, 8);
    Particles water =
        s.particles(new ParticleDef(ParticleDef.Kind.WATER, 0.15f), SceneColors.WATER);
    water.fill(new Box(2.9f, 3), new Transform(-9, 3.1f, 0), 0, 0);
    Body<?> gate =
        s.body(
            new BodyDef(BodyType.KINEMATIC)
                .shape(new Box(0.15f, 3.4f), SceneColors.of(SceneColors.STEEL))
                .position(-5.9f, 3.4f));
    for (int row = 0; row < 5; row++) {
      for (int i = 0; i < 5 - row; i++) {
        float x = 5 + (i - (4 - row) / 2f) * 1.02f;
        free(
            s,
            new Box(0.5f, 0.5f),
            x,
            row + 0.5f,
            SceneColors.of(SceneColors.WOOD).withDensity(0.4f));
      }
    }
    s.eachTick(tick -> gate.setVelocity(0, tick >= 60 && tick < 150 ? 5 : 0));
  }

  private static <T> void waterWheel(SceneWorld<T> s) {
    trough(s, 9, 4);
    Particles water =
        s.particles(
            new ParticleDef(ParticleDef.Kind.WATER, 0.14f).lifetime(13).maxCount(2000),
            SceneColors.WATER);
    Emitter spout = new Emitter(-1.7f, 10, 0, -1).width(0.6f).speed(4);
    BodyDef def =
        new BodyDef(BodyType.DYNAMIC)
            .position(0, 5)
            .shape(new Circle(1), SceneColors.of(SceneColors.WOOD));
    int paddles = 10;
    for (int i = 0; i < paddles; i++) {
      double a = 2 * Math.PI * i / paddles;
      float cos = (float) StrictMath.cos(a);
      float sin = (float) StrictMath.sin(a);
      def.shape(bar(cos, sin, 0.9f, 2.4f, 0.08f), SceneColors.of(SceneColors.PAPER));
    }
    Body<T> wheel = s.body(def);
    s.joint(JointDef.revolute(null, wheel, 0, 5));
    for (int i = 0; i < 6; i++) {
      Material wood = SceneColors.of(SceneColors.bright(i)).withDensity(0.35f);
      free(s, SceneBodies.smallShape(i), -7.5f + 3 * i, 1, wood);
    }
    s.eachTick(tick -> spout.emit(water, tick, 1f / Scene.DEFAULT_TICK_RATE));
  }

  /** Returns a bar that points away from the origin, from one distance to another. */
  private static Polygon bar(float cos, float sin, float from, float to, float half) {
    return Polygon.of(
        from * cos + half * sin,
        from * sin - half * cos,
        to * cos + half * sin,
        to * sin - half * cos,
        to * cos - half * sin,
        to * sin + half * cos,
        from * cos - half * sin,
        from * sin + half * cos);
  }

  private static void hourglass(SceneWorld<?> s) {
    Particles sand = s.particles(new ParticleDef(ParticleDef.Kind.SAND, 0.13f), SAND);
    float rim = 5.2f;
    float shoulder = 3.9f;
    float wide = 3;
    float neck = 0.55f;
    BodyDef glass = new BodyDef(BodyType.KINEMATIC).position(0, 6);
    Material pane = SceneColors.of(SceneColors.SKY);
    for (int side = -1; side <= 1; side += 2) {
      float w = side * wide;
      float n = side * neck;
      glass.shape(
          new Box(wide + 0.5f, 0.2f, 0, side * (rim + 0.2f)), SceneColors.of(SceneColors.WOOD));
      glass.shape(new Capsule(n, 0.25f, n, -0.25f, 0.1f), pane);
      for (int end = -1; end <= 1; end += 2) {
        glass.shape(new Capsule(w, end * rim, w, end * shoulder, 0.1f), pane);
        glass.shape(new Capsule(w, end * shoulder, n, end * 0.25f, 0.1f), pane);
      }
    }
    Body<?> body = s.body(glass);
    sand.fill(
        Polygon.of(-0.3f, 1, 0.3f, 1, 2.6f, shoulder, -2.6f, shoulder),
        new Transform(0, 6, 0),
        0,
        0);
    int turning = 2 * Scene.DEFAULT_TICK_RATE;
    int period = 30 * Scene.DEFAULT_TICK_RATE;
    s.eachTick(
        tick ->
            body.setAngularVelocity(tick % period >= period - turning ? SceneBodies.PI / 2 : 0));
    fixed(s, new Box(10, 0.3f), 0, -0.6f, 0, SceneBodies.STONE);
  }
}
