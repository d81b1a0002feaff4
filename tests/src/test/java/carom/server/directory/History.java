package carom.server.directory;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Calls to a directory with the times at which they began and ended. It looks for an order in which
 * they can have taken effect: each between its beginning and its end, and each with the answer that
 * it got. A call that failed may take effect at any time after its beginning, or never. Keys are
 * independent of each other, so each is looked at alone (Wing and Gong's search, with the states it
 * has seen).
 */
final class History {
  /** What is stored at a key: number 0 is nothing. */
  private record State(long number, String value, long last) {}

  private interface Effect {
    /** Returns the state after it; null: it can't have happened in this state. */
    State on(State state);
  }

  private record Call(String name, long begin, long end, Effect effect) {}

  private final Map<String, List<Call>> calls = new HashMap<>();
  private final Map<String, Integer> creating = new HashMap<>();
  private int failures;

  private synchronized void add(String key, String name, long begin, Effect effect) {
    calls
        .computeIfAbsent(key, k -> new ArrayList<>())
        .add(new Call(name, begin, System.nanoTime(), effect));
  }

  private synchronized void addUnknown(String key, String name, long begin, Effect effect) {
    failures++;
    calls
        .computeIfAbsent(key, k -> new ArrayList<>())
        .add(new Call(name + "?", begin, Long.MAX_VALUE, effect));
  }

  /** Returns how many calls failed. */
  synchronized int failures() {
    return failures;
  }

  /**
   * Returns whether a call creates an entry now. It may have done so and try again, as it knows
   * nothing of it: if the entry is deleted meanwhile, it creates a second one.
   */
  synchronized boolean isCreating(String key) {
    return creating.getOrDefault(key, 0) > 0;
  }

  private synchronized void creating(String key, int more) {
    creating.merge(key, more, Integer::sum);
  }

  long create(Directory way, String key, String value) {
    creating(key, 1);
    try {
      return createNoted(way, key, value);
    } finally {
      creating(key, -1);
    }
  }

  private long createNoted(Directory way, String key, String value) {
    long begin = System.nanoTime();
    try {
      long number = way.create(key, value, 0);
      add(
          key,
          "create " + value + " = " + number,
          begin,
          s ->
              (s.number == 0) != (number > 0) || (number > 0 && number <= s.last)
                  ? null
                  : number > 0 ? new State(number, value, number) : s);
      return number;
    } catch (DirectoryException e) {
      // Its number isn't known: -1 fits whatever number is seen with this value.
      addUnknown(
          key, "create " + value, begin, s -> s.number == 0 ? new State(-1, value, s.last) : null);
      return 0;
    }
  }

  void update(Directory way, String key, String value, long number) {
    long begin = System.nanoTime();
    try {
      boolean done = way.update(key, value, number);
      add(
          key,
          "update " + number + " " + value + " = " + done,
          begin,
          s -> {
            State known = s.number == -1 && done ? new State(number, s.value, number) : s;
            return (known.number == number && number > 0) != done
                ? null
                : done ? new State(number, value, known.last) : s;
          });
    } catch (DirectoryException e) {
      addUnknown(
          key,
          "update " + number + " " + value,
          begin,
          s -> s.number == number || s.number == -1 ? new State(number, value, s.last) : null);
    }
  }

  void delete(Directory way, String key, long number) {
    long begin = System.nanoTime();
    try {
      boolean done = way.delete(key, number);
      add(
          key,
          "delete " + number + " = " + done,
          begin,
          s ->
              done && (s.number == number || s.number == -1)
                  ? new State(0, "", Math.max(s.last, number))
                  : done || (s.number == number && number > 0) ? null : s);
    } catch (DirectoryException e) {
      addUnknown(
          key,
          "delete " + number,
          begin,
          s ->
              s.number == number || s.number == -1
                  ? new State(0, "", Math.max(s.last, number))
                  : null);
    }
  }

  DirectoryEntry get(Directory way, String key) {
    long begin = System.nanoTime();
    try {
      DirectoryEntry entry = way.get(key);
      add(
          key,
          "get = " + entry,
          begin,
          s -> {
            if (entry == null || s.number == 0) {
              return entry == null && s.number == 0 ? s : null;
            }
            boolean fits =
                s.number == entry.number() || (s.number == -1 && entry.number() > s.last);
            return fits && s.value.equals(entry.value())
                ? new State(entry.number(), s.value, entry.number())
                : null;
          });
      return entry;
    } catch (DirectoryException e) {
      return null;
    }
  }

  /** Fails if no order explains the answers. */
  synchronized void check(String hint) {
    calls.forEach(
        (key, all) -> {
          all.sort((a, b) -> Long.compare(a.begin, b.begin));
          Set<Object> seen = new HashSet<>();
          if (!search(all, new BitSet(), new State(0, "", 0), seen)) {
            StringBuilder text =
                new StringBuilder(hint + ": no order explains the calls to " + key);
            all.forEach(
                c ->
                    text.append("\n")
                        .append(c.begin)
                        .append("..")
                        .append(c.end)
                        .append(" ")
                        .append(c.name));
            throw new AssertionError(text);
          }
        });
  }

  private static boolean search(List<Call> all, BitSet done, State state, Set<Object> seen) {
    if (!seen.add(List.of(done.clone(), state))) {
      return false;
    }
    long firstEnd = Long.MAX_VALUE;
    for (int i = done.nextClearBit(0); i < all.size(); i = done.nextClearBit(i + 1)) {
      firstEnd = Math.min(firstEnd, all.get(i).end);
    }
    if (firstEnd == Long.MAX_VALUE) {
      return true; // what is left has failed
    }
    for (int i = done.nextClearBit(0); i < all.size(); i = done.nextClearBit(i + 1)) {
      Call call = all.get(i);
      if (call.begin > firstEnd) {
        break;
      }
      State next = call.effect.on(state);
      if (next != null) {
        done.set(i);
        if (search(all, done, next, seen)) {
          return true;
        }
        done.clear(i);
      }
    }
    return false;
  }
}
