package carom.client.replay;

import carom.client.ClientConfig;
import carom.client.link.Redirects;
import carom.client.link.ServerAddress;
import carom.net.protocol.ServerMessage;
import carom.net.transport.ClientTransport;
import carom.replay.RecordingReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Runs a {@link RecordingDownload} on a thread of its own, so that its file grows while another
 * thread plays it. The file is temporary; closing deletes it.
 */
public final class SpectatorThread implements AutoCloseable {
  private static final long NAP_MS = 5;
  private static final long LEAVE_MS = 200;
  private static final long EXTRA_S = 10;

  private final ClientConfig config;
  private final int room;
  private final ClientTransport transport;
  private final Redirects redirects;
  private final Path file;
  private final RecordingDownload spectator;
  private final Thread thread;
  private final long beginNs = System.nanoTime();
  private volatile boolean stop;
  private volatile int delaySeconds;
  private volatile String message = "";
  private volatile ServerMessage.Redirect redirect;
  private volatile boolean ended;

  /** Reason why the redirect isn't followed; empty without one. */
  private String refusal = "";

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
    this(config, room, transport, new Redirects());
  }

  private SpectatorThread(
      ClientConfig config, int room, ClientTransport transport, Redirects redirects)
      throws IOException {
    this.config = config;
    this.room = room;
    this.transport = transport;
    this.redirects = redirects;
    file = Files.createTempFile("carom-watched", ".carom");
    file.toFile().deleteOnExit();
    spectator = new RecordingDownload(config, room, transport, file);
    thread = new Thread(this::run, "carom-spectator");
    thread.setDaemon(true);
    thread.start();
  }

  private void run() {
    while (!stop) {
      spectator.update(System.nanoTime());
      delaySeconds = spectator.delaySeconds();
      message = spectator.message();
      redirect = spectator.redirect();
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

  /**
   * Watches the room of the same number on the server to which this one has sent the spectator.
   * This object and its file stay as they are: what has arrived can be watched to its end.
   *
   * @return a new thread, or null if there is nothing to follow; {@link #message} says why
   * @throws IOException if the temporary file can't be written
   */
  public SpectatorThread follow() throws IOException {
    ServerMessage.Redirect to = redirect;
    if (!ended || to == null) {
      return null;
    }
    redirect = null;
    ServerAddress next;
    try {
      ServerAddress from =
          new ServerAddress(
              config.get(ClientConfig.SERVER).host(),
              config.get(ClientConfig.SERVER).tcpPort(),
              config.get(ClientConfig.SERVER).udpPort());
      next = redirects.follow(to, from, System.nanoTime());
    } catch (IllegalArgumentException e) {
      refusal = e.getMessage();
      return null;
    }
    if (!to.fingerprint().isEmpty()) {
      transport.expect(next.toString(), to.fingerprint());
    }
    ClientConfig there = config.withServer(next.host(), next.tcpPort(), next.udpPort());
    return new SpectatorThread(there, room, transport, redirects);
  }

  /** Returns the recording's file. */
  public Path file() {
    return file;
  }

  /** Returns whether there is something to play. Opens the file, so don't ask in each frame. */
  public boolean isReady() {
    try (RecordingReader reader = RecordingReader.open(file)) {
      // Without the state that may follow the header, the replay would begin with an empty game.
      return reader.next() != RecordingReader.Entry.WAIT;
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
    if (!refusal.isEmpty()) {
      return refusal;
    }
    return message.isEmpty() ? "There is nothing to watch yet; try again later." : message;
  }

  /** Returns why nothing more arrives, in words for the player; empty while more may arrive. */
  public String end() {
    return ended ? message() : "";
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
