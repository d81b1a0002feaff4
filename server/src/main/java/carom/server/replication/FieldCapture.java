package carom.server.replication;

import carom.net.field.FieldTables;
import carom.net.protocol.ProtocolLimits;
import carom.net.snapshot.table.JointWords;
import carom.net.snapshot.table.Table;
import carom.net.snapshot.table.TableLayout;
import carom.net.snapshot.table.Tables;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.field.FieldValues;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Copies the fields that changed into the tables that all sessions of a room share, once per tick.
 * Entities are looked at only in ticks in which any of them changed a field, came or went.
 *
 * <p>The room's thread; no allocation but to grow.
 */
final class FieldCapture {
  private final SimulationHost simulation;
  private final Schema schema;
  private final List<Table> tables;

  /** The words of one target, filled up to whole rows. */
  private final int[] words;

  // By id: the player or entity of the table's row, and how new the row is.
  private HostPlayer[] players = {};
  private long[] playerStamps = {};
  private int[] teams = {};
  private HostEntity[] entities = {};
  private long[] entityStamps = {};
  private long matchStamp;
  private long entityChanges;
  private long roster = -1;
  private int teamChanges;

  FieldCapture(SimulationHost simulation) {
    this.simulation = simulation;
    schema = simulation.schema();
    FieldTables of =
        new FieldTables(schema, ProtocolLimits.MAX_PLAYERS, ProtocolLimits.MAX_ENTITIES);
    tables = new ArrayList<>(of.layouts().stream().map(Table::new).toList());
    int most = 0;
    for (TableLayout layout : of.layouts()) {
      most = Math.max(most, layout.chunks() * layout.width());
    }
    words = new int[most];
  }

  /** Returns the room's tables: those of fields, and that of joints. */
  Tables with(Table joints) {
    tables.set(JointWords.TABLE, joints);
    return new Tables(tables);
  }

  /** Returns a number that grows whenever a player comes, goes, or changes the team. */
  int teamChanges() {
    return teamChanges;
  }

  /** Captures the state after the simulation's last step. */
  void capture() {
    int tick = simulation.tick();
    capturePlayers(tick);
    if (schema.toldWords(Scope.ENTITY) > 0) {
      captureEntities(tick);
    }
    FieldValues match = simulation.fieldValues();
    if (match.stamp() != matchStamp) {
      matchStamp = match.stamp();
      put(Scope.MATCH, 0, 0, match, tick);
    }
  }

  private void capturePlayers(int tick) {
    int capacity = simulation.playerCapacity();
    if (players.length < capacity) {
      players = Arrays.copyOf(players, 2 * capacity);
      playerStamps = Arrays.copyOf(playerStamps, players.length);
      teams = Arrays.copyOf(teams, players.length);
    }
    for (int id = 0; id < capacity; id++) {
      HostPlayer player = simulation.player(id);
      boolean isNew = player != players[id];
      if (isNew || (player != null && player.team() != teams[id])) {
        teamChanges++;
        teams[id] = player == null ? 0 : player.team();
      }
      if (player != null && (isNew || player.fieldValues().stamp() != playerStamps[id])) {
        playerStamps[id] = player.fieldValues().stamp();
        put(Scope.PLAYER, id, 0, player.fieldValues(), tick);
      }
      players[id] = player;
    }
  }

  private void captureEntities(int tick) {
    long changes = simulation.fieldChanges(Scope.ENTITY);
    if (changes == entityChanges && roster == simulation.rosterVersion()) {
      return;
    }
    entityChanges = changes;
    roster = simulation.rosterVersion();
    int capacity = simulation.entityCapacity();
    if (entities.length < capacity) {
      entities = Arrays.copyOf(entities, 2 * capacity);
      entityStamps = Arrays.copyOf(entityStamps, entities.length);
    }
    for (int id = 0; id < capacity; id++) {
      HostEntity entity = simulation.entity(id);
      if (entity != null
          && (entity != entities[id] || entity.fieldValues().stamp() != entityStamps[id])) {
        entityStamps[id] = entity.fieldValues().stamp();
        put(Scope.ENTITY, id, entity.generation(), entity.fieldValues(), tick);
      }
      entities[id] = entity;
    }
  }

  private void put(Scope scope, int target, int identity, FieldValues values, int tick) {
    int told = schema.toldWords(scope);
    if (told == 0) {
      return;
    }
    Table table = tables.get(FieldTables.table(scope));
    TableLayout layout = table.layout();
    int rows = layout.chunks() * layout.width();
    for (int i = 0; i < rows; i++) {
      words[i] = i < told ? values.word(i) : 0;
    }
    for (int chunk = 0; chunk < layout.chunks(); chunk++) {
      int key = target * layout.chunks() + chunk;
      table.put(key, identity, words, chunk * layout.width(), tick);
    }
  }
}
