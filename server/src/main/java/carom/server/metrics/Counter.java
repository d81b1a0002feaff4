package carom.server.metrics;

/** What a room counts. Every value only grows, except the gauges, which are marked as such. */
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
  /** Players that came in, returning ones included. */
  JOINS,
  /** Players that came back within their grace period. */
  RESUMES,
  /** Players that said they go. */
  LEAVES,
  /** Links lost or silent for too long. */
  LINKS_LOST,
  /** Sessions closed because of what the client did: wrong message, too much data. */
  SESSIONS_EXPELLED,
  /** Sessions closed by an exception of ours while serving them; each is a bug. */
  SESSIONS_FAILED,
  /** Input datagrams taken. */
  DATAGRAMS_IN,
  /** Payload bytes of input datagrams, dropped ones included. */
  BYTES_IN,
  /** Datagrams dropped because they weren't an input datagram or had another key. */
  DATAGRAMS_REFUSED,
  /** Snapshot datagrams sent. */
  DATAGRAMS_OUT,
  /** Payload bytes of snapshots sent. */
  SNAPSHOT_BYTES,
  /** Snapshots that waited for the next tick because theirs took too long. */
  SNAPSHOTS_POSTPONED,
  /** Snapshot datagrams that the transport didn't take. */
  DATAGRAMS_UNSENT,
  /** Ticks of a player that an input was due for. */
  INPUTS_DUE,
  /** Ticks of a player for which no input was there in time. */
  INPUTS_MISSING,
  /** Inputs that came after their tick was consumed. */
  INPUTS_LATE,
  /** Inputs refused because they were for a tick too far ahead. */
  INPUTS_EARLY,
  /** Updates of exact states of what is near a player's body, because the list of them changed. */
  NEAR_UPDATES,
  /** Further ones, because a client had computed another state: its prediction was wrong. */
  NEAR_DISAGREEMENTS,
  /** Events that players were to be told of, each player counted. */
  EVENTS_OFFERED,
  /**
   * Those that were never told, because too many waited for a client's acks; and those that the
   * game told beyond the most of a tick, each once.
   */
  EVENTS_LOST,
  /** Exceptions thrown by the game's callbacks. */
  GAME_FAILURES,
  /**
   * Predictions, of the own body or what is near it, that clients reported as wrong for no reason
   * they knew.
   */
  DIVERGENCES_REPORTED,
  /** Those for which the server knows no reason either: somebody computes wrongly. */
  DIVERGENCES_UNEXPLAINED,
  /** Recordings that ended early, because the disk was too slow or failed. */
  RECORDINGS_CUT
}
