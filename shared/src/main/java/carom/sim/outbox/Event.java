package carom.sim.outbox;

import carom.physics.math.Limits;
import carom.sim.entity.Entity;
import carom.sim.entity.HostEntity;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.event.EventKind;
import carom.sim.spawn.Origin;
import java.util.function.IntUnaryOperator;

/**
 * An event happens at one moment and is worth a sound, a flash or a line of text: a hit, a goal, a
 * jump. A game makes one with {@code Simulation.emit} and fills it in. The server sends it to each
 * client that may know of it, and each client shows it exactly once.
 *
 * <p>Events are output only. They are no part of the state, are neither hashed nor saved, and
 * nothing may depend on them. The object is mutable and reused: a listener reads it and does not
 * keep it.
 */
public final class Event {
  /** Stands for no player or no entity. */
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

  /** Creates an empty event, to be filled in by {@link #set}. */
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

  /** Sets where it happens, in metres; (0, 0) by default. */
  public Event at(float newX, float newY) {
    x = newX;
    y = newY;
    return this;
  }

  /** Sets the entity to which it happens. Static level geometry counts as {@link #NONE}. */
  public Event of(Entity entity) {
    first = key(entity);
    return this;
  }

  /** Sets the other entity that takes part. Static level geometry counts as {@link #NONE}. */
  public Event with(Entity entity) {
    second = key(entity);
    return this;
  }

  /**
   * Sets the player who caused it, or null. That player's client shows the event when it predicts
   * it.
   */
  public Event by(Player cause) {
    player = cause == null ? NONE : cause.id();
    return this;
  }

  /** Sets how strong it is, in a unit of the kind's own. Clients receive eight significant bits. */
  public Event strength(float value) {
    strength = value;
    return this;
  }

  /** Sets a number with a meaning of the kind's own, such as a team. */
  public Event data(int value) {
    data = value;
    return this;
  }

  /**
   * Sets the audience. The default is {@link Audience#NEAR}: clients that look at the place and may
   * know the entities and the body of the player in {@link #by}. {@link Audience#TEAM} and {@link
   * Audience#OWNER} mean the team and the client of that player. That client always receives the
   * event, except for {@link Audience#NOBODY}.
   */
  public Event to(Audience newAudience) {
    audience = Limits.notNull("audience", newAudience);
    return this;
  }

  private static int key(Entity told) {
    HostEntity entity = (HostEntity) told;
    return entity == null || entity.isLevel() ? NONE : key(entity.id(), entity.generation());
  }

  /** Returns a key of an entity: its id and, above 16 bits, its generation. */
  public static int key(int id, int generation) {
    return id | generation << 16;
  }

  /**
   * Sets all values but the audience, which becomes {@link Audience#NEAR}.
   *
   * @param newKind its kind
   * @param newTick the tick in which it happens
   * @param newPlayer 0..1,023 or {@link #NONE}
   * @param newFirst a {@link #key} or {@link #NONE}
   * @param newSecond a {@link #key} or {@link #NONE}
   * @param newX metres
   * @param newY metres
   * @param newStrength in a unit of the kind's own
   * @param newData a number of the kind's own
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

  /** Copies another event. */
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
   * Returns whether two events may be the same happening, computed twice. Their kinds, players and
   * entities are equal; place, tick and strength may differ.
   */
  public boolean isLike(Event other) {
    return kind == other.kind
        && player == other.player
        && ((first == other.first && second == other.second)
            || (first == other.second && second == other.first));
  }

  /**
   * Returns whether this event, which a prediction computed, may be the same as one of the server,
   * which knows other keys of the entities that the own input has spawned.
   *
   * @param other the server's, or another predicted one
   * @param origins returns the {@link Origin} of the entity of a key, if the key is known to be
   *     that of such an entity, or {@link Origin#NONE}
   */
  public boolean isLike(Event other, IntUnaryOperator origins) {
    return kind == other.kind
        && player == other.player
        && ((isSame(first, other.first, origins) && isSame(second, other.second, origins))
            || (isSame(first, other.second, origins) && isSame(second, other.first, origins)));
  }

  /** Returns whether two keys may mean the same entity; one that lived too short was never told. */
  private static boolean isSame(int key, int other, IntUnaryOperator origins) {
    if (key == other) {
      return true;
    }
    int origin = Origin.isProvisional(key) ? key : origins.applyAsInt(key);
    if (!Origin.isProvisional(origin) || other == NONE) {
      return false;
    }
    int otherOrigin = Origin.isProvisional(other) ? other : origins.applyAsInt(other);
    return otherOrigin == origin || (otherOrigin == Origin.NONE && origin == key);
  }

  // ---- read by a listener

  /** Returns its kind. */
  public EventKind kind() {
    return kind;
  }

  /** Returns the tick in which it happens. */
  public int tick() {
    return tick;
  }

  /** Returns the id of the player who caused it, or {@link #NONE}. */
  public int player() {
    return player;
  }

  /** Returns the {@link #key} of the entity to which it happens, or {@link #NONE}. */
  public int first() {
    return first;
  }

  /** Returns the {@link #key} of the other entity that takes part, or {@link #NONE}. */
  public int second() {
    return second;
  }

  /** Returns where it happens, in metres to the right. */
  public float x() {
    return x;
  }

  /** Returns where it happens, in metres upwards. */
  public float y() {
    return y;
  }

  /** Returns how strong it is, in a unit of the kind's own. */
  public float strength() {
    return strength;
  }

  /** Returns a number with a meaning of the kind's own. */
  public int data() {
    return data;
  }

  /** Returns which clients receive it. */
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
