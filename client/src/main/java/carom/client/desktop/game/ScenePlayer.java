package carom.client.desktop.game;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.World;
import carom.physics.geometry.Shape;
import carom.physics.math.Transform;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneRun;
import carom.sim.scene.Scenes;
import java.util.ArrayList;
import java.util.List;
import java.util.function.LongSupplier;

/**
 * Runs a scene in steps of fixed length, however long frames take, and drags one body on demand.
 * Steps that a frame can't compute in time are dropped, so a slow scene runs in slow motion. One
 * thread; needs no window.
 */
final class ScenePlayer {
  /** Most time that the steps of one frame may take. */
  private static final long FRAME_BUDGET_NS = 30_000_000;

  /** Longest time that a frame counts for, seconds, so that a stalled window doesn't jump. */
  private static final double LONGEST_FRAME = 0.1;

  private static final float[] SPEEDS = {1 / 16f, 1 / 8f, 1 / 4f, 1 / 2f, 1, 2, 4};
  private static final int NORMAL = 4;

  /** Largest acceleration of a dragged body, m/s^2: it can be flung, but not torn away. */
  private static final float GRIP = 400;

  private static final double SMOOTH = 0.08;

  private Scene scene;
  private SceneRun run;
  private boolean paused;
  private int speed = NORMAL;
  private double due;
  private double stepMs;
  private Joint<String> hand;
  private final Transform pose = new Transform();
  private final LongSupplier clock;

  /** Creates a player that measures its steps by a clock, nanoseconds. */
  ScenePlayer(LongSupplier clock) {
    this.clock = clock;
  }

  /** Starts a scene from the beginning, with sleep and continuous collision as users have them. */
  void open(Scene newScene) {
    scene = newScene;
    restart();
  }

  /** Starts the same scene again. */
  void restart() {
    run = scene.with(scene.def().withSleeping(true).withContinuous(true)).start();
    due = 0;
    stepMs = 0;
    hand = null;
  }

  /** Opens a neighbour in the sorted list of scenes: 1 the next, -1 the one before. */
  void turn(int by) {
    List<String> names = Scenes.names();
    int here = names.indexOf(scene.name());
    open(Scenes.get(names.get(Math.floorMod(here + by, names.size()))));
  }

  Scene scene() {
    return scene;
  }

  SceneRun run() {
    return run;
  }

  boolean paused() {
    return paused;
  }

  void pause(boolean pause) {
    paused = pause;
    due = 0;
  }

  /** Returns the speed, scene seconds per second. */
  float speed() {
    return SPEEDS[speed];
  }

  /** Changes the speed by some notches, down if negative. */
  void speedUp(int notches) {
    speed = Math.max(0, Math.min(SPEEDS.length - 1, speed + notches));
  }

  /** Returns the mean time of a step, ms; 0 before the first. */
  double stepMs() {
    return stepMs;
  }

  /** Pauses and makes exactly one step. */
  void single() {
    pause(true);
    step();
  }

  /** Lets time pass, seconds, and makes the steps that are due. */
  void advance(double seconds) {
    if (paused) {
      return;
    }
    due += Math.min(seconds, LONGEST_FRAME) * speed();
    long start = clock.getAsLong();
    while (due >= run.tickSeconds()) {
      step();
      due -= run.tickSeconds();
      if (clock.getAsLong() - start > FRAME_BUDGET_NS) {
        due = 0;
      }
    }
  }

  private void step() {
    if (hand != null && !hand.isValid()) {
      hand = null;
    }
    long start = clock.getAsLong();
    run.step();
    double ms = (clock.getAsLong() - start) / 1e6;
    stepMs = stepMs == 0 ? ms : stepMs + SMOOTH * (ms - stepMs);
  }

  /** Takes hold of the dynamic body at a point; false if there is none. */
  boolean grab(float x, float y) {
    release();
    Body<String> body = bodyAt(x, y);
    if (body == null) {
      return false;
    }
    hand = run.world().createJoint(JointDef.mouse(body, x, y, GRIP * body.mass()));
    return true;
  }

  /** Moves the body that is held. */
  void drag(float x, float y) {
    if (hand != null && hand.isValid()) {
      hand.setTarget(x, y);
    }
  }

  /** Releases the body that is held; it keeps its speed. */
  void release() {
    if (hand != null && hand.isValid()) {
      run.world().destroyJoint(hand);
    }
    hand = null;
  }

  /** Returns the body that is held, or null. */
  Body<String> held() {
    return hand != null && hand.isValid() ? hand.bodyB() : null;
  }

  /** Returns the dynamic body with a solid shape at a point, or null. */
  private Body<String> bodyAt(float x, float y) {
    World<String> world = run.world();
    List<Body<String>> found = new ArrayList<>();
    world.queryAabb(
        x,
        y,
        x,
        y,
        body -> {
          if (body.type() == BodyType.DYNAMIC && contains(body, x, y)) {
            found.add(body);
          }
          return true;
        });
    return found.isEmpty() ? null : found.get(0);
  }

  private boolean contains(Body<String> body, float x, float y) {
    pose.set(body.x(), body.y(), body.cos(), body.sin());
    for (int i = 0; i < body.shapeCount(); i++) {
      Shape shape = body.shape(i);
      if (!body.sensor(i) && shape.containsPoint(pose, x, y)) {
        return true;
      }
    }
    return false;
  }
}
