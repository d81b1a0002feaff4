package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.ClientConfig;
import carom.client.GameClient;
import carom.client.bots.Bot;
import carom.client.link.ConnectionPhase;
import carom.game.Games;
import carom.net.kryo.KryoClientTransport;
import carom.net.kryo.server.KryoServerTransport;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.sim.level.Level;
import carom.suite.Needs;
import com.sun.management.UnixOperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Path;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: whatever comes and goes leaves nothing behind. Method: heap after a collection, threads and
 * open files, early and late. {@code -Dcarom.leak.ticks} and {@code -Dcarom.leak.cycles} run it for
 * longer; it prints what it has seen.
 */
@Needs("sockets")
class LeakTest {
  private static final int TICKS = Integer.getInteger("carom.leak.ticks", 12_000);
  private static final int CYCLES = Integer.getInteger("carom.leak.cycles", 24);

  @TempDir Path folder;

  /** What the process holds. */
  private record Held(double heapMb, long threads, long files) {
    static Held now() {
      Runtime runtime = Runtime.getRuntime();
      for (int i = 0; i < 3; i++) {
        System.gc();
      }
      long files =
          ManagementFactory.getOperatingSystemMXBean() instanceof UnixOperatingSystemMXBean unix
              ? unix.getOpenFileDescriptorCount()
              : 0;
      double heapMb = (runtime.totalMemory() - runtime.freeMemory()) / 1e6;
      return new Held(heapMb, countThreads(), files);
    }

    static long countThreads() {
      return Thread.getAllStackTraces().keySet().stream()
          .filter(t -> t.getName().startsWith("carom-"))
          .count();
    }
  }

  @Test
  void playersWhoComeAndGoLeaveNothingBehind() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    SplittableRandom random = new SplittableRandom(seed);
    try (Rig rig =
        new Rig(
            ServerConfig.defaults().with(ServerConfig.MAX_PLAYERS, 16).with(ServerConfig.GRACE, 1),
            new TestGame(3))) {
      Held early = null;
      for (int tick = 0; tick < TICKS; tick++) {
        if (tick == TICKS / 2) {
          early = heldOf(rig);
        }
        if (random.nextInt(10) == 0 && rig.clients.size() < 16) {
          rig.connect().hello("p" + tick);
        }
        if (random.nextInt(12) == 0 && !rig.clients.isEmpty()) {
          rig.clients.remove(random.nextInt(rig.clients.size())).link.close("churn");
        }
        rig.step();
      }
      Held late = heldOf(rig);
      long joins = rig.count(Counter.JOINS);
      System.out.printf(
          "leak: seed=%d ticks=%d joins=%d early=%s late=%s%n", seed, TICKS, joins, early, late);
      assertTrue(joins > TICKS / 50, "joins=" + joins);
      assertTrue(late.heapMb < early.heapMb + 1, early + " " + late);
      assertEquals(early.threads, late.threads);
    }
  }

  /** Returns what an empty server holds: players differ in what their tests' clients keep. */
  private static Held heldOf(Rig rig) {
    rig.clients.forEach(client -> client.link.close("measured"));
    rig.clients.clear();
    rig.seconds(3);
    assertEquals(0, rig.room.seats().takenCount());
    return Held.now();
  }

  @Test
  void serversThatStartAndStopLeaveNothingBehind() throws Exception {
    Held early = null;
    long threads = Held.countThreads();
    for (int cycle = 0; cycle < CYCLES; cycle++) {
      if (cycle == CYCLES / 2) {
        early = Held.now();
      }
      int port = playOnce();
      awaitThreads(threads, cycle);
      new ServerSocket(port).close(); // throws if the port is still taken
    }
    Held late = Held.now();
    System.out.printf("leak: cycles=%d early=%s late=%s%n", CYCLES, early, late);
    assertEquals(early.threads, late.threads);
    assertTrue(late.files <= early.files + 2, early + " " + late);
    assertTrue(late.heapMb < early.heapMb + 2, early + " " + late);
  }

  /** Waits for threads that have been told to end, such as the one of keys, and still do so. */
  private static void awaitThreads(long most, int cycle) throws Exception {
    long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(20);
    while (Held.countThreads() > most) {
      assertTrue(System.nanoTime() < endNs, "cycle=" + cycle + " threads=" + Held.countThreads());
      TimeUnit.MILLISECONDS.sleep(5);
    }
  }

  /**
   * Starts a server with all its threads, which goes on from the checkpoint of the last one, plays
   * a moment as a client, and stops both. Returns the number of the TCP port.
   */
  private int playOnce() throws Exception {
    Level level = Level.builtIn(Games.create("arena").defaultLevel());
    try (Server server =
            new Server(
                ServerConfig.defaults()
                    .with(ServerConfig.STATUS_INTERVAL, 0)
                    .with(ServerConfig.TICK_RATE, 120),
                () -> Games.create("arena"),
                level,
                new KryoServerTransport(0, 0),
                System::nanoTime);
        KryoClientTransport transport = new KryoClientTransport()) {
      server.checkpoint(folder, 1);
      server.start();
      ClientConfig config =
          ClientConfig.of("guest").withServer("127.0.0.1", server.tcpPort(), server.udpPort());
      try (GameClient client = new GameClient(config, transport, new Bot(7, true));
          Socket stranger = new Socket("127.0.0.1", server.tcpPort())) {
        assertTrue(stranger.getInputStream().read() >= 0);
        long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(20);
        for (int playing = 0; playing < 20; ) {
          assertTrue(System.nanoTime() < endNs, "phase=" + client.view().phase());
          client.update(System.nanoTime());
          boolean plays = client.view().phase() == ConnectionPhase.PLAYING;
          playing += plays && client.view().own() != null ? 1 : 0;
          TimeUnit.MILLISECONDS.sleep(2);
        }
      }
      return server.tcpPort();
    }
  }
}
