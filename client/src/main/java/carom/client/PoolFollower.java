package carom.client;

import carom.client.link.Connection;
import carom.net.field.FieldTables;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.snapshot.table.TableInbox;
import carom.physics.archive.ArchiveException;
import carom.physics.archive.ArchiveReader;
import carom.sim.pool.OrderLog;
import carom.sim.pool.Pools;

/**
 * Keeps the pools of a client equal to the server's. It asks for their state when they need one,
 * and then computes each tick as soon as the client's clock has come to it and the rows for it are
 * here. One stay's; one thread; allocates only while it loads a state.
 */
final class PoolFollower {
  /** Ticks that are computed at once at most, so that catching up takes bounded time. */
  private static final int MOST_STEPS = 4;

  /** Pieces that are requested and not yet received. */
  private static final int PIECES_IN_FLIGHT = 8;

  /** Time after which a state that was asked for is asked for anew. */
  private static final long PATIENCE_NS = 3_000_000_000L;

  private final Pools pools;
  private final TableInbox tables;
  private final Connection connection;
  private final int[] row = new int[OrderLog.WORDS];
  private int lastTick;
  private byte[] state;
  private int received;
  private int requested;
  private long askedNs;
  private boolean asked;
  private int refused;

  /**
   * Creates a follower that has no state yet.
   *
   * @param pools of the client's simulation
   * @param tables receives the server's tables
   * @param connection sends requests
   */
  public PoolFollower(Pools pools, TableInbox tables, Connection connection) {
    this.pools = pools;
    this.tables = tables;
    this.connection = connection;
  }

  /** Takes in the rows of the datagram that was received last. */
  public void receive() {
    for (int i = 0; i < tables.touchedCount() && !pools.isEmpty(); i++) {
      int key = tables.touchedKey(i);
      if (tables.touchedTable(i) == FieldTables.POOLS && tables.isPresent(FieldTables.POOLS, key)) {
        for (int word = 0; word < row.length; word++) {
          row[word] = tables.get(FieldTables.POOLS, key, word);
        }
        pools.hear(row);
      }
    }
  }

  /**
   * Moves the pools on, and asks for a state when they need one.
   *
   * @param predicted the tick that is predicted next
   * @param seen the tick in which the picture shows what isn't predicted, as the bodies of a world
   *     of particles
   * @return whether the particles of this tick are known, and those of all ticks before it were
   */
  public boolean advance(int predicted, int seen, long nowNs) {
    int tick = pools.followsWorld() ? seen : predicted;
    if (pools.isEmpty()) {
      return true;
    }
    boolean wentBack = pools.tick() < lastTick;
    pools.follow(tick, MOST_STEPS);
    lastTick = pools.tick();
    if (pools.needsState(tick) && (!asked || nowNs - askedNs > PATIENCE_NS)) {
      asked = true;
      askedNs = nowNs;
      state = null;
      received = 0;
      requested = ProtocolLimits.MAX_LEVEL_CHUNK_BYTES;
      connection.send(new ClientMessage.PoolRequest(0));
    }
    return pools.tick() == tick && !wentBack;
  }

  /** Takes in a piece of a state. Pieces that don't fit are passed over. */
  public void add(ServerMessage.PoolChunk chunk) {
    if (!asked || pools.isEmpty()) {
      return;
    }
    if (chunk.offset() == 0) {
      state = new byte[chunk.size()];
      received = 0;
    }
    boolean fits =
        state != null
            && chunk.size() == state.length
            && chunk.offset() == received
            && chunk.bytes().length <= state.length - received;
    if (!fits) {
      return;
    }
    System.arraycopy(chunk.bytes(), 0, state, received, chunk.bytes().length);
    received += chunk.bytes().length;
    if (received == state.length) {
      take();
      return;
    }
    int piece = ProtocolLimits.MAX_LEVEL_CHUNK_BYTES;
    while (requested < state.length && requested - received < PIECES_IN_FLIGHT * piece) {
      connection.send(new ClientMessage.PoolRequest(requested));
      requested += piece;
    }
  }

  private void take() {
    try {
      pools.restore(pools.read(new ArchiveReader(state)));
    } catch (ArchiveException e) {
      refused++; // damaged, or of a server with another level: the next one may be good
    }
    state = null;
    asked = refused > 0; // then patience passes before the next request
  }
}
