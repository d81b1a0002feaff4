package carom.client.look;

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

  /** Throws unless two values are within a range, and the first isn't greater. */
  static void checkPair(String what, float first, float second, float least, float most) {
    check("least " + what, first, least, most);
    check("most " + what, second, first, most);
  }
}
