package carom.server;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Hears of each change of the GameServer, on a thread of its own; begins again after a break. */
final class GameServerWatch implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(GameServerWatch.class);

  private final Sidecar sidecar;
  private final int retryMs;
  private final Consumer<GameServer> heard;
  private final Thread thread = new Thread(this::run, "carom-agones-watch");
  private volatile boolean closed;

  /**
   * Creates a watch that hasn't begun.
   *
   * @param retryMs pause after a break
   * @param heard told of each change; returns at once
   */
  GameServerWatch(Sidecar sidecar, int retryMs, Consumer<GameServer> heard) {
    this.sidecar = sidecar;
    this.retryMs = retryMs;
    this.heard = heard;
    thread.setDaemon(true);
  }

  void start() {
    thread.start();
  }

  private void run() {
    while (!closed) {
      try (InputStream in = new BufferedInputStream(sidecar.stream("/watch/gameserver"))) {
        for (byte[] line = line(in); line != null && !closed; line = line(in)) {
          if (line.length > 0) {
            heard.accept(GameServer.parse(line));
          }
        }
      } catch (IOException e) {
        LOG.debug("agones: the watch has ended: {}", e.toString());
      } catch (RuntimeException e) {
        LOG.error("agones: the watch survived an error", e);
      }
      try {
        Thread.sleep(retryMs);
      } catch (InterruptedException e) {
        return;
      }
    }
  }

  /** Returns the next line, or null at the end. */
  private static byte[] line(InputStream in) throws IOException {
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    for (int one = in.read(); one != '\n'; one = in.read()) {
      if (one < 0) {
        return null;
      }
      if (line.size() >= Sidecar.MOST_BYTES) {
        throw new IOException("a line of the watch is longer than " + Sidecar.MOST_BYTES);
      }
      line.write(one);
    }
    return line.toByteArray();
  }

  @Override
  public void close() {
    closed = true;
    thread.interrupt();
  }
}
