package carom.server.checkpoint;

import carom.net.protocol.SessionState;
import carom.server.session.Seats;
import carom.server.session.Session;
import java.util.ArrayList;
import java.util.List;

/**
 * The seats that the file beside a log must have. The file is written before each block of the log,
 * and holds all who play before or after that block. So wherever the log ends, each player that it
 * has there has a seat in the file, and the log alone decides who plays.
 *
 * <pre>
 *   log     ticks of block 7 │ Ann leaves, Bob joins: block 8 │ block 9
 *   file                 Ann, Bob                            Bob
 * </pre>
 *
 * <p>The room's thread.
 */
final class SlotSeats {
  private static final long NS_PER_MS = 1_000_000;

  private final Seats seats;
  private final Session[] bySeat;

  /** The last file. */
  private List<SavedSeat> written = List.of();

  /** Those of {@link #written} who still played then. */
  private int presentCount;

  /**
   * Creates the seats of a room without a file.
   *
   * @param bySeat as in {@link RoomCheckpoints.KeptRoom}
   */
  SlotSeats(Seats seats, Session[] bySeat) {
    this.seats = seats;
    this.bySeat = bySeat;
  }

  /** Begins another slot, whose log has no players yet. */
  void clear() {
    written = List.of();
    presentCount = 0;
  }

  /**
   * Returns the seats of the next file.
   *
   * @param firstTick the first tick of the block behind the file, or that of the state that begins
   *     the log
   * @param events tells what the players may not have heard of
   */
  List<SavedSeat> next(int firstTick, SavedEvents events, long nowNs) {
    List<SavedSeat> next = new ArrayList<>();
    for (Session session : bySeat) {
      if (session != null) {
        boolean left = session.state() == SessionState.GRACE;
        // A process that stood still learns of lost links by a newer clock than its last tick's.
        long leftMs = Math.max(0, (session.graceEndNs() - nowNs) / NS_PER_MS);
        leftMs = Math.min(leftMs, SavedSeat.MAX_GRACE_MS);
        int graceMs = left ? (int) leftMs : SavedSeat.PLAYED;
        next.add(saved(session.seat(), graceMs, false, firstTick, events));
      }
    }
    int present = next.size();
    for (Seats.Seat seat : seats.reserved()) {
      next.add(saved(seat, SavedSeat.PLAYED, true, firstTick, events));
    }
    for (SavedSeat before : written.subList(0, presentCount)) {
      if (next.stream().noneMatch(s -> s.id() == before.id() && s.secret() == before.secret())) {
        next.add(before);
      }
    }
    written = next;
    presentCount = present;
    return next;
  }

  private SavedSeat saved(
      Seats.Seat seat, int graceMs, boolean reserved, int firstTick, SavedEvents events) {
    int since = firstTick;
    for (SavedSeat before : written) {
      since = before.is(seat) ? before.sinceTick() : since;
    }
    return new SavedSeat(
        seat.id(),
        seat.wantedName(),
        seat.name(),
        seat.account(),
        seat.party(),
        seat.skill().claim(),
        seat.secret(),
        seat.isMuted(),
        graceMs,
        seat.courseTick(),
        seat.switches(),
        reserved,
        since,
        seat.stay(),
        events.lackedBy(seat.secret()));
  }

  /** Returns the players' seats that still have one behind in another room. */
  List<Seats.Seat> unsettled() {
    List<Seats.Seat> all = new ArrayList<>(0);
    for (Session session : bySeat) {
      if (session != null && !session.seat().isSettled()) {
        all.add(session.seat());
      }
    }
    return all;
  }
}
