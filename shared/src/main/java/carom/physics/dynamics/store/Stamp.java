package carom.physics.dynamics.store;

/**
 * Tells whether something changed between two moments: its copies with an equal stamp have equal
 * contents, so that saving and restoring can leave out what rarely changes.
 *
 * <p>Only the stamp of the living object is ever changed; those of copies take its values over. A
 * value is never used again, even when an old one comes back by restoring.
 */
public final class Stamp {
  private long value;
  private long next = 1;

  /** Makes the stamp of something empty. */
  public Stamp() {}

  /** Notes a change of the contents. */
  public void change() {
    value = next++;
  }

  /**
   * Returns whether nothing changed between the two.
   *
   * @param other the stamp of a copy, or of the original
   * @return true if the contents are equal
   */
  public boolean same(Stamp other) {
    return value == other.value;
  }

  /**
   * Notes that the contents were copied.
   *
   * @param to the stamp of the copy
   */
  public void copyTo(Stamp to) {
    to.value = value;
  }

  /**
   * Gives a copy that was filled in another way a value of its own, which none had before.
   *
   * @param copy its stamp
   */
  public void distinguish(Stamp copy) {
    copy.value = next++;
  }
}
