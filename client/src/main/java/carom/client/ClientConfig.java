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
 * @param nearMetres bodies within this distance of the own body are predicted with it, 0..100
 * @param maxNearBodies most of them; the nearest win
 * @param maxRollbackTicks longest replay; beyond, the client waits for the server
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
    float nearMetres,
    int maxNearBodies,
    int maxRollbackTicks,
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
    require("nearMetres", nearMetres, 0, 100);
    require("maxNearBodies", maxNearBodies, 0, 1_000);
    require("maxRollbackTicks", maxRollbackTicks, 1, 120);
    require("ticksPerInputDatagram", ticksPerInputDatagram, 1, 8);
  }

  /** The defaults for a player of this name on this machine's server. */
  public static ClientConfig of(String name) {
    return new ClientConfig(
        "localhost",
        DEFAULT_TCP_PORT,
        DEFAULT_UDP_PORT,
        name,
        PredictionMode.OWN,
        4,
        32,
        60,
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

  /** This, with another reach of the prediction. */
  public ClientConfig withNear(float nearMetres, int maxNearBodies) {
    return with(
        d -> {
          d.nearMetres = nearMetres;
          d.maxNearBodies = maxNearBodies;
        });
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
    private float nearMetres;
    private int maxNearBodies;
    private int maxRollbackTicks;
    private int ticksPerInputDatagram;
    private boolean reconnect;

    Draft(ClientConfig from) {
      host = from.host;
      tcpPort = from.tcpPort;
      udpPort = from.udpPort;
      name = from.name;
      prediction = from.prediction;
      nearMetres = from.nearMetres;
      maxNearBodies = from.maxNearBodies;
      maxRollbackTicks = from.maxRollbackTicks;
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
          nearMetres,
          maxNearBodies,
          maxRollbackTicks,
          ticksPerInputDatagram,
          reconnect);
    }
  }
}
