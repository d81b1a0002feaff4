package carom.client.bots;

import carom.client.view.ClientView.Drawn;
import carom.sim.entity.Input;

/**
 * Plays {@code platformer}: jumps from foothold to foothold to the coin that is nearest, or to the
 * flag where that is worth it, and to another once it gets no nearer.
 */
final class PlatformerBrain extends GradedBrain {
  private static final float FEET = 0.7f; // below the middle, m
  private static final int PATIENCE_TICKS = 240;

  private final Hopper hopper = new Hopper(2.8f, 5.5f, false);
  private int side = 1;
  private boolean dawdles;
  private float goalX;
  private float goalY;
  private int goalTick;

  /** Creates a bot of a strength, null for one by chance. */
  PlatformerBrain(Strength strength) {
    super("platformer", strength);
  }

  @Override
  void play(Senses s, Strength strength, Input out) {
    if (changesMind(s, 40)) {
      side = s.random().nextInt(2) == 0 ? 1 : -1;
      dawdles = s.random().nextFloat() < strength.of(0.45f, 0.2f, 0);
    }
    Footholds footholds = hopper.footholds(s);
    if (footholds.count() == 0) {
      return;
    }
    int since = s.tick() - goalTick;
    Drawn goal = at(s);
    if (goal == null || since < 0 || since > PATIENCE_TICKS) {
      goal = choose(s, strength, since > PATIENCE_TICKS);
      goalTick = s.tick();
    }
    if (goal != null) {
      goalX = goal.x();
      goalY = goal.y();
    }
    int foothold =
        goal == null
            ? footholds.nearest(8 * side, s.own().y())
            : footholds.nearest(goalX, goalY - FEET);
    hopper.go(s, foothold, side, out);
    boolean isBelow = goal != null && Math.abs(goalX - s.own().x()) < 1 && goalY > s.own().y();
    if (isBelow && Math.abs(s.own().velocityY()) < 0.5f) {
      out.hold(Input.JUMP, s.tick() % 20 < 12);
    }
    if (dawdles) {
      out.move(0.3f * out.moveX(), 0);
    }
  }

  /** Returns what lies where it goes to, or null if somebody took it. */
  private Drawn at(Senses s) {
    for (int i = 0; i < s.view().entityCount(); i++) {
      Drawn thing = s.view().entity(i);
      if (isWanted(thing) && thing.x() == goalX && thing.y() == goalY) {
        return thing;
      }
    }
    return null;
  }

  private static boolean isWanted(Drawn thing) {
    String name = thing.archetype().name();
    return name.equals("coin") || name.equals("flag");
  }

  /**
   * Returns the coin or flag that is worth most for its way; any but the last one if that failed.
   */
  private Drawn choose(Senses s, Strength strength, boolean failed) {
    Drawn best = null;
    float least = Float.MAX_VALUE;
    for (int i = 0; i < s.view().entityCount(); i++) {
      Drawn thing = s.view().entity(i);
      boolean isLast = failed && thing.x() == goalX && thing.y() == goalY;
      if (isWanted(thing) && !isLast) {
        float worth = thing.archetype().name().equals("flag") ? strength.of(1, 3, 8) : 1;
        float climb = Math.max(0, thing.y() - s.own().y());
        float cost =
            (s.distance(thing) + 2 * climb) / worth + (failed ? 6 * s.random().nextFloat() : 0);
        if (cost < least) {
          least = cost;
          best = thing;
        }
      }
    }
    return best;
  }
}
