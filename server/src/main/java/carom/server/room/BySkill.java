package carom.server.room;

import carom.server.account.PlayerSkill;
import carom.server.session.RoomSkill;

/**
 * Fills up those rooms whose players are about as good as the newcomer: the longer that one has
 * waited, the more they may differ. Rooms of games without a skill are filled up as ever.
 *
 * @param fill chooses among the rooms that suit
 * @param skill of the newcomer, which is known
 * @param waitedS time for which the newcomer has waited, s
 * @param begins whether the newcomer goes to rooms without players of a known skill, too
 */
public record BySkill(FillUp fill, PlayerSkill skill, double waitedS, boolean begins)
    implements RoomSearch {
  @Override
  public int fit(RoomOffer room) {
    RoomSkill there = room.skill();
    boolean suits =
        there == null
            || (there.players() == 0
                ? begins
                : there.joins(
                    skill.in(room.game(), there.field(), there.start()), there.mean(), waitedS));
    return suits ? fill.fit(room) : -1;
  }
}
