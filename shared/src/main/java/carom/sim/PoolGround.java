package carom.sim;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.math.Trig;
import carom.sim.level.Archetype;
import carom.sim.level.Archetypes;
import carom.sim.level.Level;
import carom.sim.pool.Pools;
import java.util.ArrayList;
import java.util.List;

/**
 * The bodies with which the particles of pools collide: the level's statics, and its kinematic
 * bodies, which move on their paths or spin, also after the game changed them. A function of the
 * level and the tick alone, in a world of its own.
 */
final class PoolGround {
  private final World<Object> world;
  private final int tickRate;
  private final List<Body<Object>> moving = new ArrayList<>();
  private final List<Archetype> kinds = new ArrayList<>();
  private final List<Level.Placement> places = new ArrayList<>();

  private PoolGround(WorldDef def, Level level, Archetypes archetypes, int tickRate) {
    world = new World<>(def);
    this.tickRate = tickRate;
    for (Level.Placement p : level.statics()) {
      world.createBody(archetypes.get(p.archetype()).body(p.x(), p.y(), p.angle()), null);
    }
    for (Level.Placement p : level.bodies()) {
      Archetype kind = archetypes.get(p.archetype());
      if (kind.type() == BodyType.KINEMATIC && !kind.sensor()) {
        moving.add(world.createBody(kind.body(p.x(), p.y(), p.angle()), null));
        kinds.add(kind);
        places.add(p);
      }
    }
  }

  /** Ends the declaration of pools, and gives them the ground of a level. */
  public static void begin(
      Pools pools, WorldDef def, Level level, Archetypes archetypes, int tickRate) {
    if (pools.count() == 0) {
      pools.begin(null, tick -> {}, false);
      return;
    }
    PoolGround ground = new PoolGround(def, level, archetypes, tickRate);
    pools.begin(ground.world, ground::drive, ground.moves());
  }

  private boolean moves() {
    for (Archetype kind : kinds) {
      if (kind.motion() != null || kind.spin() != 0) {
        return true;
      }
    }
    return false;
  }

  private void drive(int tick) {
    for (int i = 0; i < moving.size(); i++) {
      Body<Object> body = moving.get(i);
      Archetype kind = kinds.get(i);
      if (kind.spin() != 0) {
        int turn = Math.max(1, Math.round(tickRate * 2 * Trig.PI / Math.abs(kind.spin())));
        float angle = places.get(i).angle() + (tick - 1) % turn * kind.spin() / tickRate;
        body.setPose(body.x(), body.y(), Trig.cos(angle), Trig.sin(angle));
      }
      if (kind.motion() != null) {
        kind.motion().drive(body, tick, tickRate);
      }
    }
  }
}
