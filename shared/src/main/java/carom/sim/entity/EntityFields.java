package carom.sim.entity;

import carom.sim.field.FieldStore;
import carom.sim.field.FieldValues;
import carom.sim.field.Ratio;
import carom.sim.field.Scope;
import carom.sim.level.Archetype;
import carom.sim.level.Archetypes;
import java.util.Arrays;

/** Creates the fields of entities, which begin as their archetypes say. */
final class EntityFields {
  private final FieldStore fields;

  /** By archetype: the words with which its entities begin; null until one does. */
  private int[][] starts = new int[16][];

  EntityFields(FieldStore fields) {
    this.fields = fields;
  }

  /**
   * Creates the fields of an entity.
   *
   * @throws IllegalArgumentException if the archetype starts a field that isn't declared
   */
  FieldValues create(Archetype archetype, boolean ofLevel) {
    int[] begins = starts(archetype);
    return ofLevel ? fields.createOfLevel(begins) : fields.create(Scope.ENTITY, begins);
  }

  /** Lets values count as begun as an archetype says; they stay as they are. */
  void begunAs(Archetype archetype, FieldValues values) {
    values.begunAs(starts(archetype));
  }

  private int[] starts(Archetype archetype) {
    int index = archetype.index();
    if (index >= starts.length) {
      starts = Arrays.copyOf(starts, Math.max(index + 1, 2 * starts.length));
    }
    if (starts[index] == null) {
      starts[index] = fields.schema().starts(Scope.ENTITY, archetype.starts(fields.schema()));
    }
    return starts[index];
  }

  /**
   * Checks that archetypes use declared fields only.
   *
   * @throws IllegalArgumentException if one starts a field that isn't declared, or has an area
   *     whose power is in one
   */
  void check(Archetypes archetypes) {
    for (int i = 0; i < archetypes.size(); i++) {
      starts(archetypes.get(i));
      Ratio power = archetypes.get(i).areaPower();
      if (power != null && !fields.schema().fields().contains(power)) {
        throw new IllegalArgumentException(
            "archetype="
                + archetypes.get(i).name()
                + ": field "
                + power.path()
                + " isn't declared; return it from Game.fields");
      }
    }
  }
}
