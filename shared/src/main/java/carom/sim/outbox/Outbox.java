package carom.sim.outbox;

import carom.sim.event.EventKind;
import carom.sim.message.Message;
import java.util.ArrayDeque;
import java.util.function.Consumer;

/**
 * Holds what a game has said until the program around the simulation takes it: notices, events,
 * messages, and what to play next. No part of the state; {@code Simulation.restore} leaves it
 * alone. Bounded. One thread.
 */
public final class Outbox {
  /** Most notices that wait for {@link #drainNotices}. More are dropped and counted. */
  public static final int MAX_NOTICES = 16;

  /** Longest notice, in characters. The rest is cut off. */
  public static final int MAX_NOTICE_LENGTH = 120;

  /** Most events that wait for {@link #drainEvents}. Beyond, the oldest are dropped and counted. */
  public static final int MAX_EVENTS = 1 << 10;

  /**
   * Most messages that wait for {@link #drainMessages}. Beyond, new ones are dropped and counted.
   */
  public static final int MAX_MESSAGES = 1 << 10;

  private final boolean decides;
  private final NoticeQueue notices = new NoticeQueue(MAX_NOTICES, MAX_NOTICE_LENGTH);
  private final EventLog events = new EventLog();
  private final ArrayDeque<Delivery> messages = new ArrayDeque<>();
  private NextMatch nextMatch;

  /**
   * Creates an empty outbox.
   *
   * @param decides whether notices, messages and the next match count, as on a server; events
   *     always do
   */
  public Outbox(boolean decides) {
    this.decides = decides;
  }

  /** Adds a notice; on {@code Role.PREDICTION} does nothing. */
  public void notice(String text) {
    if (decides) {
      notices.add(text);
    }
  }

  /** Adds an event for the caller to fill in. */
  public Event event(EventKind kind, int tick) {
    return events.add(kind, tick);
  }

  /**
   * Adds a message without recipients. It is not sent on {@code Role.PREDICTION}, or if {@value
   * #MAX_MESSAGES} wait already.
   */
  public Delivery send(Message message) {
    Delivery delivery = new Delivery(message);
    if (decides && messages.size() < MAX_MESSAGES) {
      messages.add(delivery);
    }
    return delivery;
  }

  /** Sets what the game wants to be played next; on {@code Role.PREDICTION} does nothing. */
  public void playNext(NextMatch next) {
    if (decides) {
      nextMatch = next;
    }
  }

  /** Returns what the game wants to be played next, and forgets it; null for nothing. */
  public NextMatch takeNextMatch() {
    NextMatch taken = nextMatch;
    nextMatch = null;
    return taken;
  }

  /** Passes on the notices since the last call, oldest first, and forgets them. */
  public void drainNotices(Consumer<String> consumer) {
    notices.drain(consumer);
  }

  /** Returns the number of notices that were lost because {@value #MAX_NOTICES} waited. */
  public long droppedNotices() {
    return notices.dropped();
  }

  /** Passes on the events since the last call in the order they were emitted, and forgets them. */
  public void drainEvents(Consumer<Event> consumer) {
    events.drain(consumer);
  }

  /** Returns the number of events that were lost because {@value #MAX_EVENTS} waited. */
  public long droppedEvents() {
    return events.dropped();
  }

  /** Passes on the messages sent since the last call, oldest first, and forgets them. */
  public void drainMessages(Consumer<Delivery> consumer) {
    while (!messages.isEmpty()) {
      consumer.accept(messages.remove());
    }
  }
}
