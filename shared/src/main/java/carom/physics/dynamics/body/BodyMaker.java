package carom.physics.dynamics.body;

import carom.physics.geometry.Convex;
import carom.physics.geometry.MassData;
import carom.physics.geometry.Segment;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Limits;
import carom.physics.math.StateHash;
import carom.physics.math.Transform;

/**
 * Makes bodies of shapes: parts around the centre of mass, mass and inertia, and the hash of it all
 * that stands for them in the state hash. What comes out depends on what a body consists of, on its
 * type and flags, never on what it was before.
 */
public final class BodyMaker {
  private static final MassData NO_MASS = new MassData(0, 0, 0, 0);

  private final BodyStore bodies;
  private final ShapeTable parts;
  private final Transform identity = new Transform();
  private final Aabb box = new Aabb();

  /** Makes bodies in these stores. */
  public BodyMaker(BodyStore bodies, ShapeTable parts) {
    this.bodies = bodies;
    this.parts = parts;
    identity.setIdentity();
  }

  /** Takes a slot and fills it in; pose and velocity are zero. */
  public int make(byte type, ShapeSpec[] shapes, MassData own, boolean fixedRotation) {
    int count = partCount(shapes);
    MassData total = total(type, shapes, own);
    int body = bodies.allocate(type);
    bodies.flags[body] = fixedRotation ? BodyStore.FIXED_ROTATION : 0;
    bodies.firstPart[body] = parts.allocate(body, count);
    bodies.partCount[body] = count;
    fill(body, shapes, own, total);
    return body;
  }

  /** Fills in a slot that was read: its type, flags and generation are known. */
  public void embody(int body, ShapeSpec[] shapes, MassData own) {
    int count = partCount(shapes);
    MassData total = total(bodies.type[body], shapes, own);
    bodies.firstPart[body] = parts.allocate(body, count);
    bodies.partCount[body] = count;
    fill(body, shapes, own, total);
  }

  /**
   * Returns the number of convex parts that a body of some shapes has.
   *
   * @throws IllegalArgumentException if they are more than one body can have
   */
  public static int partCount(ShapeSpec[] shapes) {
    long count = 0;
    for (ShapeSpec spec : shapes) {
      count += spec.shape().parts().size();
    }
    if (count > BodyStore.MAX_PARTS) {
      throw new IllegalArgumentException(
          "parts="
              + count
              + " is more than the "
              + BodyStore.MAX_PARTS
              + " convex parts one body can have; split it into several bodies");
    }
    return (int) count;
  }

  /** Returns the mass of a body of a type: none, unless it is dynamic. */
  public static MassData total(byte type, ShapeSpec[] shapes, MassData own) {
    return type == BodyStore.DYNAMIC ? massOf(shapes, own) : NO_MASS;
  }

  /** Returns the mass of a dynamic body, in its frame; refuses shapes without mass. */
  public static MassData massOf(ShapeSpec[] shapes, MassData own) {
    if (own != null) {
      for (ShapeSpec spec : shapes) {
        refuseLines(spec.shape());
      }
      checkCenter(own.centerX(), own.centerY());
      checkAround(shapes, own.centerX(), own.centerY());
      return own;
    }
    if (shapes.length == 0) {
      return new MassData(1, 0, 0, 0);
    }
    double mass = 0;
    double mx = 0;
    double my = 0;
    for (ShapeSpec spec : shapes) {
      refuseLines(spec.shape());
      MassData m = spec.shape().mass(spec.density());
      mass += m.mass();
      mx += (double) m.mass() * m.centerX();
      my += (double) m.mass() * m.centerY();
    }
    Limits.range("mass", (float) mass, 1e-9f, 1e15f);
    float x = (float) (mx / mass);
    float y = (float) (my / mass);
    checkCenter(x, y);
    checkAround(shapes, x, y);
    double inertia = 0;
    for (ShapeSpec spec : shapes) {
      MassData m = spec.shape().mass(spec.density());
      double dx = m.centerX() - x;
      double dy = m.centerY() - y;
      inertia += m.inertia() + m.mass() * (dx * dx + dy * dy);
    }
    return new MassData((float) mass, x, y, (float) inertia);
  }

