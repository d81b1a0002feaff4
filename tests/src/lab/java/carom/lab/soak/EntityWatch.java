package carom.lab.soak;

import carom.client.link.ConnectionPhase;
import carom.net.snapshot.EntityHistory;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.snapshot.frame.FrameState;
import carom.server.match.MatchInfo;
import carom.sim.level.Level;
import carom.testkit.SimulatedClient;
import java.util.Locale;
import java.util.Map;
import java.util.WeakHashMap;

/**
 * Looks for ghosts and lost bodies in the clients of one room. An entity that has been there for
 * long must be known to a client whose network has been well for long, and one that has been gone
 * for long must not be. In a level that is larger than a view, a client needn't have heard of all.
 */
final class EntityWatch {
  /** Time that counts as long, ticks: the goal is 2 s after the last change. */
  private static final int LONG = 120;

  /** Smallest sides of a level that a view doesn't hold, m. */
  private static final int VIEW = 128;

  private int[] since = {};
  private int[] known = {}; // generation + 1, 0 = free
  private int match = -1;
  private int begun;
  private boolean inView;
  private FrameState newest;
  private final Map<SimulatedClient, Integer> wellSince = new WeakHashMap<>();

  /** Takes note of a tick. */
  void tick(FrameState frame, MatchInfo playing) {
    newest = frame;
    if (playing.number() != match) {
      match = playing.number();
      Level.Bounds bounds = playing.level().level().bounds();
      inView = bounds.maxX() - bounds.minX() <= VIEW && bounds.maxY() - bounds.minY() <= VIEW;
      begun = frame.tick();
      since = new int[0];
      known = new int[0];
      wellSince.clear();
    }
    if (since.length < frame.slotLimit()) {
      since = java.util.Arrays.copyOf(since, frame.slotLimit() * 2);
      known = java.util.Arrays.copyOf(known, frame.slotLimit() * 2);
    }
    for (int slot = 0; slot < known.length; slot++) {
      boolean alive = slot < frame.slotLimit() && frame.alive(slot);
      int now = alive ? frame.generation(slot) + 1 : 0;
      if (known[slot] != now) {
        known[slot] = now;
        since[slot] = frame.tick();
      }
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
    if (client.view().phase() != ConnectionPhase.PLAYING
        || client.view().matchNumber() != match
        || decoder == null
        || !decoder.hasAck()
        || client.isCutOff()
        || newest.tick() - decoder.newestTick() > LONG / 4) {
      wellSince.remove(client);
      return 0;
    }
    int well = wellSince.computeIfAbsent(client, c -> newest.tick());
    if (newest.tick() - well < LONG || newest.tick() - begun < LONG) {
      return 0;
    }
    long compared = 0;
    for (int slot = 0; slot < known.length; slot++) {
      if (newest.tick() - since[slot] < LONG) {
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
                newest.tick(),
                heard ? shown - 1 + " of tick=" + history.tick(0) : "never",
                client));
      }
      compared++;
    }
    return compared;
  }
}
