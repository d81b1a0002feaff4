package carom.sim.entity;

import carom.physics.Body;
import carom.physics.BodyContactVisitor;
import carom.physics.math.Limits;
import carom.sim.field.Countdown;

/**
 * The ground that an entity stands on, see {@link Entity#ground}. All of it is 0 and null in the
 * air. Reused; one simulation's.
 */
public final class Ground {
  /**
   * Largest upward part of the normal from the entity to a contact that counts as ground: slopes up
   * to 53 degrees.
   */
  private static final float MAX_NORMAL = -0.6f;

  private final BodyContactVisitor<HostEntity> visitor = this::visit;
  private HostEntity entity;
  private float impulse;
  private float normalX;
  private float normalY;

  Ground() {}

  /** Looks below a body. */
  Ground find(Body<HostEntity> body) {
    impulse = 0;
    entity = null;
    normalX = 0;
    normalY = 0;
    body.forEachContact(visitor);
    return this;
  }

  private void visit(Body<HostEntity> other, float nx, float ny, float pressure) {
    if (ny < MAX_NORMAL && pressure > impulse) {
      impulse = pressure;
      entity = other.user();
      normalX = -nx;
      normalY = -ny;
    }
  }

  /** Returns whether there is any: slopes up to 53 degrees that bore it in the last step. */
  public boolean isThere() {
    return entity != null;
  }

  /**
   * Returns whether there is any, or was a few ticks ago: so a jump shortly after an edge still
   * works. Call it in every tick, from {@code Game.input}.
   *
   * @param player the player who owns the entity
   * @param since a field of players, which this method sets
   * @param ticks how long ago, 1 or more
   */
  public boolean isThereWithin(Player player, Countdown since, int ticks) {
    Limits.notNull("player", player);
    if (isThere()) {
      player.set(since, ticks);
    }
    return player.get(since) > 0;
  }

  /** Returns the entity, maybe {@linkplain Entity#isLevel of the level}; null in the air. */
  public Entity entity() {
    return entity;
  }

  /** Returns how fast the ground's body moves to the right, m/s. */
  public float velocityX() {
    return entity == null ? 0 : entity.velocityX();
  }

  /** Returns how fast the ground's body moves upwards, m/s. */
  public float velocityY() {
    return entity == null ? 0 : entity.velocityY();
  }

  /** Returns x of the unit normal out of the ground. */
  public float normalX() {
    return normalX;
  }

  /** Returns y of the unit normal out of the ground, 0.6..1. */
  public float normalY() {
    return normalY;
  }
}
