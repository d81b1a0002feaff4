package carom.server.room;

import carom.net.protocol.ProtocolLimits;
import carom.server.checkpoint.RoomCheckpoints;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.match.Match;
import carom.server.match.MatchLibrary;
import carom.server.match.MatchLoader;
import carom.server.match.RoomContext;
import carom.server.metrics.Counters;
import carom.server.session.Ownership;
import carom.server.session.PartingLinks;
import carom.server.session.Seats;
import carom.server.threads.LoadWarnings;
import carom.server.threads.LoaderThread;
import carom.server.threads.TickPace;
import java.nio.file.Path;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/**
 * The parts that a room consists of. Each part does one thing.
 *
 * <pre>
 *   Room ──► RoomTick ──► RoomEnd ──► RoomParts
 *     └────► OperatorCommands ────────────┘
 * </pre>
 *
 * <p>Each of these sees what is right of it. The room's thread, but for what a part says itself.
 */
final class RoomParts {
  final RoomContext context;

  /** Nanoseconds, to measure how long ticks take. */
  final LongSupplier clock;

  final StageTimes stages;
  final TickPace pace;
  final RoomSessions sessions;
  final Announcer announcer;
  final RosterNews roster;
  final PartingLinks partings = new PartingLinks(ProtocolLimits.MAX_PLAYERS);
  final RoomBots bots;
  final Departures departures;
  final RoomRecording recording;
  final RoomAccounts accounts;
  final MatchChange changes;
  final Arrivals arrivals;
  final RoomSwitches switches;
  final SnapshotRound snapshots;
  final MessageDelivery messages;

  /** Null if the room isn't kept. */
  final RoomJournals journals = new RoomJournals();

  /**
   * Builds the level and sets up the game of the first match; the parameters are those of {@link
   * Room}.
   *
   * @param label begins each log line: the room's name, or empty if there is only one room
   * @param journal folder from which the room will go on, or null
   * @param self the room that has these parts
   * @throws IllegalArgumentException when the first match can't be played; the message says why
   */
  RoomParts(
      Supplier<ServerConfig> settingsNow,
      String label,
      RoomConfig settings,
      MatchLibrary library,
      LoaderThread loads,
      LongSupplier clock,
      Seats seats,
      RoomDirectory directory,
      Counters counters,
      Ownership ownership,
      Path journal,
      Room self) {
    this.clock = clock;
    ServerConfig config = settingsNow.get();
    stages = new StageTimes(clock);
    MatchLoader loader = new MatchLoader(settingsNow, settings, library, label, counters);
    context =
        new RoomContext(
            settingsNow, label, counters, seats, ownership, firstMatch(loader, journal));
    recording = new RoomRecording(context);
    sessions = new RoomSessions(ProtocolLimits.MAX_PLAYERS, label, counters);
    announcer = new Announcer(sessions, config.get(ServerConfig.TICK_RATE));
    roster =
        new RosterNews(ProtocolLimits.MAX_PLAYERS, config.get(ServerConfig.ROSTER_INTERVAL_MS));
    accounts = new RoomAccounts(context, directory, sessions, journals, settings.name());
    bots = new RoomBots(context, settings.name(), directory, sessions);
    departures = new Departures(context, sessions, roster, announcer, partings, accounts, bots);
    changes =
        new MatchChange(
            context, loader, loads, settings, sessions, recording, journals, roster, announcer,
            accounts);
    arrivals =
        new Arrivals(
            context, clock, sessions, departures, roster, announcer, changes, accounts, bots);
    LevelChoices choices =
        new LevelChoices(context, settings.name(), directory, sessions, announcer, changes);
    switches = new RoomSwitches(context, self, directory, sessions, departures, accounts, choices);
    LoadWarnings warnings = new LoadWarnings(label, counters, config.get(ServerConfig.TICK_RATE));
    pace =
        new TickPace(
            config.get(ServerConfig.TICK_RATE),
            config.get(ServerConfig.CATCH_UP_TICKS),
            warnings,
            counters);
    snapshots = new SnapshotRound(context, clock, sessions, departures, warnings);
    messages = new MessageDelivery(context, sessions, directory);
  }

  private static Match firstMatch(MatchLoader loader, Path journal) {
    Match prepared = journal == null ? null : RoomCheckpoints.prepare(journal, loader);
    try {
      return prepared == null ? loader.first() : prepared;
    } catch (MatchLoader.Unplayable e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }
}
