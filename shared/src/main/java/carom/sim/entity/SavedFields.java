package carom.sim.entity;

import carom.physics.archive.Archive;
import carom.sim.field.Field;
import carom.sim.field.FieldValues;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The values of all fields of a simulation, saved. Reused from save to save; allocates only to
 * grow. One thread.
 */
public final class SavedFields {
  private static final int MAX_LINE = 1 << 16;

  private final Schema schema;

  /** Words by scope, one target after the other. */
  private final int[][] words = new int[Scope.values().length][0];

  /** Creates an empty store for saved values of a schema. */
  public SavedFields(Schema schema) {
    this.schema = schema;
  }

  /** Copies the values of a target, which is the only one of its scope with this id. */
  public void save(FieldValues values, int id) {
    values.copyTo(ensure(values.scope(), id), at(values.scope(), id));
  }

  /** Gives a target the values that were saved or read under its id. */
  public void restore(FieldValues values, int id) {
    values.copyFrom(words[values.scope().ordinal()], at(values.scope(), id));
  }

  /** Returns a word of the match that was saved. */
  public int matchWord(int index) {
    return words[Scope.MATCH.ordinal()][index];
  }

  /**
   * Passes the declarations to or from an archive.
   *
   * @throws carom.physics.archive.ArchiveException if they differ from these, with the name of the
   *     field
   */
  public void passSchema(Archive a) {
    List<String> mine = schema.lines();
    int n = a.count("fields", mine.size(), Schema.MAX_FIELDS, Integer.BYTES);
    List<String> stored = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      stored.add(a.text("field", a.reads() ? "" : mine.get(i), MAX_LINE));
    }
    String difference = schema.difference(stored);
    a.require(difference == null, "the state is of other fields: " + difference);
  }

  /** Passes the values of a target to or from an archive, each within its field's range. */
  public void pass(Archive a, Scope scope, int id) {
    int[] all = ensure(scope, id);
    int at = at(scope, id);
    for (int i = 0; i < schema.words(scope); i++) {
      Field<?> field = schema.field(scope, i);
      all[at + i] = a.integer(field.path(), all[at + i], field.min(), field.max());
    }
  }

  private int at(Scope scope, int id) {
    return id * schema.words(scope);
  }

  private int[] ensure(Scope scope, int id) {
    int needed = at(scope, id + 1);
    int[] all = words[scope.ordinal()];
    if (needed > all.length) {
      all = Arrays.copyOf(all, scope == Scope.MATCH ? needed : 2 * needed);
      words[scope.ordinal()] = all;
    }
    return all;
  }
}
