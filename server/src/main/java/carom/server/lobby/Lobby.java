package carom.server.lobby;

import carom.net.admission.Entrance;
import carom.net.admission.Origin;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.Limits;
import carom.net.protocol.PlayerName;
import carom.net.protocol.Protocol;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.SessionState;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import carom.net.transport.ServerTransport;
import carom.server.access.BadTokenException;
import carom.server.access.EntryRule;
import carom.server.access.JoinToken;
import carom.server.access.JoinTokens;
import carom.server.config.ServerConfig;
import carom.server.match.LevelUpload;
import carom.server.match.MatchInfo;
import carom.server.recording.ShownRecordings;
import carom.server.room.Room;
import carom.server.room.RoomDirectory;
import carom.server.schedule.TickLoad;
import carom.server.session.Admission;
import carom.server.session.PartingLinks;
import carom.server.session.Seats;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
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
 *
 * <p><b>Length.</b> Just above 500 lines, because a visitor's steps share the lobby's state.
 */
public final class Lobby {
  private static final Logger LOG = LoggerFactory.getLogger(Lobby.class);
  private static final long NS_PER_MS = 1_000_000;
  private static final long PARTING_MS = 1_000;
  private static final int MAX_POLL = 32;
  private static final int FIRST_EPOCH = 0;

  /** Time after which a visitor of a full server asks for a seat again, ms. */
  private static final long ASK_AGAIN_MS = 400;

  /** Time for which a visitor waits for a seat before the lobby refuses it, ms. */
  private static final long ENTRANCE_WAIT_MS = 2_500;

  /**
   * Number of seats that visitors of one host may hold while they load the level, or half of the
   * free seats if that is more.
   */
  private static final int MIN_LOADING = 8;

  private static final int MAX_ACCEPT = 32;

  /** Number of times that a visitor may ask for the list of rooms. */
  private static final int MAX_LISTS = 8;

  private final ServerConfig config;
  private final ServerTransport transport;
  private final RoomChooser chooser;
  private final RoomDirectory directory;
  private final int places;
  private final List<Visitor> visitors = new ArrayList<>();
  private final Entrance<Visitor> entrance;
  private final PartingLinks partings = new PartingLinks(Limits.MAX_PLAYERS);
  private final AdmissionRate rate;
  private final Spectators spectators;
  private volatile EntryRule entryRule = EntryRule.OPEN;

  /** Where the next turn sends those who wait or watch; null for nowhere. */
  private final AtomicReference<ServerMessage.Redirect> redirect = new AtomicReference<>();

  private long nowNs;

  /**
   * Creates a lobby in front of rooms.
   *
   * @param config settings of the server
   * @param transport accepts links
   * @param rooms at least one
   * @param directory the same rooms, for visitors who look for one
   */
  public Lobby(
      ServerConfig config, ServerTransport transport, List<Room> rooms, RoomDirectory directory) {
    this.directory = directory;
    this.config = config;
    this.transport = transport;
    this.chooser =
        new RoomChooser(
            rooms, config.maxLoadPercent(), TickLoad.ticksUntilKnown(config.tickRateHz()));
    this.spectators = new Spectators(rooms);
    this.places = rooms.stream().mapToInt(room -> room.seats().count()).sum();
    this.entrance = new Entrance<>(placesToWait(places), placesToWait(places), Visitor::giveWay);
    this.rate = new AdmissionRate(places);
  }

  private static int placesToWait(int places) {
    return places + 32;
  }

  /**
   * Returns the largest number of links that may be open for a server with so many places: those
   * that play or load, those that wait, those that watch, and those that are told goodbye.
   */
  public static int mostLinks(int places) {
    return 2 * places + 2 * placesToWait(places) + Spectators.MAX;
  }

