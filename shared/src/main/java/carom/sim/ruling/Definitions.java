package carom.sim.ruling;

import carom.physics.Body;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.sim.level.Archetype;
import java.util.ArrayList;
import java.util.List;

/**
 * Compares bodies with their archetypes, which are all that clients know them by. One thread.
 * Allocates for the first body of each archetype.
 */
final class Definitions {
  /** Has the samples; made when the first one is. */
  private World<Object> world;

  /** A body just as its archetype says, by the archetype's index; null before the first one. */
  private final List<Body<Object>> samples = new ArrayList<>();

  /** Creates a comparison that has seen no archetype yet. */
  Definitions() {}

  /**
   * Returns what a body has that its archetype doesn't say. Outlines and sleep aren't compared.
   *
   * @return the name of one such property, such as {@code filter}; null if there is none
   */
  String difference(Archetype archetype, Body<?> body) {
    while (samples.size() <= archetype.index()) {
      samples.add(null);
    }
    Body<Object> sample = samples.get(archetype.index());
    if (sample == null) {
      world = world == null ? new World<>(new WorldDef()) : world;
      sample = world.createBody(archetype.body(0, 0, 0), null);
      samples.set(archetype.index(), sample);
    }
    String shapes = differenceOfShapes(sample, body);
    if (shapes != null) {
      return shapes;
    } else if (body.type() != sample.type()) {
      return "type";
    } else if (body.hasOwnMass()) {
      return "mass";
    } else if (body.isBullet() != sample.isBullet()) {
      return "bullet";
    } else if (!body.motionLocks().equals(sample.motionLocks())) {
      return "motionLocks";
    } else if (body.gravityScale() != sample.gravityScale()) {
      return "gravityScale";
    } else if (body.linearDamping() != sample.linearDamping()) {
      return "linearDamping";
    }
    return body.angularDamping() == sample.angularDamping() ? null : "angularDamping";
  }

  private static String differenceOfShapes(Body<?> sample, Body<?> body) {
    if (body.shapeCount() != sample.shapeCount()) {
      return "number of shapes";
    }
    for (int i = 0; i < body.shapeCount(); i++) {
      if (!body.material(i).equals(sample.material(i))) {
        return "material";
      } else if (!body.filter(i).equals(sample.filter(i))) {
        return "filter";
      } else if (body.sensor(i) != sample.sensor(i)) {
        return "sensor";
      }
    }
    return null;
  }
}
