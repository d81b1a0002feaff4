package carom.physics.geometry;

import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import java.util.ArrayList;
import java.util.List;

/**
 * Several convex shapes that move as one, the way to build concave bodies. Nested compounds are
 * flattened, and the order of the parts is kept. Parts may overlap; their common area then counts
 * once for each part.
 */
public final class Compound extends Shape {
  /** Largest number of parts in a compound. */
  public static final int MAX_PARTS = 4096;

  private final List<Convex> parts;

  private Compound(List<Convex> parts) {
    this.parts = parts;
  }

  /** Creates a compound of 1 to {@value #MAX_PARTS} parts. */
  public static Compound of(Shape... shapes) {
    return of(List.of(shapes));
  }

  /** Creates a compound of 1 to {@value #MAX_PARTS} parts. The list is copied. */
  public static Compound of(List<? extends Shape> shapes) {
    List<Convex> flat = new ArrayList<>(shapes.size());
    for (Shape shape : shapes) {
      flat.addAll(shape.parts());
    }
    if (flat.isEmpty() || flat.size() > MAX_PARTS) {
      throw new IllegalArgumentException(
          "compound parts=" + flat.size() + " must be in 1.." + MAX_PARTS);
    }
    return new Compound(List.copyOf(flat));
  }

  @Override
  public List<Convex> parts() {
    return parts;
  }

  @Override
  public void aabb(Transform t, Aabb out) {
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
