package carom.sim.scene;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.CollisionListener;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.World;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;

/**
 * What a scene is built on: a world, and what is to happen in it. One thread at a time.
 *
 * @param <T> what the world's bodies stand for
 */
public final class Stage<T> {
  private final World<T> world;
  private final Function<BodyDef, Body<T>> maker;
  private final List<TickAction> actions = new ArrayList<>();
  private CollisionListener<T> listener;

  /**
   * A stage whose bodies stand for nothing.
   *
   * @param world where to build
   */
  public Stage(World<T> world) {
    this(world, def -> world.createBody(def, null));
  }

  /**
   * A stage.
   *
   * @param world where to build
   * @param maker makes the bodies in that world, and gives them their users
   */
  public Stage(World<T> world, Function<BodyDef, Body<T>> maker) {
    this.world = world;
    this.maker = maker;
  }

  /**
   * Where the scene is built.
   *
   * @return the world
   */
  public World<T> world() {
    return world;
  }

  /**
   * Makes a body.
   *
   * @param def what it is made from
   * @return its handle
   */
  public Body<T> body(BodyDef def) {
    return maker.apply(def);
  }

  /**
   * Makes a joint.
   *
   * @param def what it is made from
   * @return its handle
   */
  public Joint<T> joint(JointDef<T> def) {
    return world.createJoint(def);
  }

  /**
   * Has something done before every step, after what was given earlier.
   *
   * @param action what to do
   */
  public void eachTick(TickAction action) {
    actions.add(action);
  }

  /**
   * Sets who hears about collisions; whoever runs the scene passes it on to the world.
   *
   * @param newListener null for nobody
   */
  public void listener(CollisionListener<T> newListener) {
    listener = newListener;
  }

  /**
   * Who wants to hear about collisions.
   *
   * @return null for nobody
   */
  public CollisionListener<T> listener() {
    return listener;
  }

  /**
   * Does what the scene does by itself before a step.
   *
   * @param tick number of the step that follows, 0 for the first
   */
  public void beforeStep(int tick) {
    for (int i = 0; i < actions.size(); i++) {
      actions.get(i).run(tick);
    }
  }
}
