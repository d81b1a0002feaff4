package carom.server.metrics;

/**
 * The numbers that a room counts. Values only grow, except for gauges. Each has a text that says
 * what it counts, for people and for tools that read the metrics.
 */
public enum Counter {
  TICKS("Simulation steps run."),
  TICKS_LATE("Steps that began at least one period after their deadline."),
  TICKS_DROPPED("Steps that never ran because the room was too far behind."),
  TICKS_OVERRUN("Steps that took longer than their period."),
  LOAD_PERCENT(
      Kind.GAUGE,
      "Time that 95 of 100 ticks of the last 10 s took at most, percent of their period."),
  PACE_PERCENT(
      Kind.GAUGE,
      "Ticks a second, percent of the tick rate: less than 100 when time is slowed down."),
  PLAYERS(Kind.GAUGE, "Players with a link."),
  BOTS(Kind.GAUGE, "Players of them that are bots of the server."),
  PLAYERS_IN_GRACE(Kind.GAUGE, "Players whose link was lost and whose body waits for them."),
  PLAYERS_IDLE(Kind.GAUGE, "Players whose input hasn't changed for as long as --idle-kick says."),
  SPECTATORS(Kind.GAUGE, "Spectators."),
  JOINS("Players who joined, returning ones included."),
  RESUMES("Players who came back within their grace period."),
  LEAVES("Players who left with a message."),
  LINKS_LOST("Links lost or silent for too long."),
  SESSIONS_EXPELLED("Sessions closed because the client sent a wrong message or too much data."),
  SESSIONS_FAILED(
      "Sessions closed because the server threw an exception while serving them. Each is a bug."),
  DATAGRAMS_IN("Input datagrams accepted."),
  BYTES_IN(
      "Payload bytes of input datagrams, dropped ones included, and of all that thin clients say."),
  DATAGRAMS_REFUSED("Datagrams dropped because they weren't input datagrams or had another key."),
  DATAGRAMS_OUT("Snapshot datagrams sent."),
  SNAPSHOT_BYTES("Payload bytes of snapshots sent."),
  SNAPSHOTS_POSTPONED("Snapshots that the room sent a tick later because the tick took too long."),
  TICKS_NARROW(
      "Ticks in which players were told only of what they show because ticks took too long."),
  DATAGRAMS_UNSENT("Snapshot datagrams that the transport didn't accept."),
  INPUTS_DUE("Inputs due: one per player and tick."),
  INPUTS_MISSING("Inputs due that had not arrived when their tick ran."),
  INPUTS_LATE("Inputs that arrived after their tick was consumed."),
  INPUTS_EARLY("Inputs refused because their tick was too far ahead."),
  NEAR_UPDATES("Exact updates begun because a predicted set changed or the game interfered."),
  NEAR_DISAGREEMENTS(
      "Exact updates begun because a client had predicted another state than the server's."),
  EVENTS_OFFERED("Events offered to players, counted once per player."),
  EVENTS_LOST(
      "Events that players never received: those beyond the most that may wait for a client's acks,"
          + " counted once per player, and those that the game emitted beyond the most of a tick,"
          + " counted once."),
  MATCHES("Matches begun after the first."),
  MESSAGES_DROPPED(
      "Messages of games that were dropped because a client or the game sent too many."),
  MESSAGES_MUTED("Lines of chat and emotes of muted players."),
  GAME_FAILURES("Exceptions thrown by the game's callbacks."),
  UNPREDICTABLE(
      "Things that the game's rules do again and again and no client can predict, each once."),
  DIVERGENCES_REPORTED(
      "Mispredictions reported by clients, of the own body or of other predicted entities, for"
          + " which the client knew no reason."),
  DIVERGENCES_UNEXPLAINED(
      "Reported mispredictions for which the server knows no reason either: the client and the"
          + " server disagree although they used the same inputs."),
  RECORDINGS_CUT("Recordings that ended early, because the disk was too slow or failed."),
  CHECKPOINTS("Checkpoints that were taken."),
  CHECKPOINTS_FAILED(
      "Checkpoints that could not be kept, because the disk was too slow or failed, or the state is"
          + " too large."),
  ROOMS_RESUMED("Times that the room went on from a checkpoint."),
  TICKS_REPLAYED("Steps that were computed again from the log behind a checkpoint."),
  CALLBACKS_ABANDONED("Callbacks of games that did not return, with the thread that ran them.");

  private enum Kind {
    COUNTER,
    GAUGE
  }

  private final Kind kind;
  private final String help;

  Counter(String help) {
    this(Kind.COUNTER, help);
  }

  Counter(Kind kind, String help) {
    this.kind = kind;
    this.help = help;
  }

  /** Returns whether the value may fall. */
  public boolean isGauge() {
    return kind == Kind.GAUGE;
  }

  /** Returns what it counts, in a sentence or two. */
  public String help() {
    return help;
  }
}
