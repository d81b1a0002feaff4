package carom.sim.scene;

import carom.physics.WorldDef;
import java.util.function.Consumer;

/**
 * A recipe for a world: everything that is needed to run it again, bit for bit. Immutable.
 *
 * @param name by which it is found, in small letters with underscores
 * @param description what there is to see, one line
 * @param def the world's constants
 * @param tickRate steps per second, 10 to 1000
 * @param view where to look
 * @param builder makes the bodies; called once per run
 */
public record Scene(
    String name,
    String description,
    WorldDef def,
    int tickRate,
    View view,
    Consumer<Stage<?>> builder) {
  /** Steps per second unless a scene says otherwise. */
  public static final int DEFAULT_TICK_RATE = 60;

  /**
   * Checks name and rate.
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
   * A scene with {@link #DEFAULT_TICK_RATE} and the default constants.
   *
   * @param name by which it is found
   * @param description what there is to see, one line
   * @param view where to look
   * @param builder makes the bodies
   */
  public Scene(String name, String description, View view, Consumer<Stage<?>> builder) {
    this(name, description, new WorldDef(), DEFAULT_TICK_RATE, view, builder);
  }

  /**
   * The same with other constants.
   *
   * @param newDef the world's constants
   * @return a changed copy
   */
  public Scene with(WorldDef newDef) {
    return new Scene(name, description, newDef, tickRate, view, builder);
  }

  /**
   * The same with another name.
   *
   * @param newName by which it is found
   * @param newDescription what there is to see, one line
   * @return a changed copy
   */
  public Scene named(String newName, String newDescription) {
    return new Scene(newName, newDescription, def, tickRate, view, builder);
  }

  /**
   * The same at another rate.
   *
   * @param newTickRate steps per second
   * @return a changed copy
   */
  public Scene atRate(int newTickRate) {
    return new Scene(name, description, def, newTickRate, view, builder);
  }

  /**
   * Makes the bodies of the scene.
   *
   * @param stage where; its world is empty and was made with {@link #def}
   */
  public void build(Stage<?> stage) {
    builder.accept(stage);
  }

  /**
   * Makes the world of the scene.
   *
   * @return before its first step
   */
  public SceneRun start() {
    return new SceneRun(this, def);
  }
}
