package carom.server.session;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.SessionState;
import carom.net.snapshot.frame.WaitingInputs;
import carom.net.transport.Broadcast;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.server.metrics.Counters;
import carom.server.replication.SessionReplication;
import carom.server.thin.ThinLink;
import carom.sim.entity.HostPlayer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The protocol's state of one player in a room: the state of the session, and its link while there
 * is one.
 *
 * <p>A session lives from the first Ready until the player leaves or the grace period ends. A
 * resumed session keeps this object and gets a new link. When the room begins another match, the
 * session gets another player and loads again over the same link.
 *
 * <p>Data flows one way. What arrives goes to the part that owns the subject, and each part does
 * one thing:
 *
 * <pre>
 *               ┌─► MatchLoading        while the client loads a match
 *               ├─► RoomRequests        other rooms
 *   Link ─poll──┼─► SessionMessages     messages of the game ─┐
 *               ├─► SessionInputs       one input per tick ───┴─► Simulation ─► frame ─┐
 *               ├─► DivergenceReports   mispredictions                                 │
 *               └─► SessionReplication  acknowledgements ──────────► snapshot ◄────────┘──► Link
 * </pre>
 *
 * <p>What a client sends can change this object only: a wrong message asks the room to expel the
 * session; a wrong datagram is counted and ignored, because anybody can forge a datagram.
 *
 * <p>Owned by the room's thread. Polling and sending in the steady state allocate nothing.
 */
public final class Session implements LinkHandler {
  /** Most messages and datagrams taken from one link per poll; the rest waits for the next. */
  public static final int MAX_POLL = 64;

  private static final Logger LOG = LoggerFactory.getLogger(Session.class);
  private static final long NS_PER_MS = 1_000_000;

  private final Seats.Seat seat;
  private HostPlayer player;
  private final ServerConfig config;
  private final Counters counters;
  private SessionReplication replication;
  private SessionMessages messages;
  private final SessionInputs inputs;
  private final MatchLoading loading = new MatchLoading();
  private final RoomRequests roomRequests = new RoomRequests();
  private final Departure departure = new Departure();
  private SessionState state = SessionState.LOADING;
  private volatile Link link;
  private ThinLink thin; // the link, if the client is a thin one
  private int epoch;
  private boolean bot;
  private String shownName;
  private final DivergenceReports reports;
  private long nowNs;
  private int silentTicks;
  private ServerMessage.Pace toldPace = ServerMessage.Pace.FULL;
  private long graceEndNs;
  private int playedTicks;
  private boolean knowsRoster;
  private ServerMessage.Fleet toldFleet;

  /**
   * Creates a session without a link, in {@link SessionState#LOADING}; {@link #attach} and {@link
   * #play} let it play.
   *
   * @param player the player in the room's simulation
   * @param replication tells the player's client about the room
   * @param messages the game's, between the player and the room
   */
  public Session(
      Seats.Seat seat,
      HostPlayer player,
      ServerConfig config,
      SessionReplication replication,
      SessionMessages messages,
      Counters counters) {
    this.seat = seat;
    shownName = seat.name();
    this.player = player;
    this.config = config;
    this.replication = replication;
    this.messages = messages;
    this.counters = counters;
    this.reports = new DivergenceReports(this, counters);
    this.inputs = new SessionInputs(config, counters);
  }

  /**
   * Gives the session a link; {@link #play} or {@link #load} must follow.
   *
   * @param newLink its inbox belongs to this session from now on
   * @param lastEpoch that of the link's last Welcome
   * @param toBot whether the link is a bot's
   */
  public void attach(Link newLink, int lastEpoch, boolean toBot) {
    link = newLink;
    bot = toBot;
    shownName = toBot ? seat.nameOfBot() : seat.name();
    thin = newLink instanceof ThinLink thinLink ? thinLink : null;
    epoch = lastEpoch;
    departure.begin();
  }

  /**
   * Lets a session play whose client has loaded the match; allowed while loading and in grace.
   *
   * @param tick the room's last tick: inputs for later ones are welcome
   */
  public void play(int tick) {
    state = state.become(SessionState.PLAYING);
    loading.end();
    playedTicks = 0;
    replication.begin(epoch, link);
    messages.attach(link, epoch);
    inputs.begin(tick);
    silentTicks = 0;
    toldPace = ServerMessage.Pace.FULL;
    knowsRoster = false;
    toldFleet = null;
    seat.follows();
  }

