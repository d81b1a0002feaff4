package carom.server.threads;

import java.util.ArrayList;
import java.util.List;

/**
 * Decides which thread of a pool takes which item, and when each thread looks again.
 *
 * <p>Each thread has a line of items that wait for it. With as many threads as items, each item has
 * a thread of its own, whose core keeps its memory in the cache. An item whose turn is late by
 * {@value #PATIENCE_US} us because its thread is busy goes over to the line of another thread, and
 * stays there. So a long turn delays no other item while a thread is free, and items whose turns
 * collide end up in different lines.
 *
 * <pre>
 *   rests ──wake──► waits in a line ──take──► has its turn ──put──► waits, or rests
 *                     │        ▲
 *                     └─ late ─┘  of another thread
 * </pre>
 *
 * <p>A thread that is free looks after the lines of those that are busy: it wakes when an item
 * there would be late. One such thread is enough, so a thread that begins a turn asks {@link
 * #guard} for one that must be woken, which mostly is none.
 *
 * <p>Between the turns that an item needs, it may have turns that are merely good for it, because
 * its links may bring something. A thread that is awake takes those a little before their time
 * together, so that it sleeps longer.
 *
 * <p>Reads no clock: times come from the caller, in ns. One thread at a time. No allocation but
 * when lines grow.
 */
final class TurnSchedule {
  /** Time between turns of an item with links, ms. */
  static final int POLL_MS = 4;

  /** Time for which an item waits for its own thread before another one takes it, us. */
  static final int PATIENCE_US = 500;

  private static final long POLL_NS = 1_000_000L * POLL_MS;
  private static final long PATIENCE_NS = 1_000L * PATIENCE_US;

  /** Time by which a turn that isn't needed yet comes early if its thread is awake anyway. */
  private static final long EARLY_NS = POLL_NS / 2;

  /** A time that never comes. */
  static final long NEVER = Long.MAX_VALUE;

  /** Something that has turns. */
  static class Item {
    /** The line in which it waits or whose thread it has; the one before while it rests. */
    private Line line;

    /** When it wants a turn. */
    private long dueNs;

    /** When it needs a turn: not before {@link #dueNs}. */
    private long neededNs;

    private boolean waits;
    private boolean runs;
    private boolean woken;
  }

  /** The items that wait for one thread, and what that thread does. */
  static final class Line {
    /** Sorted: the first that is due comes last. */
    private final List<Item> waiting = new ArrayList<>();

    private Item running;

    /** When the thread is expected to be back from its turn if that is short. */
    private long backNs;

    /** When the thread looks again, while it has no turn. */
    private long looksNs;

    private int count() {
      return waiting.size() + (running == null ? 0 : 1);
    }

    private Item first() {
      return waiting.get(waiting.size() - 1);
    }

    /** Returns whether an item is due before a time; cheap. */
    private boolean isDueBefore(long timeNs) {
      return !waiting.isEmpty() && first().dueNs < timeNs;
    }

    /** Returns the item that needs a turn first, or null. */
    private Item neediest() {
      Item neediest = null;
      for (int i = waiting.size() - 1; i >= 0; i--) {
        Item item = waiting.get(i);
        if (neediest == null || item.neededNs < neediest.neededNs) {
          neediest = item;
        }
      }
      return neediest;
    }

    private void insert(Item item) {
      int at = waiting.size();
      while (at > 0 && waiting.get(at - 1).dueNs <= item.dueNs) {
        at--;
      }
      waiting.add(at, item);
      item.line = this;
      item.waits = true;
    }

    private void remove(Item item) {
      waiting.remove(item);
      item.waits = false;
    }
  }

  private final List<Line> lines = new ArrayList<>();

  /** Adds the line of another thread, which looks at once. */
  Line addLine(long nowNs) {
    Line line = new Line();
    line.looksNs = nowNs;
    lines.add(line);
    return line;
  }

  /**
   * Adds an item.
   *
   * @param neededNs when it needs its first turn
   * @return the line of a thread that must look now, or null
   */
  Line add(Item item, long neededNs, long nowNs) {
    item.line = shortest(lines.get(0));
    return putInto(item.line, item, neededNs, neededNs, nowNs);
  }

  /**
   * Returns the item whose turn a thread has to run now, or null if it may nap. The thread's turn
   * before must have ended.
   */
  Item take(Line line, long nowNs) {
    Item first = line.waiting.isEmpty() ? null : line.first();
    Item item = first != null && first.dueNs <= nowNs ? first : late(line, nowNs);
    if (item == null) {
      boolean early =
          first != null && first.dueNs < first.neededNs && first.dueNs - nowNs <= EARLY_NS;
      if (!early) {
        return null;
      }
      item = first;
    }
    item.line.remove(item);
    item.line = line;
    item.runs = true;
    item.woken = false;
    line.running = item;
    line.backNs = item.neededNs <= nowNs ? nowNs : nowNs + POLL_NS;
    return item;
  }

