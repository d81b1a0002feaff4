package carom.server.checkpoint;

import carom.net.protocol.ProtocolLimits;
import carom.net.snapshot.frame.EventRecord;
import carom.net.snapshot.frame.EventRing;
import carom.physics.archive.Archive;
import carom.server.session.Session;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The events of a room that some of its players may not have heard of, as of a checkpoint. What
 * happens after it, the logged inputs make happen again.
 */
final class SavedEvents {
  private static final int WORDS = 10;
  private static final int LEAST = Integer.MIN_VALUE;
  private static final int MOST = Integer.MAX_VALUE;
  private static final int MAX_KIND = 255;

  /** Ten numbers for each event: those of a record, and the audience. */
  private final int[] words;

  /** Places of the events that a player lacks, by the secret of the player's seat. */
  private final Map<Long, int[]> lacked = new HashMap<>();

  private SavedEvents(int[] words) {
    this.words = words;
  }

  /** Copies the events that the clients of some sessions may lack; null stands for no session. */
  static SavedEvents of(EventRing ring, Session[] bySeat) {
    Map<Long, List<Long>> numbers = new HashMap<>();
    long[] first = {ring.limit()};
    for (Session session : bySeat) {
      if (session != null) {
        List<Long> own = new ArrayList<>();
        session.replication().forEachUnacknowledged(own::add);
        numbers.put(session.seat().secret(), own);
        first[0] = own.isEmpty() ? first[0] : Math.min(first[0], own.get(0));
      }
    }
    int[] words = new int[WORDS * (int) (ring.limit() - first[0])];
    for (long number = first[0]; number < ring.limit(); number++) {
      put(ring.at(number), ring.audience(number), words, WORDS * (int) (number - first[0]));
    }
    SavedEvents events = new SavedEvents(words);
    numbers.forEach(
        (secret, own) ->
            events.lacked.put(secret, own.stream().mapToInt(n -> (int) (n - first[0])).toArray()));
    return events;
  }

  private static void put(EventRecord e, int audience, int[] to, int at) {
    int[] record = {
      e.kind, e.tick, e.player, e.first, e.second, e.x, e.y, e.strength, e.data, audience
    };
    System.arraycopy(record, 0, to, at, WORDS);
  }

  /** Passes the events of a room; null when reading. */
  static SavedEvents pass(Archive a, SavedEvents events) {
    int[] words = a.reads() ? null : events.words;
    int count = a.count("events", a.reads() ? 0 : words.length / WORDS, EventRing.SIZE, 4 * WORDS);
    words = a.reads() ? new int[WORDS * count] : words;
    a.integers("event", words, WORDS * count, LEAST, MOST);
    for (int at = 0; at < words.length; at += WORDS) {
      int tick = words[at + 1];
      int player = words[at + 2];
      a.require(words[at] >= 0 && words[at] <= MAX_KIND, "an event of kind=" + words[at]);
      a.require(tick >= (at == 0 ? 0 : words[at + 1 - WORDS]), "an event of tick=" + tick);
      a.require(
          player >= EventRecord.NONE && player < ProtocolLimits.MAX_PLAYERS, "player=" + player);
    }
    return a.reads() ? new SavedEvents(words) : events;
  }

  int count() {
    return words.length / WORDS;
  }

  /** Returns the places of the events that the player of a seat lacks. */
  int[] lackedBy(long secret) {
    return lacked.getOrDefault(secret, new int[0]);
  }

  /** Adds the events to an empty ring, so that their places are their numbers. */
  void restore(EventRing ring) {
    EventRecord e = new EventRecord();
    for (int at = 0; at < words.length; at += WORDS) {
      e.kind = words[at];
      e.tick = words[at + 1];
      e.player = words[at + 2];
      e.first = words[at + 3];
      e.second = words[at + 4];
      e.x = words[at + 5];
      e.y = words[at + 6];
      e.strength = words[at + 7];
      e.data = words[at + 8];
      ring.add(e, words[at + 9]);
    }
  }
}
