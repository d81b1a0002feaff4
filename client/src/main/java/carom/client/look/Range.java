package carom.client.look;

import carom.physics.math.Limits;
import java.util.List;

/** Refuses numbers that can't be meant. */
final class Range {
  private Range() {}

  /**
   * Returns a value that is within a range.
   *
   * @param what names it, for the message
   * @throws IllegalArgumentException for a value outside, and for NaN
   */
  static float check(String what, float value, float least, float most) {
    if (!(value >= least && value <= most)) {
      throw new IllegalArgumentException(what + "=" + value + " is outside " + least + ".." + most);
    }
    return value;
  }

  /** Returns a whole value that is within a range; throws as {@link #check} does. */
  static int check(String what, int value, int least, int most) {
    if (value < least || value > most) {
      throw new IllegalArgumentException(what + "=" + value + " is outside " + least + ".." + most);
    }
    return value;
  }

  /**
   * Returns the elements of an array as a list that nobody changes.
   *
   * @param what names one of them, for the message
   * @throws NullPointerException if the array or one of them is null
   */
  static <T> List<T> all(String what, T[] elements) {
    for (T element : Limits.notNull(what, elements)) {
      Limits.notNull(what, element);
    }
    return List.of(elements);
  }

  /** Throws unless two values are within a range, and the first isn't greater. */
  static void checkPair(String what, float first, float second, float least, float most) {
    check("least " + what, first, least, most);
    check("most " + what, second, first, most);
  }
}
