package carom.sim.entity;

import carom.physics.Body;
import carom.physics.Queries;
import carom.physics.QueryFilter;
import carom.physics.QueryHit;
import carom.physics.QueryVisitor;
import carom.physics.geometry.Shape;
import carom.physics.math.Limits;
import carom.physics.math.Transform;

/**
 * Questions about what is where. Sensors are never seen; a filter of null sees all else. In {@code
 * Game.forces} queries see the level's static geometry only, since a client doesn't know all
 * entities. A query allocates nothing.
 */
public final class EntityQueries {
  private final Queries<HostEntity> queries;
  private final Transform pose = new Transform();
  private final QueryFilter<HostEntity> filtered = this::accepts;
  private final QueryVisitor<HostEntity> visited = this::visit;
  private EntityFilter filter;
  private EntityVisitor visitor;
  private EntityHit shown;
  private QueryHit<HostEntity> inShown;

  /** Creates the face of the engine's queries. */
  public EntityQueries(Queries<HostEntity> queries) {
    this.queries = queries;
  }

  /**
   * Finds the first hit of a ray.
   *
   * @param x where it starts, m
   * @param y where it starts, m
   * @param wayX x of the way from start to end, m
   * @param wayY y of the way from start to end, m
   * @param sees chooses entities, or null
   * @param out receives the hit; unchanged if there is none
   * @return whether it hits anything
   */
  public boolean rayClosest(
      float x, float y, float wayX, float wayY, EntityFilter sees, EntityHit out) {
    return queries.rayClosest(x, y, wayX, wayY, by(sees), Limits.notNull("out", out).hit);
  }

  /** Returns whether a ray hits anything, which is cheaper than {@link #rayClosest}. */
  public boolean rayAny(float x, float y, float wayX, float wayY, EntityFilter sees) {
    return queries.rayAny(x, y, wayX, wayY, by(sees));
  }

  /** Visits all that a ray hits, the nearest first, see {@link #rayClosest}. */
  public void rayAll(
      float x, float y, float wayX, float wayY, EntityFilter sees, EntityVisitor to) {
    queries.rayAll(x, y, wayX, wayY, by(sees), to(to));
  }

  /**
   * Finds what a moving shape hits first.
   *
   * @param shape the shape
   * @param x where its origin starts, m
   * @param y where its origin starts, m
   * @param angle its angle, rad
   * @param wayX x of the way, m
   * @param wayY y of the way, m
   * @param sees chooses entities, or null
   * @param out receives the hit; unchanged if there is none
   * @return whether it hits anything
   */
  public boolean shapeClosest(
      Shape shape,
      float x,
      float y,
      float angle,
      float wayX,
      float wayY,
      EntityFilter sees,
      EntityHit out) {
    pose.set(x, y, angle);
    return queries.shapeClosest(shape, pose, wayX, wayY, by(sees), Limits.notNull("out", out).hit);
  }

  /** Visits what overlaps or touches a shape at a place, in the order of the world. */
  public void overlaps(
      Shape area, float x, float y, float angle, EntityFilter sees, EntityVisitor to) {
    pose.set(x, y, angle);
    queries.overlaps(area, pose, by(sees), to(to));
  }

  /** Returns whether anything overlaps or touches a shape at a place. */
  public boolean isFree(Shape area, float x, float y, float angle, EntityFilter sees) {
    pose.set(x, y, angle);
    return !queries.shapeAny(area, pose, 0, 0, by(sees));
  }

  /** Visits the entities that contain a point. */
  public void containing(float x, float y, EntityFilter sees, EntityVisitor to) {
    queries.containing(x, y, by(sees), to(to));
  }

  /**
   * Finds the point nearest to a place.
   *
   * @param radius how far away it may be, m
   * @return whether there is one
   */
  public boolean nearest(float x, float y, float radius, EntityFilter sees, EntityHit out) {
    return queries.nearest(x, y, radius, by(sees), Limits.notNull("out", out).hit);
  }

  private QueryFilter<HostEntity> by(EntityFilter sees) {
    filter = sees;
    return sees == null ? null : filtered;
  }

  private QueryVisitor<HostEntity> to(EntityVisitor to) {
    visitor = Limits.notNull("to", to);
    return visited;
  }

  private boolean accepts(Body<HostEntity> body, int shape) {
    return !body.sensor(shape) && filter.accepts(body.user());
  }

  private boolean visit(QueryHit<HostEntity> hit) {
    if (inShown != hit) {
      inShown = hit;
      shown = new EntityHit(hit);
    }
    return visitor.visit(shown);
  }
}
