package carom.server.prediction;

import java.util.Arrays;

/**
 * Two marks for each entity id, all of which are removed at once. One object serves all sessions of
 * a room, because they choose their predicted sets one after the other. Allocates only to grow.
 */
final class EntityMarks {
  private int[] listed = new int[64];
  private int[] member = new int[64];
  private int round;

  /** Removes all marks. */
  void clear(int capacity) {
    round++;
    if (listed.length < capacity) {
      listed = Arrays.copyOf(listed, Math.max(2 * listed.length, capacity));
      member = Arrays.copyOf(member, listed.length);
    }
  }

  /** Marks an entity as listed. Returns false if it was already. */
  boolean list(int id) {
    boolean fresh = listed[id] != round;
    listed[id] = round;
    return fresh;
  }

  /** Removes the mark of a listed entity. */
  void unlist(int id) {
    listed[id] = 0;
  }

  /** Marks a listed entity as left out, because there is no room for all that it touches. */
  void leaveOut(int id) {
    listed[id] = -round;
  }

  boolean isLeftOut(int id) {
    return listed[id] == -round;
  }

  /** Returns whether an entity is marked as listed. */
  boolean isListed(int id) {
    return listed[id] == round;
  }

  /** Marks an entity as a member of the set that was chosen before. */
  void member(int id) {
    if (id < member.length) {
      member[id] = round;
    }
  }

  boolean isMember(int id) {
    return member[id] == round;
  }
}
