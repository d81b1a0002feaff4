package carom.server.match;

import carom.game.GameDigest;
import carom.game.GuardedGame;
import carom.net.field.Declarations;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counters;
import carom.server.prediction.OwnCapture;
import carom.server.replication.FrameCapture;
import carom.server.replication.SessionReplication;
import carom.server.session.LoadedLevel;
import carom.server.session.SessionMessages;
import carom.sim.Game;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostPlayer;
import carom.sim.event.Audience;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.Message;
import java.util.function.Supplier;
import java.util.stream.Stream;

/**
 * One game in one level in a room, from tick 0 on: the simulation and what sessions are told from.
 * A room that changes its game or level gets another match, in which everything here is new.
 *
 * <p>Any thread may build a match. From the room's {@code MatchChange} on it belongs to the room's
 * thread.
 */
public final class Match {
  private final MatchInfo info;
  private final GameFailures failures;
  private final SimulationHost simulation;
  private final FrameCapture capture;
  private final OwnCapture ownCapture;
  private final Supplier<ServerConfig> config;
  private final Counters counters;
  private final boolean hearsChat;
  private long droppedEvents;
  private boolean teamSecrets;

  /**
   * Builds the level and sets up the game.
   *
   * @param room name of the room
   * @param rules an instance of this match's own
   * @param label begins each log line
   * @throws IllegalArgumentException when the game can't be played in the level
   */
  public Match(
      String room,
      int number,
      Game rules,
      LoadedLevel level,
      long seed,
      Supplier<ServerConfig> config,
      String label,
      Counters counters) {
    this.config = config;
    this.counters = counters;
    failures = new GameFailures(rules.name(), counters, label);
    GuardedGame game = new GuardedGame(rules, failures);
    simulation =
        new SimulationHost(
            game, level.level(), seed, config.get().get(ServerConfig.TICK_RATE), Role.AUTHORITY);
    info =
        new MatchInfo(
            room,
            number,
            rules.name(),
            level,
            seed,
            Declarations.of(simulation.schema(), simulation.messageKinds()),
            GameDigest.of(rules),
            rules.skill(),
            config.get().get(ServerConfig.DEV));
    capture = new FrameCapture(simulation);
    ownCapture = new OwnCapture(simulation);
    hearsChat = overridesChat(rules);
    teamSecrets =
        simulation.schema().fields().stream().anyMatch(f -> f.audience() == Audience.TEAM);
  }

  private static boolean overridesChat(Game rules) {
    return Stream.of(rules.getClass().getMethods())
        .anyMatch(m -> m.getName().equals("chat") && m.getDeclaringClass() != Game.class);
  }

  /** Returns whether the game does something with what players say, so that it may be of effect. */
  public boolean hearsChat() {
    return hearsChat;
  }

  /**
   * Returns whether the match has anything so far that a team alone may know, but for plain chat:
   * fields, entities, events or messages.
   */
  public boolean hasTeamSecrets() {
    return teamSecrets || capture.hasTeamSecrets();
  }

  /** Notes that a team alone was sent a message. */
  public void toldTeam(Message message) {
    boolean isChat = message.is(BuiltInKinds.SAID) && message.count("player") >= 0;
    teamSecrets |= hearsChat || !isChat;
  }

  /** Returns what clients must know to play. */
  public MatchInfo info() {
    return info;
  }

  /** Returns the exceptions of the game. */
  public GameFailures failures() {
    return failures;
  }

  /** Returns the simulation that the room steps. The room's thread. */
  public SimulationHost simulation() {
    return simulation;
  }

  /** Returns what captures the simulation's frames for the sessions. The room's thread. */
  public FrameCapture capture() {
    return capture;
  }

  /** Returns the number of events that the simulation has dropped since the last call. */
  public long takeDroppedEvents() {
    long now = simulation.outbox().droppedEvents();
    long dropped = now - droppedEvents;
    droppedEvents = now;
    return dropped;
  }

  /** Creates the messages of the game between a player and the match. */
  public SessionMessages messagesOf(HostPlayer player) {
    return new SessionMessages(simulation, player, counters);
  }

  /** Creates what tells the client of a player about the match. */
  public SessionReplication replicationTo(HostPlayer player) {
    return new SessionReplication(player, config, capture, ownCapture, counters);
  }
}
