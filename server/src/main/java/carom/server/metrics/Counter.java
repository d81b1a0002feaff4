package carom.server.metrics;

/** The numbers that a room counts. Values only grow, except for those marked as gauges. */
public enum Counter {
  /** Simulation steps run. */
  TICKS,
  /** Steps that began at least one period after their deadline. */
  TICKS_LATE,
  /** Steps that never ran because the room was too far behind. */
  TICKS_DROPPED,
  /** Steps that took longer than their period. */
  TICKS_OVERRUN,
  /** Gauge: players with a link. */
  PLAYERS,
  /** Gauge: players whose link was lost and whose body waits for them. */
  PLAYERS_IN_GRACE,
  /** Gauge: spectators. */
  SPECTATORS,
  /** Players who joined, returning ones included. */
  JOINS,
  /** Players who came back within their grace period. */
  RESUMES,
  /** Players who left with a message. */
  LEAVES,
  /** Links lost or silent for too long. */
  LINKS_LOST,
  /** Sessions closed because the client sent a wrong message or too much data. */
  SESSIONS_EXPELLED,
  /** Sessions closed because the server threw an exception while serving them. Each is a bug. */
  SESSIONS_FAILED,
  /** Input datagrams accepted. */
  DATAGRAMS_IN,
  /** Payload bytes of input datagrams, dropped ones included. */
  BYTES_IN,
  /** Datagrams dropped because they weren't input datagrams or had another key. */
  DATAGRAMS_REFUSED,
  /** Snapshot datagrams sent. */
  DATAGRAMS_OUT,
  /** Payload bytes of snapshots sent. */
  SNAPSHOT_BYTES,
  /** Snapshots that the room sent a tick later because the tick took too long. */
  SNAPSHOTS_POSTPONED,
  /** Snapshot datagrams that the transport didn't accept. */
  DATAGRAMS_UNSENT,
  /** Inputs due: one per player and tick. */
  INPUTS_DUE,
  /** Inputs due that had not arrived when their tick ran. */
  INPUTS_MISSING,
  /** Inputs that arrived after their tick was consumed. */
  INPUTS_LATE,
  /** Inputs refused because their tick was too far ahead. */
  INPUTS_EARLY,
  /** Exact updates begun because a predicted set changed or the game interfered. */
  NEAR_UPDATES,
  /** Exact updates begun because a client had predicted another state than the server's. */
  NEAR_DISAGREEMENTS,
  /** Events offered to players, counted once per player. */
  EVENTS_OFFERED,
  /**
   * Events that players never received: those beyond the most that may wait for a client's acks,
   * counted once per player, and those that the game emitted beyond the most of a tick, counted
   * once.
   */
  EVENTS_LOST,
  /** Matches begun after the first. */
  MATCHES,
  /** Messages of games that were dropped because a client or the game sent too many. */
  MESSAGES_DROPPED,
  /** Lines of chat and emotes of players whom the operator muted. */
  MESSAGES_MUTED,
  /** Exceptions thrown by the game's callbacks. */
  GAME_FAILURES,
  /** Things that the game's rules do again and again and no client can foresee, each once. */
  UNFORESEEN,
  /**
   * Mispredictions reported by clients, of the own body or of other predicted entities, for which
   * the client knew no reason.
   */
  DIVERGENCES_REPORTED,
  /**
   * Reported mispredictions for which the server knows no reason either: the client and the server
   * disagree although they used the same inputs.
   */
  DIVERGENCES_UNEXPLAINED,
  /** Recordings that ended early, because the disk was too slow or failed. */
  RECORDINGS_CUT
}
