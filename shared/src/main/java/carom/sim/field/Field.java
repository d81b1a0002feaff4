package carom.sim.field;

import carom.physics.math.Limits;
import carom.sim.event.Audience;

/**
 * A piece of a game's state: what it is called, what it can hold, what has it, who is told, and how
 * it begins. Declare each as a constant and return it from {@code Game.fields}; Carom then stores,
 * hashes, saves, sends, predicts and rolls back its values.
 *
 * <pre>{@code
 * static final Count HEALTH = Field.count("health", 0, 100).of(PLAYER).to(ALL).startsAt(100);
 * static final Flag DOOR_OPEN = Field.flag("doorOpen").of(MATCH).to(ALL).times(4);
 *
 * p.add(HEALTH, -20);                // stops at 0
 * s.set(DOOR_OPEN, 2, true);         // the third door
 * }</pre>
 *
 * <p>What is {@code of(ACCOUNT)} lasts: the player's account keeps it from stay to stay.
 *
 * <p>Without more words a field belongs to each player, is told to players near, and begins at 0,
 * false, the first constant or nobody. Fields are immutable: each of {@link #of}, {@link #to},
 * {@link #times} and {@code startsAt} returns another one. Several simulations and games may share
 * a field. Any thread.
 *
 * @param <F> the kind of field
 */
public abstract class Field<F extends Field<F>> {
  /** Most characters of a name. */
  public static final int MAX_NAME = 32;

  /** Most values of one field. */
  public static final int MAX_TIMES = 65_536;

  /** Largest value of a {@link #count(String)} without a range. */
  public static final int MOST_COUNTED = 1_000_000_000;

  private static int created;

  private final int id = nextId();
  private final Spec spec;

  /** Creates a field that differs from its predecessor in what it is, who has it or who knows. */
  Field(Spec spec) {
    this.spec = spec;
  }

