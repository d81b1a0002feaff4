package carom.net.codec;

/**
 * One pass over a section of a datagram. A section is described by one method that hands every
 * value to the pass and stores what the pass answers; the pass decides whether that writes ({@link
 * BitWriter}) or reads ({@link BitReader}). What is written and what is read can't drift apart.
 */
public interface BitPass extends PlainBits {

  /** Returns whether the values come from the pass: then what is described starts out empty. */
  boolean isReading();

  /**
   * Checks a value that the section's rules restrict. A reader fails, a writer asserts: its values
   * are the program's own.
   *
   * @return {@code holds}
   */
  boolean require(boolean holds);

  /**
   * Passes a signed number that is mostly near zero: 1 bit "not zero", then 5 bits for the width of
   * its zigzag form less one, then that form.
   */
  default int difference(int value) {
    int z = Bits.zigzag(value);
    if (!flag(z != 0)) {
      return 0;
    }
    int width = 1 + plain(Bits.width(z) - 1, 5);
    return Bits.unzigzag(plain(z, width));
  }
}
