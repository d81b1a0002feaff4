package carom.client;

import java.util.function.Consumer;

/**
 * Settings of a {@link GameClient}. Immutable; start from {@link #of} and change by {@code
 * with...}.
 *
 * @param host name or address of the server
 * @param tcpPort the server's TCP port, 1..65,535
 * @param udpPort the server's UDP port, 1..65,535
 * @param name the player's name, see {@link carom.net.protocol.PlayerName}
 * @param prediction what is simulated ahead of the server
 * @param maxRollbackTicks longest replay, 1..120; of a longer one, the oldest ticks are left out
 * @param maxReplayMs longest time a replay may take, 1..1,000; then ticks are left out, too
 * @param syncTest whether to roll back eight ticks in each tick and compare hashes; for developers
 * @param ticksPerInputDatagram 1 sends each tick; 2 halves the number of datagrams and adds a tick
 *     of lag
 * @param reconnect whether to come back by itself when the link is lost
 */
public record ClientConfig(
    String host,
    int tcpPort,
    int udpPort,
    String name,
    PredictionMode prediction,
    int maxRollbackTicks,
    int maxReplayMs,
    boolean syncTest,
    int ticksPerInputDatagram,
    boolean reconnect) {
  /** TCP port a server uses unless told otherwise. */
  public static final int DEFAULT_TCP_PORT = 54_555;

  /** UDP port a server uses unless told otherwise. */
  public static final int DEFAULT_UDP_PORT = 54_777;

  /** Checks the ranges. */
  public ClientConfig {
    require("tcpPort", tcpPort, 0, 65_535); // 0: an in-process transport has no ports
    require("udpPort", udpPort, 0, 65_535);
    require("maxRollbackTicks", maxRollbackTicks, 1, 120);
    require("maxReplayMs", maxReplayMs, 1, 1_000);
    require("ticksPerInputDatagram", ticksPerInputDatagram, 1, 8);
  }

  /** The defaults for a player of this name on this machine's server. */
  public static ClientConfig of(String name) {
    return new ClientConfig(
        "localhost",
        DEFAULT_TCP_PORT,
        DEFAULT_UDP_PORT,
        name,
        PredictionMode.ISLAND,
        60,
        8,
        false,
        1,
        true);
  }

  /** This, for another server. */
  public ClientConfig withServer(String host, int tcpPort, int udpPort) {
    return with(
        d -> {
          d.host = host;
          d.tcpPort = tcpPort;
          d.udpPort = udpPort;
        });
  }

  /** This, with another name. */
  public ClientConfig withName(String name) {
    return with(d -> d.name = name);
  }

  /** This, with another prediction. */
  public ClientConfig withPrediction(PredictionMode prediction) {
    return with(d -> d.prediction = prediction);
  }

  /** This, with other bounds of what is simulated again after a correction. */
  public ClientConfig withRollback(int maxTicks, int maxMs) {
    return with(
        d -> {
          d.maxRollbackTicks = maxTicks;
          d.maxReplayMs = maxMs;
        });
  }

  /** This, testing the prediction's rollback in each tick, or not. */
  public ClientConfig withSyncTest(boolean syncTest) {
    return with(d -> d.syncTest = syncTest);
  }

  /** This, with another number of inputs per datagram. */
  public ClientConfig withTicksPerInputDatagram(int ticksPerInputDatagram) {
    return with(d -> d.ticksPerInputDatagram = ticksPerInputDatagram);
  }

  /** This, coming back by itself or not. */
  public ClientConfig withReconnect(boolean reconnect) {
    return with(d -> d.reconnect = reconnect);
  }

  private static void require(String name, double value, double min, double max) {
    if (!(value >= min && value <= max)) {
      throw new IllegalArgumentException(name + "=" + value + " is outside " + min + ".." + max);
    }
  }

  private ClientConfig with(Consumer<Draft> change) {
    Draft draft = new Draft(this);
    change.accept(draft);
    return draft.build();
  }

  /** The settings as variables, so that each {@code with...} method names just its own. */
  private static final class Draft {
    private String host;
    private int tcpPort;
    private int udpPort;
    private String name;
    private PredictionMode prediction;
    private int maxRollbackTicks;
    private int maxReplayMs;
    private boolean syncTest;
    private int ticksPerInputDatagram;
    private boolean reconnect;

    Draft(ClientConfig from) {
      host = from.host;
      tcpPort = from.tcpPort;
      udpPort = from.udpPort;
      name = from.name;
      prediction = from.prediction;
      maxRollbackTicks = from.maxRollbackTicks;
      maxReplayMs = from.maxReplayMs;
      syncTest = from.syncTest;
      ticksPerInputDatagram = from.ticksPerInputDatagram;
      reconnect = from.reconnect;
    }

    ClientConfig build() {
      return new ClientConfig(
          host,
          tcpPort,
          udpPort,
          name,
          prediction,
          maxRollbackTicks,
          maxReplayMs,
          syncTest,
          ticksPerInputDatagram,
          reconnect);
    }
  }
}
