package carom.client;

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

  /** This, with another name. */
  public ClientConfig withName(String name) {
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

  /** This, with another prediction. */
  public ClientConfig withPrediction(PredictionMode prediction) {
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

  /** This, with another reach of the prediction. */
  public ClientConfig withNear(float nearMetres, int maxNearBodies) {
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

  /** This, with another number of inputs per datagram. */
  public ClientConfig withTicksPerInputDatagram(int ticksPerInputDatagram) {
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

  /** This, coming back by itself or not. */
  public ClientConfig withReconnect(boolean reconnect) {
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

  private static void require(String name, double value, double min, double max) {
    if (!(value >= min && value <= max)) {
      throw new IllegalArgumentException(name + "=" + value + " is outside " + min + ".." + max);
    }
  }
}
