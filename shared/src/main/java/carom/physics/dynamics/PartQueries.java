package carom.physics.dynamics;

import carom.physics.broadphase.CastVisitor;
import carom.physics.broadphase.CellVisitor;
import carom.physics.broadphase.IntVisitor;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.pairs.PairFinder;
import carom.physics.geometry.Convex;
import carom.physics.math.Aabb;

/**
 * Answers where the parts of bodies' shapes are. Brings boxes and trees up to date first, which
 * changes no result of a step.
 */
public final class PartQueries {
  private final PairFinder pairs;
  private final ShapeTable parts;

  PartQueries(PairFinder pairs, ShapeTable parts) {
    this.pairs = pairs;
    this.parts = parts;
  }

  /**
   * Calls back with every part whose tight box overlaps the given one.
   *
   * @param minX left edge, m
   * @param minY lower edge, m
   * @param maxX right edge, m
   * @param maxY upper edge, m
   * @param visitor receives parts in no particular order
   */
  public void query(float minX, float minY, float maxX, float maxY, IntVisitor visitor) {
    pairs.refresh();
    pairs.refit();
    pairs.moving().query(minX, minY, maxX, maxY, visitor);
    pairs.resting().query(minX, minY, maxX, maxY, visitor);
  }

  /**
   * Calls back with every part whose fat box a moving box meets.
   *
   * @param minX left edge at the start, m
   * @param minY lower edge, m
   * @param maxX right edge, m
   * @param maxY upper edge, m
   * @param dx way along x, m
   * @param dy way along y, m
   * @param visitor receives parts in no particular order; the way it shortens must stay short, as
   *     there are two trees
   */
  public void cast(
      float minX, float minY, float maxX, float maxY, float dx, float dy, CastVisitor visitor) {
    pairs.refresh();
    pairs.refit();
    pairs.moving().cast(minX, minY, maxX, maxY, dx, dy, 1, visitor);
    pairs.resting().cast(minX, minY, maxX, maxY, dx, dy, 1, visitor);
  }

  /**
   * Computes the box of one part.
   *
   * @param part which
   * @param fat whether with its margin, as the broadphase sees it
   * @param out receives the box
   */
  public void boxOf(int part, boolean fat, Aabb out) {
    if (fat) {
      pairs.refresh();
      out.set(
          parts.fat.minX(part), parts.fat.minY(part), parts.fat.maxX(part), parts.fat.maxY(part));
    } else {
      pairs.tightBox(part, out);
    }
  }

  /**
   * Visits the nodes of both trees.
   *
   * @param visitor receives boxes and depths
   */
  public void cells(CellVisitor visitor) {
    pairs.refresh();
    pairs.refit();
    pairs.moving().cells(visitor);
    pairs.resting().cells(visitor);
  }

  /**
   * Returns the body that a part belongs to.
   *
   * @param part which
   * @return its slot
   */
  public int bodyOf(int part) {
    return parts.body[part];
  }

  /**
   * Returns the geometry of a part.
   *
   * @param part which
   * @return relative to its body's centre of mass
   */
  public Convex convexOf(int part) {
    return parts.convex[part];
  }

  /**
   * Returns which of its body's shapes a part belongs to.
   *
   * @param part which
   * @return the shape's number
   */
  public int shapeOf(int part) {
    return parts.shapeIndex[part];
  }
}
