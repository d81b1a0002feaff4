package carom.client.replay;

import carom.client.ClientConfig;
import carom.net.transport.ClientTransport;
import carom.replay.RecordingReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Runs a {@link Spectator} on a thread of its own, so that its file grows while another thread
 * plays it. The file is temporary; closing deletes it.
 */
public final class SpectatorThread implements AutoCloseable {
  private static final long NAP_MS = 5;
  private static final long LEAVE_MS = 200;
  private static final long EXTRA_S = 10;

  private final Path file;
  private final Spectator spectator;
  private final Thread thread;
  private final long beginNs = System.nanoTime();
  private volatile boolean stop;
  private volatile int delaySeconds;
  private volatile String message = "";
  private volatile boolean ended;

  /**
   * Starts the thread.
   *
   * @param config names the server
   * @param room 1..255
   * @param transport opens the link; stays the caller's
   * @throws IOException if the temporary file can't be written
   */
  public SpectatorThread(ClientConfig config, int room, ClientTransport transport)
      throws IOException {
    file = Files.createTempFile("carom-watched", ".carom");
    file.toFile().deleteOnExit();
    spectator = new Spectator(config, room, transport, file);
    thread = new Thread(this::run, "carom-spectator");
    thread.setDaemon(true);
    thread.start();
  }

  private void run() {
    while (!stop) {
      spectator.update(System.nanoTime());
      delaySeconds = spectator.delaySeconds();
      message = spectator.message();
      ended = spectator.ended();
      if (!nap(ended ? LEAVE_MS : NAP_MS)) {
        break;
      }
    }
    spectator.close();
  }

  private static boolean nap(long ms) {
    try {
      Thread.sleep(ms);
      return true;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /**
   * Waits until there is something to play. That takes longer than the delay if the game has just
   * begun.
   *
   * @return the recording's file, or null if there is none; {@link #message} says why
   */
  public Path await() {
    while (!isOver()) {
      if (isReady()) {
        return file;
      }
      if (!nap(10 * NAP_MS)) {
        return null;
      }
    }
    return null;
  }

  /** Returns the recording's file. */
  public Path file() {
    return file;
  }

  /** Returns whether there is something to play. Opens the file, so don't ask in each frame. */
  public boolean isReady() {
    try (RecordingReader reader = RecordingReader.open(file)) {
      // Without the state that may follow the header, the replay would begin with an empty game.
      return reader.next() != RecordingReader.Event.WAIT;
    } catch (IOException e) {
      return false; // there is no whole header yet
    }
  }

  /** Returns whether there will be nothing to play; {@link #message} says why. */
  public boolean isOver() {
    return ended || System.nanoTime() - beginNs >= (delaySeconds + EXTRA_S) * 1_000_000_000L;
  }

  /** Returns why there is nothing to watch, in words for the player. */
  public String message() {
    return message.isEmpty() ? "There is nothing to watch yet; try again later." : message;
  }

  /** Returns why nothing more arrives, in words for the player; empty while more may arrive. */
  public String end() {
    return ended ? message : "";
  }

  @Override
  public void close() {
    stop = true;
    try {
      thread.join(10 * LEAVE_MS);
      Files.deleteIfExists(file);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (IOException e) {
      System.err.println("carom-client: " + e);
    }
  }
}
