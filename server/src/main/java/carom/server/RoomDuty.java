package carom.server;

import carom.net.protocol.GoodbyeReason;
import carom.server.room.Room;
import carom.server.threads.Duty;

/** The work of a room. */
record RoomDuty(Room room) implements Duty {
  @Override
  public void turn(long nowNs) {
    room.doWork(nowNs);
  }

  @Override
  public long napNs(long nowNs) {
    return room.isPaused() ? Long.MAX_VALUE : room.nextDeadlineNs() - nowNs;
  }

  @Override
  public boolean hasLinks() {
    return !room.isDeserted();
  }

  @Override
  public int progress() {
    return room.age();
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
