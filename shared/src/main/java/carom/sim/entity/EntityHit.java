package carom.sim.entity;

import carom.physics.QueryHit;

/** An entity that a query of {@link EntityQueries} found, and where. Reused by its owner. */
public final class EntityHit {
  final QueryHit<HostEntity> hit;

  /** Makes an empty hit. */
  public EntityHit() {
    this(new QueryHit<>());
  }

  EntityHit(QueryHit<HostEntity> hit) {
    this.hit = hit;
  }

  /**
   * Returns the entity, maybe {@linkplain Entity#isLevel of the level}; null if nothing was hit.
   */
  public Entity entity() {
    return hit.body() == null ? null : hit.body().user();
  }

  /** Returns which of its shapes was hit, in the order of its archetype's. */
  public int shape() {
    return hit.shape();
  }

  /** Returns the part of the way at which a ray or a moving shape hit, 0..1. */
  public float fraction() {
    return hit.fraction();
  }

  /** Returns the distance to the hit, m. */
  public float distance() {
    return hit.distance();
  }

  /** Returns x of the point, m. */
  public float x() {
    return hit.x();
  }

  /** Returns y of the point, m. */
  public float y() {
    return hit.y();
  }

  /** Returns x of the unit normal out of the surface; 0 if the query began inside. */
  public float normalX() {
    return hit.normalX();
  }

  /** Returns y of the unit normal out of the surface; 0 if the query began inside. */
  public float normalY() {
    return hit.normalY();
  }
}
