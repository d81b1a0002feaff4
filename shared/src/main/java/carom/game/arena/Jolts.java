package carom.game.arena;

import static carom.game.arena.ArenaFields.GLOW;
import static carom.game.arena.ArenaFields.MAX_SPARKS;
import static carom.game.arena.ArenaFields.SPARK;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.QueryFilter;
import carom.physics.QueryHit;
import carom.physics.math.Trig;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;

/** Jolts: pushes from afar, judged by what the player saw, and the sparks that show them. */
final class Jolts {
  private static final float SPARK_SECONDS = 0.2f;

  private final Pitch pitch;
  private final QueryHit<HostEntity> hit = new QueryHit<>();
  private final QueryFilter<HostEntity> inTheWay = this::isInTheWay;
  private Body<HostEntity> jolter;

  Jolts(Pitch pitch) {
    this.pitch = pitch;
  }

  /** Pushes the body that the player saw in front of it, where that body is now. */
  void give(SimulationHost s, HostPlayer p) {
    jolter = p.body().body();
    float wayX = ArenaGame.JOLT_RANGE * Trig.cos(p.input().aim());
    float wayY = ArenaGame.JOLT_RANGE * Trig.sin(p.input().aim());
    boolean any = s.asSeenBy(p).rayClosest(jolter.x(), jolter.y(), wayX, wayY, inTheWay, hit);
    if (!any) {
      return;
    }
    Body<HostEntity> target = hit.body();
    if (target.type() == BodyType.DYNAMIC) {
      float scale = ArenaGame.JOLT_IMPULSE / ArenaGame.JOLT_RANGE;
      target.applyImpulse(wayX * scale, wayY * scale);
    }
    s.emit(pitch.joltHit)
        .at(hit.x(), hit.y())
        .of(target.user())
        .by(p)
        .strength(ArenaGame.JOLT_IMPULSE);
    showSpark(s, p, hit.x(), hit.y());
  }

  private boolean isInTheWay(Body<HostEntity> body, int shape) {
    return body != jolter && !body.sensor(shape);
  }

  /**
   * Shows all players where a jolt has hit, for a moment or until the player leaves. When there are
   * too many sparks, the oldest one goes.
   */
  private void showSpark(SimulationHost s, HostPlayer p, float x, float y) {
    int oldest = 0;
    for (int i = 0; i < MAX_SPARKS; i++) {
      oldest = glow(s, i) < glow(s, oldest) ? i : oldest;
    }
    if (s.get(SPARK, oldest) != null) {
      s.despawn(s.get(SPARK, oldest));
    }
    HostEntity shown = s.spawn(pitch.spark, x, y, 0, p);
    shown.set(GLOW, s.ticks(SPARK_SECONDS));
    s.set(SPARK, oldest, shown);
  }

  /** Returns the ticks that a spark still glows, 0 if there is none. */
  private static int glow(SimulationHost s, int i) {
    HostEntity shown = s.get(SPARK, i);
    return shown == null ? 0 : shown.get(GLOW);
  }

  /** Removes the sparks whose time is over. */
  static void fadeSparks(SimulationHost s) {
    for (int i = 0; i < MAX_SPARKS; i++) {
      HostEntity shown = s.get(SPARK, i);
      if (shown != null && shown.get(GLOW) == 0) {
        s.despawn(shown);
      }
    }
  }
}
