package carom.server.lobby;

import carom.server.account.AccountService;
import carom.server.account.AccountValues;
import carom.server.account.PlayerSkill;
import carom.server.room.BySkill;
import carom.server.room.FillUp;
import carom.server.room.FleetDoor;
import carom.server.room.RoomOffer;
import carom.server.room.RoomSearch;
import carom.server.session.RoomSkill;
import java.util.concurrent.CompletableFuture;

/**
 * A visitor's look for a room whose players are about as good. It widens with the time, and any
 * room will do when that is over. On the lobby's thread.
 */
final class SkillLook {
  private static final double NS_PER_S = 1e9;
  private static final long ACCOUNT_WAIT_NS = 2_000_000_000L;
  private static final long LOOK_NS = 100_000_000;
  private static final long TELL_NS = 1_000_000_000;

  private final int claim;
  private final CompletableFuture<AccountValues> asked;
  private final long waitNs;
  private long sinceNs;
  private long nextNs;
  private long tellNs;
  private PlayerSkill skill;

  private FleetDoor.Looker own; // or null

  private RoomSkill measure;
  private boolean over;

  /**
   * Begins a look.
   *
   * @param claim by a join token, or {@link PlayerSkill#NO_CLAIM}
   * @param account of the player, or empty
   * @param accounts reads what the account has; null without a store
   * @param waitNs longest time that it takes
   */
  SkillLook(int claim, String account, AccountService accounts, long waitNs, long nowNs) {
    this.claim = claim;
    this.waitNs = waitNs;
    asked =
        claim == PlayerSkill.NO_CLAIM && accounts != null && !account.isEmpty()
            ? accounts.valuesOf(account)
            : CompletableFuture.completedFuture(null);
    sinceNs = nowNs;
    nextNs = nowNs;
    tellNs = nowNs;
  }

  /**
   * Takes what the store of accounts has answered, or goes on without it after two seconds.
   *
   * @return whether the answer is awaited
   */
  boolean awaitSkill(long nowNs) {
    if (skill != null) {
      return false;
    }
    if (!asked.isDone() && nowNs - sinceNs < ACCOUNT_WAIT_NS) {
      return true;
    }
    boolean answered = asked.isDone() && !asked.isCompletedExceptionally();
    skill = new PlayerSkill(claim, answered ? asked.join() : null);
    sinceNs = nowNs;
    over = !skill.isKnown();
    return false;
  }

  /** Returns what is known of the player's skill, once nobody is asked. */
  PlayerSkill skill() {
    return skill;
  }

  /**
   * Returns the rule for now.
   *
   * @param begins whether the player goes to a room without others whose skill is known
   */
  RoomSearch search(FillUp fill, boolean begins, long nowNs) {
    return isOver(nowNs) ? fill : new BySkill(fill, skill, waitedS(nowNs), begins);
  }

  private double waitedS(long nowNs) {
    return (nowNs - sinceNs) / NS_PER_S;
  }

  /** Returns whether any room will do. */
  boolean isOver(long nowNs) {
    return over || nowNs - sinceNs >= waitNs;
  }

  /** Takes a turn to look again, and returns true, if it is time for one: a few times a second. */
  boolean takeTurn(long nowNs) {
    if (nowNs - nextNs < 0) {
      return false;
    }
    nextNs = nowNs + LOOK_NS;
    return true;
  }

  /**
   * Notes the room to which the player would go if skill didn't count. If nobody of a known skill
   * is there, the look is over: there is nobody to wait for.
   */
  void otherwise(RoomOffer room) {
    measure = room.skill();
    over = measure == null || measure.players() == 0;
    own =
        over
            ? null
            : new FleetDoor.Looker(
                room.game(), skill.in(room.game(), measure.field(), measure.start()));
  }

  /** Returns what others may know of the player while the look lasts, or null. */
  FleetDoor.Looker own() {
    return own;
  }

  /** Returns whether the player suits another one who looks elsewhere. */
  boolean suits(FleetDoor.Looker other, long nowNs) {
    return own != null
        && own.game().equals(other.game())
        && measure.joins(own.skill(), other.skill(), waitedS(nowNs));
  }

  /** Returns whether two players who look here suit each other. */
  boolean suits(SkillLook other, long nowNs) {
    return other.own != null && suits(other.own, nowNs) && other.suits(own, nowNs);
  }

  /** Takes what to tell the player now, once a second; null for nothing. */
  String takeNews(long nowNs) {
    if (nowNs - tellNs < 0) {
      return null;
    }
    tellNs = nowNs + TELL_NS;
    long left = Math.max(1, Math.round((waitNs - (nowNs - sinceNs)) / NS_PER_S));
    return "Looking for players of about your skill; in " + left + " s any room will do.";
  }
}
