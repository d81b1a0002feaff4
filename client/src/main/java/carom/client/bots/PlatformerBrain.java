package carom.client.bots;

import carom.client.view.ClientView.Drawn;
import carom.game.platformer.PlatformerFields;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import java.util.Set;

/**
 * Plays {@code platformer}: jumps from foothold to foothold to the coin that is nearest, or to the
 * flag or the goal where that is worth it, and to another once it gets no nearer. It jumps on foes.
 */
final class PlatformerBrain extends GradedBrain {
  private static final Set<String> FOES = Set.of("walker", "hunter");
  private static final float FEET = 0.7f; // below the middle, m
  private static final int PATIENCE_TICKS = 240;
  private static final int LOOK_TICKS = 20; // on the way to the goal, for coins
  private static final int HOP_TICKS = 12;
  private static final float HOP = 2.6f; // before a foe, m

  private final Hopper hopper = new Hopper(2.8f, 5.5f, false);
  private int side = 1;
  private boolean dawdles;
  private boolean isAlert;
  private boolean runs; // to the goal
  private int hopTick;
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
      isAlert = s.random().nextFloat() < strength.of(0.3f, 0.7f, 1);
      dawdles = s.random().nextFloat() < strength.of(0.45f, 0.2f, 0);
    }
    Footholds footholds = hopper.footholds(s);
    if (footholds.count() == 0) {
      return;
    }
    int since = s.tick() - goalTick;
    Drawn goal = runs ? null : at(s);
    if ((goal == null && !runs) || since < 0 || since > (runs ? LOOK_TICKS : PATIENCE_TICKS)) {
      Level.Zone end = end(s);
      float most = end == null ? Footholds.UNREACHED : strength.of(16, 11, 7);
      footholds.measureFrom(footholds.nearest(s.own().x(), s.own().y() - FEET));
      goal = choose(s, footholds, strength, most, !runs && since > PATIENCE_TICKS);
      goalTick = s.tick();
      runs = goal == null && end != null;
      if (runs) {
        goalX = (end.minX() + end.maxX()) / 2;
        goalY = end.minY() + FEET;
      } else if (goal != null) {
        goalX = goal.x();
        goalY = goal.y();
      }
    }
    int foothold =
        goal == null && !runs
            ? footholds.nearest(8 * side, s.own().y())
            : footholds.nearest(goalX, goalY - FEET);
    hopper.go(s, foothold, side, out);
    if (isAlert) {
      meetFoe(s, out);
    }
    boolean isBelow = goal != null && Math.abs(goalX - s.own().x()) < 1 && goalY > s.own().y();
    if (isBelow && Math.abs(s.own().velocityY()) < 0.5f) {
      out.hold(Input.JUMP, s.tick() % 20 < 12);
    }
    if (dawdles) {
      out.move(0.3f * out.moveX(), 0);
    }
  }

  /** Jumps before a foe, and comes down on it. */
  private void meetFoe(Senses s, Input out) {
    Drawn foe = null;
    for (int i = 0; i < s.view().entityCount(); i++) {
      Drawn e = s.view().entity(i);
      boolean isFoe = FOES.contains(e.archetype().name());
      if (isFoe && (foe == null || s.distance(e) < s.distance(foe))) {
        foe = e;
      }
    }
    if (foe == null) {
      return;
    }
    float dx = foe.x() - s.own().x();
    float dy = foe.y() - s.own().y();
    boolean meets = dx * (out.moveX() * 8 - foe.velocityX()) > 0; // they come nearer
    int since = s.tick() - hopTick;
    if (Math.abs(dy) < 0.8f && Math.abs(dx) < HOP && meets && (since > 40 || since < 0)) {
      hopTick = s.tick();
      since = 0;
    }
    boolean hops = since >= 0 && since < HOP_TICKS;
    out.hold(Input.JUMP, hops || out.held(Input.JUMP));
    if (dy < -0.9f && dy > -4 && Math.abs(dx) < 3 && Math.abs(s.own().velocityY()) > 0.5f) {
      out.move(Math.max(-1, Math.min(1, 2 * dx)), 0);
    }
  }

  /** Returns where the run ends that the bot is in, or may begin; null if there is none. */
  private static Level.Zone end(Senses s) {
    Level level = s.view().level();
    if (level.zones("goal").isEmpty() || !level.spawns("flag").isEmpty()) {
      return null; // flags are nearer
    }
    boolean begins = level.zones("start").get(0).contains(s.own().x(), s.own().y());
    return begins || s.player().get(PlatformerFields.RUN) > 0 ? level.zones("goal").get(0) : null;
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
   * Returns the coin or flag that is worth most for its way, if that costs less than the most; any
   * but the last one if that failed.
   */
  private Drawn choose(
      Senses s, Footholds footholds, Strength strength, float most, boolean failed) {
    Drawn best = null;
    float least = most;
    for (int i = 0; i < s.view().entityCount(); i++) {
      Drawn thing = s.view().entity(i);
      boolean isLast = failed && thing.x() == goalX && thing.y() == goalY;
      if (isWanted(thing) && !isLast) {
        int foothold = footholds.nearest(thing.x(), thing.y() - FEET);
        boolean isOut = Math.abs(footholds.x(foothold) - thing.x()) > 1.5f; // over a pit
        float worth = thing.archetype().name().equals("flag") ? strength.of(1, 3, 8) : 1;
        float way = isOut ? Footholds.UNREACHED : footholds.way(foothold);
        if (way < Footholds.UNREACHED && way / worth < least) {
          least = way / worth;
          best = thing;
        }
      }
    }
    return best;
  }
}
