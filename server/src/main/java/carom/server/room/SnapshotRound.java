package carom.server.room;

import carom.net.protocol.SessionState;
import carom.server.config.ServerConfig;
import carom.server.match.RoomContext;
import carom.server.session.Session;
import carom.server.threads.LoadWarnings;
import java.util.IdentityHashMap;
import java.util.function.LongSupplier;

/**
 * Sends the snapshots of a tick to the sessions whose {@linkplain SendTurns turn} it is. An
 * exception while serving one session ends that session only.
 */
final class SnapshotRound {
  private final RoomContext room;
  private final LongSupplier clock;
  private final RoomSessions sessions;
  private final Departures departures;
  private final SendTurns turns;
  private final LoadWarnings warnings;
  private final IdentityHashMap<Session, RuntimeException> broken = new IdentityHashMap<>();

  /**
   * Creates the round of a room.
   *
   * @param clock nanoseconds, to measure how long the tick takes
   */
  SnapshotRound(
      RoomContext room,
      LongSupplier clock,
      RoomSessions sessions,
      Departures departures,
      LoadWarnings warnings) {
    this.room = room;
    this.clock = clock;
    this.sessions = sessions;
    this.departures = departures;
    this.warnings = warnings;
    turns =
        new SendTurns(room.config().get(ServerConfig.TICK_RATE), room.config().snapshotRateHz());
  }

  /**
   * Prepares the snapshots of the newest frame and sends those that are due.
   *
   * @param beginNs when the tick began, by the clock
   * @return whether snapshots have to wait because the tick took too long
   */
  boolean run(long beginNs, long nowNs) {
    int count = sessions.count();
    turns.rate(room.config().snapshotRateHz());
    turns.begin(count, beginNs);
    showWaitingInputs();
    for (int i = 0; i < count; i++) {
      Session session = sessions.get(turns.index(i));
      try {
        serve(session, i, beginNs, nowNs);
      } catch (RuntimeException e) {
        broken.put(session, e);
      }
    }
    if (!broken.isEmpty()) {
      broken.forEach((session, e) -> departures.fail(session, e, nowNs));
      broken.clear();
    }
    if (turns.late() > 0) {
      int tick = room.simulation().tick();
      warnings.snapshotsPostponed(turns.late(), sessions.count(), tick, nowNs);
    }
    return turns.late() > 0;
  }

  private void showWaitingInputs() {
    for (int i = 0; i < sessions.count() && room.simulation().game().relaysAhead(); i++) {
      if (sessions.get(i).state() == SessionState.PLAYING) {
        sessions.get(i).showWaiting(room.match().capture().frames().waiting());
      }
    }
  }

  private void serve(Session session, int turn, long beginNs, long nowNs) {
    if (session.state() == SessionState.GRACE) {
      session.replication().listen();
    } else if (session.state() == SessionState.PLAYING) {
      session.prepareSnapshot();
      if (session.replication().isSnapshotDue() && turns.take(turn, clock.getAsLong())) {
        session.sendSnapshot(clock.getAsLong() - beginNs + nowNs);
      }
    }
  }
}
