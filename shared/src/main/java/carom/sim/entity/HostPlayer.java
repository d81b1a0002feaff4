package carom.sim.entity;

import carom.physics.math.Limits;
import carom.sim.field.FieldStore;
import carom.sim.field.FieldValues;
import carom.sim.field.PlayerRef;
import carom.sim.level.Archetype;
import carom.sim.message.PlayerColour;
import carom.sim.message.PlayerRole;
import carom.sim.spawn.Origin;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * A participant as what runs a simulation holds it: a name, an input, a team, a score. It belongs
 * to one {@code SimulationHost} and its thread. A {@linkplain #isSpectator spectator} has no body.
 */
public final class HostPlayer implements Player, FieldStore.Owner {
  /** Number of parts of a tick in which {@link #viewDelay} counts. */
  public static final int VIEW_STEPS = PoseHistory.STEPS_PER_TICK;

  /** The team of a spectator, which no game has. */
  public static final int NO_TEAM = -1;

  /** Largest {@link #viewDelay}, which is 255 ticks. */
  public static final int MAX_VIEW_DELAY = 255 * VIEW_STEPS;

  /** Creates entities in {@code Game.input}. */
  @FunctionalInterface
  public interface Spawns {
    /** Creates an entity of a player, as {@link Player#spawn} says. */
    HostEntity spawn(Archetype archetype, float x, float y, float angle, HostPlayer owner);
  }

  private final Consumer<String> authority;
  private final Consumer<String> told;
  private final Spawns spawns;
  private final int id;
  private final String name;
  final String account;
  private final FieldValues fields;
  private final Input input = new Input();
  private int viewDelay;
  private int score;
  private int team;
  private PlayerRole role = PlayerRole.PLAYER;
  private boolean ready;
  private PlayerColour colour = PlayerColour.OF_THE_GAME;
  HostEntity body;

  /** The player's entities with an origin, oldest first. */
  private final List<HostEntity> spawned = new ArrayList<>(0);

  /**
   * Creates a player without a body.
   *
   * @param account empty for a stranger
   * @param authority refuses a call, by its name, that only a server may make
   * @param told refuses a question, by its name, where clients would have to know the answer
   * @param spawns creates what the player fires
   */
  HostPlayer(
      int id,
      String name,
      String account,
      FieldValues fields,
      Consumer<String> authority,
      Consumer<String> told,
      Spawns spawns) {
    this.id = id;
    this.name = name;
    this.account = account;
    this.fields = fields;
    this.authority = authority;
    this.told = told;
    this.spawns = spawns;
  }

  @Override
  public int id() {
    return id;
  }

  /** Returns the name given at {@code Simulation.join}, which is any text. */
  public String name() {
    return name;
  }

  @Override
  public String account() {
    told.accept("account");
    return account;
  }

  @Override
  public HostEntity entity() {
    return body;
  }

  @Override
  public boolean isAlive() {
    return body != null;
  }

  /**
   * Returns whether it plays or watches. {@code Simulation.role} changes it. On {@code
   * Role.PREDICTION} everybody plays.
   */
  public PlayerRole role() {
    return role;
  }

  /** Returns whether it watches: it has no body, no team, no score, and no fields of its own. */
  public boolean isSpectator() {
    return role == PlayerRole.SPECTATOR;
  }

  /**
   * Returns whether the player has said that it is ready. What that begins is for the game to say.
   * A spectator never is. On {@code Role.PREDICTION} it is false.
   */
  public boolean isReady() {
    return ready;
  }

  /**
   * Sets whether the player is ready, such as to false when a round has begun.
   *
   * @throws IllegalStateException on {@code Role.PREDICTION}
   */
  public void ready(boolean value) {
    authority.accept("ready");
    ready = value && !isSpectator();
  }

  @Override
  public int spawnedCount() {
    return spawned.size();
  }

  @Override
  public HostEntity spawned(int index) {
    return spawned.get(Limits.index("index", index, spawned.size()));
  }

  /**
   * Adds an entity with an origin.
   *
   * @return the one that is too many now, the oldest, or null
   */
  HostEntity addSpawned(HostEntity entity) {
    int at = spawned.size();
    while (at > 0 && Origin.isEarlier(entity.origin(), spawned.get(at - 1).origin())) {
      at--;
    }
    spawned.add(at, entity);
    return spawned.size() > Origin.MOST_PER_PLAYER ? spawned.remove(0) : null;
  }

  void removeSpawned(HostEntity entity) {
    spawned.remove(entity);
  }

  void clearSpawned() {
    spawned.clear();
  }

  /**
   * Returns the commands for the next step. The caller of {@code Simulation.step} sets them before
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
   * Sets the view delay, clamped to 0..255 ticks. The caller of {@code Simulation.step} sets it
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
   * @throws IllegalStateException on {@code Role.PREDICTION}
   */
  public void score(int points) {
    authority.accept("score");
    score = points;
  }

  /**
   * Returns the team, a number with a meaning of the game's own; 0 by default, {@link #NO_TEAM} for
   * spectators. Clients are told it in the roster, but {@code Role.PREDICTION} doesn't know it.
   */
  public int team() {
    return team;
  }

  /**
   * Sets the team.
   *
   * @throws IllegalStateException on {@code Role.PREDICTION}
   */
  public void team(int value) {
    authority.accept("team");
    team = value;
  }

  /**
   * Returns the colour that the player has chosen. Nothing of the game depends on it. On {@code
   * Role.PREDICTION} it isn't known.
   */
  public PlayerColour colour() {
    return colour;
  }

  /**
   * Sets the colour.
   *
   * @throws IllegalStateException on {@code Role.PREDICTION}
   */
  public void colour(PlayerColour value) {
    authority.accept("colour");
    colour = value;
  }

  /** Begins to play or to watch, with nothing left from before but name, colour and input. */
  void become(PlayerRole newRole) {
    role = newRole;
    team = isSpectator() ? NO_TEAM : 0;
    score = 0;
    ready = false;
    body = null;
    resetFields();
  }

  /** Returns role and readiness in two bits, and above them the colour; 0 for usual players. */
  int standing() {
    return role.ordinal() | (ready ? 2 : 0) | colour.number() << 2;
  }

  /** Returns whether a number is the standing of a player: a spectator is never ready. */
  static boolean isStanding(int value) {
    return PlayerColour.isOne(value >> 2) && (value & 3) != 3;
  }

  /** Returns whether a standing is that of a spectator. */
  static boolean watches(int standing) {
    return (standing & 1) != 0;
  }

  void restore(
      int savedScore, int savedTeam, int savedStanding, long savedInput, int savedViewDelay) {
    score = savedScore;
    team = savedTeam;
    role = watches(savedStanding) ? PlayerRole.SPECTATOR : PlayerRole.PLAYER;
    ready = (savedStanding & 2) != 0;
    colour = PlayerColour.of(savedStanding >> 2);
    input.unpack(savedInput);
    input.before((int) (savedInput >>> Input.PACKED_BITS));
    viewDelay = savedViewDelay;
  }

  @Override
  public Entity spawn(Archetype archetype, float x, float y, float angle) {
    return spawns.spawn(archetype, x, y, angle, this);
  }

  @Override
  public FieldValues fieldValues() {
    return fields;
  }

  @Override
  public FieldValues bodyFieldValues() {
    return body == null ? null : body.fieldValues();
  }

  @Override
  public int reference() {
    return PlayerRef.word(id);
  }

  @Override
  public String toString() {
    return name + "(id=" + id + ")";
  }
}
