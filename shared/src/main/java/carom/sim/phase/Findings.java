package carom.sim.phase;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * The things that a game does again and again although no client can predict them, each once, with
 * advice. An example: {@code beforeStep pushes entity 17 (crate) every tick, so clients can't
 * predict it; use Game.forces. First seen at tick 311.} For developers: a finding changes nothing.
 *
 * <p>One thread. Allocates for a finding only.
 */
public final class Findings {
  /** Most findings that are kept. */
  public static final int MOST = 64;

  private final List<String> texts = new ArrayList<>();
  private final Set<String> known = new TreeSet<>();

  /** Creates an empty list. */
  public Findings() {}

  /**
   * Returns whether something is still to be told.
   *
   * @param id says what it is, such as callback, deed and kind of entity
   */
  public boolean isNew(String id) {
    return texts.size() < MOST && !known.contains(id);
  }

  /**
   * Adds a finding, unless there was one of the same id.
   *
   * @param id as for {@link #isNew}
   * @param text what the game does, and how to mend it
   */
  public void add(String id, String text) {
    if (isNew(id)) {
      known.add(id);
      texts.add(text);
    }
  }

  /** Returns the number of findings. It never shrinks. */
  public int count() {
    return texts.size();
  }

  /** Returns the text of a finding, in the order in which they were found. */
  public String get(int index) {
    return texts.get(index);
  }

  /** Returns all texts, one a line; empty if nothing was found. */
  @Override
  public String toString() {
    return String.join("\n", texts);
  }
}
