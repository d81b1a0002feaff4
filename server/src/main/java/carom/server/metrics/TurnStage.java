package carom.server.metrics;

/** The parts of a room's turn whose time is measured, in the order in which they run. */
public enum TurnStage {
  /** Takes arrivals, departures and one input per player. */
  INPUTS("Takes arrivals, departures and one input per player."),
  /** Steps the simulation: the game's callbacks and the physics. */
  STEP("Steps the simulation: the game's callbacks and the physics."),
  /** Quantises the world once for all sessions. */
  CAPTURE("Quantises the world once for all sessions."),
  /** Chooses, encodes and sends the snapshots. */
  SNAPSHOTS("Chooses, encodes and sends the snapshots."),
  /** Sends messages, records, and changes the match. */
  REST("Sends messages, records, and changes the match."),
  /** Reads the world for the operator's page, after the tick and not as a part of it. */
  PICTURE("Reads the world for the operator's page, after the tick and not as a part of it.");

  private final String help;

  TurnStage(String help) {
    this.help = help;
  }

  /** Returns what it does, in a sentence. */
  public String help() {
    return help;
  }
}
