package carom.client;

import carom.client.link.Connection;
import carom.client.link.ConnectionListener;
import carom.client.link.RoomListing;
import carom.client.link.ServerAddress;
import carom.client.stats.NetStats;
import carom.client.stats.NetStatsRecorder;
import carom.client.view.ClientView;
import carom.client.view.ViewWriter;
import carom.game.GameDigest;
import carom.game.GameFault;
import carom.game.GameJars;
import carom.game.Games;
import carom.game.GuardedGame;
import carom.game.JarWatch;
import carom.net.field.Declarations;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.Protocol;
import carom.net.protocol.RoomName;
import carom.net.protocol.ServerMessage;
import carom.net.protocol.ServerMessage.LevelEntry;
import carom.net.protocol.ServerMessage.RoomEntry;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.transport.ClientTransport;
import carom.sim.Game;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.level.Level;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.Emote;
import carom.sim.message.Message;
import carom.sim.message.PlayerColour;
import carom.sim.message.PlayerRole;
import carom.sim.outbox.Event;
import carom.text.FileErrors;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.LongSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A player's side of the game, without a window. Its owner calls {@link #update} once per frame
 * with the present time and then reads {@link #view}. It never sleeps, waits or starts a thread.
 * One thread.
 *
 * <p>One update is one client frame:
 *
 * <ol>
 *   <li>Take in what has arrived.
 *   <li>Move the clock that runs ahead of the server.
 *   <li>For each tick that is due: sample, send and predict.
 *   <li>Reconcile the prediction with the newest server state.
 * </ol>
 *
 * <p>The entities of the view are composed when a user looks at them. {@link JoinedGame} has a
 * drawing of the parts.
 *
 * <pre>{@code
 * try (GameClient client = new GameClient(config, transport, input)) {
 *   while (client.view().phase() != ConnectionPhase.ENDED) {
 *     client.update(System.nanoTime());
 *     draw(client.view());
 *   }
 * }
 * }</pre>
 */
public final class GameClient implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(GameClient.class);

  /** Time between two looks at the jars of games, with {@code --dev}. */
  private static final long JAR_LOOK_NS = 500_000_000;

  private final ClientConfig config;

  /** Null without {@code --dev}. */
  private final JarWatch jars;

  private long lookedNs;
  private final InputSource source;
  private final LongSupplier stopwatch;
  private final NetStatsRecorder stats = new NetStatsRecorder();
  private final ViewWriter view = new ViewWriter(stats.stats());
  private final Connection connection;
  private final MessageExchange messages;
  private final RoomListing rooms = new RoomListing();

  /** Most levels of players that are kept of a server's list. */
  private static final int MAX_LEVELS = 1_024;

  private final List<LevelEntry> levels = new ArrayList<>();
  private final InterestReporter interest = new InterestReporter();
  private final WatchedPlayer watched = new WatchedPlayer();
  private final RepeatedEventFilter repeats = new RepeatedEventFilter();
  private final EventListener countingListener =
      new EventListener() {
        @Override
        public void happened(Event e, boolean predicted) {
          listener.happened(e, predicted);
        }

        @Override
        public void retracted(Event e) {
          stats.eventRetracted();
          listener.retracted(e);
        }
      };

  private EventListener listener = EventListener.NONE;

  /** The present stay or, after it, the last one; null before the first. */
  private JoinedGame game;

  private long declarationsDigest;
  private long gameDigest;
  private PlayerColour colour = PlayerColour.OF_THE_GAME;
  private boolean colourIsDue;

  private long nowNs;
  private long lastUpdateNs;

  /**
   * Creates a client that connects at the first {@link #update}.
   *
   * @param config server, player and settings
   * @param transport opens links; stays the caller's, close it after this client
   * @param input samples the player's input
   */
  public GameClient(ClientConfig config, ClientTransport transport, InputSource input) {
    this(config, transport, input, System::nanoTime);
  }

  /**
   * Creates a client whose prediction measures its time by another clock.
   *
   * @param config server, player and settings
   * @param transport opens links; stays the caller's, close it after this client
   * @param input samples the player's input
   * @param stopwatch nanoseconds; bounds how long a replay takes. A constant lifts that bound, for
   *     tests in virtual time that must not depend on the machine
   */
  public GameClient(
      ClientConfig config, ClientTransport transport, InputSource input, LongSupplier stopwatch) {
    this.config = config;
    jars = config.get(ClientConfig.DEV) ? new JarWatch() : null;
    this.source = input;
    this.stopwatch = stopwatch;
    connection =
        new Connection(
            new ServerAddress(
                config.get(ClientConfig.SERVER).host(),
                config.get(ClientConfig.SERVER).tcpPort(),
                config.get(ClientConfig.SERVER).udpPort()),
            config.get(ClientConfig.NAME),
            config.get(ClientConfig.ROOM),
            config.get(ClientConfig.GAME),
            config.get(ClientConfig.PARTY),
            config.get(ClientConfig.TOKEN),
            config.get(ClientConfig.KEY),
            config.get(ClientConfig.PASSWORD),
            config.get(ClientConfig.RECONNECT),
            transport,
            new ConnectionHandler(),
            stats);
    messages = new MessageExchange(connection, stats);
    view.composer(this::compose);
  }

  /**
   * Does everything that is due: takes in what has arrived, runs the ticks that are due, sends
   * inputs, and reconciles. The {@link #view} then shows this moment.
   *
   * @param nowNs the present, nanoseconds of any clock that never goes back
   */
  public void update(long nowNs) {
    float seconds = lastUpdateNs == 0 ? 0 : Math.max(0, (nowNs - lastUpdateNs) * 1e-9f);
    lastUpdateNs = nowNs;
    this.nowNs = nowNs;
    if (jars != null && nowNs - lookedNs >= JAR_LOOK_NS) {
      lookedNs = nowNs;
      lookAtJars();
    }
    connection.update(nowNs);
    messages.update(nowNs);
    stats.roll(nowNs);
    if (game != null) {
      game.advance(nowNs, seconds, connection.isPlaying());
      if (game.hasStarted() && connection.isPlaying()) {
        watched.update(view.view(), nowNs);
        interest.follow(watched.id());
        view.watched(watched.id());
        interest.sendIfDue(connection, nowNs);
        colourIsDue = colourIsDue && !send(BuiltInKinds.COLOUR.of(colour));
      }
    }
    describe();
  }

  /** Takes the jars of games that have changed: views and brains are new at once, games later. */
  private void lookAtJars() {
    try {
      if (jars.look()) {
        LOG.info("dev: the jars of games have changed");
      }
    } catch (IOException e) {
      String text = "The games in --games can't be read anew: " + FileErrors.reason(e) + ".";
      LOG.warn("dev: {}", text);
      view.notice(text, nowNs);
    }
  }

  private final class ConnectionHandler implements ConnectionListener {
    @Override
    public String joined(ServerMessage.Welcome welcome, Level level) {
      Game rules;
      try {
        if (config.get(ClientConfig.DEV)) {
          GameJars.refresh(); // the server may play a new build
        }
        rules = Games.create(welcome.game());
      } catch (IllegalArgumentException e) {
        return "This client can't play " + welcome.game() + ": " + e.getMessage();
      } catch (IOException e) {
        return "The games in --games can't be read: " + FileErrors.reason(e) + ".";
      }
      try {
        return join(welcome, level, rules);
      } catch (RuntimeException | Error e) {
        String text =
            String.format(
                Locale.ROOT,
                "This client can't play %s: %s failed at tick %d, for player %d: %s.",
                welcome.game(),
                GameFault.callback(rules.getClass(), e),
                welcome.tick(),
                welcome.playerId(),
                GameFault.describe(e));
        LOG.error("{}", text, e);
        return text;
      }
    }

    @Override
    public long declarationsDigest() {
      return declarationsDigest;
    }

    @Override
    public long gameDigest() {
      return gameDigest;
    }

    @Override
    public void datagram(byte[] bytes, int length, long arrivedNs) {
      if (!messages.receive(bytes, length)) {
        game.receive(bytes, length, arrivedNs, nowNs, connection.roundTripNs());
      }
    }

    @Override
    public void roster(ServerMessage.Roster roster) {
      game.roster(roster);
    }

    @Override
    public void rooms(ServerMessage.RoomList part) {
      List<RoomEntry> all = rooms.add(part);
      if (all != null) {
        view.rooms(all);
      }
    }

    @Override
    public void best(ServerMessage.BestLists lists) {
      view.best(lists.lists());
    }

    @Override
    public void levels(ServerMessage.LevelList part) {
      if (levels.size() < MAX_LEVELS) {
        levels.addAll(part.levels());
      }
      if (part.left() == 0) {
        view.levels(new ServerMessage.LevelList(0, part.mayChoose(), levels));
        levels.clear();
      }
    }

    @Override
    public void pace(ServerMessage.Pace pace) {
      game.pace(pace, nowNs);
    }

    @Override
    public void playPage(String host, ServerMessage.PlayPage page) {
      view.playPage(host, page);
    }

    @Override
    public void notice(String text) {
      view.notice(text, nowNs);
    }

    @Override
    public void message(ServerMessage.GameMessage message) {
      messages.receive(message);
    }

    @Override
    public void pools(ServerMessage.PoolChunk chunk) {
      game.pools(chunk);
    }

    @Override
    public void heard(ServerMessage.Heard message) {
      messages.heard(message);
    }

    @Override
    public void stopped() {
      messages.stop();
      game.close();
      view.freeze();
    }
  }

  /** Joins a match. Returns why this client can't, in words for the player, or null. */
  private String join(ServerMessage.Welcome welcome, Level level, Game rules) {
    PredictionFailure failure =
        new PredictionFailure(welcome.game(), welcome.playerId(), text -> view.notice(text, nowNs));
    SimulationHost simulation =
        new SimulationHost(
            new GuardedGame(rules, failure),
            level,
            welcome.seed(),
            welcome.tickRate(),
            Role.PREDICTION);
    Declarations mine = Declarations.of(simulation.schema(), simulation.messageKinds());
    String difference =
        mine.difference(welcome.game(), welcome.declarationsDigest(), welcome.declarations());
    if (difference != null) {
      return difference;
    }
    gameDigest =
        config.get(ClientConfig.PREDICTION) == PredictionMode.NONE
            ? GameDigest.UNKNOWN
            : GameDigest.of(rules);
    difference = welcome.codeDifference(gameDigest);
    if (difference != null) {
      if (!welcome.takesAnyCode() && !config.get(ClientConfig.DEV)) {
        return difference + " Use the same build, or --dev to play all the same.";
      }
      LOG.warn("{} Predictions may be wrong.", difference);
      view.notice(difference + " Predictions may be wrong.", nowNs);
      gameDigest = welcome.takesAnyCode() ? gameDigest : GameDigest.UNKNOWN;
    }
    declarationsDigest = mine.digest();
    interest.reset();
    watched.reset();
    colourIsDue = colour != PlayerColour.OF_THE_GAME;
    messages.begin(welcome, simulation.messageKinds());
    if (game != null) {
      stats.ticksLost(game.ticksLost(welcome));
    }
    game =
        new JoinedGame(
            config,
            welcome,
            level,
            simulation,
            failure,
            source,
            stopwatch,
            connection,
            stats,
            view,
            repeats,
            countingListener,
            game != null && game.goesOn(welcome, level));
    return null;
  }

  private void describe() {
    view.connection(connection.phase(), connection.message(), connection.levelProgress());
    if (game != null) {
      game.describe(connection.isPlaying());
    }
  }

  /** Composes the visible entities; called when a user looks. */
  private void compose() {
    view.clear();
    if (game != null) {
      game.compose(nowNs);
    }
  }

  /**
   * Sets who receives the events of the game (hits, goals, jumps), each one once. They fire during
   * {@link #update} and {@link #close}.
   */
  public void events(EventListener newListener) {
    listener = newListener;
  }

  /** Sets who hears messages of the game, chat and emotes. They arrive during {@link #update}. */
  public void messages(MessageListener newListener) {
    messages.listener(newListener);
  }

  /**
   * Sends a message to the game at the server with the next {@link #update}. A reliable one
   * survives a broken link: up to 64 wait and arrive once, in order, when the client is back. If
   * the session is over by then, {@link MessageListener#unsent} names them.
   *
   * @param message of a kind that the game registered and clients may send
   * @return false when it isn't sent: no game is played yet, the kind's rate is exceeded, 64 wait
   *     already, or the message is unreliable and there is no link
   * @throws IllegalArgumentException when the kind isn't registered, or only the server sends it
   */
  public boolean send(Message message) {
    return messages.send(message);
  }

  /** Says a line to all, see {@link #send}. What is longer than a line of chat is cut off. */
  public boolean chat(String text) {
    return say(false, text);
  }

  /** Says a line to the own team, as {@link #chat} does to all. */
  public boolean teamChat(String text) {
    return say(true, text);
  }

  private boolean say(boolean team, String text) {
    String line = text.substring(0, Math.min(BuiltInKinds.MAX_CHAT, text.length()));
    return !line.isBlank() && send(BuiltInKinds.SAY.of(team, line));
  }

  /** Shows an emote above the own body, see {@link #send}. */
  public boolean emote(Emote emote) {
    return send(BuiltInKinds.EMOTE.of(emote));
  }

  /** Says whether the player is ready, see {@link #send}. */
  public boolean ready(boolean ready) {
    return send(BuiltInKinds.READY.of(ready));
  }

  /**
   * Asks for a team, see {@link #send}. If the game refuses, the server says why, as a line of
   * chat.
   *
   * @param team 1..255, one of {@link carom.sim.Game#teams}
   */
  public boolean team(int team) {
    return send(BuiltInKinds.TEAM.of(team));
  }

  /**
   * Chooses the colour of the own body, in this match and in those that follow. If the game doesn't
   * let players choose, nothing happens.
   */
  public void colour(PlayerColour chosen) {
    colourIsDue |= chosen != colour;
    colour = chosen;
  }

  /** Asks to play or to watch, see {@link #send}. If the game refuses, the server says why. */
  public boolean role(PlayerRole role) {
    return send(BuiltInKinds.ROLE.of(role));
  }

  /**
   * Follows another player, while the own one watches or is out; the client chooses the first by
   * itself. {@link ClientView#watchedPlayer} returns it.
   *
   * @param step 1 for the next by id, -1 for the one before
   */
  public void watchNext(int step) {
    watched.next(view.view(), step, nowNs);
  }

  /**
   * Asks the server for its rooms; {@link ClientView#rooms} then lists them. Does nothing while
   * nothing is played.
   */
  public void listRooms() {
    connection.send(new ClientMessage.ListRooms(Protocol.VERSION));
  }

  /**
   * Asks the server for the best of what accounts keep in the room's game; {@link ClientView#best}
   * then lists them. Does nothing while nothing is played.
   */
  public void listBest() {
    connection.send(new ClientMessage.ListBest());
  }

  /**
   * Asks the server for the levels of players; {@link ClientView#levels} then lists them. Does
   * nothing while nothing is played.
   */
  public void listLevels() {
    connection.send(new ClientMessage.ListLevels());
  }

  /**
   * Says which level of a player the room is to play, if its players may choose. A {@linkplain
   * ClientView#notices notice} says what comes of it. Does nothing while nothing is played.
   *
   * @param level name of the level; empty for none
   */
  public void chooseLevel(String level) {
    connection.send(new ClientMessage.ChooseLevel(level));
  }

  /**
   * Asks to go on in another room, with the same name and over the same link. If there is no such
   * room, or no place in it, a {@linkplain ClientView#notices notice} says so and the player stays.
   * Does nothing while nothing is played.
   *
   * @param room name of the room
   * @throws IllegalArgumentException when no room can have this name
   */
  public void changeRoom(String room) {
    String problem = RoomName.problem(room);
    if (problem != null) {
      throw new IllegalArgumentException(problem);
    }
    connection.send(new ClientMessage.ChangeRoom(room));
  }

  /** Returns what the player sees; the same object for ever. */
  public ClientView view() {
    return view.view();
  }

  /**
   * Tells the server which part of the level is shown, so that it sends that part first. The server
   * bounds the size, and follows the own body by itself, or that of the watched player. A client
   * that never calls this gets as much as the server allows.
   *
   * @param x middle of the picture while there is no own body, metres
   * @param y middle of the picture while there is no own body, metres
   * @param width of the picture, metres, 0 or more
   * @param height of the picture, metres, 0 or more
   * @throws IllegalArgumentException when a number isn't finite or a size is negative
   */
  public void look(float x, float y, float width, float height) {
    boolean numbers = Float.isFinite(x) && Float.isFinite(y);
    if (!numbers || !(width >= 0 && height >= 0) || Float.isInfinite(width + height)) {
      throw new IllegalArgumentException(
          "look x=%s y=%s width=%s height=%s must be finite, with sizes of 0 or more"
              .formatted(x, y, width, height));
    }
    boolean follows = view().own() != null || view().watchedPlayer() >= 0;
    interest.show(follows ? 0 : x, follows ? 0 : y, width, height);
  }

  /**
   * Returns what has arrived, exactly as the server sent it, or null before joining. Read-only:
   * tests and tools compare it with the server's state.
   */
  public SnapshotDecoder decoder() {
    return game == null ? null : game.decoder();
  }

  /**
   * Returns which run of its server the client plays in, as the server's seats count it; 0 before
   * joining. A server that goes on after a crash is another run.
   */
  public int incarnation() {
    return game == null ? 0 : game.incarnation();
  }

  /** Returns what is left to fade of corrections of the own body, metres. */
  public double visualErrorMetres() {
    return game == null ? 0 : game.visualErrorMetres();
  }

  /**
   * Returns whether a new client might get in where this one ended: the server was full, busy or
   * out of reach, but not at odds with this client.
   */
  public boolean isRetryUseful() {
    return connection.isRetryUseful();
  }

  /** Returns figures about the connection. */
  public NetStats stats() {
    return stats.stats();
  }

  /** Leaves the game: tells the server, closes the link. Does nothing the second time. */
  @Override
  public void close() {
    connection.leave();
    if (game != null) {
      game.close();
    }
    describe();
  }
}
