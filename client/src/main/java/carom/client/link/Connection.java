package carom.client.link;

import carom.client.stats.NetStatsRecorder;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.Protocol;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.ServerMessage;
import carom.net.seal.PlayerKey;
import carom.net.transport.ClientTransport;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;

/**
 * Connects to a server and comes back after a loss. It opens the link, says hello, downloads the
 * level, notices a dead line, and resumes the session with its secret. It knows nothing of ticks
 * and worlds. One client's; one thread.
 *
 * <pre>
 * WAITING ─► CONNECTING ─► JOINING ─► LOADING ─► PLAYING
 *    ▲            │            │          │         │        refused, kicked, left: ENDED
 *    └────────────┴────────────┴──────────┴─────────┘        lost: back to WAITING, if wanted
 * </pre>
 */
public final class Connection implements LinkHandler {
  private enum Stage {
    IDLE,
    WAITING,
    CONNECTING,
    JOINING,
    LOADING,
    PLAYING,
    ENDED
  }

  private static final long MS = 1_000_000L;

  /** Longest time in which a link opens; links have deadlines of their own for each step. */
  private static final long CONNECT_TIMEOUT_NS = 120_000 * MS;

  private static final long JOIN_TIMEOUT_NS = 10_000 * MS;
  private static final long LOAD_SILENCE_NS = 15_000 * MS;

  /** Silence after which a link counts as lost. Client and server survive gaps of 5 s. */
  private static final long PLAY_SILENCE_NS = 6_000 * MS;

  private static final int MAX_POLL = 2_048;

  /** Stands for a question that the server has put off, so that the answer's time says nothing. */
  private static final long NEVER = Long.MIN_VALUE;

  private ServerAddress address;
  private final String playerName;
  private final String game;
  private final String party;
  private String token;
  private final PlayerKey key;

  /** Stands in for the token at the server to which the present one has moved the client. */
  private String ticket = "";

  private final String password;
  private final boolean reconnects;
  private final ClientTransport transport;
  private final ConnectionListener listener;
  private final NetStatsRecorder stats;
  private final LinkTraffic traffic;
  private final ReconnectTimer comeback = new ReconnectTimer();
  private final Redirects redirects = new Redirects();
  private final FleetRoute fleet;
  private final LevelDownload download = new LevelDownload();

  private Stage stage = Stage.IDLE;
  private String message = "";

  /** Why the latest attempt to come back failed; empty if there was none. */
  private String latest = "";

  private Link link;
  private long nowNs;
  private long stageSinceNs;
  private long lastHeardNs;
  private long askedNs;
  private long roundTripNs;
  private boolean retryUseful;

  private ServerMessage.Welcome welcome;
  private long secret;

  /** The session that a lost link should bring back, 0 for none. */
  private long lostSecret;

  /** Room where the player wants to be after a lost link, if the session is over then. */
  private String room;

  /**
   * Creates a connection that opens its link at the first {@link #update}.
   *
   * @param address of the server
   * @param playerName the player's name
   * @param room name of the requested room, empty for any
   * @param game name of the requested game, empty for any
   * @param party name of the player's party, empty for none
   * @param token join token, empty for none
   * @param key the player's own, which is shown without a token; null for none
   * @param password the server's, empty for none
   * @param reconnects whether to come back after a link was lost
   */
  public Connection(
      ServerAddress address,
      String playerName,
      String room,
      String game,
      String party,
      String token,
      PlayerKey key,
      String password,
      boolean reconnects,
      ClientTransport transport,
      ConnectionListener listener,
      NetStatsRecorder stats) {
    this.address = address;
    this.playerName = playerName;
    this.room = room;
    this.game = game;
    this.party = party;
    this.token = token;
    this.key = key;
    this.password = password;
    this.reconnects = reconnects;
    this.transport = transport;
    this.listener = listener;
    this.stats = stats;
    this.traffic = new LinkTraffic(stats);
    this.fleet = new FleetRoute(transport);
  }

