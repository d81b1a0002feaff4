package carom.client.replay;

import carom.client.ClientConfig;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.Protocol;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.transport.ClientTransport;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Downloads the recording of a room that is being played into a file that grows. A {@link
 * ReplayClient} of that file shows the game, as late as the server wants it.
 *
 * <p>It requests several pieces at once while there is much to download, and one piece a few times
 * a second at the end. One thread, driven by {@link #update}; nothing here waits.
 */
public final class RecordingDownload implements LinkHandler, AutoCloseable {
  private static final int PIECES_IN_FLIGHT = 16;
  private static final long ASK_AGAIN_NS = 200_000_000L;
  private static final long SILENCE_NS = 10_000_000_000L;
  private static final int MAX_POLL = 64;

  private final ClientConfig config;
  private final int room;
  private final ClientTransport transport;
  private final FileChannel file;
  private Link link;
  private boolean greeted;
  private int delaySeconds;
  private long received;
  private int pending;
  private boolean atEnd;
  private long nowNs;
  private long heardNs;
  private long askedNs;
  private boolean ended;
  private String message = "";
  private ServerMessage.Redirect redirect;

  /**
   * Creates a spectator that connects at the first {@link #update}.
   *
   * @param config names the server
   * @param room 1..255
   * @param transport opens the link; stays the caller's
   * @param target the file; overwritten
   * @throws IOException if the file can't be written
   */
  public RecordingDownload(ClientConfig config, int room, ClientTransport transport, Path target)
      throws IOException {
    this.config = config;
    this.room = room;
    this.transport = transport;
    file =
        FileChannel.open(
            target,
            StandardOpenOption.CREATE,
            StandardOpenOption.WRITE,
            StandardOpenOption.TRUNCATE_EXISTING);
  }

  /**
   * Takes in what has arrived and requests more.
   *
   * @param timeNs nanoseconds of any clock that never goes back
   */
  public void update(long timeNs) {
    nowNs = timeNs;
    if (ended) {
      return;
    }
    if (link == null) {
      heardNs = nowNs;
      link =
          transport.connect(
              config.get(ClientConfig.SERVER).host(),
              config.get(ClientConfig.SERVER).tcpPort(),
              config.get(ClientConfig.SERVER).udpPort());
    }
    link.poll(this, MAX_POLL);
    if (ended) {
      return;
    }
    if (!greeted && link.state() == Link.State.OPEN) {
      greeted = true;
      heardNs = nowNs;
      if (!config.get(ClientConfig.PASSWORD).isEmpty()) {
        link.send(new ClientMessage.Password(config.get(ClientConfig.PASSWORD)));
      }
      link.send(new ClientMessage.Watch(Protocol.VERSION, Protocol.physicsDigest(), room));
    }
    if (nowNs - heardNs > SILENCE_NS) {
      end(
          "No answer from "
              + config.get(ClientConfig.SERVER).host()
              + ". Check the address; is the server running?");
    } else if (delaySeconds > 0 && pending == 0 && (!atEnd || nowNs - askedNs >= ASK_AGAIN_NS)) {
      ask();
    }
  }

  private void ask() {
    askedNs = nowNs;
    pending = atEnd ? 1 : PIECES_IN_FLIGHT;
    for (int i = 0; i < pending; i++) {
      link.send(
          new ClientMessage.RecordingRequest(
              received + (long) i * ProtocolLimits.MAX_LEVEL_CHUNK_BYTES));
    }
  }

  @Override
  public void message(Link from, Object what) {
    heardNs = nowNs;
    if (what instanceof ServerMessage.Watching watching) {
      delaySeconds = watching.delaySeconds();
    } else if (what instanceof ServerMessage.RecordingChunk chunk && delaySeconds > 0) {
      take(chunk);
    } else if (what instanceof ServerMessage.Refused refused) {
      end(refused.playerText());
    } else if (what instanceof ServerMessage.Goodbye goodbye) {
      end(goodbye.playerText());
    } else if (what instanceof ServerMessage.Redirect to) {
      redirect = to;
      end(
          "The server at "
              + config.get(ClientConfig.SERVER).host()
              + " sends you to "
              + to.server()
              + ".");
    } else {
      end(
          "The server at "
              + config.get(ClientConfig.SERVER).host()
              + " sent something unexpected. Is it a Carom server?");
    }
  }

  private void take(ServerMessage.RecordingChunk chunk) {
    pending = Math.max(0, pending - 1);
    if (chunk.offset() != received) {
      return; // requested beyond the end
    }
    try {
      ByteBuffer bytes = ByteBuffer.wrap(chunk.bytes());
      while (bytes.hasRemaining()) {
        received += file.write(bytes, received);
      }
    } catch (IOException e) {
      end("What is watched can't be kept: " + e);
    }
    atEnd = chunk.bytes().length < ProtocolLimits.MAX_LEVEL_CHUNK_BYTES;
  }

  @Override
  public void datagram(Link from, byte[] bytes, int length) {
    // A spectator receives none.
  }

  @Override
  public void closed(Link from, String reason) {
    String cause = greeted ? "The connection was lost: " : "Can't reach the server: ";
    end(cause + reason + ".");
  }

  private void end(String why) {
    if (!ended) {
      ended = true;
      message = why;
      link.close(why);
    }
  }

  /** Returns whether the download has ended; {@link #message} says why. */
  public boolean ended() {
    return ended;
  }

  /** Returns why the download has ended, in words for the player, or an empty string. */
  public String message() {
    return message;
  }

  /** Returns where the server has sent this spectator; null if it has not. */
  public ServerMessage.Redirect redirect() {
    return redirect;
  }

  /** Returns how far behind the present the server keeps spectators, seconds; 0 before it tells. */
  public int delaySeconds() {
    return delaySeconds;
  }

  /** Returns how many bytes of the recording are here. */
  public long received() {
    return received;
  }

  /** Leaves the server and closes the file. */
  @Override
  public void close() {
    if (link != null && !ended) {
      link.send(new ClientMessage.Leave());
      end("left");
    }
    try {
      file.close();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
