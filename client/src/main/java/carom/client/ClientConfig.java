package carom.client;

import carom.client.link.ServerAddress;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.RoomName;
import carom.values.Records;

/**
 * Settings of a {@link GameClient}. Immutable; start from {@link #of}.
 *
 * @param host name or address of the server
 * @param tcpPort the server's TCP port, 1..65,535; 0 for an in-process transport, which has no
 *     ports
 * @param udpPort the server's UDP port, 0..65,535; 0 for the one that it tells over TCP
 * @param name the player's name, see {@link carom.net.protocol.PlayerName}
 * @param prediction what is simulated ahead of the server
 * @param maxRollbackTicks longest replay, 1..120 ticks; the oldest ticks of a longer one are left
 *     out
 * @param maxReplayMs longest time a replay may take, 1..1,000 ms; the oldest ticks of a longer one
 *     are left out
 * @param syncTest whether each tick rolls back eight ticks and compares hashes; for developers
 * @param ticksPerInputDatagram how many ticks of input a datagram carries, 1..8; 2 halves the
 *     number of datagrams and adds a tick of lag
 * @param reconnect whether the client reconnects by itself when the link is lost
 * @param room name of the room in which to play; empty for any
 * @param game name of the game to play if the room is any; empty for any. It is a request: the
 *     server may have no place in such a room
 * @param minInterpolationMs least time by which other players' bodies are drawn late, 0..300 ms; 0
 *     = as little as the connection allows
 * @param token join token, for servers whose operator demands one; empty for none
 * @param password the server's password; empty for none
 * @param takesAnyCode whether to play also where the server's build of the game differs, with a
 *     warning; for developers
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
    boolean reconnect,
    String room,
    String game,
    int minInterpolationMs,
    String token,
    String password,
    boolean takesAnyCode) {
  /**
   * Checks the ranges.
   *
   * @throws IllegalArgumentException names value and range
   */
  public ClientConfig {
    require("tcpPort", tcpPort, 0, 65_535);
    require("udpPort", udpPort, 0, 65_535);
    require("maxRollbackTicks", maxRollbackTicks, 1, 120);
    require("maxReplayMs", maxReplayMs, 1, 1_000);
    require("ticksPerInputDatagram", ticksPerInputDatagram, 1, 8);
    require("minInterpolationMs", minInterpolationMs, 0, 300);
    String problem = room.isEmpty() ? null : RoomName.problem(room);
    if (problem != null) {
      throw new IllegalArgumentException(problem);
    }
    require("token.length", token.length(), 0, ProtocolLimits.MAX_TOKEN_BYTES);
    require("game.length", game.length(), 0, ProtocolLimits.MAX_GAME_NAME_BYTES);
  }

  /** Returns the defaults for a player of this name on this machine's server. */
  public static ClientConfig of(String name) {
    return new ClientConfig(
        /* host= */ "localhost",
        /* tcpPort= */ ServerAddress.DEFAULT_TCP_PORT,
        /* udpPort= */ ServerAddress.TOLD_UDP_PORT,
        /* name= */ name,
        /* prediction= */ PredictionMode.ISLAND,
        /* maxRollbackTicks= */ 60,
        /* maxReplayMs= */ 8,
        /* syncTest= */ false,
        /* ticksPerInputDatagram= */ 1,
        /* reconnect= */ true,
        /* room= */ "",
        /* game= */ "",
        /* minInterpolationMs= */ 0,
        /* token= */ "",
        /* password= */ "",
        /* takesAnyCode= */ false);
  }

  /** Returns a copy for this server. */
  public ClientConfig withServer(String host, int tcpPort, int udpPort) {
    return Records.with(this, "host", host, "tcpPort", tcpPort, "udpPort", udpPort);
  }

  /** Returns a copy for a player of this name. */
  public ClientConfig withName(String name) {
    return Records.with(this, "name", name);
  }

  /** Returns a copy that simulates this ahead of the server. */
  public ClientConfig withPrediction(PredictionMode prediction) {
    return Records.with(this, "prediction", prediction);
  }

  /** Returns a copy with these bounds of a replay after a correction. */
  public ClientConfig withRollback(int maxTicks, int maxMs) {
    return Records.with(this, "maxRollbackTicks", maxTicks, "maxReplayMs", maxMs);
  }

  /** Returns a copy that tests the prediction's rollback in each tick, or not. */
  public ClientConfig withSyncTest(boolean syncTest) {
    return Records.with(this, "syncTest", syncTest);
  }

  /** Returns a copy with this many inputs per datagram. */
  public ClientConfig withTicksPerInputDatagram(int ticksPerInputDatagram) {
    return Records.with(this, "ticksPerInputDatagram", ticksPerInputDatagram);
  }

  /** Returns a copy that reconnects by itself, or not. */
  public ClientConfig withReconnect(boolean reconnect) {
    return Records.with(this, "reconnect", reconnect);
  }

  /** Returns a copy that plays in this room; empty for any. */
  public ClientConfig withRoom(String room) {
    return Records.with(this, "room", room);
  }

  /** Returns a copy that asks for this game; empty for any. */
  public ClientConfig withGame(String game) {
    return Records.with(this, "game", game);
  }

  /** Returns a copy that draws other players' bodies at least this late. */
  public ClientConfig withMinInterpolationMs(int minInterpolationMs) {
    return Records.with(this, "minInterpolationMs", minInterpolationMs);
  }

  /** Returns a copy with a join token; empty for none. */
  public ClientConfig withToken(String token) {
    return Records.with(this, "token", token);
  }

  /** Returns a copy that shows this password to the server; empty for none. */
  public ClientConfig withPassword(String password) {
    return Records.with(this, "password", password);
  }

  /** Leaves out what lets its bearer in. */
  @Override
  public String toString() {
    return "ClientConfig[host=" + host + ", tcpPort=" + tcpPort + ", name=" + name + "]";
  }

  /** Returns a copy that plays also where the server's build of the game differs, or not. */
  public ClientConfig withTakesAnyCode(boolean takesAnyCode) {
    return Records.with(this, "takesAnyCode", takesAnyCode);
  }

  private static void require(String name, double value, double min, double max) {
    if (!(value >= min && value <= max)) {
      throw new IllegalArgumentException(name + "=" + value + " is outside " + min + ".." + max);
    }
  }
}
