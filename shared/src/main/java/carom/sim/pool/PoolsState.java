package carom.sim.pool;

import carom.physics.archive.Archive;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.particles.ParticleState;
import java.util.Arrays;

/**
 * A saved state of {@link Pools}. It belongs to the pools that made it, is reused from save to
 * save, and its contents are internal.
 */
public final class PoolsState {
  final ParticleState[] particles;
  final int[] stillTicks;
  final OrderLog log = new OrderLog();
  final int[] requests = new int[OrderLog.WORDS];
  ParticleWorld.State own;
  int tick;
  int open;
  int requestedOpen;

  PoolsState(int pools) {
    particles = new ParticleState[pools];
    stillTicks = new int[pools];
  }

  /** Returns the tick of the state. */
  public int tick() {
    return tick;
  }

  /** Appends the state to an archive, with some 32 bytes a particle. */
  public void write(ArchiveWriter archive) {
    pass(archive);
    for (ParticleState p : particles) {
      p.write(archive);
    }
    if (own != null) {
      own.write(archive);
    }
  }

  /** Reads a state of these pools; see {@link Pools#read}. */
  static PoolsState read(Pools of, ArchiveReader archive) {
    PoolsState s = new PoolsState(of.count());
    s.pass(archive);
    for (int i = 0; i < s.particles.length; i++) {
      s.particles[i] = of.get(i).particles().read(archive);
    }
    return s;
  }

  private void pass(Archive a) {
    int least = Integer.MIN_VALUE;
    int most = Integer.MAX_VALUE;
    int n = a.integer("pools", particles.length, 0, OrderLog.MAX_POOLS);
    a.require(n == particles.length, "pools=" + n + " aren't this level's " + particles.length);
    tick = a.integer("tick of pools", tick, 0, most);
    open = a.integer("open spouts", open, least, most);
    requestedOpen = a.integer("spouts to open", requestedOpen, least, most);
    a.integers("still ticks", stillTicks, n, 0, most);
    a.integers("request", requests, OrderLog.WORDS, least, most);
    int rows = a.count("rows of orders", countRows(), OrderLog.KEPT, OrderLog.WORDS);
    int[] row = new int[OrderLog.WORDS];
    int at = -1;
    for (int i = 0; i < rows; i++) {
      if (!a.reads()) {
        at = nextRow(at);
        System.arraycopy(log.slot(at), 0, row, 0, row.length);
      }
      a.integers("row of orders", row, OrderLog.WORDS, least, most);
      if (a.reads()) {
        a.require(OrderLog.period(row) >= 0, "row of period=" + OrderLog.period(row));
        log.take(row);
      }
    }
    a.require(
        OrderLog.orders(requests) >= 0 && OrderLog.orders(requests) <= OrderLog.MAX_ORDERS,
        "requests=" + OrderLog.orders(requests));
  }

  private int countRows() {
    int n = 0;
    for (int at = nextRow(-1); at < OrderLog.KEPT; at = nextRow(at)) {
      n++;
    }
    return n;
  }

  private int nextRow(int after) {
    int at = after + 1;
    while (at < OrderLog.KEPT && OrderLog.period(log.slot(at)) < 0) {
      at++;
    }
    return at;
  }

  void copyRequests(int[] from) {
    System.arraycopy(from, 0, requests, 0, requests.length);
  }

  void copyStill(int index, int ticks) {
    stillTicks[index] = ticks;
  }

  @Override
  public String toString() {
    return "tick=" + tick + " still=" + Arrays.toString(stillTicks);
  }
}