  /**
   * Goes on in another match of the room. What a client without a link would have heard of the last
   * one is forgotten.
   *
   * @param newPlayer the player in the match's simulation
   * @param newReplication tells the player's client about the match
   * @param newMessages of the match's game; those of the last one that wait are forgotten
   */
  public void enter(
      HostPlayer newPlayer, SessionReplication newReplication, SessionMessages newMessages) {
    replication.end();
    messages = newMessages;
    player = newPlayer;
    replication = newReplication;
  }

  /**
   * Makes the client load the match. Until it {@linkplain #hasLoaded has}, the player's input is
   * neutral.
   *
   * @param upload sends the level
   * @param welcome tells the client
   */
  public void load(LevelUpload upload, ServerMessage.Welcome welcome) {
    if (state != SessionState.LOADING) {
      state = state.become(SessionState.LOADING);
    }
    epoch = welcome.epoch();
    loading.begin(upload, welcome);
    send(welcome);
  }

  /** Returns whether the client has loaded the match, so that the session may {@link #play}. */
  public boolean hasLoaded() {
    return state == SessionState.LOADING && loading.isDone();
  }

  /** Returns the epoch of the link's last Welcome. */
  public int epoch() {
    return epoch;
  }

  /**
   * Takes the link away and begins the grace period; the player's input turns neutral. The link of
   * a bot that stands in for a player leaves the player's grace period as it is.
   *
   * @return the link, now the caller's
   */
  public Link detach(long timeNs) {
    state = state.become(SessionState.GRACE);
    messages.detach();
    if (!bot) {
      graceEndNs = timeNs + config.graceMs() * NS_PER_MS;
    }
    bot = false;
    Link old = link;
    link = null;
    player.input().clear();
    return old;
  }

  /**
   * Goes on with a session of an earlier run of the room, without a link: its grace period begins,
   * and it notes the events that the player would hear of.
   *
   * @param newGraceEndNs when the grace period is over
   */
  public void await(long newGraceEndNs) {
    state = state.become(SessionState.GRACE);
    graceEndNs = newGraceEndNs;
    replication.begin(0, null);
  }

  /** Sets when the grace period ends, such as now for a player who has gone on to another room. */
  public void endGrace(long newGraceEndNs) {
    graceEndNs = newGraceEndNs;
  }

  /** Ends the session; returns its link, or null when it had none. */
  public Link end() {
    state = state.become(SessionState.CLOSED);
    Link old = link;
    link = null;
    replication.end();
    return old;
  }

  /** Closes the link, if there is one; from any thread. */
  public void closeLink(String why) {
    Link present = link;
    if (present != null) {
      present.close(why);
    }
  }

  /** Takes what has arrived, at most {@link #MAX_POLL} messages and datagrams. */
  public int poll(long timeNs) {
    nowNs = timeNs;
    int work = link.poll(this, MAX_POLL);
    if (work == 0 && !departure.isLinkLost() && link.state() == Link.State.CLOSED) {
      closed(link, link.closeReason()); // while it changed hands, the lobby was told
    }
    return work;
  }

  @Override
  public void message(Link from, Object message) {
    if (from != link) {
      return;
    }
    silentTicks = 0;
    if (message instanceof ClientMessage.Leave) {
      departure.leave();
    } else if (message instanceof ClientMessage.ListRooms) {
      roomRequests.askForList();
    } else if (message instanceof ClientMessage.ListBest) {
      roomRequests.askForBest();
    } else if (message instanceof ClientMessage.ListLevels) {
      roomRequests.askForLevels();
    } else if (message instanceof ClientMessage.ChooseLevel choice) {
      roomRequests.choose(choice.name());
    } else if (message instanceof ClientMessage.ChangeRoom change) {
      roomRequests.goTo(change.room());
    } else if (state == SessionState.LOADING) {
      String offence = loading.receive(message, link);
      if (offence != null) {
        departure.expel(offence);
      }
    } else if (message instanceof ClientMessage.Look look) {
      replication.look(look);
    } else if (message instanceof ClientMessage.Diverged report) {
      reports.receive(report, replication, nowNs);
    } else if (message instanceof ClientMessage.Heard heard) {
      messages.heard(heard);
    } else if (message instanceof ClientMessage.PoolRequest request
        && replication.answer(request, link)) {
      return;
    } else if (message instanceof ClientMessage.GameMessage m && messages.receive(m)) {
      return;
    } else if (!(message instanceof ClientMessage.Ready)) {
      departure.expel(Offence.of(message, state));
    }
  }