  /** Takes in what has arrived and does what is due. */
  public void update(long nowNs) {
    this.nowNs = nowNs;
    if (stage != Stage.ENDED && welcome != null && fleet.poll(nowNs, secret, welcome.room())) {
      followRoom();
    }
    switch (stage) {
      case IDLE -> open();
      case WAITING -> {
        if (comeback.isOver(nowNs)) {
          end(comeback.isComingBack() ? explained() + " " + notBack() : message);
        } else if (comeback.isDue(nowNs)) {
          open();
        }
      }
      case CONNECTING, JOINING, LOADING, PLAYING -> {
        poll();
        if (link != null) {
          progress();
        }
      }
      case ENDED -> {}
    }
  }

  private void open() {
    retryUseful = false;
    comeback.attempt();
    enter(Stage.CONNECTING);
    if (!comeback.isRunning()) {
      latest = "";
      message = "Connecting to " + address + " ...";
    }
    traffic.begin();
    link = transport.connect(address.host(), address.tcpPort(), address.udpPort());
    listener.playPage(address.host(), null);
    progress();
  }

  /** Returns the join token, or what proves the player's own key on this link. */
  private String tokenOrProof() {
    byte[] binding = link.binding();
    return token.isEmpty() && key != null && binding != null ? key.proof(binding) : token;
  }

  /** Checks for an open link and for deadlines. */
  private void progress() {
    long waited = nowNs - stageSinceNs;
    switch (stage) {
      case CONNECTING -> {
        if (link.state() == Link.State.OPEN) {
          enter(Stage.JOINING);
          askedNs = nowNs;
          lastHeardNs = nowNs;
          if (!password.isEmpty()) {
            link.send(new ClientMessage.Password(password));
          }
          link.send(
              new ClientMessage.Hello(
                  Protocol.VERSION,
                  Protocol.physicsDigest(),
                  playerName,
                  secret,
                  room.isEmpty() && welcome != null && fleet.count() > 0 ? welcome.room() : room,
                  game,
                  party,
                  ticket.isEmpty() ? tokenOrProof() : ticket));
          ticket = "";
        } else if (link.state() == Link.State.CLOSED) {
          poll(); // delivers the reason
        } else if (waited > CONNECT_TIMEOUT_NS) {
          failPassing("No answer from " + address + ". Check the address; is the server running?");
        }
      }
      case JOINING -> {
        if (waited > JOIN_TIMEOUT_NS) {
          fail(address + " accepts connections but says nothing. Is it a Carom server?");
        }
      }
      case LOADING -> {
        if (nowNs - lastHeardNs > LOAD_SILENCE_NS) {
          fail("The level stopped arriving from " + address + ".");
        }
      }
      case PLAYING -> {
        if (nowNs - lastHeardNs > PLAY_SILENCE_NS) {
          fail("The connection to " + address + " was lost.");
        }
      }
      default -> {}
    }
  }

  private void poll() {
    Link polled = link;
    polled.poll(this, MAX_POLL);
    traffic.count(polled);
  }

  @Override
  public void message(Link from, Object received) {
    if (from != link) {
      return; // an old link's last words
    }
    lastHeardNs = nowNs;
    if (received instanceof ServerMessage.Welcome w
        && (stage == Stage.JOINING || stage == Stage.LOADING || stage == Stage.PLAYING)) {
      welcomed(w);
    } else if (received instanceof ServerMessage.LevelChunk chunk && stage == Stage.LOADING) {
      chunk(chunk);
    } else if (received instanceof ServerMessage.Refused refused && stage != Stage.PLAYING) {
      refused(refused);
    } else if (received instanceof ServerMessage.Goodbye goodbye) {
      goodbye(goodbye);
    } else if (received instanceof ServerMessage.Redirect redirect) {
      redirected(redirect);
    } else if (received instanceof ServerMessage.Move move) {
      moved(move);
    } else if (received instanceof ServerMessage.Fleet servers) {
      fleet.told(servers, address);
    } else if (received instanceof ServerMessage.Roster roster) {
      listener.roster(roster);
    } else if (received instanceof ServerMessage.RoomList rooms) {
      listener.rooms(rooms);
    } else if (received instanceof ServerMessage.BestLists lists) {
      listener.best(lists);
    } else if (received instanceof ServerMessage.LevelList levels) {
      listener.levels(levels);
    } else if (received instanceof ServerMessage.Notice notice && stage == Stage.JOINING) {
      waits(notice.text());
    } else if (received instanceof ServerMessage.Notice notice) {
      listener.notice(notice.text());
    } else if (received instanceof ServerMessage.PlayPage page) {
      listener.playPage(address.host(), page);
    } else if (received instanceof ServerMessage.Pace pace && stage == Stage.PLAYING) {
      listener.pace(pace);
    } else if (received instanceof ServerMessage.GameMessage m && stage == Stage.PLAYING) {
      listener.message(m);
    } else if (received instanceof ServerMessage.PoolChunk chunk && stage == Stage.PLAYING) {
      listener.pools(chunk);
    } else if (received instanceof ServerMessage.Heard heard && stage == Stage.PLAYING) {
      listener.heard(heard);
    } else {
      fail("The server at " + address + " sent something unexpected: " + nameOf(received));
    }
  }

