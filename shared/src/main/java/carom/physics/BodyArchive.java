package carom.physics;

import carom.physics.archive.Archive;
import carom.physics.dynamics.DynamicsState;
import carom.physics.geometry.Convex;
import carom.physics.geometry.MassData;
import carom.physics.geometry.Shape;
import carom.physics.geometry.ShapeArchive;
import carom.physics.settings.MixingRule;

/** Passes the shapes, materials, filters and own masses of bodies through an archive. */
final class BodyArchive {
  private static final float MOST = Float.MAX_VALUE;
  private static final MixingRule[] RULES = MixingRule.values();
  private static final int SHAPE_BYTES = 4 * Integer.BYTES;

  private final Archive a;
  private final Interner<Shape> shapes = new Interner<>(BodyArchive::same);
  private final Interner<Material> materials = new Interner<>(Material::equals);
  private final Interner<Filter> filters = new Interner<>(Filter::equals);

  /** Number of convex parts of all shapes that were read so far. */
  private long parts;

  BodyArchive(Archive a) {
    this.a = a;
  }

  private static boolean same(Shape p, Shape q) {
    return p == q || (p instanceof Convex x && q instanceof Convex y && x.isSame(y));
  }

  /** Passes a body's shapes through the archive. The given shapes are null when reading. */
  ShapeDef[] passShapes(ShapeDef[] given) {
    int most = Integer.MAX_VALUE / SHAPE_BYTES;
    int count = a.count("shapes of body", a.reads() ? 0 : given.length, most, SHAPE_BYTES);
    ShapeDef[] passed = new ShapeDef[count];
    for (int i = 0; i < count; i++) {
      ShapeDef d = a.reads() ? null : given[i];
      passed[i] =
          new ShapeDef(
              shapes.pass(a, "shape", d == null ? null : d.shape(), s -> ShapeArchive.pass(a, s)),
              materials.pass(a, "material", d == null ? null : d.material(), this::pass),
              filters.pass(a, "filter", d == null ? null : d.filter(), this::pass),
              a.flag("sensor", d != null && d.sensor()));
      if (a.reads()) {
        // Refuse too many parts while reading, before a hostile file costs more time.
        parts += passed[i].shape().parts().size();
        a.require(
            parts <= DynamicsState.MAX_PARTS, "parts=" + parts + " of all shapes are too many");
      }
    }
    return passed;
  }

  private Material pass(Material m) {
    boolean reads = m == null;
    return new Material(
        a.number("density", reads ? 0 : m.density(), 0, MOST),
        a.number("friction", reads ? 0 : m.friction(), 0, MOST),
        a.number("restitution", reads ? 0 : m.restitution(), 0, MOST),
        a.number("rolling resistance", reads ? 0 : m.rollingResistance(), 0, MOST),
        a.number("tangent speed", reads ? 0 : m.tangentSpeed(), -MOST, MOST),
        a.integer("tag", reads ? 0 : m.tag(), Integer.MIN_VALUE, Integer.MAX_VALUE),
        pass("friction mixing", reads ? null : m.frictionMixing()),
        pass("restitution mixing", reads ? null : m.restitutionMixing()));
  }

  /** Passes a rule through the archive, by its number in the list; 0 stands for the world's. */
  private MixingRule pass(String what, MixingRule rule) {
    int code = a.integer(what, rule == null ? 0 : rule.ordinal() + 1, 0, RULES.length);
    return code == 0 ? null : RULES[code - 1];
  }

  private Filter pass(Filter f) {
    boolean reads = f == null;
    int least = Integer.MIN_VALUE;
    int most = Integer.MAX_VALUE;
    return new Filter(
        a.integer("category", reads ? 0 : f.category(), least, most),
        a.integer("mask", reads ? 0 : f.mask(), least, most),
        a.integer("group", reads ? 0 : f.group(), least, most));
  }

  /** Passes a body's own mass through the archive. It is null if the body has none. */
  MassData passMass(MassData own) {
    if (!a.flag("own mass", own != null)) {
      return null;
    }
    boolean reads = a.reads();
    return BodyDef.checkedMass(
        a.number("mass", reads ? 0 : own.mass(), 0, MOST),
        a.number("inertia", reads ? 0 : own.inertia(), 0, MOST),
        a.number("centre x", reads ? 0 : own.centerX(), -MOST, MOST),
        a.number("centre y", reads ? 0 : own.centerY(), -MOST, MOST));
  }
}
