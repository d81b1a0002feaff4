package carom.server.room;

import carom.server.checkpoint.RoomCheckpoints;

/**
 * The journals of a room, from which it can go on elsewhere: its checkpoints on the disk, and those
 * at the server that follows it. Either may be missing. The room's thread, but for {@link #isKept}
 * and {@link #abandon}.
 */
final class RoomJournals {
  private volatile RoomCheckpoints own;
  private volatile RoomCheckpoints follower;

  /** Sets the checkpoints on the disk. */
  void own(RoomCheckpoints checkpoints) {
    own = checkpoints;
  }

  /** Sets the checkpoints at the server that follows the room, null for none. */
  void follower(RoomCheckpoints checkpoints) {
    follower = checkpoints;
  }

  /** Returns the checkpoints at the server that follows the room, or null. */
  RoomCheckpoints follower() {
    return follower;
  }

  /** Returns whether nothing that happened must wait for the follower before it is told. */
  boolean isThere() {
    RoomCheckpoints present = follower;
    return present == null || present.isThere();
  }

  /** Goes on without the follower, until it has a whole state again. */
  void waitNoLonger() {
    if (follower != null) {
      follower.waitNoLonger();
    }
  }

  /** Returns whether players who come are kept in a moment; from any thread. */
  boolean isKept() {
    RoomCheckpoints kept = own == null ? follower : own;
    return kept != null && kept.isKept();
  }

  /**
   * Returns how many of the writes of accounts that the room has noted may be stored: those of
   * ticks that all journals have.
   *
   * @param noted how many it has noted
   */
  long accountsKept(long noted) {
    long byOwn = own == null ? noted : own.accountsKept(noted);
    return follower == null ? byOwn : Math.min(byOwn, follower.accountsKept(noted));
  }

  void tickEnds(long nowNs) {
    if (own != null) {
      own.tickEnds(nowNs);
    }
    if (follower != null) {
      follower.tickEnds(nowNs);
    }
  }

  void rests(long nowNs) {
    if (own != null) {
      own.rests(nowNs);
    }
    if (follower != null) {
      follower.rests(nowNs);
    }
  }

  void endMatch(String why) {
    if (own != null) {
      own.endMatch(why);
    }
    if (follower != null) {
      follower.endMatch(why);
    }
  }

  void beginMatch(long nowNs) {
    if (own != null) {
      own.beginMatch(nowNs);
    }
    if (follower != null) {
      follower.beginMatch(nowNs);
    }
  }

  void end(boolean good, long nowNs) {
    if (own != null) {
      own.end(good, nowNs);
    }
    if (follower != null) {
      follower.end(good, nowNs);
    }
  }

  void abandon(String why) {
    if (own != null) {
      own.abandon(why);
    }
    if (follower != null) {
      follower.abandon(why);
    }
  }
}
