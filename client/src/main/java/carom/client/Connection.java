package carom.client;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.Limits;
import carom.net.protocol.PackedLevel;
import carom.net.protocol.Protocol;
import carom.net.protocol.ServerMessage;
import carom.net.transport.ClientTransport;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import carom.sim.level.Level;
import carom.sim.level.LevelException;

/**
 * The way into the game and back: opens the link, says hello, fetches the level, notices when the
 * line is dead, and comes back with the session's secret. Knows nothing of ticks and worlds.
 *
 * <pre>
 * WAITING ─► CONNECTING ─► JOINING ─► LOADING ─► PLAYING
 *    ▲            │            │          │         │        refused, kicked, left: ENDED
 *    └────────────┴────────────┴──────────┴─────────┘        lost: back to WAITING, if wanted
 * </pre>
 */
final class Connection implements LinkHandler {
  /** What the connection tells its client. */
  interface Listener {
    /**
     * The server let us in and the level is here: get ready to play.
     *
     * @return null, or why this client can't play, in words for the player
     */
    String joined(ServerMessage.Welcome welcome, Level level);

    /**
     * A datagram arrived while playing.
     *
     * @param arrivedNs when, by the clock of {@code update}; a frame may have passed since
     */
    void datagram(byte[] bytes, int length, long arrivedNs);

    /** Who plays has changed. */
    void roster(ServerMessage.Roster roster);

    /** A line for the player. */
    void notice(String text);

    /** Playing is over for now, or for good. */
    void stopped();
  }

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
  private static final long CONNECT_TIMEOUT_NS = 10_000 * MS;
  private static final long JOIN_TIMEOUT_NS = 10_000 * MS;
  private static final long LOAD_SILENCE_NS = 15_000 * MS;

  /** Snapshots come several times a second; a gap of 5 s is survived, as on the server. */
  private static final long PLAY_SILENCE_NS = 6_000 * MS;

  private static final long FIRST_BACKOFF_NS = 250 * MS;
  private static final long LONGEST_BACKOFF_NS = 4_000 * MS;
  private static final long GIVE_UP_NS = 90_000 * MS;

  /** Level pieces asked for and not yet received: hides the round trip. */
  private static final int PIECES_IN_FLIGHT = 16;

  private static final int MAX_POLL = 2_048;

  private final ClientConfig config;
  private final ClientTransport transport;
  private final Listener listener;
  private final NetStats stats;

  private Stage stage = Stage.IDLE;
  private String message = "";
  private Link link;
  private long nowNs;
  private long stageSinceNs;
  private long lastHeardNs;
  private long askedNs;
  private long roundTripNs;
  private boolean comingBack;
  private boolean mayPass;
  private long lostNs;
  private long nextAttemptNs;
  private long backoffNs;
  private int attempts;
  private long countedIn;
  private long countedOut;

  private ServerMessage.Welcome welcome;
  private long secret;
  private byte[] packedLevel;
  private long packedHash;
  private int levelReceived;
  private int levelAsked;
  private Level level;
  private long levelHash;

  Connection(ClientConfig config, ClientTransport transport, Listener listener, NetStats stats) {
    this.config = config;
    this.transport = transport;
    this.listener = listener;
    this.stats = stats;
  }

