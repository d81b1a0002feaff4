package carom.server.thin.web;

import carom.game.Games;
import carom.server.Server;
import carom.server.config.ServerConfig;
import carom.sim.level.Level;
import java.io.IOException;
import java.net.InetAddress;
import java.util.List;

/** A server with threads and the play port alone, at a free port of this machine. */
final class PlayServer implements AutoCloseable {
  final PlayPort port;
  final Server server;

  PlayServer(String game) throws IOException {
    this(game, PlayPort.Settings.plain(List.of(InetAddress.getLoopbackAddress()), 0, 400));
  }

  PlayServer(String game, PlayPort.Settings settings) throws IOException {
    port = new PlayPort(settings);
    try {
      Level level = Level.builtIn(Games.create(game).defaultLevel());
      server =
          new Server(
              ServerConfig.defaults().with(ServerConfig.STATUS_INTERVAL, 0),
              () -> Games.create(game),
              level,
              port,
              System::nanoTime);
    } catch (Exception e) {
      port.close();
      throw new IOException(e);
    }
    server.start();
  }

  WebPlayer player() {
    return new WebPlayer(port.tcpPort());
  }

  @Override
  public void close() {
    server.close();
  }
}