  @Override
  public void datagram(Link from, byte[] bytes, int length) {
    if (from != link || state != SessionState.PLAYING) {
      return;
    }
    counters.add(Counter.BYTES_IN, length);
    boolean taken = true;
    if (messages.isOne(bytes, length)) {
      messages.receive(bytes, length);
    } else if (inputs.receive(bytes, length, epoch, nowNs - from.waitedNs(), replication)) {
      silentTicks = 0;
    } else {
      taken = false;
    }
    counters.add(taken ? Counter.DATAGRAMS_IN : Counter.DATAGRAMS_REFUSED, 1);
  }

  @Override
  public void closed(Link from, String reason) {
    if (from == link) {
      departure.loseLink(reason);
    }
  }

  /** Sets the player's input for a tick, which must be the one after the last consumed. */
  public void consumeInput(int tick) {
    roomRequests.tick();
    playedTicks++;
    if (state == SessionState.PLAYING) {
      silentTicks++;
      reports.tick(inputs.buffer().newestTick(), replication, nowNs);
      if (thin == null) {
        inputs.consume(tick, player);
      } else {
        silentTicks = thin.takeHeard() ? 0 : silentTicks;
        inputs.consumeNewest(thin.takeInput(), player);
        counters.add(Counter.BYTES_IN, thin.takeBytesIn());
      }
      return;
    }
    player.input().clear();
    player.viewDelay(0);
    if (state == SessionState.LOADING) {
      loading.tick();
    }
  }

  /**
   * Tells the client at which pace time passes and whether views are narrow, if it plays and
   * doesn't know.
   */
  public void tellPace(int percent, boolean viewsNarrow) {
    boolean known = percent == toldPace.percent() && viewsNarrow == toldPace.viewsNarrow();
    if (!known && state == SessionState.PLAYING) {
      toldPace = new ServerMessage.Pace(percent, viewsNarrow);
      send(new Broadcast(toldPace));
    }
  }

  /** Adds the inputs that wait for the next ticks, which clients of players near are told. */
  public void showWaiting(WaitingInputs to) {
    inputs.showWaiting(player.id(), to);
  }

  /** Prepares a snapshot of the newest frame; call once per tick while playing. */
  public void prepareSnapshot() {
    replication.prepareSnapshot(
        inputs.buffer().lastConsumedTick(), inputs.wasInTime(), inputs.areLate());
  }

  /** Sends the snapshot that was prepared, over the session's link. */
  public void sendSnapshot(long timeNs) {
    replication.sendSnapshot(link, inputs.feedback(timeNs));
  }

  /**
   * Sends a message when there is a link.
   *
   * @return false when there is none or it doesn't take the message
   */
  public boolean send(ServerMessage message) {
    return link != null && link.send(message);
  }

  /** Sends a message that many sessions share, as {@link #send(ServerMessage)} does. */
  public boolean send(Broadcast message) {
    return link != null && link.send(message);
  }

  /** Hands the messages of the player to the next tick, but for commands. */
  public void deliverMessages(ChatCommands commands) {
    messages.deliver(this, commands);
  }

  /** Sends the messages of the game that are queued, when there is a link. */
  public void sendMessages() {
    if (state == SessionState.PLAYING) {
      messages.flush(link);
    }
  }

  /** Returns the messages of the game between the player and the room. */
  public SessionMessages messages() {
    return messages;
  }

  /** Sends the last message if the link still takes one; the session ends either way. */
  public void sayGoodbye(GoodbyeReason reason, String text) {
    try {
      send(new ServerMessage.Goodbye(reason, text));
    } catch (RuntimeException e) {
      LOG.debug("no goodbye for {}", this, e);
    }
  }

  /** Returns whether a client of Carom plays, which can stand by at a server; from any thread. */
  public boolean mayStandBy() {
    Link present = link;
    return !bot
        && present != null
        && present.door() == Link.Door.OWN
        && present.state() == Link.State.OPEN;
  }

  /** Returns the door by which the client has come; the own one without a link. */
  public Link.Door door() {
    return link == null ? Link.Door.OWN : link.door();
  }

  /**
   * Tells the client the other servers of the fleet, if they have changed.
   *
   * @param fleet null for none
   */
  @SuppressWarnings("ReferenceEquality") // another message is made when something has changed
  public void tellFleet(ServerMessage.Fleet fleet) {
    if (fleet != toldFleet && state == SessionState.PLAYING) {
      toldFleet = fleet;
      send(fleet);
    }
  }

