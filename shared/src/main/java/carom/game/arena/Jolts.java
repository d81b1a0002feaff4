package carom.game.arena;

import static carom.game.arena.ArenaFields.GLOW;
import static carom.game.arena.ArenaFields.MAX_SPARKS;
import static carom.game.arena.ArenaFields.SPARK;

import carom.physics.math.Trig;
import carom.sim.Match;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityFilter;
import carom.sim.entity.EntityHit;
import carom.sim.entity.Player;

/** Jolts: pushes from afar, judged by what the player saw, and the sparks that show them. */
final class Jolts {
  private static final float SPARK_SECONDS = 0.2f;

  private final Pitch pitch;
  private final EntityHit hit = new EntityHit();
  private final EntityFilter inTheWay = this::isInTheWay;
  private Entity jolter;

  Jolts(Pitch pitch) {
    this.pitch = pitch;
  }

  /** Pushes the body that the player saw in front of it, where that body is now. */
  void give(Match m, Player p) {
    jolter = p.entity();
    float wayX = ArenaGame.JOLT_RANGE * Trig.cos(m.input(p).aim());
    float wayY = ArenaGame.JOLT_RANGE * Trig.sin(m.input(p).aim());
    boolean any = m.asSeenBy(p).rayClosest(jolter.x(), jolter.y(), wayX, wayY, inTheWay, hit);
    if (!any) {
      return;
    }
    Entity target = hit.entity();
    if (target.isDynamic()) {
      float scale = ArenaGame.JOLT_IMPULSE / ArenaGame.JOLT_RANGE;
      target.applyImpulse(wayX * scale, wayY * scale);
    }
    m.emit(pitch.joltHit).at(hit.x(), hit.y()).of(target).by(p).strength(ArenaGame.JOLT_IMPULSE);
    showSpark(m, p, hit.x(), hit.y());
  }

  private boolean isInTheWay(Entity e) {
    return e != jolter;
  }

  /**
   * Shows all players where a jolt has hit, for a moment or until the player leaves. When there are
   * too many sparks, the oldest one goes.
   */
  private void showSpark(Match m, Player p, float x, float y) {
    int oldest = 0;
    for (int i = 0; i < MAX_SPARKS; i++) {
      oldest = glow(m, i) < glow(m, oldest) ? i : oldest;
    }
    if (m.get(SPARK, oldest) != null) {
      m.get(SPARK, oldest).despawn();
    }
    Entity shown = m.spawn(pitch.spark, x, y, 0, p);
    shown.set(GLOW, m.ticks(SPARK_SECONDS));
    m.set(SPARK, oldest, shown);
  }

  /** Returns the ticks that a spark still glows, 0 if there is none. */
  private static int glow(Match m, int i) {
    Entity shown = m.get(SPARK, i);
    return shown == null ? 0 : shown.get(GLOW);
  }

  /** Removes the sparks whose time is over. */
  static void fadeSparks(Match m) {
    for (int i = 0; i < MAX_SPARKS; i++) {
      Entity shown = m.get(SPARK, i);
      if (shown != null && shown.get(GLOW) == 0) {
        shown.despawn();
      }
    }
  }
}
