package carom.client.bots;

import java.util.HashMap;
import java.util.Map;
import java.util.TreeMap;
import org.HdrHistogram.Histogram;

/**
 * Bodies as a thin client has been told of them, with their newest poses, and figures about how
 * they came. The door's thread writes, any thread reads.
 */
public final class ThinPicture {
  private static final long MOST_MICROS = 60_000_000L;
  private static final int MOST_TICKS = 10_000;

  private final Map<Integer, Body> bodies = new HashMap<>();
  private final Histogram gaps;
  private final Histogram tickGaps;
  private final Histogram keys;
  private int player = -1;
  private int tick = -1;
  private int whole = -1;
  private int parts;
  private long snapshots;
  private long bytesIn;
  private long firstNs;
  private long lastNs;
  private long longestGapNs;
  private int ping;
  private int probe;
  private long probeNs;
  private boolean probes;
  private int errors;
  private String room = "";
  private String secret = "";
  private String standby = "";
  private ThinDoor.Goal redirect; // or null
  private boolean refused;
  private String ended;

  /**
   * A body as it was told.
   *
   * @param x centre, metres
   * @param y centre, metres
   * @param angle radians
   * @param archetype index in the match
   * @param owner player that owns it; that and 1,024 if it only belongs to that one; or -1
   */
  public record Body(float x, float y, float angle, int archetype, int owner) {}

  /**
   * A picture of one tick.
   *
   * @param bodies by their ids; owned by the caller
   */
  public record Shown(int tick, Map<Integer, Body> bodies) {}

  /** Creates an empty picture. */
  public ThinPicture() {
    gaps = new Histogram(MOST_MICROS, 2);
    tickGaps = new Histogram(MOST_TICKS, 2);
    keys = new Histogram(MOST_MICROS, 2);
  }

  /** Creates an empty picture for a client that goes on elsewhere, whose figures go on, too. */
  public ThinPicture(ThinPicture before) {
    synchronized (before) {
      gaps = before.gaps.copy();
      tickGaps = before.tickGaps.copy();
      keys = before.keys.copy();
      snapshots = before.snapshots;
      bytesIn = before.bytesIn;
      firstNs = before.firstNs;
      lastNs = before.lastNs;
      longestGapNs = before.longestGapNs;
      errors = before.errors;
      room = before.room;
      secret = before.secret;
      standby = before.standby;
    }
  }

  /** Notes the secret of the seat, as the door writes it. */
  public synchronized void welcome(String newSecret) {
    secret = newSecret;
  }

  /** Returns the secret of the seat, as the door writes it; empty for none. */
  synchronized String secret() {
    return secret;
  }

  /** Begins a match in a room: all bodies are forgotten. */
  public synchronized void match(int newPlayer, String newRoom) {
    player = newPlayer;
    room = newRoom;
    bodies.clear();
    tick = -1;
    whole = -1;
  }

  /**
   * Begins a snapshot or a part of one.
   *
   * @param of all parts of the tick
   * @param input count of the input that was used last
   * @return false if it is late, or none of a match, and must be ignored
   */
  public synchronized boolean snapshot(int newTick, int of, int input, long nowNs) {
    if (newTick < tick || player < 0) {
      return false;
    }
    if (newTick > tick) {
      parts = 0;
      snapshots++;
      if (tick >= 0) {
        tickGaps.recordValue(Math.min(MOST_TICKS, newTick - tick));
      }
      if (lastNs == 0) {
        firstNs = nowNs;
      } else {
        gaps.recordValue(Math.min(MOST_MICROS, (nowNs - lastNs) / 1_000));
        longestGapNs = Math.max(longestGapNs, nowNs - lastNs);
      }
      lastNs = nowNs;
    }
    tick = newTick;
    if (++parts == of) {
      whole = newTick;
    }
    if (probes && input - probe >= 0) {
      probes = false;
      keys.recordValue(Math.min(MOST_MICROS, (nowNs - probeNs) / 1_000));
    }
    return true;
  }

