package carom.server.lobby;

import carom.net.admission.Entrance;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.net.transport.ServerTransport;
import carom.server.access.EntryRule;
import carom.server.access.GamePassword;
import carom.server.config.ServerConfig;
import carom.server.recording.ShownRecordings;
import carom.server.room.Room;
import carom.server.room.RoomDirectory;
import carom.server.session.PartingLinks;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Function;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Takes links from the handshake to their room. The lobby welcomes or refuses a link, chooses the
 * room and sends the level. Each phase has a deadline, so a half-open connection or a client that
 * stalls holds its slot only for seconds.
 *
 * <p>A player who returns with a session's secret goes to the room that holds the session. A player
 * who names a room goes there. Any other player goes to the fullest room that still has a seat,
 * because players want company: one that plays the requested game, if there is one; among equals,
 * the first. If there is no seat, the lobby refuses the newcomer. Rooms that have failed count as
 * full.
 *
 * <p>One thread calls {@link #doWork}. It need not be a room's thread.
 */
public final class Lobby {
  private static final Logger LOG = LoggerFactory.getLogger(Lobby.class);
  private static final int MAX_ACCEPT = 32;

  /** Places to wait for links in plain text, which displace nobody else. */
  private static final int PLAIN_PLACES = 32;

  private final ServerTransport transport;
  private final LobbyContext context;
  private final List<Visitor> visitors;
  private final Entrance<Visitor> entrance;

  private final Entrance<Visitor> plainEntrance =
      new Entrance<>(PLAIN_PLACES, PLAIN_PLACES, Visitor::giveWay);

  private final PartingLinks partings;
  private final Spectators spectators;

  /** Server to which the next turn sends those who wait or watch; null for none. */
  private final AtomicReference<ServerMessage.Redirect> redirect = new AtomicReference<>();

  private volatile Runnable wake = () -> {};

  /**
   * Creates a lobby in front of rooms.
   *
   * @param config returns the present settings of the server
   * @param transport accepts links
   * @param rooms the live list, at least one
   * @param directory the same rooms, for visitors who look for one
   */
  public Lobby(
      Supplier<ServerConfig> config,
      ServerTransport transport,
      List<Room> rooms,
      RoomDirectory directory) {
    this.transport = transport;
    context = new LobbyContext(config, rooms, directory);
    visitors = context.visitors();
    partings = context.partings();
    spectators = context.spectators();
    int toWait = placesToWait(context.places());
    entrance = new Entrance<>(toWait, toWait, Visitor::giveWay);
  }

  private Entrance<Visitor> entranceOf(Visitor visitor) {
    return visitor.isPlainText() ? plainEntrance : entrance;
  }

  private static int placesToWait(int places) {
    return places + 32;
  }

  /**
   * Returns the largest number of links that may be open for a server with so many places. These
   * are links that play and as many that leave, that wait with a proof and without, that watch and
   * as many that leave, and those that the lobby tells goodbye.
   */
  public static int mostLinks(int places) {
    return 2 * (places + placesToWait(places) + Spectators.MAX) + LobbyContext.MAX_PARTINGS;
  }

  /** Returns the largest number of links of one address for a server with so many places. */
  public static int mostLinksOfAddress(int places) {
    return placesToWait(places); // a whole school may be behind one router
  }

  /**
   * Does one turn: accepts new links, reads the messages of visitors and checks deadlines.
   *
   * @param timeNs monotonic time in nanoseconds
   * @return the amount of work done; 0 when nothing was due
   */
  public int doWork(long timeNs) {
    context.passTo(timeNs);
    sendAway();
    int work = partings.doWork(timeNs) + spectators.doWork(timeNs);
    for (int i = 0; i < MAX_ACCEPT; i++) {
      Link link = transport.accept();
      if (link == null) {
        break;
      }
      work++;
      Visitor visitor = new Visitor(context, link);
      visitors.add(visitor);
      entranceOf(visitor).add(visitor);
    }
    for (int i = visitors.size() - 1; i >= 0; i--) {
      Visitor visitor = visitors.get(i);
      try {
        visitor.tryToEnter();
        work += visitor.poll();
        visitor.checkDeadline();
      } catch (RuntimeException e) {
        LOG.error("a handshake failed; only this link is closed", e);
        visitor.fail();
      }
      if (visitor.isDone()) {
        visitors.remove(i);
        entranceOf(visitor).remove(visitor);
      }
    }
    context.tellLookers();
    if (work > 0) {
      entrance.sort();
      plainEntrance.sort();
    }
    return work;
  }

  /**
   * Refuses all visitors and all links that the transport still accepts.
   *
   * @param timeNs monotonic time in nanoseconds
   */
  public void close(long timeNs) {
    context.passTo(timeNs);
    sendAway();
    spectators.close(timeNs);
    visitors.forEach(Visitor::turnAway);
    visitors.clear();
    for (Link link; (link = transport.accept()) != null; ) {
      context.sendRefusal(link, RefusalReason.SHUTTING_DOWN, "");
    }
  }

  /**
   * Sends all who wait for a place, load the level or watch to another server, in the lobby's next
   * turn or when it closes. Those who haven't said yet what they want stay. Any thread.
   */
  public void redirect(ServerMessage.Redirect to) {
    redirect.set(to);
    wake.run();
  }

  /**
   * Sets what tells the lobby's thread that it is needed; before the first turn.
   *
   * @param newWake runs on any thread and returns at once
   */
  public void onNeeded(Runnable newWake) {
    wake = newWake;
  }

  private void sendAway() {
    ServerMessage.Redirect to = redirect.getAndSet(null);
    if (to == null) {
      return;
    }
    spectators.redirect(to, context.nowNs());
    visitors.forEach(visitor -> visitor.redirect(to));
  }

  /** Returns whether the lobby has no open link, not even a refused one that isn't closed yet. */
  public boolean isDeserted() {
    return visitors.isEmpty() && partings.isEmpty() && spectators.isDeserted();
  }

  /** Closes the links that are still open after {@link #close}. */
  public void closeLinks() {
    partings.closeAll();
    spectators.closeLinks();
  }

  /** Sets the password that players and spectators must know from now on; any thread. */
  public void demand(GamePassword password) {
    context.demand(password);
  }

  /** Sets who may come in, for players and spectators; any thread. */
  public void admit(EntryRule rule) {
    context.admit(rule);
  }

  /**
   * Lets spectators in from now on.
   *
   * @param recordings finds those of a room by its name
   * @param delaySeconds age at which spectators see what happens, s
   */
  public void allowSpectators(Function<String, ShownRecordings> recordings, int delaySeconds) {
    spectators.allow(recordings, delaySeconds);
  }

  /** Returns the number of links that wait to play. */
  public int visitorCount() {
    return visitors.size();
  }
}
