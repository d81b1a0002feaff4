package carom.sim.scene;

import carom.physics.WorldDef;
import java.util.function.Consumer;

/**
 * A recipe for a world: everything that is needed to run it again, bit for bit. Immutable.
 *
 * @param name small letters, digits and underscores
 * @param description one line of what there is to see
 * @param def the world's constants
 * @param tickRate steps per second, 10 to 1000
 * @param view the part of the world to show
 * @param builder makes the bodies; called once per run
 */
public record Scene(
    String name,
    String description,
    WorldDef def,
    int tickRate,
    View view,
    Consumer<SceneWorld<?>> builder) {
  /** Steps per second of most scenes. */
  public static final int DEFAULT_TICK_RATE = 60;

  /**
   * Checks name and tick rate.
   *
   * @throws IllegalArgumentException naming what is wrong
   */
  public Scene {
    if (!name.matches("[a-z][a-z0-9_]*")) {
      throw new IllegalArgumentException(
          "name=" + name + " must be small letters, digits and underscores");
    }
    if (tickRate < 10 || tickRate > 1000) {
      throw new IllegalArgumentException("tickRate=" + tickRate + " is outside 10..1000");
    }
  }

  /**
   * Creates a scene with {@link #DEFAULT_TICK_RATE} and the default constants.
   *
   * @param name small letters, digits and underscores
   * @param description one line of what there is to see
   * @param view the part of the world to show
   * @param builder makes the bodies
   */
  public Scene(String name, String description, View view, Consumer<SceneWorld<?>> builder) {
    this(name, description, new WorldDef(), DEFAULT_TICK_RATE, view, builder);
  }

  /**
   * Returns the scene with other constants.
   *
   * @param newDef the world's constants
   * @return a changed copy
   */
  public Scene with(WorldDef newDef) {
    return new Scene(name, description, newDef, tickRate, view, builder);
  }

  /**
   * Returns the scene under another name.
   *
   * @param newName small letters, digits and underscores
   * @param newDescription one line of what there is to see
   * @return a changed copy
   */
  public Scene named(String newName, String newDescription) {
    return new Scene(newName, newDescription, def, tickRate, view, builder);
  }

  /**
   * Makes the bodies of the scene.
   *
   * @param stage receives them; its world is empty and was made with {@link #def}
   */
  public void build(SceneWorld<?> stage) {
    builder.accept(stage);
  }

  /**
   * Makes the world of the scene.
   *
   * @return a run before its first step
   */
  public SceneRun start() {
    return new SceneRun(this, def);
  }
}
