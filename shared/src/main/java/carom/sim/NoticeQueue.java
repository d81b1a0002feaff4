package carom.sim;

import java.util.ArrayDeque;
import java.util.function.Consumer;

/** Short texts for all players that wait to be sent. Bounded: a full queue drops the newest. */
final class NoticeQueue {
  private final ArrayDeque<String> texts = new ArrayDeque<>();
  private long dropped;

  /** Adds a text, cut to {@link Simulation#MAX_NOTICE_LENGTH} characters. */
  void add(String text) {
    if (texts.size() == Simulation.MAX_NOTICES) {
      dropped++;
      return;
    }
    boolean fits = text.length() <= Simulation.MAX_NOTICE_LENGTH;
    texts.add(fits ? text : text.substring(0, Simulation.MAX_NOTICE_LENGTH));
  }

  /** Hands over all texts, oldest first, and removes them. */
  void drain(Consumer<String> consumer) {
    while (!texts.isEmpty()) {
      consumer.accept(texts.remove());
    }
  }

  long dropped() {
    return dropped;
  }
}
