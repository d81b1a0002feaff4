package carom.sim;

import carom.sim.event.Audience;
import carom.sim.event.EventKind;

/**
 * Something that happens at one moment and is worth a sound, a flash or a line: a hit, a goal, a
 * jump. A game makes one with {@link Simulation#emit} and fills it in; the server brings it to each
 * client that may know of it, and each client shows it exactly once.
 *
 * <p>An event is told, never asked: it is no part of the state, isn't hashed or saved, and nothing
 * may depend on it. Mutable and reused: who hears one reads it and doesn't keep it.
 */
public final class Event {
  /** No player, no entity. */
  public static final int NONE = -1;

  EventKind kind;
  int tick;
  int player;
  int first;
  int second;
  float x;
  float y;
  float strength;
  int data;
  Audience audience = Audience.NEAR;

  /** Creates an empty one, for {@link #set}. */
  public Event() {
    begin(null, 0);
  }

  void begin(EventKind newKind, int newTick) {
    kind = newKind;
    tick = newTick;
    player = NONE;
    first = NONE;
    second = NONE;
    x = 0;
    y = 0;
    strength = 0;
    data = 0;
    audience = Audience.NEAR;
  }

  // ---- filled in by the game

  /** Where it happens, metres; (0, 0) unless said. */
  public Event at(float newX, float newY) {
    x = newX;
    y = newY;
    return this;
  }

  /** Whom it happens to; the level's statics are nobody. */
  public Event of(Entity entity) {
    first = key(entity);
    return this;
  }

  /** Who else takes part; the level's statics are nobody. */
  public Event with(Entity entity) {
    second = key(entity);
    return this;
  }

  /** Whose doing it is: that player's client shows it when it predicts it. */
  public Event by(Player who) {
    player = who == null ? NONE : who.id();
    return this;
  }

  /** How hard, in a unit of the kind's; clients are told eight significant bits. */
  public Event strength(float value) {
    strength = value;
    return this;
  }

  /** A number of the kind's own, such as a team. */
  public Event data(int value) {
    data = value;
    return this;
  }

  /**
   * Who is told; {@link Audience#NEAR} unless said: whoever looks at the place and may know of the
   * entities and of the body of {@link #by}. {@link Audience#TEAM} and {@link Audience#OWNER} mean
   * the team and the client of {@link #by}, who is told in any case but {@link Audience#NOBODY}.
   */
  public Event to(Audience who) {
    audience = who;
    return this;
  }

  private static int key(Entity entity) {
    return entity == null || entity.isLevel() ? NONE : key(entity.id(), entity.generation());
  }

  /** Names an entity: its id and, above 16 bits, its generation. */
  public static int key(int id, int generation) {
    return id | generation << 16;
  }

  /**
   * Fills all of it in, for whoever brings events from elsewhere.
   *
   * @param newKind what it is
   * @param newTick when
   * @param newPlayer 0..1,023 or {@link #NONE}
   * @param newFirst a {@link #key} or {@link #NONE}
   * @param newSecond a {@link #key} or {@link #NONE}
   */
  public Event set(
      EventKind newKind,
      int newTick,
      int newPlayer,
      int newFirst,
      int newSecond,
      float newX,
      float newY,
      float newStrength,
      int newData) {
    begin(newKind, newTick);
    player = newPlayer;
    first = newFirst;
    second = newSecond;
    x = newX;
    y = newY;
    strength = newStrength;
    data = newData;
    return this;
  }

  /** Copies another one. */
  public Event set(Event other) {
    set(
        other.kind,
        other.tick,
        other.player,
        other.first,
        other.second,
        other.x,
        other.y,
        other.strength,
        other.data);
    audience = other.audience;
    return this;
  }

  /**
   * Whether both may be the same happening, computed twice: same kind, player and entities. Where,
   * when and how hard may differ.
   */
  public boolean isLike(Event other) {
    return kind == other.kind
        && player == other.player
        && ((first == other.first && second == other.second)
            || (first == other.second && second == other.first));
  }

  // ---- read by whoever hears it

  /** What it is. */
  public EventKind kind() {
    return kind;
  }

  /** The tick in which it happens. */
  public int tick() {
    return tick;
  }

  /** Whose doing it is, or {@link #NONE}. */
  public int player() {
    return player;
  }

  /** {@link #key} of whom it happens to, or {@link #NONE}. */
  public int first() {
    return first;
  }

  /** {@link #key} of who else takes part, or {@link #NONE}. */
  public int second() {
    return second;
  }

  /** Where it happens, metres. */
  public float x() {
    return x;
  }

  /** Where it happens, metres. */
  public float y() {
    return y;
  }

  /** How hard, in a unit of the kind's. */
  public float strength() {
    return strength;
  }

  /** A number of the kind's own. */
  public int data() {
    return data;
  }

  /** Who is told. */
  public Audience audience() {
    return audience;
  }

  @Override
  public String toString() {
    return kind
        + " tick="
        + tick
        + " player="
        + player
        + " first="
        + first
        + " second="
        + second
        + " at=("
        + x
        + ", "
        + y
        + ") strength="
        + strength
        + " data="
        + data;
  }
}
