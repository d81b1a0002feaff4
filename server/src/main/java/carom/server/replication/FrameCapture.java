package carom.server.replication;

import carom.net.protocol.Limits;
import carom.net.snapshot.FrameRing;
import carom.net.snapshot.FrameState;
import carom.physics.Body;
import carom.sim.Entity;
import carom.sim.Player;
import carom.sim.Simulation;

/**
 * Quantises the whole world once per tick into the ring of frame states that all sessions share.
 *
 * <p>The room's thread; no allocation but for frames that grow with the highest entity id.
 */
public final class FrameCapture {
  private final Simulation simulation;
  private final FrameRing ring;

  /** Creates an empty ring for a simulation's entities. */
  public FrameCapture(Simulation simulation) {
    this.simulation = simulation;
    this.ring = new FrameRing(Limits.MAX_ENTITIES);
  }

  /** Captures the state after the simulation's last step. */
  public FrameState capture() {
    FrameState frame = ring.begin(simulation.tick());
    for (int id = 0, count = simulation.entityCapacity(); id < count; id++) {
      Entity entity = simulation.entity(id);
      if (entity == null) {
        continue;
      }
      Body<Entity> body = entity.body();
      frame.put(
          id,
          entity.generation(),
          entity.archetype().index(),
          entity.ownerId(),
          body.x(),
          body.y(),
          body.angle(),
          body.velocityX(),
          body.velocityY(),
          body.angularVelocity());
    }
    for (int id = 0, count = simulation.playerCapacity(); id < count; id++) {
      Player player = simulation.player(id);
      if (player != null) {
        frame.putInput(id, player.input().pack());
      }
    }
    ring.end();
    return frame;
  }

  /** The captured frames. */
  public FrameRing frames() {
    return ring;
  }
}