  @Override
  public void datagram(Link from, byte[] bytes, int length) {
    if (from == link && stage == Stage.PLAYING) {
      lastHeardNs = nowNs;
      listener.datagram(bytes, length, nowNs - from.waitedNs());
    }
  }

  @Override
  public void closed(Link from, String reason) {
    if (from == link) {
      traffic.count(from);
      link = null;
      retryUseful = true;
      if (stage == Stage.PLAYING) {
        lost(sentence("The connection to " + address + " was lost: " + reason), true);
      } else {
        lost(sentence("Can't reach the server: " + reason), from.mayPass());
      }
    }
  }

  /** Goes on waiting for a place: the server is there and says why it isn't time yet. */
  private void waits(String why) {
    stageSinceNs = nowNs;
    askedNs = NEVER;
    message = why;
  }

  /**
   * Takes what to load: at the beginning, whenever the room goes on with another match, and when
   * the player changes the room.
   */
  private void welcomed(ServerMessage.Welcome w) {
    if (stage == Stage.JOINING && askedNs != NEVER) {
      measureRoundTrip();
    }
    stop();
    if (!LevelDownload.accepts(w)
        || w.tickRate() < ProtocolLimits.MIN_TICK_RATE
        || w.tickRate() > ProtocolLimits.MAX_TICK_RATE) {
      fail("The server's welcome makes no sense: " + w);
      return;
    }
    if (fleet.isStale(w)) {
      failPassing("The server at " + address + " owns the room no longer.");
      return;
    }
    fleet.note(w);
    if (welcome != null && !comeback.isRunning() && !welcome.room().equals(w.room())) {
      room = w.room(); // the player has chosen it
    }
    welcome = w;
    secret = w.sessionSecret();
    enter(Stage.LOADING);
    if (download.begin(w)) {
      ready();
      return;
    }
    if (!comeback.isRunning()) {
      message = "Loading " + w.levelName() + " ...";
    }
    requestLevel();
  }

  private void requestLevel() {
    if (download.request(link)) {
      askedNs = nowNs;
    }
  }

  private void chunk(ServerMessage.LevelChunk chunk) {
    switch (download.add(chunk)) {
      case LOADING -> requestLevel();
      case DONE -> ready();
      case DAMAGED -> {
        if (comeback.isComingBack()) {
          fail(download.problem());
        } else {
          end(download.problem()); // another download would hardly bring something better
        }
      }
      case UNREADABLE -> end(download.problem());
    }
  }

  private void ready() {
    String problem = listener.joined(welcome, download.level());
    if (problem != null) {
      end(problem);
      return;
    }
    if (comeback.isComingBack()) {
      stats.reconnected();
    }
    if (lostSecret != 0 && secret != lostSecret) {
      stats.sessionLost();
    }
    lostSecret = 0;
    enter(Stage.PLAYING);
    stats.playing(true, nowNs);
    message = "";
    comeback.stop();
    lastHeardNs = nowNs;
    link.send(
        new ClientMessage.Ready(
            welcome.epoch(), listener.declarationsDigest(), listener.gameDigest()));
  }

