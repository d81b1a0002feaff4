package carom.testkit;

import carom.client.field.OwnWords;
import carom.client.prediction.Prediction;
import carom.game.Games;
import carom.net.field.FieldTables;
import carom.net.protocol.Limits;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.snapshot.exact.NearState;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.table.TableInbox;
import carom.net.snapshot.table.TableLayout;
import carom.physics.Body;
import carom.physics.rows.ContactRow;
import carom.physics.rows.RowCounts;
import carom.physics.rows.RowKind;
import carom.physics.rows.Rows;
import carom.sim.Role;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.Player;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.sim.near.Neighbourhood;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.function.LongSupplier;

/**
 * A server's simulation of a wall of crates with a player on top, and a client's {@link Prediction}
 * of it. There is no network: the client receives the server's state at once, and its clock runs
 * ahead.
 */
public final class IslandRig {
  /** Number of crates in a row of the wall. */
  public static final int COLUMNS = 20;

  private final Simulation server;
  private final Player serverPlayer;
  private final Prediction client;
  private final Simulation predicted;
  private final SnapshotDecoder decoder;
  private final Neighbourhood island;
  private final OwnState own;

  /**
   * Builds the wall. The client doesn't know of it yet.
   *
   * @param crates number of crates, a multiple of {@value #COLUMNS}, at most 240
   * @param maxReplayNs bound of the time of the client's replays, ns
   * @param stopwatch measures the replays, ns
   */
  public IslandRig(int crates, long maxReplayNs, LongSupplier stopwatch) {
    Level level = level(crates);
    server = new Simulation(Games.create(level.gameName()), level, 1, 60, Role.AUTHORITY);
    serverPlayer = server.join("p");
    island = new Neighbourhood(serverPlayer.id());
    predicted = new Simulation(Games.create(level.gameName()), level, 1, 60, Role.PREDICTION);
    client = new Prediction(predicted, serverPlayer.id(), "p", 120, maxReplayNs, stopwatch, false);
    int words = OwnWords.count(predicted.schema());
    own = new OwnState(words);
    TableLayout[] tables =
        new FieldTables(predicted.schema(), Limits.MAX_PLAYERS, Limits.MAX_ENTITIES)
            .layouts()
            .toArray(new TableLayout[0]);
    decoder = new SnapshotDecoder(Limits.MAX_ENTITIES, 1, 0, 60, words, new TableInbox(tables));
    Entity body = serverPlayer.body();
    decoder.level(
        FrameState.of(
            Limits.MAX_ENTITIES,
            frame -> {
              level.forEachBody(frame::put);
              frame.put(
                  body.id(),
                  body.generation(),
                  body.archetype().index(),
                  body.ownerId(),
                  body.body().x(),
                  body.body().y(),
                  0,
                  0,
                  0,
                  0);
            }));
  }

  /** Returns a wall of crates, each on two others, with a player on top. */
  private static Level level(int crates) {
    int rows = crates / COLUMNS;
    StringBuilder bodies = new StringBuilder();
    for (int row = 0; row < rows; row++) {
      bodies.append(row == 0 ? "" : ",");
      bodies.append(
          String.format(
              Locale.ROOT,
              "{\"name\": \"crate\", \"at\": [%.2f, %.2f], \"material\": \"crate\","
                  + "\"shape\": {\"type\": \"box\", \"width\": 1, \"height\": 1},"
                  + "\"repeat\": {\"columns\": %d, \"step\": [1.06, 0]}}",
              -10 + row % 2 * 0.53,
              row + 0.5,
              COLUMNS));
    }
    String json =
        """
        {"name": "block", "game": "platformer", "gravity": [0, -26],
         "bounds": {"min": [-40, -6], "max": [40, 60]},
         "materials": {"ground": {"friction": 0.7}, "crate": {"density": 0.4, "friction": 0.6}},
         "spawns": [{"name": "player", "at": [0, %d]}, {"name": "flag", "at": [0, 55]}],
         "statics": [{"name": "floor", "at": [0, -1], "material": "ground",
           "shape": {"type": "box", "width": 60, "height": 2}}],
         "bodies": [%s]}
        """
            .formatted(rows + 1, bodies);
    try {
      return Level.parse("block.json", json.getBytes(StandardCharsets.UTF_8));
    } catch (LevelException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Returns the server's simulation. */
  public Simulation server() {
    return server;
  }

  /** Returns the player in the server's simulation. */
  public Player player() {
    return serverPlayer;
  }

  /** Returns the client's simulation. */
  public Simulation predicted() {
    return predicted;
  }

  /** Returns the client's prediction. */
  public Prediction client() {
    return client;
  }

  /** Returns the island as the client was told it last. */
  public Neighbourhood island() {
    return island;
  }

  /**
   * Tells the client the whole island at the server's tick. Returns whether the client now has that
   * state in every bit.
   */
  public boolean tellAll() {
    readOwn();
    return tellIsland();
  }

  private boolean tellIsland() {
    int total = island.count() + contacts();
    for (int first = 0; first < total; first += NearState.MAX_PART) {
      part(first, Math.min(total, first + NearState.MAX_PART), total);
      client.receive(own, server.tick());
    }
    client.reconcile(own, server.tick(), decoder);
    return client.agreement().agreedTick() == server.tick();
  }

  /**
   * Tells the client the island as {@link #tellAll} does, but with one number for all floats of
   * contacts.
   */
  public boolean tellContactsOf(float number) {
    readOwn();
    for (int row = 0; row < contacts(); row++) {
      for (int field = ContactRow.FLOATS; field < ContactRow.INTS; field++) {
        island.rows().contacts().set(row, field, Float.floatToRawIntBits(number));
      }
    }
    return tellIsland();
  }

  private int contacts() {
    return island.rows().contacts().count();
  }

  /** Tells the client its own state and the hash of all; whether it has that in every bit. */
  public boolean tellOwn() {
    readOwn();
    list();
    client.reconcile(own, server.tick(), decoder);
    return client.agreement().agreedTick() == server.tick();
  }

  private void readOwn() {
    island.readAll(server);
    Body<Entity> b = serverPlayer.body().body();
    own.setBody(
        serverPlayer.body().id(),
        serverPlayer.body().generation(),
        b.centerX(),
        b.centerY(),
        b.cos(),
        b.sin(),
        b.velocityX(),
        b.velocityY(),
        b.angularVelocity());
    own.setArchetype(serverPlayer.body().archetype().index());
    for (int i = 0; i < own.words(); i++) {
      own.setWord(i, serverPlayer.fieldValues().word(i));
    }
  }

  private void list() {
    own.near().begin(island.hash());
    for (int i = 0; i < island.count(); i++) {
      own.near().add(island.key(i));
    }
  }

  private void part(int first, int end, int total) {
    list();
    NearState near = own.near();
    RowCounts counts = new RowCounts();
    counts.set(RowKind.BODY, island.count());
    counts.set(RowKind.CONTACT, total - island.count());
    near.beginPart(0, counts, first);
    for (int i = 0; i < island.count(); i++) {
      near.tell(i);
    }
    for (int row = first; row < end; row++) {
      RowKind kind = counts.kind(row);
      Rows rows = island.rows().of(kind);
      near.addRow(rows.ints(), rows.at(kind == RowKind.BODY ? row : row - island.count()));
    }
  }
}
