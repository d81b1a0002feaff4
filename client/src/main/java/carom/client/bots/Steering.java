package carom.client.bots;

import carom.client.view.ClientView;
import carom.sim.entity.Input;

/**
 * Walks a bot seen from above: towards a place, along walls instead of against them, and out of
 * where it is stuck. One bot's; allocates nothing.
 */
final class Steering {
  /** Directions that are tried. */
  private static final int DIRECTIONS = 16;

  /** Distance ahead at which a wall makes a direction bad, metres. */
  private static final float LOOK_AHEAD = 1.6f;

  /** A bot that moved less than this in {@link #PATIENCE_TICKS}, metres, is stuck. */
  private static final float STUCK_METRES = 0.7f;

  private static final int PATIENCE_TICKS = 80;

  /** Time for which a bot that was stuck goes another way, ticks. */
  private static final int DETOUR_TICKS = 50;

  private float markX;
  private float markY;
  private int markTick;
  private int detourUntil;
  private float detourX;
  private float detourY;

  /**
   * Moves towards a place.
   *
   * @param slow distance below which it walks slower, metres; 0 for never
   */
  void go(Senses s, float x, float y, float slow, Input out) {
    ClientView.Drawn own = s.own();
    float dx = x - own.x();
    float dy = y - own.y();
    float distance = Math.max(0.01f, (float) Math.hypot(dx, dy));
    float speed = Math.min(1, slow == 0 ? 1 : distance / slow);
    walk(s, dx / distance, dy / distance, speed, out);
  }

  /** Moves in a direction of length 1, or in the free one that is nearest to it. */
  void walk(Senses s, float wayX, float wayY, float speed, Input out) {
    boolean detour = isStuck(s, speed);
    float toX = detour ? detourX : wayX;
    float toY = detour ? detourY : wayY;
    float bestX = toX;
    float bestY = toY;
    float best = s.isWall(LOOK_AHEAD * toX, LOOK_AHEAD * toY) ? -0.5f : 2;
    for (int i = 0; i < DIRECTIONS && best < 2; i++) {
      double angle = 2 * Math.PI * i / DIRECTIONS;
      float x = (float) Math.cos(angle);
      float y = (float) Math.sin(angle);
      float value = x * toX + y * toY;
      if (value > best && !s.isWall(LOOK_AHEAD * x, LOOK_AHEAD * y)) {
        best = value;
        bestX = x;
        bestY = y;
      }
    }
    out.move(bestX * speed, bestY * speed);
  }

  /** Returns whether the bot goes a way round, because it hardly moved although it wanted to. */
  private boolean isStuck(Senses s, float speed) {
    int tick = s.tick();
    boolean another = tick < markTick || tick - markTick > 2 * PATIENCE_TICKS; // a match, a life
    if (another || tick - markTick >= PATIENCE_TICKS) {
      float moved = (float) Math.hypot(s.own().x() - markX, s.own().y() - markY);
      if (!another && speed > 0.5f && moved < STUCK_METRES) {
        detourUntil = tick + DETOUR_TICKS;
        double turn = s.random().between(-1, 1);
        double inwards = Math.atan2(-s.own().y(), -s.own().x());
        detourX = (float) Math.cos(inwards + turn);
        detourY = (float) Math.sin(inwards + turn);
      }
      markX = s.own().x();
      markY = s.own().y();
      markTick = tick;
      detourUntil = another ? 0 : detourUntil;
    }
    return tick < detourUntil;
  }
}
