package carom.sim.outbox;

import java.util.ArrayDeque;
import java.util.function.Consumer;

/** Short texts for all players that wait to be sent. A full queue drops the newest text. */
final class NoticeQueue {
  private final int maxNotices;
  private final int maxLength;
  private final ArrayDeque<String> texts = new ArrayDeque<>();
  private long dropped;

  /**
   * Creates an empty queue.
   *
   * @param maxNotices most texts that wait
   * @param maxLength longest text, in characters; the rest is cut off
   */
  public NoticeQueue(int maxNotices, int maxLength) {
    this.maxNotices = maxNotices;
    this.maxLength = maxLength;
  }

  /** Adds a text, or counts it as dropped if the queue is full. */
  public void add(String text) {
    if (texts.size() == maxNotices) {
      dropped++;
      return;
    }
    texts.add(text.length() <= maxLength ? text : text.substring(0, maxLength));
  }

  /** Passes all texts on, oldest first, and removes them. */
  public void drain(Consumer<String> consumer) {
    while (!texts.isEmpty()) {
      consumer.accept(texts.remove());
    }
  }

  /** Returns the number of texts that were dropped because the queue was full. */
  public long dropped() {
    return dropped;
  }
}
