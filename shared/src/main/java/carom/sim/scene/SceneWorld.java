package carom.sim.scene;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.CollisionListener;
import carom.physics.Joint;
import carom.physics.JointDef;
import carom.physics.World;
import carom.physics.particles.ParticleDef;
import carom.physics.particles.Particles;
import carom.sim.pool.ShownParticles;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * The place where a scene is built: a world, and actions that run in it before each step. One
 * thread at a time.
 *
 * @param <T> the world's user type
 */
public final class SceneWorld<T> {
  private final World<T> world;
  private final Function<BodyDef, Body<T>> maker;
  private final Consumer<Body<T>> remover;
  private final List<TickAction> actions = new ArrayList<>();
  private final List<ShownParticles> particles = new ArrayList<>();
  private CollisionListener<T> listener;

  /**
   * Creates a stage whose bodies have no users.
   *
   * @param world where to build
   */
  public SceneWorld(World<T> world) {
    this(world, def -> world.createBody(def, null));
  }

  /**
   * Creates a stage whose bodies are removed by destroying them.
   *
   * @param world where to build
   * @param maker makes the bodies in that world and gives them their users
   */
  public SceneWorld(World<T> world, Function<BodyDef, Body<T>> maker) {
    this(world, maker, world::destroyBody);
  }

  /**
   * Creates a stage.
   *
   * @param world where to build
   * @param maker makes the bodies in that world and gives them their users
   * @param remover removes them from it
   */
  public SceneWorld(World<T> world, Function<BodyDef, Body<T>> maker, Consumer<Body<T>> remover) {
    this.world = world;
    this.maker = maker;
    this.remover = remover;
  }

  /**
   * Returns the world in which the scene is built.
   *
   * @return the world
   */
  public World<T> world() {
    return world;
  }

  /**
   * Makes a body.
   *
   * @param def its definition
   * @return its handle
   */
  public Body<T> body(BodyDef def) {
    return maker.apply(def);
  }

  /**
   * Removes a body.
   *
   * @param body made by {@link #body}
   */
  public void remove(Body<T> body) {
    remover.accept(body);
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
   * Makes a system of particles. It moves by itself before every step, after the actions. Actions
   * of a scene with particles must be functions of the tick: clients that come late run them from
   * the server's state on.
   *
   * @param def its definition, copied
   * @param rgb their colour, 0xRRGGBB
   * @return still empty
   */
  public Particles particles(ParticleDef def, int rgb) {
    Particles made = new Particles(def);
    particles.add(new ShownParticles(made, rgb));
    return made;
  }

  /**
   * Returns all systems of particles.
   *
   * @return in the order they were made, unmodifiable, live
   */
  public List<ShownParticles> particles() {
    return Collections.unmodifiableList(particles);
  }

  /**
   * Adds an action that runs before every step, after those added earlier.
   *
   * @param action what to do
   */
  public void eachTick(TickAction action) {
    actions.add(action);
  }

  /**
   * Sets the listener to collisions. The owner of the world passes it on to the world.
   *
   * @param newListener null for none
   */
  public void listener(CollisionListener<T> newListener) {
    listener = newListener;
  }

  /**
   * Returns the listener to collisions.
   *
   * @return null for none
   */
  public CollisionListener<T> listener() {
    return listener;
  }

  /**
   * Runs everything that the scene does by itself before a step: actions, then particles.
   *
   * @param tick number of the step that follows, 0 for the first
   * @param dtSeconds length of that step, s
   */
  public void beforeStep(int tick, float dtSeconds) {
    runActions(tick);
    for (int i = 0; i < particles.size(); i++) {
      particles.get(i).particles().step(world, dtSeconds);
    }
  }

  /** Runs the actions without the particles. */
  void runActions(int tick) {
    for (int i = 0; i < actions.size(); i++) {
      actions.get(i).run(tick);
    }
  }
}
