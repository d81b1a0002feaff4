package carom.server;

import carom.server.metrics.Counter;
import carom.server.room.Room;
import carom.server.threads.LoaderThread;
import carom.server.threads.LoaderThread.Load;
import carom.server.threads.ThreadStack;
import carom.server.threads.Worker;
import java.util.function.Consumer;
import java.util.function.IntSupplier;
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

  private final Consumer<Room> replacement;
  private final Runnable giveUp;
  private final LoaderThread loads;
  private int abandoned;

  /**
   * Creates an object that has abandoned nothing.
   *
   * @param replacement replaces a room by another one, which begins as the last checkpoint has it
   * @param giveUp ends the server
   * @param loads builds rooms again
   */
  public HangingRooms(Consumer<Room> replacement, Runnable giveUp, LoaderThread loads) {
    this.replacement = replacement;
    this.giveUp = giveUp;
    this.loads = loads;
  }

  /** Abandons a room's thread. On the watchdog's thread. */
  public synchronized void abandon(Room room, Worker worker, String callback, ThreadStack stack) {
    room.counters().add(Counter.CALLBACKS_ABANDONED, 1);
    String game = "room %s: game %s".formatted(room.name(), room.match().game());
    count(game + " hangs in " + callback + " at tick " + (room.tick() + 1), worker.name(), stack);
    worker.abandon();
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
    try {
      replacement.accept(room);
    } catch (RuntimeException | Error e) {
      LOG.error("room {} can't begin again", room.name(), e);
      room.fail("its game hung, and it can't begin again");
      giveUp.run();
    }
  }
}