  /**
   * Notes a body of the present snapshot.
   *
   * @param archetype -1 if it and the owner are those told before
   */
  public synchronized void body(int id, float x, float y, float angle, int archetype, int owner) {
    Body old = bodies.get(id);
    if (archetype < 0 && old == null) {
      errors++; // the server must name what the client doesn't know
      return;
    }
    boolean named = archetype >= 0;
    bodies.put(
        id,
        new Body(x, y, angle, named ? archetype : old.archetype(), named ? owner : old.owner()));
  }

  /** Notes that a body is gone. */
  public synchronized void gone(int id) {
    bodies.remove(id);
  }

  /** Notes bytes of payload that came. */
  public synchronized void bytes(long count) {
    bytesIn += count;
  }

  /** Notes the round trip as the server has measured it, ms. */
  public synchronized void ping(int ms) {
    ping = ms;
  }

  /** Notes that an input with another control is sent, to see when a snapshot has used it. */
  public synchronized void press(int count, long nowNs) {
    if (!probes) {
      probe = count;
      probeNs = nowNs;
      probes = true;
    }
  }

  /** Notes what couldn't be read. */
  public synchronized void error() {
    errors++;
  }

  /** Notes that the server sends the player to another one, with the seat. */
  public synchronized void redirect(String server, String there, String token) {
    redirect = new ThinDoor.Goal(server, there, secret, token);
  }

  /** Notes where the room goes on if this server is lost; empty for nowhere. */
  public synchronized void standby(String server) {
    standby = server;
  }

  /** Notes that the server lets the player play no longer, and why. */
  public synchronized void refuse(String reason) {
    refused = true;
    end(reason);
  }

  /** Returns whether the server lets the player play no longer. */
  public synchronized boolean isRefused() {
    return refused;
  }

  /** Notes why it is over; the first reason counts. */
  public synchronized void end(String reason) {
    if (ended == null) {
      ended = reason;
    }
  }

  /** Returns the newest snapshot with all bodies, or null if a part of it is missing. */
  public synchronized Shown shown() {
    return whole == tick && tick >= 0 ? new Shown(tick, new TreeMap<>(bodies)) : null;
  }

  /** Returns the own player's id, or -1 before a match. */
  public synchronized int player() {
    return player;
  }

  /** Returns the tick of the newest snapshot of which all parts are here, or -1. */
  public synchronized int wholeTick() {
    return whole;
  }

  /** Returns the number of snapshots. */
  public synchronized long snapshots() {
    return snapshots;
  }

  /** Returns the payload bytes that came. */
  public synchronized long bytesIn() {
    return bytesIn;
  }

  /** Returns the time from the first snapshot to the last, seconds. */
  public synchronized double seconds() {
    return (lastNs - firstNs) / 1e9;
  }

  /** Returns the time between two snapshots that 99 % stay below, ms. */
  public synchronized double gapP99Ms() {
    return gaps.getValueAtPercentile(99) / 1e3;
  }

  /** Returns the ticks between two snapshots of which 99 % have no more. */
  public synchronized long gapP99Ticks() {
    return tickGaps.getValueAtPercentile(99);
  }

  /** Returns the longest time between two snapshots, and since the last one, ms. */
  public synchronized double longestGapMs(long nowNs) {
    return (lastNs == 0 ? 0 : Math.max(longestGapNs, ended == null ? nowNs - lastNs : 0)) / 1e6;
  }

  /** Returns the median time from an input to the first snapshot that has used it, ms. */
  public synchronized double keyP50Ms() {
    return keys.getValueAtPercentile(50) / 1e3;
  }

  /** Returns the round trip as the server has told it last, ms. */
  public synchronized int pingMs() {
    return ping;
  }

  /** Returns how many messages couldn't be read or made no sense. */
  public synchronized int errors() {
    return errors;
  }

  /** Returns where the server has sent the player, or null. */
  public synchronized ThinDoor.Goal redirect() {
    return redirect;
  }

  /**
   * Returns where the player's seat is if the connection is lost, or null if there is none.
   *
   * @param server the one that is lost
   */
  public synchronized ThinDoor.Goal seat(String server) {
    return secret.isEmpty()
        ? null
        : new ThinDoor.Goal(standby.isEmpty() ? server : standby, room, secret, "");
  }

  /** Returns why it is over, or null. */
  public synchronized String ended() {
    return ended;
  }
}
