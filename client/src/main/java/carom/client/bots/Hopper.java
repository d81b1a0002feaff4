package carom.client.bots;

import carom.client.view.ClientView.Drawn;
import carom.sim.entity.Input;
import carom.sim.level.Level;

/** Walks and jumps from foothold to foothold of a level seen from the side. One bot's. */
final class Hopper {
  private static final float FEET = 0.7f; // below the middle, m
  private static final float ON_CRATES = 6;
  private static final int JUMP_TICKS = 10;
  private static final int PATIENCE_TICKS = 100;
  private static final int DETOUR_TICKS = 40;

  private final float rise;
  private final float reach;
  private final boolean jumpsTwice;
  private Footholds footholds;
  private Level level;
  private int next = -1; // foothold that it jumps to
  private float lastVelocityY;
  private int steady;
  private int jumpedAt;
  private boolean jumps;
  private float markX;
  private float markY;
  private int markTick;

  /**
   * Creates a hopper.
   *
   * @param rise of a jump, or of two, with a margin, metres
   * @param reach of a jump, or of two, to the same height, metres
   * @param jumpsTwice whether a second jump works in the air
   */
  Hopper(float rise, float reach, boolean jumpsTwice) {
    this.rise = rise;
    this.reach = reach;
    this.jumpsTwice = jumpsTwice;
  }

  /** Returns the footholds of the level that is shown. */
  Footholds footholds(Senses s) {
    if (level != s.view().level()) {
      level = s.view().level();
      footholds = new Footholds(s.view(), rise, reach);
      next = -1;
    }
    return footholds;
  }

  /**
   * Walks or jumps on towards a foothold, and back to the nearest one out of the air.
   *
   * @param side to which it goes while it is stuck, -1 or 1
   */
  void go(Senses s, int goal, int side, Input out) {
    Drawn own = s.own();
    float feet = own.y() - FEET;
    int here = footholds.nearest(own.x(), feet);
    steady = Math.abs(own.velocityY() - lastVelocityY) < 0.2f ? steady + 1 : 0;
    boolean stands = steady > 2 && s.tick() - jumpedAt > JUMP_TICKS; // the picture may lag
    float above = feet - footholds.y(here); // of ground, or on a crate that stands on it
    boolean isThere =
        Math.abs(footholds.x(here) - own.x()) < 0.9f && above > -0.5f && above < ON_CRATES;
    if (stands && isThere) {
      next = footholds.next(here, goal);
    } else if (stands || next < 0 || next >= footholds.count() || isLost(feet)) {
      next = here; // on a moving stage, or thrown off
    }
    float dx = footholds.x(next) - own.x();
    float rise = footholds.y(next) - feet;
    out.move(Math.abs(dx) < 0.2f ? 0 : Math.max(-1, Math.min(1, 1.5f * dx)), 0);
    boolean walks = isThere && Math.abs(dx) < 1.8f && Math.abs(rise) < 0.7f;
    boolean isStuck = isStuck(s);
    if (isStuck) {
      out.move(side, 0);
      walks = false;
    }
    boolean below = !isStuck && rise < -0.7f && Math.abs(dx) < 1.6f;
    boolean falls = own.velocityY() < 1 && rise > (Math.abs(dx) > 1.5f ? -1 : 0.2f); // short
    boolean jump = stands ? !walks && !below : falls && jumpsTwice;
    int since = Math.abs(s.tick() - jumpedAt);
    if (jump && since > JUMP_TICKS && !jumps) { // a jump is a press, and the second another
      jumpedAt = s.tick();
      since = 0;
    }
    jumps = since < JUMP_TICKS || (jumps && own.velocityY() > 0 && rise > -0.3f);
    out.hold(Input.JUMP, jumps);
    out.hold(Input.DOWN, below && stands);
    lastVelocityY = own.velocityY();
  }

  /** Returns whether it has hardly moved for a while, so that it should jump away for a moment. */
  private boolean isStuck(Senses s) {
    int since = s.tick() - markTick;
    boolean moved = Math.hypot(s.own().x() - markX, s.own().y() - markY) > 2;
    if (moved || since < 0 || since > PATIENCE_TICKS + DETOUR_TICKS) {
      markX = s.own().x();
      markY = s.own().y();
      markTick = s.tick();
      return false;
    }
    return since > PATIENCE_TICKS;
  }

  /** Returns whether it falls below where it wanted to go. */
  private boolean isLost(float feet) {
    return feet < footholds.y(next) - 5;
  }
}
