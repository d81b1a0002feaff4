package carom.client.prediction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import carom.game.Games;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.exact.SpawnList;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.sim.near.Neighbourhood;
import org.junit.jupiter.api.Test;

final class SnapshotRecordsTest {
  private static final int ANN = 3;

  /**
   * Goal: an own spawn that the server has told keeps its owner although its first record is lost.
   * A soak found this: the client failed when it then removed what had left its surroundings.
   */
  @Test
  void anOwnSpawnWithoutARecordKeepsItsOwner() throws LevelException {
    SnapshotRecords records = records();
    int rocket = Neighbourhood.key(70, 5);
    OwnState told = new OwnState();
    told.spawned().add(SpawnList.FIRST_ORIGIN, rocket);
    records.spawns().add(told);
    assertEquals(HostEntity.NO_OWNER, records.owner(rocket));
    records.spawns().settle(rocket, ANN);
    assertEquals(ANN, records.owner(rocket));
    assertFalse(records.isBody(rocket), "a spawn is no player's body");
    assertEquals(HostEntity.NO_OWNER, records.owner(Neighbourhood.key(70, 6)), "its successor");
    records.spawns().settle(rocket, HostEntity.NO_OWNER);
    assertEquals(HostEntity.NO_OWNER, records.owner(rocket));
    assertFalse(records.isBody(rocket));
  }

  private static SnapshotRecords records() throws LevelException {
    SimulationHost s =
        new SimulationHost(Games.create("arena"), Level.builtIn("arena"), 1, 60, Role.PREDICTION);
    SnapshotRecords records = new SnapshotRecords(s, ANN);
    records.readFrom(new SnapshotDecoder(100, 0, 0, 60));
    return records;
  }
}
