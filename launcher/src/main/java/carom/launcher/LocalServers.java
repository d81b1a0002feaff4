package carom.launcher;

import carom.client.app.LocalGames;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.transport.PortUnavailableException;
import carom.server.Server;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.level.LevelCheck;
import carom.server.match.MatchLibrary;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.util.List;

/** Starts servers in the client's process; found as {@link LocalGames}. */
public final class LocalServers implements LocalGames {
  static final int TCP_PORT = 54_555;
  static final int UDP_PORT = 54_777;

  /** Creates it, for the service loader. */
  public LocalServers() {}

  @Override
  public List<String> levels() {
    return MatchLibrary.builtInLevels();
  }

  @Override
  public Level level(String name) {
    try {
      return MatchLibrary.INSTALLED.level(name).level();
    } catch (LevelException e) {
      throw new IllegalStateException(e.getMessage(), e);
    }
  }

  @Override
  public LocalGame start(GameChoice choice) {
    return start(choice, TCP_PORT, UDP_PORT);
  }

  @Override
  public LocalGame start(Level level, int bots) {
    MatchLibrary given = MatchLibrary.with(level, MatchLibrary.INSTALLED);
    return start(new GameChoice(level.name(), bots, false), given, 0, 0);
  }

  @Override
  public List<String> warnings(Level level) {
    return LevelCheck.of(level.name(), level.source()).warnings();
  }

  /** Starts a server on other ports, of which 0 are any; they count only if others may join. */
  static LocalServer start(GameChoice choice, int tcpPort, int udpPort) {
    return start(choice, MatchLibrary.INSTALLED, tcpPort, udpPort);
  }

  private static LocalServer start(
      GameChoice choice, MatchLibrary library, int tcpPort, int udpPort) {
    if (choice.bots() < 0 || choice.bots() > MAX_BOTS) {
      throw new IllegalArgumentException("bots=" + choice.bots() + " is outside 0.." + MAX_BOTS);
    }
    JoinedTransport transport = new JoinedTransport(open(choice, tcpPort, udpPort));
    try {
      String game = library.level(choice.level()).level().gameName();
      ServerConfig config =
          ServerConfig.defaults()
              .with(ServerConfig.GAME, game)
              .with(ServerConfig.STATUS_INTERVAL, 0);
      Server server =
          new Server(
              config,
              RoomConfig.equalRooms(config, List.of(choice.level())),
              library,
              transport,
              System::nanoTime);
      server.start();
      return new LocalServer(server, transport, choice.bots());
    } catch (LevelException | IllegalArgumentException e) {
      transport.close();
      throw new IllegalStateException(
          "The level " + choice.level() + " can't be played: " + e.getMessage(), e);
    }
  }

  private static KryoServerTransport open(GameChoice choice, int tcpPort, int udpPort) {
    try {
      return choice.open() ? new KryoServerTransport(tcpPort, udpPort) : null;
    } catch (PortUnavailableException e) {
      throw new IllegalStateException(
          "Others can't join: " + e.getMessage() + " Is another server running here?", e);
    }
  }
}
