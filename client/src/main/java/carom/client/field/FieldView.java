package carom.client.field;

import carom.sim.field.FieldReader;
import carom.sim.field.FieldStore;
import carom.sim.field.FieldValues;
import carom.sim.field.Scope;

/**
 * The fields of a player, an entity or the match as a client knows them. Read them by the typed
 * methods {@code get}; what the client may not know is as declared. Setting a value changes nothing
 * but this view. One thread.
 */
public final class FieldView implements FieldReader<FieldView, FieldView> {
  private static final int NEVER = -2;

  private final FieldValues values;
  private final int reference;
  private int loadedTick = NEVER;
  private int identity;

  FieldView(FieldStore store, Scope scope, int reference) {
    values = store.create(scope);
    this.reference = reference;
  }

  /** Returns the values as words, for tools. */
  @Override
  public FieldValues fieldValues() {
    return values;
  }

  @Override
  public int reference() {
    return reference;
  }

  /** Returns whether the values are those of a user of the key as of a tick, and notes that. */
  boolean isLoaded(int tick, int user) {
    boolean same = loadedTick == tick && identity == user;
    loadedTick = tick;
    identity = user;
    return same;
  }
}
