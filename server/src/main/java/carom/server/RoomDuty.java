package carom.server;

import carom.net.protocol.GoodbyeReason;
import carom.server.room.Room;
import carom.server.threads.Worker;
import java.util.concurrent.TimeUnit;

/** The work of a room's thread, which begins at {@code beginNs}. */
record RoomDuty(Room room, long beginNs) implements Worker.Duty {
  /** Longest nap, ns. The thread also empties the inboxes between ticks. */
  private static final long NAP_NS = TimeUnit.MILLISECONDS.toNanos(4);

  @Override
  public void turn(long nowNs) {
    if (nowNs - beginNs >= 0) {
      room.doWork(nowNs);
    }
  }

  @Override
  public long napNs(long nowNs) {
    if (nowNs - beginNs < 0) {
      return beginNs - nowNs;
    }
    if (room.isPaused()) {
      return room.isDeserted() ? Long.MAX_VALUE : NAP_NS; // who needs the room wakes its thread
    }
    return Math.min(room.nextDeadlineNs() - nowNs, NAP_NS);
  }

  @Override
  public boolean hasFailed() {
    return room.hasFailed();
  }

  @Override
  public void fail(String why) {
    room.fail(why);
  }

  @Override
  public void close(long nowNs) {
    room.close(GoodbyeReason.SERVER_STOPPING, "", nowNs);
  }

  @Override
  public boolean isDeserted() {
    return room.isDeserted();
  }

  @Override
  public void closeLinks() {
    room.closeLinks();
  }
}
