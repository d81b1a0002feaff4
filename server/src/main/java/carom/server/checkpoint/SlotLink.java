package carom.server.checkpoint;

import java.io.IOException;

/** Carries the journal of one room to the server that follows it, where a {@link SlotMirror} is. */
public interface SlotLink {

  /** The steps in which a slot is written there. */
  enum Step {
    /** Bytes follow at the end of the slot's log. */
    LOG,
    /** The bytes say who plays at the checkpoint. */
    SEATS,
    /** The bytes say who plays now. */
    LATEST,
    /** The slot is of no more use. */
    DELETE
  }

  /** Returns the name of the other server, for logs. */
  String title();

  /**
   * Sends a step, after all before it. It may wait while the other server is slow.
   *
   * @param bytes are copied or sent before this returns
   * @throws IOException if the link is lost or the other server doesn't keep up
   */
  void send(Step step, int slot, byte[] bytes, int offset, int length) throws IOException;

  /**
   * Asks the other server to say when it has all that was sent. Returns at once.
   *
   * @param then runs when it says so, on any thread; never if the link is lost before
   * @throws IOException as above
   */
  void whenThere(Runnable then) throws IOException;

  /**
   * Waits until the other server has all that was sent.
   *
   * @throws IOException as above
   */
  void await() throws IOException;
}
