package carom.sim.entity;

import carom.physics.Body;
import carom.physics.World;
import carom.physics.math.Limits;
import carom.physics.mover.Mover;
import carom.physics.mover.MoverDef;

/**
 * A character that walks: a {@link Mover} whose state is that of a kinematic entity, so that
 * clients predict it like any other. One serves all players, in {@code Game.input}:
 *
 * <pre>
 *   boolean stands = mover.stand(p.entity());
 *   mover.walk(8 * in.moveX(), stands ? 0 : p.entity().velocityY() - 10 * s.tickSeconds());
 * </pre>
 */
public final class EntityMover {
  private final Mover<HostEntity> mover;
  private final float seconds;
  private Body<HostEntity> own;

  /** Makes a mover of a world with so many ticks per second. */
  @SuppressWarnings("unchecked") // without filters of the user's a definition fits any world
  public EntityMover(World<HostEntity> world, MoverDef<?> def, int tickRate) {
    mover = new Mover<>(world, (MoverDef<HostEntity>) def);
    mover.setFilter((body, shape) -> body != own && !body.sensor(shape));
    seconds = 1f / tickRate;
  }

  /**
   * Takes the place of an entity.
   *
   * @return whether it stands on ground there
   */
  public boolean stand(Entity entity) {
    own = ((HostEntity) Limits.notNull("entity", entity)).body();
    mover.setPosition(own.x(), own.y());
    return mover.findGround();
  }

  /**
   * Walks for a tick, and gives the entity of {@link #stand} the velocity that takes it there.
   *
   * @param wantedX m/s, relative to the ground if it stands on it, otherwise in the world
   * @param wantedY m/s
   */
  public void walk(float wantedX, float wantedY) {
    if (own == null) {
      throw new IllegalStateException("walk needs a body=null; call stand before");
    }
    mover.move(wantedX, wantedY, seconds);
    own.setVelocity((mover.x() - own.x()) / seconds, (mover.y() - own.y()) / seconds);
  }

  /** Returns whether it stands on ground after {@link #walk}. */
  public boolean isOnGround() {
    return mover.isOnGround();
  }

  /** Returns whether it met a wall. */
  public boolean isAtWall() {
    return mover.isAtWall();
  }

  /** Returns whether it met a ceiling. */
  public boolean isAtCeiling() {
    return mover.isAtCeiling();
  }

  /** Returns whether it has no room between two bodies. */
  public boolean isCrushed() {
    return mover.isCrushed();
  }

  /** Returns what it stands on; null in the air. */
  public Entity ground() {
    Body<HostEntity> body = mover.ground();
    return body == null ? null : body.user();
  }
}