  /** Refuses a centre of mass too far from the body's origin for a pose to tell where it is. */
  public static void checkCenter(float x, float y) {
    Limits.range("centerX", x, -Limits.MAX_POSITION, Limits.MAX_POSITION);
    Limits.range("centerY", y, -Limits.MAX_POSITION, Limits.MAX_POSITION);
  }

  /** Refuses shapes that can't be moved so that a centre of mass is their origin. */
  private static void checkAround(ShapeSpec[] shapes, float x, float y) {
    if (x != 0 || y != 0) {
      for (ShapeSpec spec : shapes) {
        for (Convex part : spec.shape().parts()) {
          part.moved(-x, -y);
        }
      }
    }
  }

  /** Refuses segments and chains, for bodies that move by forces. */
  private static void refuseLines(Shape shape) {
    for (Convex part : shape.parts()) {
      if (part instanceof Segment) {
        throw new IllegalArgumentException(
            "shape="
                + part
                + " has no mass, which a dynamic body needs; make the body static or kinematic, or"
                + " the line a thin capsule");
      }
    }
  }

  /** Gives a body other shapes, as many parts as they have, and the mass of {@link #refill}. */
  public void reshape(int body, ShapeSpec[] shapes, MassData own, MassData total) {
    int count = partCount(shapes);
    parts.release(bodies.firstPart[body], bodies.partCount[body]);
    bodies.firstPart[body] = parts.allocate(body, count);
    bodies.partCount[body] = count;
    refill(body, shapes, own, total);
  }

  /** Gives a body other mass and materials; its origin, and the velocity there, stay. */
  public void refill(int body, ShapeSpec[] shapes, MassData own, MassData total) {
    float oldX = bodies.x[body];
    float oldY = bodies.y[body];
    float oldLocalX = bodies.localX[body];
    float oldLocalY = bodies.localY[body];
    float originX = bodies.originX(body);
    float originY = bodies.originY(body);
    fill(body, shapes, own, total);
    if (bodies.localX[body] == oldLocalX && bodies.localY[body] == oldLocalY) {
      return;
    }
    bodies.setOriginPose(body, originX, originY, bodies.cos[body], bodies.sin[body]);
    bodies.vx[body] -= bodies.w[body] * (bodies.y[body] - oldY);
    bodies.vy[body] += bodies.w[body] * (bodies.x[body] - oldX);
  }

  /** Writes mass and shapes to the stores. */
  private void fill(int body, ShapeSpec[] shapes, MassData own, MassData total) {
    boolean dynamic = bodies.type[body] == BodyStore.DYNAMIC;
    boolean turns = dynamic && (bodies.flags[body] & BodyStore.FIXED_ROTATION) == 0;
    turns = turns && total.inertia() > 0;
    bodies.mass[body] = total.mass();
    bodies.invMass[body] = dynamic ? 1 / total.mass() : 0;
    bodies.coldChanged();
    bodies.inertia[body] = turns ? total.inertia() : 0;
    bodies.invInertia[body] = turns ? 1 / total.inertia() : 0;
    bodies.localX[body] = total.centerX();
    bodies.localY[body] = total.centerY();
    int part = bodies.firstPart[body];
    long hash = StateHash.SEED;
    if (own != null) {
      hash = StateHash.mix(hash, own.mass(), own.inertia());
      hash = StateHash.mix(hash, own.centerX(), own.centerY());
    }
    float inner = Float.POSITIVE_INFINITY;
    float reach = 0;
    for (int i = 0; i < shapes.length; i++) {
      ShapeSpec spec = shapes[i];
      for (Convex convex : spec.shape().parts()) {
        Convex local = convex.moved(-bodies.localX[body], -bodies.localY[body]);
        parts.set(part, local, i, spec);
        hash = StateHash.mix(hash, spec.friction(), spec.restitution());
        hash = spec.mix(hash, dynamic && own == null);
        hash = ShapeHash.mix(hash, local);
        local.aabb(identity, box);
        if (!spec.sensor()) {
          inner = Math.min(inner, local.innerRadius());
        }
        float furthestX = Math.max(-box.minX, box.maxX);
        float furthestY = Math.max(-box.minY, box.maxY);
        float square = furthestX * furthestX + furthestY * furthestY;
        reach = Math.max(reach, (float) Math.sqrt(square));
        part++;
      }
    }
    bodies.reach[body] = reach;
    bodies.shapeHash[body] = hash;
    bodies.innerRadius[body] = inner;
  }
}