  /** Returns whether this link got the whole roster; from then on changes are enough. */
  public boolean knowsRoster() {
    return knowsRoster;
  }

  /** Notes that this link got the whole roster. */
  public void toldRoster() {
    knowsRoster = true;
  }

  /** Returns the place in the room: id, name, secret. */
  public Seats.Seat seat() {
    return seat;
  }

  /** Returns whether a bot plays over the present link. */
  public boolean isBot() {
    return bot;
  }

  /** Returns whether a bot plays for a player who may come back until the grace period is over. */
  public boolean isStandIn() {
    return bot && !seat.isBots();
  }

  /** Returns the name that others read: with a mark while a bot plays in a player's place. */
  public String shownName() {
    return shownName;
  }

  /** Returns the secret by which the client may come back; 0 for a bot, which may not. */
  public long secret() {
    return bot ? 0 : seat.secret();
  }

  /** Returns the player in the room's simulation. */
  public HostPlayer player() {
    return player;
  }

  /** Returns the present state: loading, playing, in grace or closed. */
  public SessionState state() {
    return state;
  }

  /** Returns why the session should end or lose its link, if it should. */
  public Departure departure() {
    return departure;
  }

  /**
   * Returns when the grace period is over; meaningful in {@link SessionState#GRACE}, and for a
   * stand-in.
   */
  public long graceEndNs() {
    return graceEndNs;
  }

  /** Returns how many ticks the player has played since its input last changed. */
  public int idleTicks() {
    return inputs.idleTicks();
  }

  /**
   * Returns whether nothing was heard for longer than the configured silence. Silence is counted in
   * ticks of the room: while the server itself stood still no client could be heard.
   */
  public boolean isSilent() {
    return silentTicks * 1_000L
        > (long) config.get(ServerConfig.SILENCE_TIMEOUT_MS) * config.get(ServerConfig.TICK_RATE);
  }

  /** Returns whether the client takes longer to load the match than it may. */
  public boolean isTooSlow() {
    return state == SessionState.LOADING
        && loading.ticks() * 1_000L
            > (long) config.get(ServerConfig.LOAD_TIMEOUT_MS) * config.get(ServerConfig.TICK_RATE);
  }

  /** Returns whether the grace period is over; meaningful in grace. */
  public boolean graceIsOver(long timeNs) {
    return timeNs - graceEndNs >= 0;
  }

  /** Returns the peer for log lines. */
  public String remote() {
    return link == null ? "no link" : link.remote();
  }

  /** Returns what tells the client about the room. */
  public SessionReplication replication() {
    return replication;
  }

  /**
   * Takes the client's request for the list of rooms, if there is one. Requests in between are one.
   *
   * @param ticks number of ticks that must have passed after the last answer
   * @return whether there is one
   */
  public boolean takeRoomsRequest(int ticks) {
    return roomRequests.takeListRequest(ticks);
  }

  /** Takes the client's request for the best lists, as {@link #takeRoomsRequest} does. */
  public boolean takeBestRequest(int ticks) {
    return roomRequests.takeBestRequest(ticks);
  }

  /** Takes the request for the levels of players, as {@link #takeRoomsRequest} does. */
  public boolean takeLevelsRequest(int ticks) {
    return roomRequests.takeLevelsRequest(ticks);
  }

  /** Takes the level of a player that the client has chosen since, empty for none; or null. */
  public String takeChoice() {
    return roomRequests.takeChoice();
  }

  /** Returns the answer that is under way to the player: a list of rooms or levels, or the best. */
  public PacedMessages answer() {
    return roomRequests.answer();
  }

  /** Returns the name of the room that the player wants to go to, or null. */
  public String requestedRoom() {
    return roomRequests.room();
  }

  /** Forgets the room that the player wanted to go to. */
  public void clearRequestedRoom() {
    roomRequests.clearRoom();
  }

  /** Returns the number of ticks for which the session plays; meaningful while it does. */
  public int playedTicks() {
    return playedTicks;
  }

  /** Returns the client's first misprediction that nothing explained, in words, or null. */
  public String firstUnexplained() {
    return reports.firstUnexplained();
  }

  /** Returns the input buffer, for inspection. */
  public InputBuffer inputs() {
    return inputs.buffer();
  }

  @Override
  public String toString() {
    return "player=" + seat.id() + " name=\"" + seat.name() + "\" state=" + state;
  }
}
