package carom.server.prediction;

import carom.net.snapshot.SnapshotEncoder;
import carom.net.snapshot.exact.OwnState;
import carom.physics.Body;
import carom.physics.math.Aabb;
import carom.sim.SimulationHost;
import carom.sim.entity.AreaForces;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.field.FieldValues;
import carom.sim.field.Scope;
import java.util.function.Predicate;

/**
 * Reads from a room's simulation the exact state of a player's body and the words of its fields,
 * which the player's client needs to predict. Shared by the room's sessions. The room's thread; no
 * allocation but by {@link #predictedSet}.
 */
public final class OwnCapture {
  private final SimulationHost simulation;
  private final EntityMarks marks = new EntityMarks();
  private final Aabb box = new Aabb();

  /** Creates a reader of a room's simulation. */
  public OwnCapture(SimulationHost simulation) {
    this.simulation = simulation;
  }

  /**
   * Creates the predicted set of one player's client.
   *
   * @param viewer the player
   * @param encoder that of the client's snapshots
   * @param mayKnow returns whether the game lets that player know of an entity, at present
   */
  public PredictedSet predictedSet(
      HostPlayer viewer, SnapshotEncoder encoder, Predicate<HostEntity> mayKnow) {
    return new PredictedSet(simulation, viewer, encoder, marks, mayKnow);
  }

  /** Returns the number of words in each own section. */
  public int words() {
    return simulation.schema().toldWords(Scope.PLAYER);
  }

  /**
   * Reads a player's own section after the simulation's last step.
   *
   * @param mayKnow returns whether the game lets that player know of an entity, at present
   */
  public void capture(HostPlayer player, Predicate<HostEntity> mayKnow, OwnState out) {
    out.spawned().clear();
    for (int i = 0; i < player.spawnedCount(); i++) {
      HostEntity spawned = player.spawned(i);
      if (mayKnow.test(spawned)) {
        out.spawned().add(spawned.origin(), EntityList.key(spawned));
      }
    }
    FieldValues fields = player.fieldValues();
    for (int i = 0; i < out.words(); i++) {
      out.setWord(i, fields.word(i));
    }
    HostEntity entity = player.entity();
    if (entity == null) {
      out.clearBody();
      return;
    }
    Body<HostEntity> body = entity.body();
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
    out.setArchetype(entity.archetype().index());
  }

  /** Returns whether an entity carries an area that may act on a player's body. */
  public boolean isInArea(HostPlayer player) {
    AreaForces<HostEntity> areas = simulation.areas();
    for (int i = 0; player.entity() != null && i < areas.carriers(); i++) {
      areas.reach(i, box);
      box.grow(1);
      if (box.contains(player.entity().body().centerX(), player.entity().body().centerY())) {
        return true;
      }
    }
    return false;
  }

  /**
   * Returns the last tick whose state of a player's body the game itself changed; see {@link
   * carom.sim.ruling.InterferenceLog#lastTick(HostPlayer)}.
   */
  public int interferedTick(HostPlayer player) {
    return simulation.interference().lastTick(player);
  }
}
