package carom.sim.field;

import carom.physics.math.Limits;
import carom.sim.event.Audience;

/**
 * A field that players see: as a bar or a number of their own, over heads, as the clock of the
 * match, or as the score of each team. Return them from {@code Game.gauges}, in the order in which
 * they stand.
 *
 * <pre>{@code
 * List.of(Gauge.bar("health", HEALTH), Gauge.overHeads("health", HEALTH), Gauge.teamScore(GOALS))
 * }</pre>
 *
 * <p>Immutable. Each factory throws {@link IllegalArgumentException} for a field that clients can't
 * know, or of another scope than it shows.
 *
 * @param kind how it is shown
 * @param label what it is, in a word; empty for {@link Kind#CLOCK} and {@link Kind#TEAM_SCORE}
 * @param field where the value is
 */
public record Gauge(Kind kind, String label, Field<?> field) {
  /** The way in which a field is shown. */
  public enum Kind {
    /** A bar of the own player. */
    BAR,
    /** A small bar over the body of each player in sight. */
    OVER_HEADS,
    /** A number of the own player, or of the match. */
    NUMBER,
    /** The time left, in minutes and seconds, at the top. */
    CLOCK,
    /** The score of each team, at the top. */
    TEAM_SCORE
  }

  /**
   * Checks that players can be told.
   *
   * @throws IllegalArgumentException when the field is only for the server
   */
  public Gauge {
    Limits.notNull("kind", kind);
    Limits.notNull("label", label);
    Limits.notNull("field", field);
    if (field.audience() == Audience.NOBODY) {
      throw new IllegalArgumentException(
          "gauge \"" + label + "\": no player is told " + field.path() + "; declare it .to(OWNER)");
    }
  }

  /** Returns a bar of the own player, from the least value of a field to its greatest. */
  public static Gauge bar(String label, Count field) {
    return new Gauge(Kind.BAR, label, of(Scope.PLAYER, field));
  }

  /** Returns a bar of the own player, from 0 to 1. */
  public static Gauge bar(String label, Ratio field) {
    return new Gauge(Kind.BAR, label, of(Scope.PLAYER, field));
  }

  /** Returns a bar over the body of each player, from the least value to the greatest. */
  public static Gauge overHeads(String label, Count field) {
    return new Gauge(Kind.OVER_HEADS, label, of(Scope.PLAYER, field));
  }

  /** Returns a bar over the body of each player, from 0 to 1. */
  public static Gauge overHeads(String label, Ratio field) {
    return new Gauge(Kind.OVER_HEADS, label, of(Scope.PLAYER, field));
  }

  /** Returns a number of the own player or of the match; a {@link Countdown} shows seconds. */
  public static Gauge number(String label, IntField<?> field) {
    boolean known = Limits.notNull("field", field).scope() == Scope.MATCH;
    return new Gauge(Kind.NUMBER, label, of(known ? Scope.MATCH : Scope.PLAYER, field));
  }

  /** Returns the clock of a match whose time the game itself keeps, without a match clock. */
  public static Gauge clock(Countdown field) {
    return new Gauge(Kind.CLOCK, "", of(Scope.MATCH, field));
  }

  /** Returns the scores of teams; the field has several values, and the index is the team. */
  public static Gauge teamScore(Count field) {
    if (Limits.notNull("field", field).times() < 2) {
      throw new IllegalArgumentException(
          field.path() + " has one value; a team score needs .times(number of teams + 1)");
    }
    return new Gauge(Kind.TEAM_SCORE, "", of(Scope.MATCH, field));
  }

  private static Field<?> of(Scope scope, Field<?> field) {
    if (Limits.notNull("field", field).scope().holder() != scope) {
      throw new IllegalArgumentException(
          "a gauge shows " + scope + " here; " + field.path() + " is of " + field.scope());
    }
    return field;
  }

  /** Returns how full a bar is, 0..1. */
  public float share(FieldReader<?, ?> holder) {
    if (field instanceof Ratio ratio) {
      return holder.get(ratio);
    }
    Count count = (Count) field;
    return (holder.get(count) - (float) count.min()) / ((float) count.max() - count.min());
  }

  /** Returns the value of a number, ticks for a {@link Countdown}. */
  public int value(FieldReader<?, ?> holder) {
    return holder.get((IntField<?>) field);
  }

  /** Returns the score of a team, 0 if the field has no such index. */
  public int value(FieldReader<?, ?> match, int team) {
    return team < field.times() ? match.get((IntField<?>) field, team) : 0;
  }
}
