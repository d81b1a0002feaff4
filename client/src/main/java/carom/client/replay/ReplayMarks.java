package carom.client.replay;

import carom.replay.Replay;
import java.util.ArrayList;
import java.util.List;

/**
 * Saved ticks of a replay, from which going back starts. Holds at most {@value #MAX}: beyond that
 * it drops every second one and saves half as often. One replay's; one thread.
 */
final class ReplayMarks {
  /** Most marks. */
  static final int MAX = 64;

  private final List<Replay.SavedTick> marks = new ArrayList<>();
  private int gap;

  /** Drops all marks, and saves one per this many ticks from now on. */
  void reset(int newGap) {
    marks.clear();
    gap = newGap;
  }

  /** Saves the present tick if the last mark is far enough away. */
  void add(Replay replay) {
    int last = marks.isEmpty() ? -gap : marks.get(marks.size() - 1).tick();
    if (replay.simulation().tick() - last < gap || !replay.canMark()) {
      return;
    }
    marks.add(replay.mark());
    if (marks.size() > MAX) {
      for (int i = marks.size() - 1; i > 0; i -= 2) {
        marks.remove(i);
      }
      gap *= 2;
    }
  }

  /** Returns the newest marked tick that is not after a tick, or -1. */
  int before(int tick) {
    int found = -1;
    for (Replay.SavedTick mark : marks) {
      found = mark.tick() <= tick ? mark.tick() : found;
    }
    return found;
  }

  /** Restores a marked tick. */
  void restore(Replay replay, int tick) {
    for (Replay.SavedTick mark : marks) {
      if (mark.tick() == tick) {
        replay.reset(mark);
      }
    }
  }
}
