package carom.launcher;

import carom.client.ClientConfig;
import carom.client.app.LocalGames;
import carom.client.bots.BotFarm;
import carom.net.transport.ClientTransport;
import carom.physics.threads.WorkerThreads;
import carom.server.Server;
import carom.server.config.ServerConfig;
import carom.server.query.StatusFacts;
import carom.server.query.StatusQuery;
import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;

/** A server in this process, and the bots that play on it, which have a thread. Thread-safe. */
final class LocalServer implements LocalGames.LocalGame {
  /** Time of a bot's frame. Bots needn't be smooth, and the player's picture should be. */
  private static final long FRAME_MS = 16;

  private static final long GOODBYE_MS = 2_000;

  private final Server server;
  private final JoinedTransport transport;
  private final StatusQuery query;
  private final Thread bots;
  private volatile boolean stop;

  /**
   * Begins to play.
   *
   * @param server runs already, over this transport
   * @param count number of bots
   */
  LocalServer(Server server, JoinedTransport transport, int count) {
    this.server = server;
    this.transport = transport;
    query = transport.tcpPort() == 0 ? null : answerQueries();
    bots = new Thread(() -> playBots(count), "carom-local-bots");
    bots.setDaemon(true);
    bots.setPriority(Thread.MIN_PRIORITY);
    if (count > 0) {
      bots.start();
    }
  }

  /** Lets the local network find this game. Returns null if another server answers there. */
  private StatusQuery answerQueries() {
    String name = server.config().get(ServerConfig.NAME);
    try {
      return new StatusQuery(
          null,
          StatusQuery.DEFAULT_PORT,
          new StatusFacts(
              name, "played here", transport.tcpPort(), transport.udpPort(), server.rooms()));
    } catch (IOException busy) {
      return null; // the game goes on without being found
    }
  }

  private void playBots(int count) {
    ClientConfig config = ClientConfig.of("bot").withServer("here", 0, 0);
    try (WorkerThreads alone = new WorkerThreads(1);
        BotFarm farm =
            new BotFarm(config, transport.client(), count, System.nanoTime(), false, 0, alone)) {
      while (!stop) {
        farm.update(System.nanoTime());
        Thread.sleep(FRAME_MS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  Server server() {
    return server;
  }

  @Override
  public ClientTransport transport() {
    return transport.client();
  }

  @Override
  public String invitation() {
    if (transport.tcpPort() == 0) {
      return "";
    }
    boolean usual = transport.tcpPort() == LocalServers.TCP_PORT;
    return "Others can join at " + hostName() + (usual ? "" : ":" + transport.tcpPort());
  }

  private static String hostName() {
    try {
      return InetAddress.getLocalHost().getHostName();
    } catch (UnknownHostException e) {
      return "this machine";
    }
  }

  @Override
  public void close() {
    stop = true;
    try {
      bots.join(GOODBYE_MS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    if (query != null) {
      query.close();
    }
    server.close();
  }
}