  private void refused(ServerMessage.Refused refused) {
    retryUseful = refused.reason().retryUseful();
    if (refused.reason() == RefusalReason.FLEET_UNSETTLED) {
      failPassing(refused.playerText());
    } else if (comeback.isComingBack() && retryUseful) {
      message = refused.playerText();
      fail(message);
    } else {
      end(refused.playerText());
    }
  }

  private void goodbye(ServerMessage.Goodbye goodbye) {
    retryUseful = goodbye.reason().retryUseful();
    if (retryUseful) {
      message = goodbye.playerText();
      fail(message);
    } else {
      end(goodbye.playerText());
    }
  }

  /** Goes to another server, and brings nothing of this one along but the player's name. */
  private void redirected(ServerMessage.Redirect redirect) {
    ServerAddress to;
    try {
      to = redirects.follow(redirect, address, nowNs);
    } catch (IllegalArgumentException e) {
      end(e.getMessage());
      return;
    }
    stats.redirected();
    boolean wasPlaying = stage == Stage.PLAYING;
    dropLink("sent to " + to);
    stop();
    fleet.forget();
    message = "The server at " + address + " sends you to " + to + ".";
    address = to;
    token = redirect.token();
    room = redirect.room();
    secret = 0;
    lostSecret = 0;
    welcome = null;
    if (!redirect.fingerprint().isEmpty()) {
      transport.expect(to.toString(), redirect.fingerprint());
    }
    comeback.stop();
    if (reconnects && wasPlaying) {
      comeback.start(nowNs, true);
    }
    open();
  }

  /** Goes to another server of the same fleet, with the session. */
  private void moved(ServerMessage.Move move) {
    ServerAddress to;
    try {
      boolean sameKey =
          !move.fingerprint().isEmpty() && move.fingerprint().equals(link.serverFingerprint());
      to = redirects.followMove(move.server(), sameKey, address, nowNs);
    } catch (IllegalArgumentException e) {
      end(e.getMessage());
      return;
    }
    stats.redirected();
    boolean wasPlaying = stage == Stage.PLAYING;
    dropLink("moved to " + to);
    stop();
    fleet.leaveStandby();
    address = to;
    room = move.room();
    ticket = move.ticket();
    transport.expect(to.toString(), move.fingerprint());
    if (reconnects && wasPlaying) {
      message = "Moving to " + to + ".";
      comeback.start(nowNs, true);
    }
    open();
  }

  /** Goes on where the server that has followed the room welcomes the client. */
  private void followRoom() {
    boolean wasPlaying = stage == Stage.PLAYING;
    dropLink("another server goes on with the room");
    stop();
    address = fleet.standbyAddress();
    link = fleet.takeLink();
    listener.playPage(address.host(), null);
    ServerMessage.Welcome first = fleet.takeWelcome();
    fleet.leaveStandby();
    traffic.begin();
    if (wasPlaying) {
      message = "The room goes on at " + address + ".";
      comeback.start(nowNs, true);
    }
    enter(Stage.JOINING);
    askedNs = nowNs;
    message(link, first);
  }

  /** Drops the link. The connection ends, or tries to come back if it was playing. */
  private void fail(String why) {
    dropLink(why);
    retryUseful = true;
    lost(why, false);
  }

  /** Drops the link as {@link #fail} does, for a reason that may be over in a moment. */
  private void failPassing(String why) {
    dropLink(why);
    retryUseful = true;
    lost(why, true);
  }

