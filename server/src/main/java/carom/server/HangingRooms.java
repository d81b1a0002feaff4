package carom.server;

import carom.server.metrics.Counter;
import carom.server.room.Room;
import carom.server.threads.LoaderThread.Load;
import carom.server.threads.Worker;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Deals with games that don't come back. Java can't end a thread, so the room's thread is
 * abandoned: it gets the lowest priority, and another room with a thread of its own takes the
 * room's place, from the last checkpoint if there is one. The links are closed, and the clients
 * come back to their bodies by themselves. The other rooms don't notice.
 *
 * <p>With {@value #MOST} abandoned threads, the server ends for its supervisor.
 */
final class HangingRooms {
  /** Abandoned threads with which the server ends. */
  public static final int MOST = 2;

  private static final Logger LOG = LoggerFactory.getLogger(HangingRooms.class);

  private final List<Room> rooms;
  private final IntFunction<Room> replacement;
  private final Consumer<Room> begin;
  private final Runnable giveUp;
  private int abandoned;

  /**
   * Creates an object that has abandoned nothing.
   *
   * @param rooms the live list of the server's rooms
   * @param replacement builds a room again, as its last checkpoint has it, by its place in the list
   * @param begin gives a room a thread
   * @param giveUp ends the server
   */
  public HangingRooms(
      List<Room> rooms, IntFunction<Room> replacement, Consumer<Room> begin, Runnable giveUp) {
    this.rooms = rooms;
    this.replacement = replacement;
    this.begin = begin;
    this.giveUp = giveUp;
  }

  /** Abandons a room's thread. On the watchdog's thread. */
  public synchronized void abandon(Room room, Worker worker, String callback, String stack) {
    room.counters().add(Counter.CALLBACKS_ABANDONED, 1);
    String game = "room %s: game %s".formatted(room.name(), room.match().game());
    count(game + " hangs in " + callback + " at tick " + (room.tick() + 1), worker.name(), stack);
    worker.abandon();
    room.abandon("the game hangs");
    if (!endsServer()) {
      // On a thread of its own, because the game's set-up may hang as well.
      Thread thread = new Thread(() -> replace(room), "carom-room-restart");
      thread.setDaemon(true);
      thread.start();
    }
  }

  /** Counts the thread of a match that is never built. On the watchdog's thread. */
  public synchronized void abandon(Load load, String thread, String where, String stack) {
    count(load.title() + ": its set-up hangs in " + where, thread, stack);
    endsServer();
  }

  private void count(String what, String thread, String stack) {
    String text = "{}; its thread {} is abandoned, the {}. of at most {}:\n{}";
    LOG.error(text, what, thread, ++abandoned, MOST, stack);
  }

  private boolean endsServer() {
    if (abandoned >= MOST) {
      LOG.error("{} threads are abandoned: the server ends; start it again", abandoned);
      giveUp.run();
    }
    return abandoned >= MOST;
  }

  private void replace(Room room) {
    int index = rooms.indexOf(room);
    try {
      Room next = replacement.apply(index);
      rooms.set(index, next);
      begin.accept(next);
    } catch (RuntimeException | Error e) {
      LOG.error("room {} can't begin again", room.name(), e);
      room.fail("its game hung, and it can't begin again");
      giveUp.run();
    }
  }
}
