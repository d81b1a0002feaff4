package carom.sim;

import carom.physics.rows.BodyRow;

/**
 * Someone who plays: a name, an input, a score, perhaps a body. Belongs to one {@link Simulation}
 * and its thread.
 */
public final class Player {
  /** Ints of {@link #memory}. */
  public static final int MEMORY_SIZE = BodyRow.MEMORY_INTS;

  /** Parts of a tick in which {@link #viewDelay} counts. */
  public static final int VIEW_STEPS = 16;

  /** Largest {@link #viewDelay}: 255 ticks. */
  public static final int MAX_VIEW_DELAY = 255 * VIEW_STEPS;

  private final Simulation simulation;
  private final int id;
  private final String name;
  private final Input input = new Input();
  private final int[] memory = new int[MEMORY_SIZE];
  private int viewDelay;
  private int score;
  private int team;
  Entity body;

  Player(Simulation simulation, int id, String name) {
    this.simulation = simulation;
    this.id = id;
    this.name = name;
  }

  /** The slot, 0..1,023; free again once the player has left. */
  public int id() {
    return id;
  }

  /** The name given at {@link Simulation#join}, any text. */
  public String name() {
    return name;
  }

  /** The body the player steers, or null while there is none. */
  public Entity body() {
    return body;
  }

  /** The commands for the next step; whoever drives the simulation sets them before each step. */
  public Input input() {
    return input;
  }

  /**
   * How old the picture of the others is that the player acts upon, in 1/{@value #VIEW_STEPS} of a
   * tick behind the tick that the input is for: what travels from the server and waits to be
   * interpolated on the client, and how far the client's inputs run ahead. Part of the input.
   */
  public int viewDelay() {
    return viewDelay;
  }

  /** Sets how old the picture is; whoever drives the simulation does, clamped to 0..255 ticks. */
  public void viewDelay(int steps) {
    viewDelay = Math.max(0, Math.min(MAX_VIEW_DELAY, steps));
  }

  /**
   * Four ints for the game's own use in {@link Game#input}: cooldowns, buttons of the tick before.
   * Hashed, saved, and sent to the player's own client, so that its prediction starts from the same
   * numbers. The array is the live one.
   */
  public int[] memory() {
    return memory;
  }

  /** Points. */
  public int score() {
    return score;
  }

  /**
   * Sets the points.
   *
   * @throws IllegalStateException on {@link Role#PREDICTION}
   */
  public void score(int points) {
    simulation.requireAuthority("score");
    score = points;
  }

  /** The side the player is on, a number of the game's own; 0 unless set. Not sent to clients. */
  public int team() {
    return team;
  }

  /**
   * Puts the player on a side.
   *
   * @throws IllegalStateException on {@link Role#PREDICTION}
   */
  public void team(int value) {
    simulation.requireAuthority("team");
    team = value;
  }

  void restore(int savedScore, int savedTeam, long savedInput, int savedViewDelay) {
    score = savedScore;
    team = savedTeam;
    input.unpack(savedInput);
    viewDelay = savedViewDelay;
  }

  @Override
  public String toString() {
    return name + "(id=" + id + ")";
  }
}