  void update(long nowNs) {
    this.nowNs = nowNs;
    switch (stage) {
      case IDLE -> open();
      case WAITING -> {
        if (nowNs - lostNs > GIVE_UP_NS) {
          end("The server at " + address() + " did not come back. " + message);
        } else if (nowNs >= nextAttemptNs) {
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
    mayPass = false;
    attempts++;
    enter(Stage.CONNECTING);
    if (!comingBack) {
      message = "Connecting to " + address() + " ...";
    }
    countedIn = 0;
    countedOut = 0;
    link = transport.connect(config.host(), config.tcpPort(), config.udpPort());
    progress();
  }

  /** Moves on what moves on without a message: an open link, a deadline. */
  private void progress() {
    long waited = nowNs - stageSinceNs;
    switch (stage) {
      case CONNECTING -> {
        if (link.state() == Link.State.OPEN) {
          enter(Stage.JOINING);
          askedNs = nowNs;
          lastHeardNs = nowNs;
          link.send(
              new ClientMessage.Hello(
                  Protocol.VERSION, Protocol.physicsDigest(), config.name(), secret));
        } else if (link.state() == Link.State.CLOSED) {
          poll(); // delivers the reason
        } else if (waited > CONNECT_TIMEOUT_NS) {
          fail("No answer from " + address() + ". Check the address; is the server running?");
        }
      }
      case JOINING -> {
        if (waited > JOIN_TIMEOUT_NS) {
          fail(address() + " accepts connections but says nothing. Is it a Carom server?");
        }
      }
      case LOADING -> {
        if (nowNs - lastHeardNs > LOAD_SILENCE_NS) {
          fail("The level stopped arriving from " + address() + ".");
        }
      }
      case PLAYING -> {
        if (nowNs - lastHeardNs > PLAY_SILENCE_NS) {
          fail("The connection to " + address() + " was lost.");
        }
      }
      default -> {}
    }
  }

  private void poll() {
    Link polled = link;
    polled.poll(this, MAX_POLL);
    count(polled);
  }

  private void count(Link counted) {
    var counters = counted.counters();
    long in = counters.datagramBytesIn.get() + counters.messageBytesIn.get();
    long out = counters.datagramBytesOut.get() + counters.messageBytesOut.get();
    stats.bytesIn((int) (in - countedIn));
    stats.bytesOut((int) (out - countedOut));
    countedIn = in;
    countedOut = out;
  }

  @Override
  public void message(Link from, Object received) {
    if (from != link) {
      return; // an old link's last words
    }
    lastHeardNs = nowNs;
    if (received instanceof ServerMessage.Welcome w && stage == Stage.JOINING) {
      welcomed(w);
    } else if (received instanceof ServerMessage.LevelChunk chunk && stage == Stage.LOADING) {
      chunk(chunk);
    } else if (received instanceof ServerMessage.Refused refused && stage != Stage.PLAYING) {
      refused(refused);
    } else if (received instanceof ServerMessage.Goodbye goodbye) {
      goodbye(goodbye);
    } else if (received instanceof ServerMessage.Roster roster) {
      listener.roster(roster);
    } else if (received instanceof ServerMessage.Notice notice) {
      listener.notice(notice.text());
    } else {
      fail("The server at " + address() + " sent something unexpected: " + nameOf(received));
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
      count(from);
      link = null;
      mayPass = true;
      if (stage == Stage.PLAYING) {
        lost(sentence("The connection to " + address() + " was lost: " + reason));
      } else if (comingBack) {
        lost("No answer from " + address() + "."); // it was there, so the address is right
      } else {
        lost(sentence("Can't reach the server: " + reason));
      }
    }
  }

  private void welcomed(ServerMessage.Welcome w) {
    roundTrip();
    if (w.levelSize() < 1
        || w.levelSize() > Limits.MAX_LEVEL_BYTES
        || w.packedSize() < 1
        || w.packedSize() > Limits.MAX_LEVEL_BYTES
        || w.tickRate() < Limits.MIN_TICK_RATE
        || w.tickRate() > Limits.MAX_TICK_RATE) {
      fail("The server's welcome makes no sense: " + w);
      return;
    }
    welcome = w;
    secret = w.sessionSecret();
    enter(Stage.LOADING);
    if (level != null && levelHash == w.levelHash()) {
      ready();
      return;
    }
    level = null;
    if (packedLevel == null
        || packedHash != w.levelHash()
        || packedLevel.length != w.packedSize()) {
      packedLevel = new byte[w.packedSize()];
      packedHash = w.levelHash();
      levelReceived = 0;
    } // else the last link broke while loading: go on where it was
    levelAsked = levelReceived;
    if (!comingBack) {
      message = "Loading " + w.levelName() + " ...";
    }
    ask();
  }

  private void ask() {
    int piece = Limits.MAX_LEVEL_CHUNK_BYTES;
    while (levelAsked < packedLevel.length
        && levelAsked - levelReceived < PIECES_IN_FLIGHT * piece) {
      link.send(new ClientMessage.LevelRequest(levelAsked));
      levelAsked += piece;
      askedNs = nowNs;
    }
  }

  private void chunk(ServerMessage.LevelChunk chunk) {
    int expected = Math.min(Limits.MAX_LEVEL_CHUNK_BYTES, packedLevel.length - levelReceived);
    if (chunk.offset() != levelReceived || chunk.bytes().length != expected) {
      unusable(
          "The level arrived in pieces that don't fit: offset="
              + chunk.offset()
              + " length="
              + chunk.bytes().length
              + ", expected offset="
              + levelReceived
              + " length="
              + expected);
      return;
    }
    System.arraycopy(chunk.bytes(), 0, packedLevel, levelReceived, expected);
    levelReceived += expected;
    if (levelReceived < packedLevel.length) {
      ask();
      return;
    }
    byte[] complete = PackedLevel.unpack(packedLevel, welcome.levelSize());
    packedLevel = null;
    if (complete == null) {
      unusable("The level was damaged on its way. Try again.");
      return;
    }
    try {
      level = Level.parse(welcome.levelName(), complete);
    } catch (LevelException e) {
      end("The server's level can't be used: " + e.getMessage());
      return;
    }
    levelHash = level.contentHash();
    if (levelHash != welcome.levelHash()) {
      level = null;
      unusable("The level was damaged on its way. Try again.");
      return;
    }
    ready();
  }

  /** What the server sent is of no use, and asking again would hardly bring something better. */
  private void unusable(String why) {
    packedLevel = null;
    if (comingBack) {
      fail(why);
    } else {
      end(why);
    }
  }

  private void ready() {
    String problem = listener.joined(welcome, level);
    if (problem != null) {
      end(problem);
      return;
    }
    if (comingBack) {
      stats.reconnects++;
    }
    enter(Stage.PLAYING);
    stats.playing(true, nowNs);
    message = "";
    comingBack = false;
    attempts = 0;
    backoffNs = FIRST_BACKOFF_NS;
    lastHeardNs = nowNs;
    link.send(new ClientMessage.Ready());
  }

  private void refused(ServerMessage.Refused refused) {
    String text = join(refused.reason().playerText(), refused.text());
    mayPass = refused.reason().retryUseful();
    if (comingBack && mayPass) {
      fail(text);
    } else {
      end(text);
    }
  }

  private void goodbye(ServerMessage.Goodbye goodbye) {
    String text = join(goodbye.reason().playerText(), goodbye.text());
    mayPass = goodbye.reason().retryUseful();
    if (goodbye.reason() == GoodbyeReason.LEFT || !goodbye.reason().retryUseful()) {
      end(text);
    } else {
      fail(text);
    }
  }

  /** Gives this link up; whether that is the end depends on what was reached. */
  private void fail(String why) {
    dropLink(why);
    mayPass = true;
    lost(why);
  }

  private void lost(String why) {
    boolean wasIn = stage == Stage.PLAYING || (stage == Stage.LOADING && !comingBack);
    stop();
    message = why;
    if (!config.reconnect() || !(wasIn || comingBack)) {
      stage = Stage.ENDED;
      return;
    }
    if (wasIn) {
      comingBack = true;
      lostNs = nowNs;
      attempts = 0;
      backoffNs = FIRST_BACKOFF_NS;
    }
    stage = Stage.WAITING;
    nextAttemptNs = nowNs + backoffNs;
    backoffNs = Math.min(LONGEST_BACKOFF_NS, backoffNs * 2);
  }

  private void end(String why) {
    dropLink(why);
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
      count(dropped);
    }
  }

  /** Leaves for good. */
  void leave() {
    if (stage == Stage.ENDED) {
      return;
    }
    if (link != null && link.state() == Link.State.OPEN) {
      link.send(new ClientMessage.Leave());
    }
    end("You left the game.");
  }

  void send(ClientMessage message) {
    if (link != null && stage == Stage.PLAYING) {
      link.send(message);
    }
  }

  boolean sendDatagram(byte[] bytes, int length) {
    return link != null && stage == Stage.PLAYING && link.sendDatagram(bytes, 0, length);
  }

  private void roundTrip() {
    long measured = Math.max(1, nowNs - askedNs);
    roundTripNs = roundTripNs == 0 ? measured : Math.min(roundTripNs, measured);
  }

  private void enter(Stage next) {
    stage = next;
    stageSinceNs = nowNs;
  }

  boolean playing() {
    return stage == Stage.PLAYING;
  }

  ConnectionPhase phase() {
    if (comingBack && stage != Stage.ENDED) {
      return ConnectionPhase.RECONNECTING;
    }
    return switch (stage) {
      case IDLE -> ConnectionPhase.IDLE;
      case WAITING -> ConnectionPhase.RECONNECTING;
      case CONNECTING -> ConnectionPhase.CONNECTING;
      case JOINING -> ConnectionPhase.JOINING;
      case LOADING -> ConnectionPhase.LOADING;
      case PLAYING -> ConnectionPhase.PLAYING;
      case ENDED -> ConnectionPhase.ENDED;
    };
  }

  /** Whether what ended the way in may be over in a moment. */
  boolean mayPass() {
    return stage == Stage.ENDED && mayPass;
  }

  String message() {
    return comingBack && stage != Stage.ENDED
        ? message + " Reconnecting" + (attempts > 1 ? " (attempt " + attempts + ")" : "") + " ..."
        : message;
  }

  double levelProgress() {
    if (stage == Stage.PLAYING) {
      return 1;
    }
    return packedLevel == null ? 0 : (double) levelReceived / packedLevel.length;
  }

  /** Quickest answer to a message so far, nanoseconds; 0 before the first. */
  long roundTripNs() {
    return roundTripNs;
  }

  private String address() {
    return config.host() + (config.tcpPort() == 0 ? "" : ":" + config.tcpPort());
  }

  private static String join(String sentence, String details) {
    return details.isEmpty() || details.equals(sentence) ? sentence : sentence + " " + details;
  }

  private static String sentence(String text) {
    return text.endsWith(".") || text.endsWith("?") || text.endsWith("!") ? text : text + ".";
  }

  private static String nameOf(Object received) {
    return received == null ? "nothing" : received.getClass().getSimpleName();
  }
}
