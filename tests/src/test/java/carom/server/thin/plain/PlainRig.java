package carom.server.thin.plain;

import carom.game.Games;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.transport.ServerTransports;
import carom.server.Server;
import carom.server.config.ServerConfig;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** A whole server on real ports, with a door for stock KryoNet. Loopback only. */
final class PlainRig implements AutoCloseable {
  /** Longest time for anything: a loaded machine is slow. */
  static final long MOST_SECONDS = 60;

  final PlainDoor door;
  final Server server;

  PlainRig(ServerConfig config, PlainLimits limits, boolean withUdp) throws IOException {
    this(config, limits, withUdp, level());
  }

  PlainRig(ServerConfig config, PlainLimits limits, boolean withUdp, Level level)
      throws IOException {
    InetAddress here = InetAddress.getLoopbackAddress();
    door = new PlainDoor(List.of(here), 0, withUdp ? 0 : -1, limits, false);
    server =
        new Server(
            config,
            Games.supplier(level.gameName()),
            level,
            ServerTransports.of(new KryoServerTransport(0, 0), List.of(door)),
            System::nanoTime);
    server.start();
  }

  private static Level level() {
    try {
      return Level.builtIn("arena");
    } catch (LevelException e) {
      throw new AssertionError(e);
    }
  }

  static PlainRig open() throws IOException {
    return new PlainRig(
        ServerConfig.defaults().with(ServerConfig.SEED, 1).with(ServerConfig.STATUS_INTERVAL, 0),
        PlainLimits.DEFAULT,
        true);
  }

  @Override
  public void close() {
    server.close();
  }

  /** A program with stock KryoNet, see StockClient of the tests' resources. */
  static final class Stock implements AutoCloseable {
    private final Process process;
    private final PrintStream in;
    private final List<String> said = new ArrayList<>(); // guarded by itself
    private final Thread reader;

    Stock(StockJvm stock, Path home) throws IOException {
      process = stock.program(home, "StockClient").redirectErrorStream(true).start();
      in = new PrintStream(process.getOutputStream(), true, StandardCharsets.UTF_8);
      reader = new Thread(this::read);
      reader.setDaemon(true);
      reader.start();
    }

    private void read() {
      try (BufferedReader out =
          new BufferedReader(
              new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
        for (String line; (line = out.readLine()) != null; ) {
          synchronized (said) {
            said.add(line);
          }
        }
      } catch (IOException e) {
        synchronized (said) {
          said.add("(ended)");
        }
      }
    }

    /** Tells it what to do. */
    void type(String command) {
      in.println(command);
    }

    /** Returns all that it has said. */
    String said() {
      synchronized (said) {
        return String.join("\n", said);
      }
    }

    /** Waits until it says something that wasn't there before, and returns the match. */
    Matcher await(String pattern) throws InterruptedException {
      Pattern wanted = Pattern.compile(pattern);
      long until = System.nanoTime() + TimeUnit.SECONDS.toNanos(MOST_SECONDS);
      while (System.nanoTime() - until < 0) {
        synchronized (said) {
          for (int i = 0; i < said.size(); i++) {
            Matcher matcher = wanted.matcher(said.get(i));
            if (matcher.find()) {
              said.remove(i);
              return matcher;
            }
          }
        }
        Thread.sleep(10);
      }
      throw new AssertionError("nothing like " + pattern + " came:\n" + said());
    }

    /** Asks where its own body is. */
    Where where() throws InterruptedException {
      type("where");
      Matcher m =
          await(
              "^where own=(\\S+) x=(\\S+) y=(\\S+) bodies=(\\d+) players=(\\d+) snapshots=(\\d+)"
                  + " tick=(\\S+) used=(\\S+)");
      return new Where(
          Integer.parseInt(m.group(1)),
          Float.parseFloat(m.group(2)),
          Float.parseFloat(m.group(3)),
          Integer.parseInt(m.group(4)),
          Integer.parseInt(m.group(5)),
          Integer.parseInt(m.group(6)),
          Integer.parseInt(m.group(7)),
          Integer.parseInt(m.group(8)));
    }

    /** Waits until its own body is shown. */
    Where awaitBody() throws InterruptedException {
      Where where = where();
      for (long i = 0; where.own() < 0 && i < MOST_SECONDS * 20; i++) {
        Thread.sleep(50);
        where = where();
      }
      return where;
    }

    @Override
    public void close() {
      in.close();
      process.destroyForcibly();
    }
  }

  /** What a program shows. */
  record Where(
      int own, float x, float y, int bodies, int players, int snapshots, int tick, int used) {}
}
