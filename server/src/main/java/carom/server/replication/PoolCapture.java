package carom.server.replication;

import carom.net.field.PoolTable;
import carom.net.snapshot.table.Table;
import carom.physics.archive.ArchiveWriter;
import carom.sim.SimulationHost;
import carom.sim.pool.OrderLog;
import carom.sim.pool.PoolsState;

/**
 * Keeps what clients are told of pools: the rows of what acts on them, and for clients that come,
 * the whole state. The room's thread; a tick allocates nothing.
 */
final class PoolCapture {
  private final SimulationHost simulation;
  private final Table table;
  private final ArchiveWriter archive = new ArchiveWriter();
  private PoolsState saved;
  private byte[] state;

  PoolCapture(SimulationHost simulation, Table table) {
    this.simulation = simulation;
    this.table = table;
  }

  /** Takes over what the simulation's last step ordered. */
  void capture() {
    int[] row = simulation.pools().closedRow();
    if (row != null) {
      table.put(PoolTable.key(OrderLog.period(row)), 0, row, 0, simulation.tick());
    }
  }

  /**
   * Returns the state of the pools, at most half a second old, so that any number of clients cost
   * two a second; null if there are no particles.
   */
  byte[] state() {
    if (simulation.pools().isEmpty()) {
      return null;
    }
    if (state == null || simulation.tick() - saved.tick() > simulation.tickRate() / 2) {
      saved = simulation.pools().save(saved);
      archive.clear();
      saved.write(archive);
      state = archive.toBytes();
    }
    return state;
  }
}
