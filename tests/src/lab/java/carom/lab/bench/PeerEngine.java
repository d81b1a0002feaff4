package carom.lab.bench;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.Joint;
import carom.physics.World;
import carom.sim.scene.Scene;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * An engine that the benchmark compares with Carom. It gets the bodies that Carom has before its
 * first step, with the same floats.
 *
 * @param <B> that engine's bodies
 */
public abstract class PeerEngine<B> implements BenchEngine {
  /** Velocity iterations per step, as the manuals of the engines advise. */
  protected static final int VELOCITY_ITERATIONS = 8;

  /** Position iterations per step. */
  protected static final int POSITION_ITERATIONS = 3;

  private final List<B> peers = new ArrayList<>();
  private World<String> copy;
  private float tickSeconds;

  /** Creates an engine. The service loader calls subclasses' constructors without arguments. */
  protected PeerEngine() {}

  @Override
  public final void start(Scene scene) {
    peers.clear();
    copy = scene.start().world();
    tickSeconds = 1f / scene.tickRate();
    open(copy);
    List<Body<String>> all = new ArrayList<>();
    copy.forEachBody(all::add);
    List<B> byIndex = new ArrayList<>(Collections.nCopies(copy.slotCount(), null));
    for (Body<String> body : all) {
      peers.add(add(body));
      byIndex.set(body.index(), peers.get(peers.size() - 1));
    }
    copy.forEachJoint(
        joint ->
            join(joint, byIndex.get(joint.bodyA().index()), byIndex.get(joint.bodyB().index())));
  }

  @Override
  public final void step() {
    step(tickSeconds);
  }

  @Override
  public final World<?> world() {
    int[] next = {0};
    copy.forEachBody(
        body -> {
          B peer = peers.get(next[0]++);
          if (body.type() == BodyType.DYNAMIC) {
            read(peer, body);
          }
        });
    return copy;
  }

  @Override
  public final int awake() {
    int count = 0;
    for (B peer : peers) {
      count += awake(peer) ? 1 : 0;
    }
    return count;
  }

  @Override
  public void close() {
    peers.clear();
  }

  /**
   * Creates an empty world, in place of the one before.
   *
   * @param start gives the gravity and whether bodies may fall asleep
   */
  protected abstract void open(World<?> start);

  /**
   * Creates a body.
   *
   * @param body the body to copy: type, pose, velocities, gravity scale, whether it sleeps, shapes
   *     with material and filter
   * @return the engine's own
   * @throws UnsupportedOperationException if a shape is neither circle, box nor polygon
   */
  protected abstract B add(Body<?> body);

  /**
   * Creates a joint.
   *
   * @param joint the joint to copy
   * @param a the engine's body for {@code joint.bodyA()}
   * @param b the engine's body for {@code joint.bodyB()}
   * @throws UnsupportedOperationException if it isn't a hinge
   */
  protected abstract void join(Joint<?> joint, B a, B b);

  /**
   * Does a step.
   *
   * @param dtSeconds length of the step, s
   */
  protected abstract void step(float dtSeconds);

  /**
   * Returns whether a body is awake and not static.
   *
   * @param peer the engine's body
   * @return true if steps move it
   */
  protected abstract boolean awake(B peer);

  /**
   * Copies a dynamic body's pose and velocities back.
   *
   * @param from the engine's body
   * @param into receives the pose of the origin, not of the centre of mass
   */
  protected abstract void read(B from, Body<?> into);
}
