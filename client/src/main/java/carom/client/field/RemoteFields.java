package carom.client.field;

import carom.net.field.FieldTables;
import carom.net.protocol.ProtocolLimits;
import carom.net.snapshot.table.TableInbox;
import carom.net.snapshot.table.TableLayout;
import carom.sim.field.Field;
import carom.sim.field.FieldStore;
import carom.sim.field.FieldValues;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import carom.sim.phase.Phases;
import carom.sim.spawn.Origin;
import java.util.Arrays;
import java.util.function.IntSupplier;

/**
 * The fields of one game as one client knows them. Values of others are the newest that the server
 * told, also of entities that are drawn a little in the past. A view is brought up to date when it
 * is asked for. One stay's; one thread; allocates for the first look at a player or an entity.
 */
public final class RemoteFields implements ShownFields {
  private final Schema schema;
  private final TableInbox inbox;
  private final FieldStore store;
  private final FieldView match;
  private FieldView[] players = {};
  private FieldView[] entities = {};
  private int ownId = -1;
  private final FieldView provisional;
  private FieldView ownBody;
  private int ownGeneration;

  /**
   * Creates the fields of a game, all as declared.
   *
   * @param clock the tick for which countdowns are read
   */
  public RemoteFields(Schema schema, IntSupplier clock) {
    this.schema = schema;
    FieldTables tables =
        new FieldTables(schema, ProtocolLimits.MAX_PLAYERS, ProtocolLimits.MAX_ENTITIES);
    inbox = new TableInbox(tables.layouts().toArray(new TableLayout[0]));
    store = new FieldStore(schema, clock, new Finder(), new Phases<>(true));
    match = new FieldView(store, Scope.MATCH, -1);
    provisional = new FieldView(store, Scope.ENTITY, -1);
  }

  private final class Finder implements FieldStore.References<FieldView, FieldView> {
    @Override
    public FieldView entity(int id, int generation) {
      return RemoteFields.this.entity(id, generation);
    }

    @Override
    public FieldView player(int id) {
      return RemoteFields.this.player(id);
    }
  }

  /** Returns what takes the rows of the server's tables. */
  public TableInbox inbox() {
    return inbox;
  }

  /**
   * Sets the own player's fields.
   *
   * @param id the own player's id
   * @param values as predicted
   */
  public void own(int id, FieldValues values) {
    ownId = id;
    FieldValues own = playerView(id).fieldValues();
    for (int i = 0; i < schema.toldWords(Scope.PLAYER); i++) {
      own.copy(i, values);
    }
  }

  /**
   * Sets the fields of the own body.
   *
   * @param id of the entity; -1 if there is none
   * @param values as predicted; null if there is none
   */
  public void ownBody(int id, int generation, FieldValues values) {
    ownBody = id < 0 ? null : entityView(id);
    ownGeneration = generation;
    for (int i = 0; ownBody != null && i < schema.toldWords(Scope.ENTITY); i++) {
      ownBody.fieldValues().copy(i, values);
    }
  }

  /** Sets a word of the own player's fields as the server told it. */
  public void own(int id, int word, int value) {
    ownId = id;
    set(playerView(id).fieldValues(), Scope.PLAYER, word, value);
  }

  @Override
  public FieldView match() {
    load(match, Scope.MATCH, 0, 0);
    return match;
  }

  @Override
  public FieldView player(int id) {
    FieldView view = playerView(id);
    if (id != ownId) {
      load(view, Scope.PLAYER, id, 0);
    }
    return view;
  }

  private FieldView playerView(int id) {
    if (id >= players.length) {
      players = Arrays.copyOf(players, Math.max(id + 1, 2 * players.length));
    }
    if (players[id] == null) {
      players[id] = new FieldView(store, Scope.PLAYER, id);
    }
    return players[id];
  }

  /** Returns the fields of an entity; as declared, if only the own input has spawned it. */
  @Override
  public FieldView entity(int id, int generation) {
    if (Origin.isProvisional(id)) {
      return provisional.of(id, generation);
    }
    FieldView view = entityView(id).of(id, generation);
    if (view != ownBody || generation != ownGeneration) {
      load(view, Scope.ENTITY, id, generation);
    }
    return view;
  }

  private FieldView entityView(int id) {
    if (id >= entities.length) {
      entities = Arrays.copyOf(entities, Math.max(id + 1, 2 * entities.length));
    }
    if (entities[id] == null) {
      entities[id] = new FieldView(store, Scope.ENTITY, id);
    }
    return entities[id];
  }

  private void load(FieldView view, Scope scope, int target, int identity) {
    int table = FieldTables.table(scope);
    TableLayout layout = inbox.layout(table);
    int told = schema.toldWords(scope);
    int tick = -1;
    for (int chunk = 0; told > 0 && chunk < layout.chunks(); chunk++) {
      tick = Math.max(tick, inbox.tick(table, target * layout.chunks() + chunk));
    }
    if (view.isLoaded(tick, identity)) {
      return;
    }
    for (int word = 0; word < told; word++) {
      int key = target * layout.chunks() + word / layout.width();
      int value = inbox.get(table, key, identity, word % layout.width());
      set(view.fieldValues(), scope, word, value);
    }
  }

  /** Sets a word, unless its field can't hold it. */
  private void set(FieldValues values, Scope scope, int word, int value) {
    Field<?> field = schema.field(scope, word);
    if (value >= field.min() && value <= field.max()) {
      values.mirror(word, value);
    }
  }
}
