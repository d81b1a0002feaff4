package carom.client.edit;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** The texts that a level had, for undo and redo; the oldest are forgotten. */
final class History {
  private static final int MOST_STEPS = 500;

  /** Bytes of all texts together. A parsed text takes about ten times as many. */
  private static final long MOST_BYTES = 16_000_000;

  /**
   * A text and what is selected in it.
   *
   * @param source the text
   * @param selection unmodifiable
   */
  record Step(LevelSource source, Set<Item> selection) {}

  private final List<Step> steps = new ArrayList<>();
  private int now;

  History(LevelSource first) {
    steps.add(new Step(first, Set.of()));
  }

  Step now() {
    return steps.get(now);
  }

  /** Goes on with another text; what was undone is forgotten. */
  void add(LevelSource source, Set<Item> selection) {
    steps.subList(now + 1, steps.size()).clear();
    steps.add(new Step(source, Set.copyOf(selection)));
    long bytes = steps.stream().mapToLong(step -> step.source.bytes().length).sum();
    while (steps.size() > 2 && (steps.size() > MOST_STEPS || bytes > MOST_BYTES)) {
      bytes -= steps.remove(0).source.bytes().length;
    }
    now = steps.size() - 1;
  }

  /** Goes steps forward or back. Returns whether there was one. */
  boolean go(int by) {
    int to = now + by;
    boolean possible = to >= 0 && to < steps.size();
    now = possible ? to : now;
    return possible;
  }
}
