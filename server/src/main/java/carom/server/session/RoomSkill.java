package carom.server.session;

import carom.sim.Skill;

/**
 * The skill of the players in a room whose game names one. Immutable.
 *
 * @param field name of the account's field
 * @param start its value for a player who is new to the game
 * @param within as {@link Skill#within}
 * @param widening as {@link Skill#widening}
 * @param players how many have a known skill
 * @param mean their mean, 0 of none
 */
public record RoomSkill(String field, int start, int within, int widening, int players, int mean) {
  /** Returns the skill of a room in which there is nobody yet. */
  public static RoomSkill ofNobody(Skill skill) {
    return new RoomSkill(
        skill.field().name(), skill.field().start(), skill.within(), skill.widening(), 0, 0);
  }

  /** Returns the same with players. */
  RoomSkill with(int count, int newMean) {
    return new RoomSkill(field, start, within, widening, count, newMean);
  }

  /** Returns whether two players suit each other after one of them has waited for some time. */
  public boolean joins(int one, int other, double waitedS) {
    return Math.abs((long) one - other) <= within + widening * waitedS;
  }
}
