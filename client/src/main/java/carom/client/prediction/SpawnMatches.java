package carom.client.prediction;

import carom.net.snapshot.exact.NearState;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.exact.SpawnList;
import carom.net.snapshot.frame.Ownership;
import carom.sim.entity.HostEntity;
import carom.sim.spawn.Origin;
import carom.sim.spawn.OwnSpawns;

/**
 * Matches the own player's spawns with entities of the server, as far as snapshots have told. An
 * entity that the server doesn't count as near stays provisional: it is told, but has no exact
 * state. The last {@value #MOST} are kept, longer than any rollback needs them. One prediction's;
 * allocates nothing.
 */
public final class SpawnMatches implements OwnSpawns {
  /** Most matches that are kept; a power of two. */
  private static final int MOST = 128;

  private static final int MASK = MOST - 1;

  private final int playerId;
  private final int[] origins = new int[MOST];
  private final int[] keys = new int[MOST];
  private final boolean[] near = new boolean[MOST];
  private final int[] ownerships = new int[MOST];
  private int next;

  /** Origins of the entities that were predicted, a ring of the last ones. */
  private final int[] predicted = new int[MOST];

  private int nextPredicted;

  /** Creates matches of a player, none yet. */
  public SpawnMatches(int playerId) {
    this.playerId = playerId;
  }

  /** Takes in what a snapshot tells. */
  public void add(OwnState own) {
    SpawnList told = own.spawned();
    for (int i = 0; i < told.count(); i++) {
      int at = find(origins, told.origin(i));
      if (at < 0 || keys[at] != told.key(i)) {
        at = next++ & MASK;
        origins[at] = told.origin(i);
        keys[at] = told.key(i);
        near[at] = false;
        ownerships[at] = HostEntity.NO_OWNER;
      }
      near[at] |= isNear(own.near(), told.key(i));
    }
  }

  private static boolean isNear(NearState near, int key) {
    for (int i = 0; i < near.count(); i++) {
      if (near.key(i) == key) {
        return true;
      }
    }
    return false;
  }

  /** Returns the newest place of a value, or -1. */
  private int find(int[] values, int value) {
    for (int i = next - 1; i >= Math.max(0, next - MOST); i--) {
      if (values[i & MASK] == value) {
        return i & MASK;
      }
    }
    return -1;
  }

  @Override
  public boolean predicts(int player) {
    return player == playerId;
  }

  @Override
  public int key(int origin) {
    int at = find(origins, origin);
    return at >= 0 && near[at] ? keys[at] : UNKNOWN;
  }

  /** Returns the origin of an entity of the server, near or not, or {@link Origin#NONE}. */
  public int origin(int key) {
    int at = find(keys, key);
    return at < 0 ? Origin.NONE : origins[at];
  }

  /**
   * Notes the owner of a provisional entity that becomes one of the server's, or {@link
   * HostEntity#NO_OWNER}.
   */
  public void settle(int key, int owner) {
    int at = find(keys, key);
    if (at >= 0) {
      ownerships[at] = owner < 0 ? owner : owner | Ownership.NOT_BODY;
    }
  }

  /** Returns the {@link Ownership} of an entity that was a provisional one, -1 for no owner. */
  int ownership(int key) {
    int at = find(keys, key);
    return at < 0 ? HostEntity.NO_OWNER : ownerships[at];
  }

  /** Notes that an entity is predicted. */
  public void predict(int origin) {
    if (!wasPredicted(origin)) {
      predicted[nextPredicted++ & MASK] = origin;
    }
  }

  /** Returns whether an entity was predicted at some time. */
  public boolean wasPredicted(int origin) {
    for (int i = 0; i < MOST; i++) {
      if (predicted[i] == origin) {
        return true;
      }
    }
    return false;
  }
}
