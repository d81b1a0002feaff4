package carom.server.checkpoint;

import carom.server.match.Match;
import carom.sim.outbox.NextMatch;

/** The place of a room in the sequence of its matches. The room's thread. */
public interface RoomCourse {
  /** Returns the present match. */
  Match match();

  /** Returns the index of the present match's level in the room's rotation. */
  int rotation();

  /** Returns the match that is wanted but not loaded yet, or null. */
  NextMatch pending();
}
