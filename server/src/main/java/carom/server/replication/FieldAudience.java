package carom.server.replication;

import carom.net.field.FieldTables;
import carom.net.snapshot.SnapshotEncoder;
import carom.net.snapshot.frame.SlotSet;
import carom.net.snapshot.table.JointWords;
import carom.net.snapshot.table.RowAudience;
import carom.net.snapshot.table.TableOutbox;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;

/**
 * Decides what one player's client may know of joints, and of the fields of others. It goes by each
 * field's audience, by what the client sees, the player's team, and what the player owns. A player
 * that sees all knows all but what stays on the server.
 *
 * <p>The room's thread; no allocation but to grow.
 */
final class FieldAudience implements RowAudience {
  /** Ticks between two looks at which players' bodies are in sight. */
  private static final int LOOK_TICKS = 4;

  private final SimulationHost simulation;
  private final FieldCapture fields;
  private final RowAudience joints;
  private final HostPlayer player;
  private final int chunks;
  private SnapshotEncoder encoder;

  /** The players whose bodies were in sight at the last look. */
  private final SlotSet near = new SlotSet();

  private int teamChanges = -1;
  private boolean sawAll;

  FieldAudience(FrameCapture capture, RowAudience joints, HostPlayer player) {
    simulation = capture.index().simulation();
    fields = capture.fields();
    this.joints = joints;
    this.player = player;
    chunks = capture.tables().get(FieldTables.PLAYERS).layout().chunks();
  }

  /** Sets the encoder, which knows what the client sees. */
  void of(SnapshotEncoder newEncoder) {
    encoder = newEncoder;
  }

  /** Tells the outbox what may have changed; once before each snapshot. */
  void update(int tick) {
    TableOutbox outbox = encoder.tables();
    boolean seesAll = seesAll();
    if (teamChanges != fields.teamChanges() || sawAll != seesAll) {
      teamChanges = fields.teamChanges();
      sawAll = seesAll;
      outbox.audienceChanged();
    }
    if ((tick + player.id()) % LOOK_TICKS != 0) {
      return;
    }
    int capacity = simulation.playerCapacity();
    near.ensure(capacity);
    for (int id = 0; id < capacity; id++) {
      boolean sees = seesBody(simulation.player(id));
      if (sees != near.has(id)) {
        if (sees) {
          near.add(id);
        } else {
          near.remove(id);
        }
        for (int key = id * chunks; key < (id + 1) * chunks; key++) {
          outbox.audienceChanged(FieldTables.PLAYERS, key >> 6, 1L << key);
        }
      }
    }
  }

  private boolean seesBody(HostPlayer other) {
    HostEntity body = other == null ? null : other.entity();
    return body != null && (encoder.inSight(body.id() >> 6) >>> body.id() & 1) != 0;
  }

  private boolean seesAll() {
    return simulation.game().seesAll(simulation, player);
  }

  @Override
  public long inSight(int table, int block, long keys) {
    return switch (table) {
      case JointWords.TABLE -> joints.inSight(table, block, keys);
      case FieldTables.ENTITIES -> keys & encoder.inSight(block);
      default -> keys;
    };
  }

  @Override
  public int of(int table, int key) {
    return switch (table) {
      case JointWords.TABLE -> joints.of(table, key);
      case FieldTables.PLAYERS -> ofPlayer(simulation.player(key / chunks));
      case FieldTables.ENTITIES -> ofEntity(simulation.entity(key));
      default -> FieldTables.audience(true, true, true);
    };
  }

  private int ofPlayer(HostPlayer other) {
    if (other == null || other == player) {
      return NOBODY;
    }
    boolean all = sawAll;
    return FieldTables.audience(
        all || near.has(other.id()), all || other.team() == player.team(), all);
  }

  private int ofEntity(HostEntity entity) {
    if (entity == null) {
      return NOBODY;
    }
    HostPlayer owner = entity.owner();
    boolean team = owner != null && owner.team() == player.team();
    return FieldTables.audience(true, sawAll || team, sawAll || owner == player);
  }
}