  /**
   * Ends the stage. While the client tries to come back, the message says why playing ended and, if
   * a server was there, why the latest attempt failed. A first connection is tried again like any
   * other, if the reason may be over in a moment.
   */
  private void lost(String why, boolean mayPass) {
    boolean wasIn = stage == Stage.PLAYING || (stage == Stage.LOADING && !comeback.isComingBack());
    stop();
    if (!comeback.isComingBack()) {
      message = why;
    } else {
      latest = mayPass ? why : ""; // a server that isn't back yet says nothing new
    }
    if (!reconnects || !(wasIn || mayPass || comeback.isComingBack())) {
      stage = Stage.ENDED;
      return;
    }
    if (wasIn || !comeback.isRunning()) {
      lostSecret = secret;
      comeback.start(nowNs, wasIn);
      latest = "";
    }
    stage = Stage.WAITING;
    ticket = "";
    address = fleet.after(address);
    comeback.scheduleAttempt(nowNs, fleet.count(), fleet.hasStandby());
  }

  private void end(String why) {
    dropLink(why);
    fleet.leaveStandby();
    stop();
    message = why;
    stage = Stage.ENDED;
  }

  private void stop() {
    if (stage == Stage.PLAYING) {
      stats.playing(false, nowNs);
      listener.stopped();
    }
  }

  private void dropLink(String why) {
    if (link != null) {
      Link dropped = link;
      link = null;
      dropped.close(why);
      traffic.count(dropped);
    }
  }

  /** Leaves the game and ends the session. */
  public void leave() {
    if (stage == Stage.ENDED) {
      return;
    }
    if (link != null && link.state() == Link.State.OPEN) {
      link.send(new ClientMessage.Leave());
    }
    end("You left the game.");
  }

  /** Sends a message, if playing. */
  public void send(ClientMessage message) {
    if (link != null && stage == Stage.PLAYING) {
      link.send(message);
    }
  }

  /** Sends a datagram, if playing; returns whether the link took it. */
  public boolean sendDatagram(byte[] bytes, int length) {
    return link != null && stage == Stage.PLAYING && link.sendDatagram(bytes, 0, length);
  }

  private void measureRoundTrip() {
    long measured = Math.max(1, nowNs - askedNs);
    roundTripNs = roundTripNs == 0 ? measured : Math.min(roundTripNs, measured);
  }

  private void enter(Stage next) {
    stage = next;
    stageSinceNs = nowNs;
  }

  /** Returns whether the client is in the game. */
  public boolean isPlaying() {
    return stage == Stage.PLAYING;
  }

  /** Returns where the client stands on its way into the game. */
  public ConnectionPhase phase() {
    if (comeback.isComingBack() && stage != Stage.ENDED) {
      return ConnectionPhase.RECONNECTING;
    }
    return switch (stage) {
      case IDLE -> ConnectionPhase.IDLE;
      case WAITING, CONNECTING -> ConnectionPhase.CONNECTING;
      case JOINING -> ConnectionPhase.JOINING;
      case LOADING -> ConnectionPhase.LOADING;
      case PLAYING -> ConnectionPhase.PLAYING;
      case ENDED -> ConnectionPhase.ENDED;
    };
  }

  /** Returns whether the connection has ended for a reason that may be over in a moment. */
  public boolean isRetryUseful() {
    return stage == Stage.ENDED && retryUseful;
  }

  /** Returns what is going on, in words for the player; empty while playing. */
  public String message() {
    return comeback.isRunning() && stage != Stage.ENDED
        ? explained()
            + (comeback.isComingBack() ? " Reconnecting" : " Trying again")
            + (comeback.attempts() > 1 ? " (attempt " + comeback.attempts() + ")" : "")
            + " ..."
        : message;
  }

  /** Returns why playing ended and, if it is another reason, why the latest attempt failed. */
  private String explained() {
    return latest.isEmpty() ? message : message + " " + latest;
  }

  private String notBack() {
    return "The server at " + address + " did not come back.";
  }

  /** Returns the share of the level that has arrived, 0..1. */
  public double levelProgress() {
    return stage == Stage.PLAYING ? 1 : download.share();
  }

  /** Returns the quickest answer to a message so far, nanoseconds; 0 before the first. */
  public long roundTripNs() {
    return roundTripNs;
  }

  private static String sentence(String text) {
    return text.endsWith(".") || text.endsWith("?") || text.endsWith("!") ? text : text + ".";
  }

  private static String nameOf(Object received) {
    return received == null ? "nothing" : received.getClass().getSimpleName();
  }
}