  /**
   * Does one turn: accepts new links, reads the messages of visitors and checks deadlines.
   *
   * @param timeNs monotonic time in nanoseconds
   * @return the amount of work done; 0 when nothing was due
   */
  public int doWork(long timeNs) {
    nowNs = timeNs;
    sendAway();
    int work = partings.doWork(timeNs) + spectators.doWork(timeNs);
    for (int i = 0; i < MAX_ACCEPT; i++) {
      Link link = transport.accept();
      if (link == null) {
        break;
      }
      work++;
      Visitor visitor = new Visitor(link);
      visitors.add(visitor);
      entrance.add(visitor);
    }
    for (int i = visitors.size() - 1; i >= 0; i--) {
      Visitor visitor = visitors.get(i);
      try {
        visitor.tryToEnter();
        work += visitor.poll();
        visitor.checkDeadline();
      } catch (RuntimeException e) {
        LOG.error("a handshake failed; only this link is closed", e);
        visitor.giveUpSeat();
        visitor.done = true;
        partings.add(visitor.link, "server error", timeNs);
      }
      if (visitor.done) {
        visitors.remove(i);
        entrance.remove(visitor);
      }
    }
    if (work > 0) {
      entrance.sort();
    }
    return work;
  }

  /**
   * Refuses all visitors and all links that the transport still accepts.
   *
   * @param timeNs monotonic time in nanoseconds
   */
  public void close(long timeNs) {
    nowNs = timeNs;
    sendAway();
    spectators.close(timeNs);
    for (Visitor visitor : visitors) {
      if (visitor.done) {
        continue; // sent to another server
      }
      if (visitor.state == SessionState.LOADING) {
        // After Welcome a client expects a Goodbye, not a Refused. The player sees the same.
        visitor.link.send(new ServerMessage.Goodbye(GoodbyeReason.SERVER_STOPPING, ""));
        closeLater(visitor.link, "server stops");
      } else {
        sendRefusal(visitor.link, RefusalReason.SHUTTING_DOWN, "");
      }
      visitor.giveUpSeat();
    }
    visitors.clear();
    for (Link link; (link = transport.accept()) != null; ) {
      sendRefusal(link, RefusalReason.SHUTTING_DOWN, "");
    }
  }

  /**
   * Sends all who wait for a place, load the level or watch to another server, in the lobby's next
   * turn or when it closes. Those who haven't said yet what they want stay. Any thread.
   */
  public void redirect(ServerMessage.Redirect to) {
    redirect.set(to);
  }

