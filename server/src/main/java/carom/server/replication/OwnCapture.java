package carom.server.replication;

import carom.net.snapshot.OwnState;
import carom.physics.Body;
import carom.sim.Entity;
import carom.sim.Player;
import carom.sim.Simulation;

/**
 * Reads from the simulation what one player's client needs to predict: the exact state of its body,
 * its memory, and whose inputs to relay to it.
 *
 * <p>Inputs are relayed of players whose bodies are near, the nearest first: what is far can't push
 * the own body before the next snapshots come. The room's thread; shared by its sessions; no
 * allocation.
 */
public final class OwnCapture {
  /** Inputs of players whose bodies are farther from the own one are not relayed, metres. */
  public static final float RELAY_METRES = 12;

  /** Most players relayed to one client. */
  public static final int MAX_RELAYED = 12;

  private final Simulation simulation;
  private final int[] nearest = new int[MAX_RELAYED];
  private final float[] distance = new float[MAX_RELAYED];

  /** Creates a reader of a room's simulation. */
  public OwnCapture(Simulation simulation) {
    this.simulation = simulation;
  }

  /** Reads a player's own section after the simulation's last step. */
  public void capture(Player player, OwnState out) {
    int[] memory = player.memory();
    for (int i = 0; i < OwnState.MEMORY; i++) {
      out.setMemory(i, memory[i]);
    }
    out.relayed().clear();
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
    relay(player, body, out);
  }

  private void relay(Player player, Body<Entity> body, OwnState out) {
    int count = 0;
    for (int id = 0; id < simulation.playerCapacity(); id++) {
      Player other = simulation.player(id);
      if (other == null || other == player || other.body() == null) {
        continue;
      }
      float dx = other.body().body().x() - body.x();
      float dy = other.body().body().y() - body.y();
      float square = dx * dx + dy * dy;
      if (square <= RELAY_METRES * RELAY_METRES) {
        count = insert(id, square, count);
      }
    }
    for (int i = 0; i < count; i++) {
      out.relayed().add(nearest[i]);
    }
  }

  /** Keeps the nearest sorted; the farthest falls out. */
  private int insert(int id, float square, int count) {
    int at = count;
    while (at > 0 && distance[at - 1] > square) {
      at--;
    }
    if (at == MAX_RELAYED) {
      return count;
    }
    int end = Math.min(count, MAX_RELAYED - 1);
    System.arraycopy(nearest, at, nearest, at + 1, end - at);
    System.arraycopy(distance, at, distance, at + 1, end - at);
    nearest[at] = id;
    distance[at] = square;
    return end + 1;
  }
}
