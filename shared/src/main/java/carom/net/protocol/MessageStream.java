package carom.net.protocol;

import java.util.ArrayDeque;

/**
 * One end of a session's reliable messages of the game, which survive a broken link. Messages are
 * numbered from 1 on in each direction. On a new link each end says which number it heard last, and
 * the other goes on behind it, as far back as it keeps messages: the last {@value #KEPT}. So each
 * message is heard once and in order, and one that is lost is known to be.
 *
 * <p>One thread.
 */
public final class MessageStream {
  /** Most messages that are kept, sent or not. */
  public static final int KEPT = 64;

  /** Sends messages over the present link. */
  @FunctionalInterface
  public interface Sender {
    /** Sends a message under its number. */
    void send(int number, byte[] bytes);
  }

  private final ArrayDeque<byte[]> kept = new ArrayDeque<>();
  private int lastOffered;
  private int lastSent;
  private int lastHeard;
  private boolean linked;

  /** Creates the end of a new session, without a link. */
  public MessageStream() {}

  /**
   * Takes a message to be sent by {@link #flush}.
   *
   * @return false when {@value #KEPT} wait for a link; this one is dropped
   */
  public boolean offer(byte[] bytes) {
    if (lastOffered - lastSent >= KEPT) {
      return false;
    }
    if (kept.size() == KEPT) {
      kept.remove();
    }
    kept.add(bytes);
    lastOffered++;
    return true;
  }

  /** Notes that there is no link; nothing is sent until {@link #begin}. */
  public void unlink() {
    linked = false;
  }

  /**
   * Begins with a new link: what the other end has not heard is sent again.
   *
   * @param number what it heard last; a number that was never sent means all
   */
  public void begin(int number) {
    linked = true;
    int oldest = lastOffered - kept.size();
    lastSent = Math.max(oldest, number < 0 ? oldest : Math.min(number, lastSent));
  }

  /** Sends what waits, if there is a link. */
  public void flush(Sender sender) {
    if (!linked || lastSent == lastOffered) {
      return;
    }
    int number = lastOffered - kept.size();
    for (byte[] bytes : kept) {
      if (++number > lastSent) {
        sender.send(number, bytes);
      }
    }
    lastSent = lastOffered;
  }

  /**
   * Notes a message that arrived.
   *
   * @return how many before it are lost, or -1 when it was heard already
   */
  public int hear(int number) {
    if (number <= lastHeard) {
      return -1;
    }
    int lost = number - lastHeard - 1;
    lastHeard = number;
    return lost;
  }

  /** Returns the number of the last message that arrived; 0 before the first. */
  public int lastHeard() {
    return lastHeard;
  }

  /** Returns how many messages wait for a link. */
  public int waiting() {
    return lastOffered - lastSent;
  }
}