  /** The properties that all kinds of fields have; the limits are those of a word. */
  record Spec(
      String name,
      String range,
      int min,
      int max,
      int start,
      Scope scope,
      Audience audience,
      int times,
      boolean lowestIsBest) {
    Spec {
      Limits.notNull("name", name);
      Limits.notNull("scope", scope);
      Limits.notNull("audience", audience);
      if (!isName(name)) {
        throw new IllegalArgumentException(
            "field name=\""
                + name
                + "\" must be a letter a-z and then letters and digits, "
                + MAX_NAME
                + " at most, such as dashWait");
      }
      if (times < 1 || times > MAX_TIMES) {
        throw new IllegalArgumentException(
            "times=" + times + " of field " + name + " is outside 1.." + MAX_TIMES);
      }
    }

    static Spec of(String name, String range, int min, int max, int start) {
      return new Spec(name, range, min, max, start, Scope.PLAYER, Audience.NEAR, 1, false);
    }

    Spec of(Scope newScope) {
      return new Spec(name, range, min, max, start, newScope, audience, times, lowestIsBest);
    }

    Spec to(Audience newAudience) {
      return new Spec(name, range, min, max, start, scope, newAudience, times, lowestIsBest);
    }

    Spec times(int newTimes) {
      return new Spec(name, range, min, max, start, scope, audience, newTimes, lowestIsBest);
    }

    Spec lowestIsBest(boolean yes) {
      return new Spec(name, range, min, max, start, scope, audience, times, yes);
    }

    Spec startsAt(int newStart) {
      return new Spec(name, range, min, max, newStart, scope, audience, times, lowestIsBest);
    }

    private static boolean isName(String name) {
      boolean good = !name.isEmpty() && name.length() <= MAX_NAME;
      for (int i = 0; good && i < name.length(); i++) {
        char c = name.charAt(i);
        boolean lower = c >= 'a' && c <= 'z';
        good = lower || (i > 0 && ((c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9')));
      }
      return good;
    }
  }

  private static synchronized int nextId() {
    return created++;
  }

  /**
   * Creates a field for a whole number in a range, such as health, ammunition or a score.
   *
   * @param name a letter a-z and then letters and digits, {@value #MAX_NAME} at most
   * @param min smallest value
   * @param max largest value, above {@code min}
   * @throws IllegalArgumentException if the name or the range is no good
   */
  public static Count count(String name, int min, int max) {
    return Count.create(name, min, max);
  }

  /**
   * Creates a field for a whole number from 0 to {@value #MOST_COUNTED}, such as of wins or goals.
   * The name is as of {@link #count(String, int, int)}.
   */
  public static Count count(String name) {
    return Count.create(name, 0, MOST_COUNTED);
  }

  /** Creates a field for yes or no. The name is as of {@link #count}. */
  public static Flag flag(String name) {
    return new Flag(Spec.of(name, "flag", 0, 1, 0));
  }

  /**
   * Creates a field for one of an enum's constants, such as the phase of a match. The name is as of
   * {@link #count}.
   */
  public static <E extends Enum<E>> Choice<E> choice(String name, Class<E> type) {
    return Choice.create(name, type);
  }

  /**
   * Creates a field for a part of a whole, 0..1 in steps of 1/{@value Ratio#STEPS}, such as fuel.
   * The name is as of {@link #count}.
   */
  public static Ratio ratio(String name) {
    return ratio(name, Ratio.STEPS);
  }

  /**
   * Creates a field for a part of a whole, 0..1 in steps. Fewer steps take fewer bits. The name is
   * as of {@link #count}.
   *
   * @param steps 1..{@value Ratio#MAX_STEPS}
   * @throws IllegalArgumentException if the name or the number of steps is no good
   */
  public static Ratio ratio(String name, int steps) {
    return Ratio.create(name, steps);
  }

  /**
   * Creates a field for any {@code float}, kept to the last bit. It takes 32 bits, so a {@link
   * #count} or {@link #ratio} is better where one will do. The name is as of {@link #count}.
   */
  public static Real real(String name) {
    return new Real(Spec.of(name, "real", Integer.MIN_VALUE, Integer.MAX_VALUE, 0));
  }

  /**
   * Creates a field for a time in ticks that runs down by itself: set it to {@code s.ticks(1.5f)}
   * and it is 0 when the time is over. It changes, and is sent, only when it is set. The name is as
   * of {@link #count}.
   */
  public static Countdown countdown(String name) {
    return new Countdown(Spec.of(name, "countdown", 0, Integer.MAX_VALUE, 0));
  }

  /**
   * Creates a field for an entity. It is null at first, and when the entity is gone. The name is as
   * of {@link #count}.
   */
  public static EntityRef entity(String name) {
    return new EntityRef(Spec.of(name, "entity", 0, EntityRef.MOST, 0));
  }

  /**
   * Creates a field for a player. It is null at first, and when the player has left. The name is as
   * of {@link #count}.
   */
  public static PlayerRef player(String name) {
    return new PlayerRef(Spec.of(name, "player", 0, PlayerRef.MOST, 0));
  }

  /** Returns whether a value means the same in another match. */
  boolean lasts() {
    return true;
  }

  /** Creates a field of the same kind with another specification. */
  abstract F with(Spec changed);

  /**
   * Returns the same field for another scope.
   *
   * @throws IllegalArgumentException if an account can't keep it: an entity, a player and a tick
   *     mean something in their match alone
   */
  public final F of(Scope scope) {
    if (scope == Scope.ACCOUNT && !lasts()) {
      throw new IllegalArgumentException(
          "field "
              + spec.name
              + " is of kind \""
              + spec.range
              + "\", which means something in its match alone; an account keeps count, flag,"
              + " choice, ratio and real");
    }
    return with(spec.of(scope));
  }

  /**
   * Returns the same field for another audience. {@link Audience#NOBODY} keeps it on the server.
   */
  public final F to(Audience audience) {
    return with(spec.to(audience));
  }

  /**
   * Returns the same field with several values, which have the indices 0..count-1.
   *
   * @param count 1..{@value #MAX_TIMES}
   * @throws IllegalArgumentException if the count is outside its range
   */
  public final F times(int count) {
    return with(spec.times(count));
  }

  /**
   * Returns the same field with another start, which a level file gives.
   *
   * @param value a {@code Double}, {@code Boolean} or {@code String}
   * @throws IllegalArgumentException if the field can't begin with that
   */
  public F startsFrom(Object value) {
    throw new IllegalArgumentException(
        path() + "=" + value + " can't be set by a level; set it in Game.setUp");
  }

  /** Returns whether another field differs in nothing but its start. */
  final boolean isLike(Field<?> other) {
    return getClass() == other.getClass() && spec.equals(other.spec.startsAt(spec.start));
  }

  /** Returns the same field with another word to start with, which must be in its range. */
  final F startingWith(int word) {
    return with(spec.startsAt(word));
  }

  /** Returns the name, which is unique in its scope. */
  public final String name() {
    return spec.name;
  }

  /** Returns what has a value of the field. */
  public final Scope scope() {
    return spec.scope;
  }

  /** Returns the kind and its range, such as {@code count 0..100}. */
  public final String range() {
    return spec.range;
  }

  /** Returns whether the lowest value is the first of a best list, and not the highest. */
  public final boolean isLowestBest() {
    return spec.lowestIsBest;
  }

  /**
   * Returns whether there is a best list of it: of whole numbers of accounts that all are told.
   * Accounts that have the start aren't in it.
   */
  public final boolean isListed() {
    return spec.scope == Scope.ACCOUNT
        && spec.audience == Audience.ALL
        && spec.times == 1
        && this instanceof Count;
  }

  /** Returns the same specification, in which the lowest value is the best. */
  final Spec lowestBest() {
    return spec.lowestIsBest(true);
  }

  /** Returns which players are told the value. */
  public final Audience audience() {
    return spec.audience;
  }

  /** Returns the number of values, 1 unless {@link #times} says otherwise. */
  public final int times() {
    return spec.times;
  }

  /** Returns the smallest word, which is the value as the kind stores it. */
  public final int min() {
    return spec.min;
  }

  /** Returns the largest word. */
  public final int max() {
    return spec.max;
  }

  /** Returns the word with which each value begins. */
  public final int start() {
    return spec.start;
  }

  /** Returns the number of bits that hold every word of the range, 1..32. */
  public final int bits() {
    return Math.max(1, 64 - Long.numberOfLeadingZeros((long) spec.max - spec.min));
  }

  /** Returns a number that no other field of this process has. */
  final int id() {
    return id;
  }

  /** Returns scope and name, such as {@code player.health}. */
  public final String path() {
    return spec.scope.label() + "." + spec.name;
  }

  /**
   * Returns a word as people read it.
   *
   * @param word in {@link #min}..{@link #max}
   */
  public abstract String show(int word);

  /**
   * Returns what a word means to programs that don't know the field: a Boolean, an Integer, a Float
   * or the name of a choice's constant; of a countdown the tick at which it is over, of a player or
   * an entity its id or -1.
   */
  public Object value(int word) {
    return word;
  }

  /** Returns the declaration in one line, such as {@code player.health count 0..100 to ALL}. */
  @Override
  public final String toString() {
    return path()
        + " "
        + spec.range
        + (spec.times == 1 ? "" : " x" + spec.times)
        + " to "
        + spec.audience
        + (spec.start == 0 ? "" : " starts " + show(spec.start))
        + (spec.lowestIsBest ? " lowest best" : "");
  }

  /** Returns an exception about a value that the field can't hold. */
  final IllegalArgumentException outside(Object value, String hint) {
    return new IllegalArgumentException(path() + "=" + value + " is outside " + spec.range + hint);
  }
}
