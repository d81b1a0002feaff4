package carom.testkit;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.InputSource;
import carom.client.stats.NetStats;
import carom.client.view.ClientView;
import carom.net.kryo.KryoMessageCodec;
import carom.net.snapshot.EntityHistory;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.transport.ClientTransport;
import carom.net.transport.ImpairedClientTransport;
import carom.net.transport.ImpairedLink;
import carom.net.transport.Impairment;
import carom.net.transport.Link;
import carom.server.room.Room;
import java.util.List;
import java.util.Locale;
import java.util.function.LongSupplier;

/**
 * A client of a {@link Stepper}: a real {@link GameClient} behind its own simulated network, played
 * by a script. After each update the class compares every newly decoded state with the server's
 * frame states; they must be equal.
 */
public final class SimulatedClient {
  /**
   * Number of ticks before the newest one that each check covers again. Datagrams that overtake
   * each other insert states behind the newest.
   */
  private static final int RECHECKED_TICKS = 32;

  private final String name;
  private final GameClient client;
  private final Impairment impairment;
  private InputSource script;
  private final OutageTransport line;
  private ImpairedLink link;
  private boolean udpBlocked;
  private boolean frozen;
  private boolean dead;
  private long blackoutEndNs;

  private SnapshotDecoder checkedDecoder;
  private int checkedTick;
  private int checkedSequence;
  private long checkedBits;
  private long compared;
  private long unverified;

  SimulatedClient(
      ClientConfig config,
      ClientTransport transport,
      Impairment impairment,
      InputSource script,
      LongSupplier clock) {
    this.name = config.get(ClientConfig.NAME);
    this.impairment = impairment;
    this.script = script;
    line = new OutageTransport(transport);
    ImpairedClientTransport impaired =
        new ImpairedClientTransport(line, impairment, new KryoMessageCodec(), clock);
    ClientTransport remembering =
        new ClientTransport() {
          @Override
          public Link connect(String host, int tcpPort, int udpPort) {
            link = impaired.connect(host, tcpPort, udpPort);
            link.blockUdp(udpBlocked);
            return link;
          }

          @Override
          public void close() {}
        };
    client =
        new GameClient(
            config, remembering, (view, tick, out) -> this.script.sample(view, tick, out), () -> 0);
  }

  // ---- driven by the stepper

  void update(long nowNs, List<Room> rooms) {
    if (line.isDead() && nowNs - blackoutEndNs >= 0) {
      line.dead(false);
    }
    if (frozen || dead) {
      return;
    }
    client.update(nowNs);
    check(rooms == null ? null : truth(rooms));
  }

  /**
   * Returns the frames of the match that the client plays, or null while the room plays another, or
   * the client hasn't heard that its server crashed.
   */
  private FrameRing truth(List<Room> rooms) {
    for (Room room : rooms) {
      if (room.name().equals(client.view().room())) {
        boolean same =
            room.match().number() == client.view().matchNumber()
                && room.seats().incarnation() == client.incarnation();
        return same ? room.frames() : null;
      }
    }
    return null;
  }

  private void check(FrameRing truth) {
    SnapshotDecoder decoder = client.decoder();
    if (decoder == null || !decoder.hasAck() || truth == null) {
      return;
    }
    if (decoder != checkedDecoder) {
      checkedDecoder = decoder;
      checkedTick = 0;
    } else if (decoder.ackSequence() == checkedSequence && decoder.ackBits() == checkedBits) {
      return;
    }
    checkedSequence = decoder.ackSequence();
    checkedBits = decoder.ackBits();
    int from = checkedTick - RECHECKED_TICKS;
    for (int slot = 0; slot < decoder.slotLimit(); slot++) {
      EntityHistory history = decoder.history(slot);
      for (int i = 0; history != null && i < history.size() && history.tick(i) > from; i++) {
        FrameState frame = truth.at(history.tick(i));
        if (history.outOfSight(i)) {
          continue; // an entry out of sight holds no state of the entity
        }
        if (frame == null) {
          unverified++;
        } else {
          requireEqual(frame, slot, history, i);
          compared++;
        }
      }
    }
    checkedTick = decoder.newestTick();
  }

