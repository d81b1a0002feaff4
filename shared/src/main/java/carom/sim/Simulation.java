package carom.sim;

import carom.physics.effects.Effect;
import carom.physics.effects.Hover;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityJoint;
import carom.sim.entity.EntityQueries;
import carom.sim.entity.Player;
import carom.sim.event.EventKind;
import carom.sim.field.FieldReader;
import carom.sim.level.Archetype;
import carom.sim.level.Level;
import carom.sim.outbox.Event;

/**
 * The part of a simulation that both sides have: {@link Game#input}, {@link Game#forces}, {@link
 * Game#collision}, {@link Game#hit} and {@link Game#broke} receive it. Whatever these compute from
 * it is the same on the server and on a client that predicts. {@code get} reads the fields of the
 * match. What only the server has is in {@link Match}.
 */
public interface Simulation extends FieldReader<Entity, Player> {
  /** Returns the tick that is being computed; between two steps that of the present state. */
  int tick();

  /** Returns the number of ticks per second. */
  int tickRate();

  /** Returns the time from tick to tick, in seconds. */
  float tickSeconds();

  /** Returns a time in ticks, rounded, and at least 1. */
  int ticks(float seconds);

  /** Returns the level that is played. */
  Level level();

  /**
   * Returns an archetype by its name.
   *
   * @throws IllegalArgumentException if there is none; the search is linear, so keep what set-up
   *     finds
   */
  Archetype archetype(String name);

  /**
   * Returns a joint of the level by its name.
   *
   * @return null if it broke or was destroyed, or if this client doesn't simulate it
   * @throws IllegalArgumentException if the level has no joint of that name
   */
  EntityJoint joint(String name);

  /**
   * Returns questions about what is where. In {@link Game#forces} they see the level's static
   * geometry only.
   */
  EntityQueries queries();

  /**
   * Emits an event: a flash and a sound. It changes nothing that is hashed or saved. A client's
   * prediction emits an event again when it computes a tick again; it is shown once.
   *
   * @param kind as registered in {@link Game#setUp}
   * @return the event to fill in; reused
   */
  Event emit(EventKind kind);

  /**
   * Lets an effect of {@code carom.physics.effects} act on an entity in this step, such as a spring
   * or a magnet that stays where it was made.
   */
  void act(Effect effect, Entity entity);

  /**
   * Lets an entity hover over what is below it in this step.
   *
   * @return whether it was lifted
   */
  boolean hover(Hover<?> how, Entity entity);
}
