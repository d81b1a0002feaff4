package carom.server.replication;

import carom.net.snapshot.exact.OwnState;
import carom.physics.Body;
import carom.sim.Entity;
import carom.sim.Player;
import carom.sim.Simulation;
import java.util.function.Predicate;

/**
 * Reads from the simulation the exact state of a player's body and its memory, which its client
 * needs to predict. The room's thread; shared by its sessions; no allocation.
 */
public final class OwnCapture {
  private final Simulation simulation;
  private final NearSet.Marks marks = new NearSet.Marks();

  /** Creates a reader of a room's simulation. */
  public OwnCapture(Simulation simulation) {
    this.simulation = simulation;
  }

  /**
   * Makes what chooses who is near one player.
   *
   * @param mayKnow whether the game lets that player know of an entity, at present
   */
  public NearSet nearSet(Predicate<Entity> mayKnow) {
    return new NearSet(simulation, marks, mayKnow);
  }

  /** Reads a player's own section after the simulation's last step. */
  public void capture(Player player, OwnState out) {
    int[] memory = player.memory();
    for (int i = 0; i < OwnState.MEMORY; i++) {
      out.setMemory(i, memory[i]);
    }
    Entity entity = player.body();
    if (entity == null) {
      out.clearBody();
      return;
    }
    Body<Entity> body = entity.body();
    out.setBody(
        entity.id(),
        entity.generation(),
        body.centerX(),
        body.centerY(),
        body.cos(),
        body.sin(),
        body.velocityX(),
        body.velocityY(),
        body.angularVelocity());
  }
}
