package carom.client;

import carom.client.link.ServerAddress;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.RoomName;
import carom.net.seal.PlayerKey;
import carom.options.Rows;
import carom.options.Setting;
import carom.options.Settings;
import carom.options.Sockets;
import java.io.IOException;
import java.nio.file.Path;

/**
 * The settings of a {@link GameClient}: a row for each, and a value for each row. Immutable; start
 * from {@link #of}.
 */
public final class ClientConfig extends Settings<ClientConfig> {
  private static final Rows FLAGS = Rows.ofFlags();
  private static final Rows INNER = Rows.inner();

  public static final Setting<ServerAddress> SERVER =
      FLAGS
          .of("host", "HOST[:PORT]", ServerAddress::parse, "localhost")
          .text(
              "Server's name or address, and its TCP port where that isn't 54555 ({default})."
                  + " HOST:PORT/UDP if a router in between shows another UDP port than the server"
                  + " tells.")
          .checked(ClientConfig::serverProblem);

  public static final Setting<String> ROOM =
      FLAGS
          .text("room", "NAME", "")
          .text(
              "Play in this room of the server; carom-client --list shows them (the fullest with a"
                  + " place).")
          .checked(room -> room.isEmpty() ? null : told(RoomName.problem(room)));

  public static final Setting<String> GAME =
      FLAGS
          .text("game", "NAME", 0, ProtocolLimits.MAX_GAME_NAME_BYTES, "")
          .text("Without --room: prefer the rooms that play this game (any).");

  public static final Setting<String> PARTY =
      FLAGS
          .text("party", "NAME", "")
          .text(
              "Without --room: play in the room of all who give the same name here, wherever the"
                  + " first of them came (none).")
          .checked(party -> party.isEmpty() ? null : told(RoomName.partyProblem(party)));

  public static final Setting<String> TOKEN =
      FLAGS
          .text("token", "TOKEN", 0, ProtocolLimits.MAX_TOKEN_BYTES, "")
          .text("Join token from the server's site, for servers that demand one (none).");

  public static final Setting<PlayerKey> KEY =
      FLAGS
          .of("key", "FILE", ClientConfig::key, null)
          .text(
              "File with a key of your own, by which servers know you again; made if it isn't there"
                  + " (none; the window has player.key beside its settings).");

  public static final Setting<Boolean> DEV =
      FLAGS
          .mark("dev")
          .text(
              "For developers of games: play also where the server's build of the game differs,"
                  + " with a warning, and take the jars of --games anew when they change: views and"
                  + " bots' brains at once, games with the next match.");

  public static final Setting<String> NAME =
      INNER.text("name", "NAME", "player").text("The player's name, see PlayerName.");

  public static final Setting<String> PASSWORD =
      INNER.text("password", "TEXT", "").text("The server's password; empty for none.");

  public static final Setting<PredictionMode> PREDICTION =
      INNER
          .choice("prediction", "MODE", PredictionMode.ISLAND)
          .text("What is simulated ahead of the server.");

  public static final Setting<Integer> MAX_ROLLBACK_TICKS =
      INNER
          .whole("maxRollbackTicks", "N", 1, 120, 60)
          .text("Longest replay; the oldest ticks of a longer one are left out.");

  public static final Setting<Integer> MAX_REPLAY_MS =
      INNER
          .whole("maxReplayMs", "MS", 1, 1_000, 8)
          .text("Longest time a replay may take; the oldest ticks of a longer one are left out.");

  public static final Setting<Boolean> SYNC_TEST =
      INNER
          .toggle("syncTest", false)
          .text("Roll back eight ticks in each tick and compare hashes; for developers.");

  public static final Setting<Integer> TICKS_PER_INPUT_DATAGRAM =
      INNER
          .whole("ticksPerInputDatagram", "N", 1, 8, 1)
          .text(
              "How many ticks of input a datagram carries; 2 halves the number of datagrams and"
                  + " adds a tick of lag.");

  public static final Setting<Boolean> RECONNECT =
      INNER.toggle("reconnect", true).text("Reconnect by itself when the link is lost.");

  public static final Setting<Integer> MIN_INTERPOLATION_MS =
      INNER
          .whole("minInterpolationMs", "MS", 0, 300, 0)
          .text(
              "Least time by which other players' bodies are drawn late; 0 = as little as the"
                  + " connection allows.");

  /** Creates the defaults: a player on this machine's server. */
  public ClientConfig() {}

  /** Returns the defaults for a player of this name on this machine's server. */
  public static ClientConfig of(String name) {
    return new ClientConfig().with(NAME, name);
  }

  /** Returns a copy for this server. */
  public ClientConfig withServer(String host, int tcpPort, int udpPort) {
    return with(SERVER, new ServerAddress(host, tcpPort, udpPort));
  }

  private static String serverProblem(ServerAddress server) {
    return Sockets.first(
        Sockets.portProblem(": tcpPort", server.tcpPort()),
        Sockets.portProblem(": udpPort", server.udpPort()));
  }

  private static String told(String problem) {
    return problem == null ? null : ": " + problem;
  }

  /** Leaves out what lets its bearer in. */
  @Override
  public String toString() {
    return "ClientConfig[server=" + get(SERVER) + ", name=" + get(NAME) + "]";
  }

  private static PlayerKey key(String file) {
    try {
      return PlayerKey.load(Path.of(file));
    } catch (IOException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }
}
