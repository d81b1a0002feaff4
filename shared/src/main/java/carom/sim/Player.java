package carom.sim;

import carom.sim.field.FieldHolder;
import carom.sim.field.FieldValues;
import carom.sim.field.PlayerRef;
import carom.sim.field.Scope;
import carom.sim.history.PoseHistory;
import carom.sim.spawn.Origin;
import java.util.ArrayList;
import java.util.List;

/**
 * A person or bot that plays: a name, an input, a score, perhaps a body. It belongs to one {@link
 * Simulation} and its thread.
 */
public final class Player extends FieldHolder<Entity, Player> {
  /** Number of parts of a tick in which {@link #viewDelay} counts. */
  public static final int VIEW_STEPS = PoseHistory.STEPS_PER_TICK;

  /** Largest {@link #viewDelay}, which is 255 ticks. */
  public static final int MAX_VIEW_DELAY = 255 * VIEW_STEPS;

  private final Simulation simulation;
  private final int id;
  private final String name;
  private final FieldValues fields;
  private final Input input = new Input();
  private int viewDelay;
  private int score;
  private int team;
  Entity body;

  /** Its entities with an origin, oldest first. */
  private final List<Entity> spawned = new ArrayList<>(0);

  Player(Simulation simulation, int id, String name) {
    this.simulation = simulation;
    this.id = id;
    this.name = name;
    fields = simulation.entities().fields().create(Scope.PLAYER);
  }

  /** Returns the slot, 0..1,023, which is free again once the player has left. */
  public int id() {
    return id;
  }

  /** Returns the name given at {@link Simulation#join}, which is any text. */
  public String name() {
    return name;
  }

  /** Returns the body the player steers, or null while there is none. */
  public Entity body() {
    return body;
  }

  /**
   * Returns the number of living entities that {@link Game#input} spawned for this player, at most
   * {@value Origin#MOST_PER_PLAYER}: an older one is an entity like others. A client knows those of
   * its own player only.
   */
  public int spawnedCount() {
    return spawned.size();
  }

  /**
   * Returns an entity that {@link Game#input} spawned for this player. To despawn some of them, go
   * from the newest to the oldest.
   *
   * @param index 0, the oldest, to {@link #spawnedCount} - 1
   */
  public Entity spawned(int index) {
    return spawned.get(index);
  }

  /**
   * Adds an entity with an origin.
   *
   * @return the one that is too many now, the oldest, or null
   */
  Entity addSpawned(Entity entity) {
    int at = spawned.size();
    while (at > 0 && Origin.isEarlier(entity.origin(), spawned.get(at - 1).origin())) {
      at--;
    }
    spawned.add(at, entity);
    return spawned.size() > Origin.MOST_PER_PLAYER ? spawned.remove(0) : null;
  }

  void removeSpawned(Entity entity) {
    spawned.remove(entity);
  }

  void clearSpawned() {
    spawned.clear();
  }

  /**
   * Returns the commands for the next step. The caller of {@link Simulation#step} sets them before
   * each step.
   */
  public Input input() {
    return input;
  }

  /**
   * Returns how far the picture on which the player acts is behind the tick of the input, in
   * 1/{@value #VIEW_STEPS} tick. The delay covers the way from the server, the interpolation on the
   * client, and how far the client's inputs run ahead. It is part of the input.
   */
  public int viewDelay() {
    return viewDelay;
  }

  /**
   * Sets the view delay, clamped to 0..255 ticks. The caller of {@link Simulation#step} sets it
   * before each step.
   */
  public void viewDelay(int steps) {
    viewDelay = Math.max(0, Math.min(MAX_VIEW_DELAY, steps));
  }

  /** Returns the points. */
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

  /**
   * Returns the team, a number with a meaning of the game's own; 0 by default. It is not sent to
   * clients.
   */
  public int team() {
    return team;
  }

  /**
   * Sets the team.
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
  public FieldValues fieldValues() {
    return fields;
  }

  @Override
  protected int reference() {
    return PlayerRef.word(id);
  }

  @Override
  public String toString() {
    return name + "(id=" + id + ")";
  }
}
