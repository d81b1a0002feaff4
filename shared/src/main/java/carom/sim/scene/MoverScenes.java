package carom.sim.scene;

import static carom.sim.scene.SceneBodies.fixed;
import static carom.sim.scene.SceneBodies.floor;
import static carom.sim.scene.SceneBodies.free;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Polygon;
import carom.physics.math.Trig;
import carom.physics.mover.Mover;
import carom.physics.mover.MoverDef;
import java.util.List;

/**
 * Makes the scene of a character mover. Its state is that of a kinematic body that shows it, so
 * that a restored world goes on as the saved one did: before each step the mover is put where the
 * body is, finds its ground, moves, and the body gets the velocity of that move.
 */
final class MoverScenes {
  private static final float DT = 1 / 60f;
  private static final float SPEED = 4;
  private static final float JUMP = 7.5f;

  /** Filter of the body that shows the mover: it touches nothing. */
  private static final Filter FOR_SHOW = new Filter(2, 0);

  private MoverScenes() {}

  static List<Scene> all() {
    return List.of(
        new Scene(
            "mover",
            "a character that walks to and fro: steps, slopes, a lift, a ferry, one-way, crates",
            new View(0, 4, 36, 14),
            MoverScenes::mover));
  }

  private static <T> void mover(SceneWorld<T> s) {
    floor(s, 18);
    int stone = SceneColors.STONE;
    Material rock = SceneColors.of(stone);
    fixed(s, new Box(0.25f, 5.5f), -17.75f, 5.5f, 0, rock);
    fixed(s, new Box(0.25f, 5.5f), 17.75f, 5.5f, 0, rock);
    for (int i = 0; i < 4; i++) {
      fixed(s, new Box(4 - i, 0.125f), -8, 0.125f + 0.25f * i, 0, rock);
    }
    fixed(s, Polygon.of(-3, 0, 4, 0, 1, 1.6f), 1, 0, 0, rock);
    Body<T> oneWay = fixed(s, new Box(1.5f, 0.1f), -8, 3, 0, SceneColors.of(SceneColors.LEAF));
    Body<T> ferry = kinematic(s, new Box(2, 0.1f), 9, 0.6f);
    Body<T> lift = kinematic(s, new Box(1, 0.1f), 15, 2.1f);
    for (int i = 0; i < 3; i++) {
      free(s, new Box(0.3f, 0.3f), -14 + 0.7f * i, 0.3f, SceneColors.bright(i));
    }
    Body<T> shown =
        s.body(
            new BodyDef(BodyType.KINEMATIC)
                .position(-5, 3)
                .sleepAllowed(false)
                .shape(Capsule.upright(1.6f, 0.35f), SceneColors.of(SceneColors.CORAL), FOR_SHOW));
    Mover<T> mover =
        new Mover<>(
            s.world(),
            new MoverDef<T>(1.6f, 0.35f)
                .pushForce(300)
                .filter((body, shape) -> body.index() != shown.index())
                .oneWay((body, shape) -> body.index() == oneWay.index()));
    s.eachTick(
        tick -> {
          ferry.setVelocity(2 * Trig.cos(tick * 0.01f), 0);
          lift.setVelocity(0, 1.5f * Trig.cos(tick * 0.013f));
          walk(mover, shown, tick);
        });
  }

  private static <T> void walk(Mover<T> mover, Body<T> shown, int tick) {
    mover.setPosition(shown.x(), shown.y());
    boolean stands = mover.findGround();
    Body<T> ground = mover.ground();
    boolean right = tick % 1200 < 600;
    // The body's velocity is its way of one tick, so a step up looks like a leap.
    float vy = stands ? 0 : Math.min(shown.velocityY(), JUMP) - 10 * DT;
    if (stands && tick % 150 == 0) {
      vy = JUMP;
    }
    mover.move(right ? SPEED : -SPEED, vy, DT);
    float vx = (mover.x() - shown.x()) / DT;
    vy = (mover.y() - shown.y()) / DT;
    if (ground != null && mover.isOnGround()) {
      vx += ground.velocityX();
      vy += ground.velocityY();
    }
    shown.setVelocity(vx, vy);
  }

  private static <T> Body<T> kinematic(SceneWorld<T> s, Box shape, float x, float y) {
    return s.body(
        new BodyDef(BodyType.KINEMATIC)
            .position(x, y)
            .sleepAllowed(false)
            .shape(shape, SceneColors.of(SceneColors.AMBER)));
  }
}
