package carom.sim;

import carom.physics.math.Limits;
import carom.sim.field.Count;
import carom.sim.field.Scope;

/**
 * The skill of a game's players, by which a server may put those together who are about as good.
 * Immutable.
 *
 * <pre>{@code
 * static final Count RATING = Field.count("rating", 0, 4_000).of(ACCOUNT).to(ALL).startsAt(1_500);
 *
 * @Override public Skill skill() {
 *   return Skill.of(RATING).within(100).widening(30);
 * }
 * }</pre>
 *
 * @param field a field of the account; larger or smaller is better
 * @param within largest difference, in units of the field, at which a player goes to a room at
 *     once; 0 or more
 * @param widening units by which that grows in each second that the player waits; 0 or more
 */
public record Skill(Count field, int within, int widening) {
  /**
   * Checks the values.
   *
   * @throws IllegalArgumentException if the field isn't one value of an account, or a number is
   *     negative
   */
  public Skill {
    if (Limits.notNull("field", field).scope() != Scope.ACCOUNT || field.times() != 1) {
      throw new IllegalArgumentException(
          "field=" + field.name() + " of a skill must be one value of(ACCOUNT)");
    }
    if (within < 0 || widening < 0) {
      throw new IllegalArgumentException(
          "within=" + within + " and widening=" + widening + " of a skill must be 0 or more");
    }
  }

  /** Returns a skill of which only equal ones go together, until it is told otherwise. */
  public static Skill of(Count field) {
    return new Skill(field, 0, 0);
  }

  /** Returns the same skill with another difference at which a player goes to a room at once. */
  public Skill within(int difference) {
    return new Skill(field, difference, widening);
  }

  /** Returns the same skill with another growth of that difference in each second. */
  public Skill widening(int unitsPerSecond) {
    return new Skill(field, within, unitsPerSecond);
  }
}
