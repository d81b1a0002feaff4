package carom.sim.level;

import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.ShapeDef;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import carom.sim.field.Field;
import carom.sim.field.Ratio;
import carom.sim.field.Schema;
import java.util.ArrayList;
import java.util.List;

/**
 * A kind of entity: shapes, materials and behaviour that all its entities share. Immutable.
 *
 * <p>Server and client register the same archetypes in the same order (the level's first, then the
 * game's), so an entity's archetype crosses the wire as its {@link #index}.
 */
public final class Archetype {
  private final int index;
  private final ArchetypeDef def;
  private final List<Shape> shapes;
  private final List<Material> materials;
  private final float reach;

  Archetype(int index, ArchetypeDef def) {
    this.index = index;
    this.def = new ArchetypeDef(def);
    shapes = List.copyOf(def.shapes);
    materials = List.copyOf(def.materials);
    reach = reachOf(shapes);
  }

  private static float reachOf(List<Shape> shapes) {
    Aabb box = new Aabb();
    Transform identity = new Transform();
    float reach = 0;
    for (Shape shape : shapes) {
      shape.aabb(identity, box);
      float w = Math.max(Math.abs(box.minX), Math.abs(box.maxX));
      float h = Math.max(Math.abs(box.minY), Math.abs(box.maxY));
      reach = Math.max(reach, (float) Math.sqrt(w * w + h * h));
    }
    return reach;
  }

  /** Returns its position among the simulation's {@link Archetypes}, from 0. */
  public int index() {
    return index;
  }

  /** Returns its name, for people and for {@link Archetypes#find}. */
  public String name() {
    return def.name;
  }

  /** Returns whether its bodies are static, kinematic or dynamic. */
  public BodyType type() {
    return def.type;
  }

  /** Returns the shapes in the body's frame, unmodifiable. */
  public List<Shape> shapes() {
    return shapes;
  }

  /** Radius of a circle around the body's origin that holds all shapes at any angle, metres. */
  public float reach() {
    return reach;
  }

  /** Returns the material of each shape, unmodifiable. */
  public List<Material> materials() {
    return materials;
  }

  /** Returns whether its bodies carry only what comes from above. */
  public boolean oneWay() {
    return def.oneWay;
  }

  /**
   * Returns whether its bodies are sensors, which detect overlaps and collide with nothing; see
   * {@link ShapeDef}.
   */
  public boolean sensor() {
    return def.sensor;
  }

  /** Returns a number with a meaning of the game's own, the same on server and client. */
  public int tag() {
    return def.tag;
  }

  /** Returns the constant angular velocity of a kinematic body, rad/s, counterclockwise. */
  public float spin() {
    return def.spin;
  }

  /** Returns the path of a kinematic body, or null. */
  public ScriptedMotion motion() {
    return def.motion;
  }

  /** Returns the area that its entities carry, in the body's frame, or null. */
  public Area area() {
    return def.area;
  }

  /** Returns the entity field that says how strong {@link #area} is, or null if it always is. */
  public Ratio areaPower() {
    return def.areaPower;
  }

  /**
   * Returns the entity fields that don't begin as declared, each with its start.
   *
   * @param schema the game's fields
   * @throws IllegalArgumentException if the level starts a field that the game doesn't declare, or
   *     with a value that it can't hold
   */
  public List<Field<?>> starts(Schema schema) {
    List<Field<?>> all = new ArrayList<>(def.starts);
    for (LevelField field : def.levelFields) {
      all.add(field.of(schema));
    }
    return all;
  }

  /** Returns how its entities are drawn. */
  public Appearance appearance() {
    return def.appearance;
  }

  /** Returns a new body definition for a place; the angle is in radians. Allocates. */
  public BodyDef body(float x, float y, float angle) {
    BodyDef body =
        new BodyDef()
            .type(def.type)
            .position(x, y)
            .angle(angle)
            .linearDamping(def.linearDamping)
            .angularDamping(def.angularDamping)
            .gravityScale(def.gravityScale)
            .motionLocks(def.locks)
            .bullet(def.bullet);
    if (def.sleepSpeed != null) {
      body.sleepSpeed(def.sleepSpeed);
    }
    if (def.type == BodyType.KINEMATIC) {
      body.angularVelocity(def.spin);
    }
    for (int i = 0; i < shapes.size(); i++) {
      body.shape(new ShapeDef(shapes.get(i), materials.get(i), def.filter, def.sensor));
    }
    return body;
  }

  @Override
  public String toString() {
    return def.name + "#" + index;
  }
}