  private void requireEqual(FrameState frame, int slot, EntityHistory history, int i) {
    boolean equal =
        frame.alive(slot) == history.alive(i)
            && (!frame.alive(slot)
                || (frame.generation(slot) == history.generation(i)
                    && frame.archetype(slot) == history.archetype(i)
                    && frame.ownership(slot) == history.ownership(i)
                    && frame.x(slot) == history.x(i)
                    && frame.y(slot) == history.y(i)
                    && frame.angle(slot) == history.angle(i)
                    && frame.still(slot) == history.still(i)));
    if (!equal) {
      throw new AssertionError(
          String.format(
              Locale.ROOT,
              "%s decoded another state than the server had: slot=%d tick=%d client=%s server=%s"
                  + " %s",
              name,
              slot,
              history.tick(i),
              history.alive(i) ? "(" + history.x(i) + ", " + history.y(i) + ")" : "gone",
              frame.alive(slot) ? "(" + frame.x(slot) + ", " + frame.y(slot) + ")" : "gone",
              impairment));
    }
  }

  /**
   * Requires that the newest known state of each slot equals a frame of the server. This holds in a
   * world at rest, and in a moving one over a perfect network.
   */
  public void requireSame(FrameState frame) {
    SnapshotDecoder decoder = client.decoder();
    int limit = Math.max(frame.slotLimit(), decoder.slotLimit());
    for (int slot = 0; slot < limit; slot++) {
      EntityHistory history = decoder.history(slot);
      boolean known = history != null && history.size() > 0;
      if (known && history.outOfSight(0)) {
        continue;
      }
      if (known) {
        requireEqual(frame, slot, history, 0);
      } else if (frame.alive(slot)) {
        throw new AssertionError(
            name + " never heard of slot=" + slot + " tick=" + frame.tick() + " " + impairment);
      }
    }
  }

  // ---- what may happen to a player

  /** Replaces the script. */
  public void play(InputSource next) {
    script = next;
  }

  /** Changes both directions of the network. */
  public void impair(Impairment next) {
    link.impair(next, next);
  }

  /** Changes the two directions of the network separately. */
  public void impair(Impairment up, Impairment down) {
    link.impair(up, down);
  }

  /** Blocks UDP, so that TCP carries the datagrams of this link and later ones, or lets it pass. */
  public void blockUdp(boolean blocked) {
    udpBlocked = blocked;
    if (link != null) {
      link.blockUdp(blocked);
    }
  }

  /** Lets nothing through in either direction until a moment of virtual time. */
  void blackout(long endNs) {
    blackoutEndNs = endNs;
    line.dead(true);
  }

  /**
   * Stops the client's process, or lets it go on. A stopped client sends, reads and closes nothing.
   */
  public void freeze(boolean stopped) {
    frozen = stopped;
  }

  /** Breaks the connection. The client notices and may come back. */
  public void cut() {
    link.close("the line was cut");
  }

  /**
   * Kills the client's process, as by {@code kill -9}. The system closes its sockets, and the
   * client says no goodbye.
   */
  public void kill() {
    dead = true;
    link.close("the process died");
  }

  /** Leaves as a player who closes the window does. */
  public void leave() {
    client.close();
  }

  // ---- what can be seen

  /** Returns the requested name. The server may have added a number. */
  public String name() {
    return name;
  }

  /** Returns the client. */
  public GameClient game() {
    return client;
  }

  /** Returns what the player sees. */
  public ClientView view() {
    return client.view();
  }

  /** Returns whether the client has opened a link, and its process lives. */
  public boolean isConnected() {
    return link != null && !dead;
  }

  /** Returns whether its process stands still, or the network lets nothing through. */
  public boolean isCutOff() {
    return frozen || dead || line.isDead();
  }

  /** Returns figures about the connection. */
  public NetStats stats() {
    return client.stats();
  }

  /** Returns how often the own body was put right since the client was created. */
  public long corrections() {
    return stats().corrections();
  }

  /** Returns the share of predictions of awake bodies that were right in every bit, percent. */
  public double rightPercent() {
    return 100 * stats().perfectRate();
  }

  /** Returns the number of states compared with the server's; all were equal. */
  public long compared() {
    return compared;
  }

  /** Returns the number of states that came after the server had forgotten their tick. */
  public long unverified() {
    return unverified;
  }

  @Override
  public String toString() {
    return name + " " + view().phase() + " \"" + view().message() + "\" " + impairment;
  }
}
