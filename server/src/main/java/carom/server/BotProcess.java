package carom.server;

import carom.game.GameJars;
import carom.options.Installation;
import carom.server.room.BotCrew;
import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Plays the server's bots in a process of its own, whose memory and garbage are no burden to ticks:
 * {@code carom-bots --orders}. It starts with the first order, and anew if it ends. It reads the
 * orders from its standard input, which no other program can write, and ends with the server.
 */
final class BotProcess implements BotCrew {
  private static final Logger LOG = LoggerFactory.getLogger(BotProcess.class);
  private static final String PROGRAM = "carom.client.bots.BotsMain";

  /** Orders that may wait; a room asks again for one that is lost. */
  private static final int MOST_WAITING = 1_024;

  /** Shortest time between two starts, so that a process that can't run costs little. */
  private static final long RESTART_NS = TimeUnit.SECONDS.toNanos(10);

  private static final long GOODBYE_MS = 2_000;

  private final List<String> flags;
  private final Path log;
  private final ArrayBlockingQueue<String> orders = new ArrayBlockingQueue<>(MOST_WAITING);
  private Thread thread; // guarded by this, as the next
  private boolean closed;
  private Process process; // the thread's, as the next
  private Writer in;
  private long startedNs = System.nanoTime() - RESTART_NS;

  /**
   * Creates one that has started nothing.
   *
   * @param flags by which a client finds this server
   * @param log file for what the process says; replaced at each start; null for none
   */
  BotProcess(List<String> flags, Path log) {
    this.flags = List.copyOf(flags);
    this.log = log;
  }

  /** Returns why no bot can play in this installation, or null if nothing speaks against it. */
  static String problem() {
    return Installation.has(PROGRAM)
        ? null
        : "--bots: this installation has no " + PROGRAM + "; one by ./gradlew installDist has it";
  }

  @Override
  public void play(String token, String strength) {
    if (orders.offer((token + " " + strength).strip())) {
      begin();
    }
  }

  private synchronized void begin() {
    if (thread == null && !closed) {
      thread = new Thread(this::work, "carom-bot-orders");
      thread.setDaemon(true);
      thread.start();
    }
  }

  private void work() {
    try {
      while (true) {
        String order = orders.take();
        try {
          if (process == null || !process.isAlive()) {
            start();
          }
          in.write(order + "\n");
          in.flush();
        } catch (IOException e) {
          LOG.warn("bots: an order is lost: {}", e.getMessage()); // the room asks again
        }
      }
    } catch (InterruptedException e) {
      end();
    }
  }

  private void start() throws IOException, InterruptedException {
    if (process != null) {
      LOG.warn(
          "bots: their process has ended with exit={}; {} has what it said",
          process.exitValue(),
          log == null ? "nothing" : log);
    }
    TimeUnit.NANOSECONDS.sleep(startedNs + RESTART_NS - System.nanoTime());
    startedNs = System.nanoTime();
    ProcessBuilder.Redirect said =
        log == null ? ProcessBuilder.Redirect.DISCARD : ProcessBuilder.Redirect.to(log.toFile());
    process = new ProcessBuilder(command()).redirectErrorStream(true).redirectOutput(said).start();
    in = process.outputWriter(StandardCharsets.UTF_8);
    LOG.info("bots: their process is pid={}", process.pid());
  }

  private List<String> command() {
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC",
                "-XX:+ExitOnOutOfMemoryError",
                "-Dkryo.unsafe=false",
                "-cp",
                Installation.classPath(),
                PROGRAM,
                "--orders",
                "--prediction",
                "island"));
    command.addAll(flags);
    Path games = GameJars.folder();
    if (games != null) {
      command.addAll(List.of("--games", games.toString()));
    }
    return command;
  }

  private void end() {
    if (process != null) {
      try {
        in.close();
        process.waitFor(GOODBYE_MS, TimeUnit.MILLISECONDS);
      } catch (IOException | InterruptedException e) {
        LOG.debug("bots: their process doesn't end by itself", e);
      }
      process.destroyForcibly();
    }
  }

  /** Ends the process. */
  @Override
  public void close() {
    Thread present;
    synchronized (this) {
      closed = true;
      present = thread;
    }
    if (present != null) {
      present.interrupt();
      try {
        present.join(2 * GOODBYE_MS);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
  }
}
