package carom.client.field;

import carom.sim.field.FieldReader;
import carom.sim.field.FieldStore;
import carom.sim.field.FieldValues;
import carom.sim.field.Scope;

/**
 * The fields of a player, an entity or the match as a client knows them. Read them by the typed
 * methods {@code get}; what the client may not know is as declared. A field that means a player or
 * an entity gives the fields of that one, whose {@link #id} says which it is. One thread.
 */
public final class FieldView implements FieldReader<FieldView, FieldView> {
  private static final int NEVER = -2;

  private final FieldValues values;
  private int id;
  private int generation = -1;
  private int loadedTick = NEVER;
  private int identity;

  FieldView(FieldStore store, Scope scope, int id) {
    values = store.create(scope);
    this.id = id;
  }

  /** Returns the values as words, for tools. */
  @Override
  public FieldValues fieldValues() {
    return values;
  }

  /** Returns the id of the player or entity; -1 of the match. */
  public int id() {
    return id;
  }

  /** Returns which of the entities that had the id one after the other this is; -1 of others. */
  public int generation() {
    return generation;
  }

  /** Sets whose values these are, for a view that serves several entities. */
  FieldView of(int entityId, int entityGeneration) {
    id = entityId;
    generation = entityGeneration;
    return this;
  }

  /** Returns whether the values are those of a user of the key as of a tick, and notes that. */
  boolean isLoaded(int tick, int user) {
    boolean same = loadedTick == tick && identity == user;
    loadedTick = tick;
    identity = user;
    return same;
  }
}
