package carom.physics.geometry;

import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.Transform;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Several convex shapes that move as one, the way to build concave bodies; {@link #ofOutline} finds
 * the parts of a concave outline. Nested compounds are flattened, and the order of the parts is
 * kept. Parts may overlap; their common area then counts once for each part.
 */
public final class Compound extends Shape {
  /** Largest number of parts in a compound. */
  public static final int MAX_PARTS = 4096;

  /** Largest number of points of an outline, see {@link #ofOutline}. */
  public static final int MAX_OUTLINE_POINTS = 2048;

  private final List<Convex> parts;

  private Compound(List<Convex> parts) {
    this.parts = parts;
  }

  /** Creates a compound of 1 to {@value #MAX_PARTS} parts. */
  public static Compound of(Shape... shapes) {
    return of(Arrays.asList(Limits.notNull("shapes", shapes)));
  }

  /** Creates a compound of 1 to {@value #MAX_PARTS} parts. The list is copied. */
  public static Compound of(List<? extends Shape> shapes) {
    List<Convex> flat = new ArrayList<>(Limits.notNull("shapes", shapes).size());
    for (Shape shape : shapes) {
      flat.addAll(Limits.notNull("shape", shape).parts());
    }
    if (flat.isEmpty() || flat.size() > MAX_PARTS) {
      throw new IllegalArgumentException(
          "compound parts=" + flat.size() + " must be in 1.." + MAX_PARTS);
    }
    return new Compound(List.copyOf(flat));
  }

  /**
   * Creates a compound of the convex parts of a simple polygon, which may be concave. The same
   * outline always gives the same parts. Their corners are corners of the outline; none has more
   * than {@value Convex#MAX_VERTICES}. They touch each other and don't overlap, but for what {@link
   * Polygon} drops. Slivers that are hardly thicker than {@link Shape#MIN_SIZE} are left out.
   *
   * <p>Bodies slide over the seams between the parts of a static or kinematic body, as over those
   * of any ground made of pieces.
   *
   * @param xy x0, y0, x1, y1, ... in metres, 3 to {@value #MAX_OUTLINE_POINTS} points along the
   *     outline in either winding; points on a line are dropped
   * @throws IllegalArgumentException when the outline crosses or touches itself, has no area, or a
   *     coordinate is not a number within {@link Shape#MAX_SIZE}
   */
  public static Compound ofOutline(float... xy) {
    Limits.notNull("xy", xy);
    for (int i = 0; i < xy.length; i++) {
      checkCoordinate(i % 2 == 0 ? "outline x" : "outline y", i / 2, xy[i]);
    }
    SimpleOutline outline = new SimpleOutline(xy, MAX_OUTLINE_POINTS);
    List<Polygon> parts = new ArrayList<>();
    for (float[] corners : ConvexDecomposition.parts(outline, MIN_SIZE, Convex.MAX_VERTICES)) {
      parts.add(Polygon.hull(corners));
    }
    return of(parts);
  }

  @Override
  public List<Convex> parts() {
    return parts;
  }

  @Override
  public void aabb(Transform t, Aabb out) {
    Limits.notNull("t", t);
    Limits.notNull("out", out);
    float minX = Float.POSITIVE_INFINITY;
    float minY = Float.POSITIVE_INFINITY;
    float maxX = Float.NEGATIVE_INFINITY;
    float maxY = Float.NEGATIVE_INFINITY;
    for (int i = 0; i < parts.size(); i++) {
      parts.get(i).aabb(t, out);
      minX = Math.min(minX, out.minX);
      minY = Math.min(minY, out.minY);
      maxX = Math.max(maxX, out.maxX);
      maxY = Math.max(maxY, out.maxY);
    }
    out.set(minX, minY, maxX, maxY);
  }

  @Override
  public float area() {
    double area = 0;
    for (Convex part : parts) {
      area += part.area();
    }
    return (float) area;
  }

  /**
   * Returns the sum of the parts' masses, with their weighted mean as centre. Inertias add up after
   * the parallel axis theorem (Huygens and Steiner) has moved each to the common centre: I' = I + m
   * d&sup2;.
   */
  @Override
  public MassData mass(float density) {
    checkDensity(density);
    boolean lines = area() == 0;
    double mass = 0;
    double weight = 0;
    double momentX = 0;
    double momentY = 0;
    for (Convex part : parts) {
      MassData m = part.mass(density);
      // Lines have no area, so among themselves they all count the same.
      double area = lines ? 1 : part.area();
      mass += m.mass();
      weight += area;
      momentX += area * m.centerX();
      momentY += area * m.centerY();
    }
    double centerX = momentX / weight;
    double centerY = momentY / weight;
    double inertia = 0;
    for (Convex part : parts) {
      MassData m = part.mass(density);
      double dx = m.centerX() - centerX;
      double dy = m.centerY() - centerY;
      inertia += m.inertia() + m.mass() * (dx * dx + dy * dy);
    }
    return new MassData((float) mass, (float) centerX, (float) centerY, (float) inertia);
  }

  @Override
  public Compound moved(float dx, float dy) {
    List<Convex> moved = new ArrayList<>(parts.size());
    for (Convex part : parts) {
      moved.add(part.moved(dx, dy));
    }
    return new Compound(List.copyOf(moved));
  }

  @Override
  public String toString() {
    return "Compound" + parts;
  }
}