  private void sendAway() {
    ServerMessage.Redirect to = redirect.getAndSet(null);
    if (to == null) {
      return;
    }
    spectators.redirect(to, nowNs);
    for (Visitor visitor : visitors) {
      if (!visitor.done && (visitor.waiting != null || visitor.state == SessionState.LOADING)) {
        visitor.redirect(to);
      }
    }
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

  /** Sets who may come in, for players and spectators; any thread. */
  public void admit(EntryRule rule) {
    entryRule = rule;
  }

  /**
   * Lets spectators in from now on.
   *
   * @param recordings one for each room, in the order of the rooms
   * @param delaySeconds age at which spectators see what happens, s
   */
  public void allowSpectators(List<ShownRecordings> recordings, int delaySeconds) {
    spectators.allow(recordings, delaySeconds);
  }

  /** Returns the number of links that wait to play. */
  public int visitorCount() {
    return visitors.size();
  }

  private void sendRefusal(Link link, RefusalReason reason, String text) {
    LOG.info("refused: {}, {}{}", link.remote(), reason, text.isEmpty() ? "" : ", " + text);
    link.send(new ServerMessage.Refused(reason, text));
    closeLater(link, "refused: " + reason);
  }

  private void closeLater(Link link, String why) {
    partings.add(link, why, nowNs + PARTING_MS * NS_PER_MS);
  }

  /** Returns the number of a room's seats that are kept for visitors other than one. */
  private int countPromised(Room room, Visitor except) {
    int count = 0;
    for (int i = 0; i < visitors.size(); i++) {
      Visitor v = visitors.get(i);
      count += v != except && !v.done && v.waiting != null && v.promised == room ? 1 : 0;
    }
    return count;
  }

  /** Returns the number of visitors of a host that hold a seat and still load the level. */
  private int countLoading(String host) {
    int count = 0;
    for (int i = 0; i < visitors.size(); i++) {
      Visitor v = visitors.get(i);
      count += !v.done && v.state == SessionState.LOADING && v.origin.host().equals(host) ? 1 : 0;
    }
    return count;
  }

  /**
   * Returns the visitor that must give up its seat when seats are short, or null. It is the oldest
   * visitor of the host that holds the most seats while loading, at least two. The newcomer's host
   * is exempt.
   *
   * @param requested the room whose seats are short, or null for all
   */
  private Visitor oldestOfBusiestHost(String newcomer, Room requested) {
    Visitor oldest = null;
    int most = 1;
    for (int i = 0; i < visitors.size(); i++) {
      Visitor v = visitors.get(i);
      if (!v.done
          && v.state == SessionState.LOADING
          && (requested == null || v.room == requested)
          && !v.origin.host().equals(newcomer)) {
        int held = countLoading(v.origin.host());
        if (held > most) { // the list is in order of arrival
          most = held;
          oldest = v;
        }
      }
    }
    return oldest;
  }

  /** What a player wants, and its account by a join token. */
  private record JoinRequest(
      String name, String account, String room, String game, long resumeSecret) {}

  /** A link from its first message to its room. */
  private final class Visitor implements LinkHandler, Entrance.Guest {
    private final Link link;
    private SessionState state = SessionState.CONNECTED;
    private long deadlineNs;
    private Room room;
    private Seats.Seat seat;
    private final Origin origin;
    private JoinRequest waiting;
    private int lists;
    private long waitsUntilNs;
    private long askAgainNs;

    /** The room whose seat is kept for this visitor, as another player gives it up, or null. */
    private Room promised;

    private MatchInfo match;
    private LevelUpload upload;
    private boolean done;

    Visitor(Link link) {
      this.link = link;
      this.origin = Origin.ofRemote(link.remote());
      this.deadlineNs = nowNs + config.handshakeTimeoutMs() * NS_PER_MS;
      this.askAgainNs = nowNs;
    }

    @Override
    public Origin origin() {
      return origin;
    }

    /**
     * Returns the stage; a visitor with a seat and one that asks for it never displace each other.
     */
    @Override
    public Entrance.Stage stage() {
      if (done || state == SessionState.LOADING) {
        return Entrance.Stage.IN;
      }
      return waiting == null ? Entrance.Stage.UNPROVEN : Entrance.Stage.PROVEN;
    }

    private void giveWay() {
      refuse(RefusalReason.TOO_MANY_CONNECTIONS, "Others wait to play.");
    }

    /**
     * Reads messages one by one. Messages behind Hello wait until it is answered, and messages
     * behind Ready are for the room.
     */
    int poll() {
      int work = 0;
      while (!done && waiting == null && work < MAX_POLL && link.poll(this, 1) > 0) {
        work++;
      }
      return work;
    }

    @Override
    public void message(Link from, Object message) {
      if (state == SessionState.CONNECTED && message instanceof ClientMessage.Hello hello) {
        hello(hello);
      } else if (state == SessionState.CONNECTED && message instanceof ClientMessage.Watch watch) {
        watch(watch);
      } else if (message instanceof ClientMessage.ListRooms list) {
        list(list);
      } else if (state == SessionState.LOADING
          && message instanceof ClientMessage.LevelRequest request) {
        String problem = upload.answer(request, link);
        if (problem != null) {
          refuse(RefusalReason.BAD_REQUEST, problem);
        }
      } else if (state == SessionState.LOADING && message instanceof ClientMessage.Ready ready) {
        if (!upload.isFinishedBy(ready)) {
          refuse(RefusalReason.BAD_REQUEST, "Ready has the key of another Welcome.");
        } else if (ready.declarationsDigest() == match.declarations().digest()) {
          enterRoom();
        } else {
          refuse(
              RefusalReason.GAME_VERSION, "The fields of your game " + match.game() + " differ.");
        }
      } else if (message instanceof ClientMessage.Leave) {
        end("left before playing");
      } else {
        String name = message == null ? "nothing" : message.getClass().getSimpleName();
        refuse(RefusalReason.BAD_REQUEST, name + " came while " + state + ".");
      }
    }

    @Override
    public void datagram(Link from, byte[] bytes, int length) {
      // A datagram means nothing before the player has a body.
    }

    @Override
    public void closed(Link from, String reason) {
      if (!done) {
        end(reason);
      }
    }

    private void watch(ClientMessage.Watch watch) {
      if (!requireThisBuild(watch.protocolVersion(), watch.physicsDigest())
          || !requireEntry(null, "")) {
        return;
      }
      ServerMessage.Refused refusal = spectators.add(link, watch.room(), nowNs);
      if (refusal != null) {
        refuse(refusal.reason(), refusal.text());
      }
      done = true;
    }

    private void list(ClientMessage.ListRooms list) {
      if (!requireProtocol(list.protocolVersion())) {
        return;
      }
      lists++;
      if (lists > MAX_LISTS) {
        refuse(RefusalReason.BAD_REQUEST, "The list of rooms was requested again and again.");
        return;
      }
      directory.list(nowNs).forEach(link::send);
    }

    /** Refuses a client of another protocol, and returns whether the client may go on. */
    private boolean requireProtocol(int protocolVersion) {
      if (protocolVersion != Protocol.VERSION) {
        refuse(
            RefusalReason.PROTOCOL_VERSION,
            "This server speaks protocol %d, your game %d."
                .formatted(Protocol.VERSION, protocolVersion));
        return false;
      }
      return true;
    }

    /** Refuses a client of another build, and returns whether the client may go on. */
    private boolean requireThisBuild(int protocolVersion, long physicsDigest) {
      if (!requireProtocol(protocolVersion)) {
        return false;
      }
      if (physicsDigest != Protocol.physicsDigest()) {
        refuse(
            RefusalReason.PHYSICS_VERSION,
            "This server computes with %s.".formatted(Protocol.PHYSICS_VERSION));
        return false;
      }
      return true;
    }

    /** Refuses a client that the operator doesn't let in, and returns whether it may go on. */
    private boolean requireEntry(String name, String account) {
      EntryRule.Refusal refusal = entryRule.refusal(name, account, link.remote());
      if (refusal != null) {
        refuse(refusal.reason(), refusal.text());
      }
      return refusal == null;
    }

    private void hello(ClientMessage.Hello hello) {
      if (!requireThisBuild(hello.protocolVersion(), hello.physicsDigest())) {
        return;
      }
      JoinRequest request = requestOf(hello);
      if (request == null) {
        return;
      }
      String problem = PlayerName.problem(request.name());
      if (problem != null) {
        refuse(RefusalReason.NAME_INVALID, "Sorry, " + problem + ".");
        return;
      }
      if (!requireEntry(request.name(), request.account())) {
        return;
      }
      waiting = request;
      waitsUntilNs = nowNs + ENTRANCE_WAIT_MS * NS_PER_MS;
      tryToEnter();
    }

    /**
     * Returns what the player wants and may want by its join token, or refuses and returns null. A
     * player who comes back proves by the session's secret that the token was good, and keeps the
     * account.
     */
    private JoinRequest requestOf(ClientMessage.Hello hello) {
      String name = hello.name().strip();
      JoinTokens joinTokens = entryRule.tokens();
      Room expecting = chooser.expecting(hello.resumeSecret());
      if (joinTokens == null || expecting != null) {
        String account = expecting == null ? "" : expecting.seats().accountOf(hello.resumeSecret());
        return new JoinRequest(name, account, hello.room(), hello.game(), hello.resumeSecret());
      }
      try {
        JoinToken token = joinTokens.check(hello.token());
        return new JoinRequest(
            token.name().isEmpty() ? name : token.name(),
            token.account(),
            token.room().isEmpty() ? hello.room() : token.room(),
            hello.game(),
            0);
      } catch (BadTokenException e) {
        refuse(RefusalReason.TOKEN_INVALID, e.getMessage());
        return null;
      }
    }

    /**
     * Gives a visitor that has sent Hello a seat as soon as it may have one. A visitor waits while
     * its host joins too often or holds too many seats without playing, and while a full room gives
     * up the seat of a player who lost the connection.
     */
    void tryToEnter() {
      if (done || waiting == null) {
        return;
      }
      if (link.state() == Link.State.CLOSED) {
        end("left while waiting");
        return;
      }
      Room expecting = chooser.expecting(waiting.resumeSecret());
      Room requested = waiting.room().isEmpty() ? null : directory.find(waiting.room());
      if (expecting == null && requested == null && !waiting.room().isEmpty()) {
        refuse(RefusalReason.ROOM_UNKNOWN, directory.describe());
        return;
      }
      String overload = expecting == null ? chooser.overload(requested) : null;
      if (overload != null) {
        refuse(RefusalReason.OVERLOADED, overload);
        return;
      }
      boolean allowed = rate.allows(origin.host(), nowNs);
      boolean full = false;
      if (allowed && expecting != null) {
        room = expecting;
        seat = room.seats().claim(waiting.resumeSecret(), origin, nowNs);
      } else if (allowed) {
        full = !takeSeat(requested) && chooser.seatsLeft(requested) == 0 && !askForSeat(requested);
      }
      boolean late = nowNs - waitsUntilNs >= 0;
      if (seat != null) {
        rate.count(origin.host(), nowNs);
        waiting = null;
        welcome();
      } else if (full || (allowed && chooser.seatsLeft(requested) == 0 && late)) {
        refuseFull(requested);
      } else if (late) {
        refuse(RefusalReason.TOO_MANY_CONNECTIONS, "");
      }
    }

    private void refuseFull(Room requested) {
      int count = requested == null ? places : requested.seats().count();
      String text =
          (count == 1 ? "The only place is taken." : "All %d places are taken.").formatted(count);
      refuse(
          requested == null ? RefusalReason.SERVER_FULL : RefusalReason.ROOM_FULL,
          requested == null ? text : text + " " + directory.describe());
    }

    /**
     * Takes a seat in the requested room, or the fullest that has one; returns whether it got one.
     */
    private boolean takeSeat(Room requested) {
      Room chosen = requested == null ? chooser.fullestWithSeat(waiting.game()) : requested;
      if (chosen != null
          && chooser.seatsLeft(chosen) > countPromised(chosen, this)
          && countLoading(origin.host()) < Math.max(MIN_LOADING, chooser.seatsLeft(null) / 2)) {
        room = chosen;
        seat = room.seats().take(waiting.name(), waiting.account(), origin);
      }
      return seat != null;
    }

    /**
     * Asks a room to give up a seat that nobody plays in or that a network holds beyond its share,
     * or else the busiest other host to give up one where the level still loads. Returns false if
     * nobody gives way.
     */
    private boolean askForSeat(Room requested) {
      if (nowNs - askAgainNs < 0) {
        return true; // the seat asked for is soon free
      }
      promised = chooser.askToGiveWay(waiting.account(), origin, requested);
      boolean asked = promised != null;
      Visitor crowding = asked ? null : oldestOfBusiestHost(origin.host(), requested);
      if (crowding != null) {
        asked = true;
        crowding.refuse(RefusalReason.TOO_SLOW, "Others wait for the place.");
      }
      askAgainNs = asked ? nowNs + ASK_AGAIN_MS * NS_PER_MS : nowNs;
      return asked;
    }

    private void welcome() {
      match = room.match();
      upload = new LevelUpload(match.level(), FIRST_EPOCH);
      deadlineNs = nowNs + config.loadTimeoutMs() * NS_PER_MS;
      state = state.become(SessionState.LOADING);
      link.send(
          match.welcome(
              seat.secret(),
              seat.id(),
              FIRST_EPOCH,
              config.tickRateHz(),
              room.tick(),
              room.seats().incarnation(),
              seat.courseTick()));
    }

    private void enterRoom() {
      done = true;
      if (!room.admit(new Admission(seat, link, FIRST_EPOCH, match.number()))) {
        LOG.warn("{} could not enter: too many enter at once, or the room failed", seat.name());
        link.send(new ServerMessage.Goodbye(GoodbyeReason.SERVER_ERROR, "Try again in a moment."));
        closeLater(link, "room takes nobody");
        giveUpSeat();
      }
    }

    private void checkDeadline() {
      if (!done && waiting == null && nowNs - deadlineNs >= 0) {
        refuse(
            RefusalReason.TOO_SLOW,
            state == SessionState.CONNECTED
                ? "No greeting came within %d ms.".formatted(config.handshakeTimeoutMs())
                : "The level was not loaded within %d ms.".formatted(config.loadTimeoutMs()));
      }
    }

    private void refuse(RefusalReason reason, String text) {
      done = true;
      sendRefusal(link, reason, text);
      giveUpSeat();
    }

    private void redirect(ServerMessage.Redirect to) {
      done = true;
      LOG.info("visitor {} goes to {}", link.remote(), to.server());
      link.send(to);
      closeLater(link, "sent to " + to.server());
      giveUpSeat();
    }

    private void end(String why) {
      done = true;
      LOG.debug("visitor {} gone: {}", link.remote(), why);
      link.close(why);
      giveUpSeat();
    }

    private void giveUpSeat() {
      if (seat != null) {
        room.seats().unclaim(seat);
        seat = null;
      }
    }
  }
}
