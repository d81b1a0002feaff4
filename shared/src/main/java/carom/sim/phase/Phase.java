package carom.sim.phase;

/** A part of a simulation's life, in which certain methods of the game run. */
public enum Phase {
  /** The game declares its parts and places what it begins with. */
  SET_UP("setUp"),

  /** No step runs. A server may change the world, and a client takes over the server's state. */
  BETWEEN_STEPS("a callback between two steps"),

  /** A player enters the game, between two steps or in one. */
  JOIN("join"),

  /** A player leaves the game, between two steps or in one. */
  LEAVE("leave"),

  /** Players' messages are handled. */
  MESSAGE("message"),

  /** The rules before the inputs run; on a client, what the server said that they did. */
  BEFORE_STEP("beforeStep"),

  /** The input of one player is applied. */
  INPUT("input"),

  /** The rules that clients run, too. */
  RULES("rules"),

  /** Forces act on each awake body. */
  FORCES("forces"),

  /** The world steps and tells of hits and of broken joints. */
  PHYSICS("hit"),

  /** The world asks, within its step, whether two bodies collide. */
  COLLISION("collision"),

  /** A body has entered a sensor. */
  ENTERED("entered"),

  /** A body has left a sensor. */
  LEFT("left"),

  /** The triggers of the level run, within {@link #AFTER_STEP}; on a client by themselves. */
  TRIGGERS("triggers"),

  /** The rules after the physics run; on a client, what the server said that they did. */
  AFTER_STEP("afterStep");

  private final String callback;

  Phase(String callback) {
    this.callback = callback;
  }

  /** Returns whether a change that the game makes in it is none that clients compute. */
  public boolean isOfRules() {
    return this != SET_UP && this != BETWEEN_STEPS && this != FORCES && !isPredicted();
  }

  /** Returns whether clients make the changes to fields that the game makes in it. */
  public boolean isPredicted() {
    return this == INPUT || this == RULES || this == TRIGGERS;
  }

  /** Returns the name of the method of the game that runs in it, for advice to its developer. */
  public String callback() {
    return callback;
  }
}
