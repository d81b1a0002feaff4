package carom.server;

import carom.server.metrics.Counter;
import carom.server.room.Room;
import carom.server.threads.LoaderThread;
import carom.server.threads.LoaderThread.Load;
import carom.server.threads.ThreadStack;
import java.util.function.Consumer;
import java.util.function.IntSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Deals with games that don't come back. Java can't end a thread, so the thread is abandoned: it
 * gets the lowest priority, and another one has its place in the pool. Another room takes the
 * room's place, from the last checkpoint if there is one. The links are closed, and the clients
 * come back to their bodies by themselves. The other rooms don't notice.
 *
 * <p>With as many abandoned threads as the pool has, the server ends for its supervisor. A callback
 * that loops takes a processor for good. With fewer, the rooms still have the larger part of the
 * machine.
 */
final class HangingRooms {
  private static final Logger LOG = LoggerFactory.getLogger(HangingRooms.class);

  private final Consumer<Room> replacement;
  private final Runnable giveUp;
  private final LoaderThread loads;
  private final int most;
  private int abandoned;

  /**
   * Creates an object that has abandoned nothing.
   *
   * @param replacement replaces a room by another one, which begins as the last checkpoint has it
   * @param giveUp ends the server
   * @param loads builds rooms again
   * @param most abandoned threads with which the server ends
   */
  public HangingRooms(Consumer<Room> replacement, Runnable giveUp, LoaderThread loads, int most) {
    this.replacement = replacement;
    this.giveUp = giveUp;
    this.loads = loads;
    this.most = most;
  }

  /** Gives up a room whose thread is abandoned. On the watchdog's thread. */
  public synchronized void abandon(Room room, String thread, String callback, ThreadStack stack) {
    room.counters().add(Counter.CALLBACKS_ABANDONED, 1);
    String game = "room %s: game %s".formatted(room.name(), room.match().game());
    count(game + " hangs in " + callback + " at tick " + (room.tick() + 1), thread, stack);
    room.abandon("the game hangs");
    if (!endsServer()) {
      // Where it is found if the game's set-up hangs as well.
      IntSupplier progress = () -> (int) room.counters().get(Counter.TICKS_REPLAYED);
      loads.execute(Load.of("room " + room.name(), progress, () -> replace(room)));
    }
  }

  /** Counts the thread of a match that is never built. On the watchdog's thread. */
  public synchronized void abandon(Load load, String thread, String where, ThreadStack stack) {
    count(load.title() + ": its set-up hangs in " + where, thread, stack);
    endsServer();
  }

  private void count(String what, String thread, ThreadStack stack) {
    String text = "{}; its thread {} is abandoned, the {}. of at most {}:";
    LOG.error(text, what, thread, ++abandoned, most, stack);
  }

  private boolean endsServer() {
    if (abandoned >= most) {
      LOG.error(
          "{} threads are abandoned, as many as rooms have: the server ends; start it again",
          abandoned);
      giveUp.run();
    }
    return abandoned >= most;
  }

  private void replace(Room room) {
    try {
      replacement.accept(room);
    } catch (RuntimeException | Error e) {
      LOG.error("room {} can't begin again", room.name(), e);
      room.fail("its game hung, and it can't begin again");
      giveUp.run();
    }
  }
}
