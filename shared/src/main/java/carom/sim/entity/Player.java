package carom.sim.entity;

import carom.sim.field.FieldHolder;
import carom.sim.level.Archetype;

/**
 * A person or bot who takes part, as both sides know it: an id, a body, fields, and what it has
 * fired. Name, team, score and role are the server's, and a {@code Match} has them.
 *
 * <p>A player without a body is out until the game gives it another. Its client then shows the view
 * of another player.
 */
public sealed interface Player extends FieldHolder<Entity, Player> permits HostPlayer {
  /** Returns the slot, 0..1,023, which is free again once the player has left. */
  int id();

  /**
   * Returns the player's account, which the operator's join token or the client's own key proves.
   * It is empty for a stranger. Fields {@code of(ACCOUNT)} are the account's.
   *
   * @throws IllegalStateException on a client, which isn't told; so don't ask in {@code Game.input}
   */
  String account();

  /** Returns the body the player steers, or null while there is none. */
  Entity entity();

  /** Returns whether the player has a body. One without is out until the game gives it another. */
  boolean isAlive();

  /**
   * Creates an entity of the player's, in {@code Game.input}: a rocket, a trap. That player's
   * client has it at once, and it becomes the server's or goes when the server's word is there.
   * What the input of others spawns, a client keeps until the end of the call only. Give it a
   * velocity and fields; {@link #spawned} finds it again.
   *
   * @param archetype its archetype
   * @param x position of the body's origin, metres
   * @param y position of the body's origin, metres
   * @param angle radians, counterclockwise
   * @throws IllegalStateException outside the input of this player, and beyond {@value
   *     carom.sim.spawn.Origin#MOST_PER_CALL} in a call; elsewhere {@code Match.spawn} does it
   */
  Entity spawn(Archetype archetype, float x, float y, float angle);

  /**
   * Returns the number of living entities that {@code Game.input} spawned for this player, at most
   * {@value carom.sim.spawn.Origin#MOST_PER_PLAYER}: an older one is an entity like others. A
   * client knows those of its own player only.
   */
  int spawnedCount();

  /**
   * Returns an entity that {@code Game.input} spawned for this player. To despawn some of them, go
   * from the newest to the oldest.
   *
   * @param index 0, the oldest, to {@link #spawnedCount} - 1
   */
  Entity spawned(int index);

  /** Returns whether {@link #spawned} has as many as it can have. */
  default boolean isFull() {
    return spawnedCount() >= carom.sim.spawn.Origin.MOST_PER_PLAYER;
  }
}
