package carom.lab.soak;

import carom.client.link.ConnectionPhase;
import carom.net.snapshot.EntityHistory;
import carom.net.snapshot.SnapshotDecoder;
import carom.server.room.Room;
import carom.sim.Journal;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.level.Level;
import carom.testkit.SimulatedClient;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.WeakHashMap;

/**
 * Looks for ghosts and lost bodies in the clients of one room. An entity that has been there for
 * long must be known to a client whose network has been well for long, and one that has been gone
 * for long must not be. It sees every tick, as a journal of the room's simulation. In a level that
 * is larger than a view, a client needn't have heard of all.
 */
final class EntityWatch implements Journal {
  /** Time that counts as long, ticks: the goal is 2 s after the last change. */
  private static final int LONG = 120;

  /** Smallest sides of a level that a view doesn't hold, m. */
  private static final int VIEW = 128;

  private int[] since = {};
  private int[] known = {}; // generation + 1, 0 = free
  private int match = -1;
  private int begun;
  private boolean inView;
  private SimulationHost followed;
  private final Map<SimulatedClient, Integer> wellSince = new WeakHashMap<>();

  /** Follows the match that a room plays now, from the present tick on. */
  void follow(Room room) {
    if (room.simulation() == followed) {
      return;
    }
    end();
    followed = room.simulation();
    match = room.match().number();
    Level.Bounds bounds = room.match().level().level().bounds();
    inView = bounds.maxX() - bounds.minX() <= VIEW && bounds.maxY() - bounds.minY() <= VIEW;
    begun = followed.tick();
    since = new int[0];
    known = new int[0];
    wellSince.clear();
    stepped(followed);
    followed.addJournal(this);
  }

  /** Follows nothing any more. */
  void end() {
    if (followed != null) {
      followed.removeJournal(this);
      followed = null;
    }
  }

  @Override
  public void stepping(SimulationHost s) {}

  /** Takes note of a tick, also of one that a room catches up with others in one turn. */
  @Override
  public void stepped(SimulationHost s) {
    int id = 0;
    for (int left = s.entityCount(); left > 0; id++) {
      HostEntity entity = s.entity(id);
      left -= entity == null ? 0 : 1;
      note(id, entity == null ? 0 : entity.generation() + 1, s.tick());
    }
    for (; id < known.length; id++) {
      note(id, 0, s.tick());
    }
  }

  private void note(int slot, int now, int tick) {
    if (slot >= known.length) {
      since = Arrays.copyOf(since, 2 * slot + 1);
      known = Arrays.copyOf(known, since.length);
    }
    if (known[slot] != now) {
      known[slot] = now;
      since[slot] = tick;
    }
  }

  /** Takes note that a client's network changed; for some time nothing is asked of it. */
  void disturbed(SimulatedClient client) {
    wellSince.remove(client);
  }

  /**
   * Compares what a client knows with what is there.
   *
   * @return number of entities that were compared
   */
  long check(SimulatedClient client) {
    SnapshotDecoder decoder = client.game().decoder();
    int tick = followed.tick();
    if (client.view().phase() != ConnectionPhase.PLAYING
        || client.view().matchNumber() != match
        || decoder == null
        || !decoder.hasAck()
        || client.isCutOff()
        || tick - decoder.newestTick() > LONG / 4) {
      wellSince.remove(client);
      return 0;
    }
    int well = wellSince.computeIfAbsent(client, c -> tick);
    if (tick - well < LONG || tick - begun < LONG) {
      return 0;
    }
    long compared = 0;
    for (int slot = 0; slot < known.length; slot++) {
      if (tick - since[slot] < LONG) {
        continue;
      }
      EntityHistory history = decoder.history(slot);
      boolean heard = history != null && history.size() > 0;
      if (heard ? history.outOfSight(0) : !inView) {
        continue;
      }
      int shown = heard && history.alive(0) ? history.generation(0) + 1 : 0;
      if (shown != known[slot]) {
        throw new AssertionError(
            String.format(
                Locale.ROOT,
                "%s slot=%d has generation=%d at the server since tick=%d, now %d; told: %s; %s",
                shown == 0 ? "a body is lost:" : "a ghost:",
                slot,
                known[slot] - 1,
                since[slot],
                tick,
                heard ? shown - 1 + " of tick=" + history.tick(0) : "never",
                client));
      }
      compared++;
    }
    return compared;
  }
}
