package carom.server.fleet;

import carom.server.checkpoint.SlotLink;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Set;
import org.slf4j.LoggerFactory;

/** The links of a server to the others of its fleet. */
public interface Peers extends AutoCloseable {

  /** Hears what comes from other servers. Any thread, but one for each server. */
  interface Inbox {
    /** Takes a frame of another server. */
    void take(long server, PeerFrame frame) throws IOException;

    /** Answers a question: does what an operator says, or returns a save. */
    PeerFrame answer(PeerFrame question);

    /** Learns that the link from another server is lost, whatever became of that server. */
    void lost(long server);

    /** Learns that the process of another server is dead. */
    void dead(long server);
  }

  /** Opens a link to a server, unless there is one. Returns at once. */
  void reach(ServerRecord server);

  /** Closes the link to a server that is gone. Returns at once. */
  void forget(long server);

  /** Returns the servers to which there are links, or are about to be. */
  Set<Long> reached();

  /** Returns whether a server can be told something. */
  boolean isReached(long server);

  /**
   * Tells a server something. It may wait while that server is slow.
   *
   * @throws IOException if there is no link
   */
  void send(long server, PeerFrame frame) throws IOException;

  /** Does as {@link #send}, and returns whether there is a link. */
  default boolean tell(long server, PeerFrame frame) {
    try {
      send(server, frame);
      return true;
    } catch (IOException e) {
      LoggerFactory.getLogger(Peers.class).debug("fleet: {}", e.getMessage());
      return false;
    }
  }

  /**
   * Asks a server to say when it has done all that it was told. Returns at once, unless that server
   * is slow.
   *
   * @param then runs when it says so, on any thread; never if the link is lost before
   * @throws IOException if there is no link
   */
  void whenDone(long server, Runnable then) throws IOException;

  /**
   * Waits until a server has done all that it was told.
   *
   * @throws IOException if the link is lost, or it takes too long
   */
  void await(long server) throws IOException;

  /**
   * Asks a server something, over a link for that alone.
   *
   * @throws IOException if it can't be reached; the message says why
   */
  PeerFrame ask(ServerRecord server, PeerFrame question) throws IOException;

  /** Returns the question that tells a server what an operator says. */
  static PeerFrame command(String line) {
    return PeerFrame.of(PeerFrame.Kind.COMMAND, 0, "", line.getBytes(StandardCharsets.UTF_8));
  }

  /**
   * Returns what a server has answered to {@link #command}.
   *
   * @throws IOException if it can't do it; the message says why
   */
  static String words(ServerRecord server, PeerFrame answer) throws IOException {
    String words = new String(answer.bytes(), StandardCharsets.UTF_8);
    if (answer.number() != 0) {
      throw new IOException(server.name() + ": " + words);
    }
    return words;
  }

  @Override
  void close();

  /** Returns the way of a room's journal to a server. */
  default SlotLink journal(ServerRecord server, String room) {
    return new SlotLink() {
      @Override
      public String title() {
        return server.name();
      }

      @Override
      public void send(Step step, int slot, byte[] bytes, int offset, int length)
          throws IOException {
        int most = step == Step.LOG ? MOST_BYTES : length; // only a log may come in pieces
        int from = offset;
        do {
          int to = Math.min(offset + length, from + most);
          byte[] part = Arrays.copyOfRange(bytes, from, to);
          Peers.this.send(
              server.lease(),
              new PeerFrame(PeerFrame.Kind.STEP, 0, room, step.ordinal(), slot, part));
          from = to;
        } while (from < offset + length);
      }

      @Override
      public void whenThere(Runnable then) throws IOException {
        Peers.this.whenDone(server.lease(), then);
      }

      @Override
      public void await() throws IOException {
        Peers.this.await(server.lease());
      }
    };
  }

  /** Most bytes of a log in one frame. */
  int MOST_BYTES = 1 << 17;
}