  /** Returns the item that has waited longest for a thread that is busy, if too long; or null. */
  private Item late(Line own, long nowNs) {
    Item latest = null;
    for (int i = 0; i < lines.size(); i++) {
      Line line = lines.get(i);
      if (line != own && line.running != null && line.isDueBefore(nowNs - PATIENCE_NS + 1)) {
        Item item = line.neediest();
        boolean late = item.neededNs <= nowNs - PATIENCE_NS;
        if (late && (latest == null || item.neededNs < latest.neededNs)) {
          latest = item;
        }
      }
    }
    return latest;
  }

  /**
   * Returns the line of a free thread that must look now, so that no item waits for too long behind
   * turns that last; or null. Ask when a turn begins.
   */
  Line guard(long nowNs) {
    long lateNs = lateNs(nowNs);
    Line free = null;
    for (int i = 0; i < lines.size(); i++) {
      Line line = lines.get(i);
      if (line.running == null) {
        if (line.looksNs <= lateNs) {
          return null;
        }
        free = line;
      }
    }
    return free == null || lateNs == NEVER ? null : look(free, nowNs);
  }

  /** Returns when the first item will be late that waits for a busy thread, not in the past. */
  private long lateNs(long nowNs) {
    long lateNs = NEVER;
    for (int i = 0; i < lines.size(); i++) {
      Line line = lines.get(i);
      if (line.running != null && line.isDueBefore(lateNs)) {
        long neededNs = line.neediest().neededNs;
        if (neededNs != NEVER) {
          lateNs = Math.min(lateNs, Math.max(neededNs, line.backNs) + PATIENCE_NS);
        }
      }
    }
    return lateNs == NEVER ? NEVER : Math.max(lateNs, nowNs);
  }

  private static Line look(Line line, long nowNs) {
    line.looksNs = nowNs;
    return line;
  }

  /**
   * Ends the turn of an item, which waits for the next.
   *
   * @param napNs time until it needs that; {@link #NEVER} if it rests
   * @param hasLinks whether it wants turns meanwhile
   * @return the line of a thread that must look now, or null
   */
  Line put(Item item, long napNs, boolean hasLinks, long nowNs) {
    Line own = item.line;
    endTurn(item);
    long restNs = item.woken ? 0 : Math.max(0, napNs); // who is late queues up behind others
    long neededNs = restNs >= NEVER - nowNs ? NEVER : nowNs + restNs;
    long dueNs = hasLinks ? Math.min(neededNs, nowNs + POLL_NS) : neededNs;
    if (dueNs == NEVER) {
      return null;
    }
    Line line = own.waiting.isEmpty() ? own : shortest(own);
    return putInto(line.count() == 0 ? line : own, item, dueNs, neededNs, nowNs);
  }

  /** Ends the turn of an item, which has none any more. */
  void endTurn(Item item) {
    item.runs = false;
    if (item.line.running == item) { // or another thread has its place
      item.line.running = null;
      item.line.looksNs = NEVER; // its thread takes or naps next, which says when
    }
  }

  private Line putInto(Line line, Item item, long dueNs, long neededNs, long nowNs) {
    item.dueNs = dueNs;
    item.neededNs = neededNs;
    line.insert(item);
    if (line.running != null) {
      return guard(nowNs);
    }
    return line.looksNs > dueNs ? look(line, nowNs) : null;
  }

  /** Returns the line with the fewest items; the given one if no other has fewer. */
  private Line shortest(Line first) {
    Line shortest = first;
    for (int i = 0; i < lines.size(); i++) {
      if (lines.get(i).count() < shortest.count()) {
        shortest = lines.get(i);
      }
    }
    return shortest;
  }

  /**
   * Gives an item a turn soon.
   *
   * @return the line of a thread that must look now, or null
   */
  Line wake(Item item, long nowNs) {
    if (item.runs) {
      item.woken = true;
      return null;
    }
    Line line = item.line;
    if (item.waits) {
      line.remove(item);
    } else {
      line = shortest(line);
    }
    return putInto(line, item, nowNs, nowNs, nowNs);
  }

  /**
   * Returns for how long a thread without a turn may sleep, ns; {@link #NEVER} until it must look.
   */
  long nap(Line line, long nowNs) {
    line.looksNs = NEVER; // so that guard() doesn't count on it
    long looksNs = line.waiting.isEmpty() ? NEVER : line.first().dueNs;
    long lateNs = lateNs(nowNs);
    if (lateNs < looksNs && !hasGuard(lateNs)) {
      looksNs = lateNs;
    }
    line.looksNs = looksNs;
    return looksNs == NEVER ? NEVER : looksNs - nowNs;
  }

  private boolean hasGuard(long lateNs) {
    for (int i = 0; i < lines.size(); i++) {
      if (lines.get(i).running == null && lines.get(i).looksNs <= lateNs) {
        return true;
      }
    }
    return false;
  }

  /**
   * Gives a thread's line to another thread, which looks at once. The first one keeps its item
   * until its turn ends.
   */
  void replace(Line line, long nowNs) {
    line.running = null;
    line.looksNs = nowNs;
  }
}
