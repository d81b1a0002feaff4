package carom.server.recording;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The length or size of one file of a {@link RotatingRecording}.
 *
 * @param seconds length of the game in a file, s; 0 = no limit
 * @param bytes bytes written to the disk; 0 = no limit. A file may exceed it by the blocks that are
 *     queued for the disk, about two seconds of the game, and always holds at least {@value
 *     #LEAST_SECONDS} seconds
 */
public record RotationLimit(int seconds, long bytes) {
  /** The absence of a limit: a single file, however long and large. */
  public static final RotationLimit NEVER = new RotationLimit(0, 0);

  private static final int MAX_MINUTES = 1_440;
  private static final long MIB = 1L << 20;
  private static final long MAX_MIB = 2_048;

  /**
   * Shortest file that a limit by size can lead to, s. A file begins with the whole state, which
   * may be larger than the limit.
   */
  private static final int LEAST_SECONDS = 10;

  private static final Pattern TEXT = Pattern.compile("([0-9]{1,9})([MG]?)");

  /**
   * Parses a limit as an operator writes it.
   *
   * @param text minutes, 1..1440, or a size, 1M..2048M or 1G..2G; 0 is {@link #NEVER}
   * @throws IllegalArgumentException if it is none of these; the message says what is possible
   */
  public static RotationLimit parse(String text) {
    Matcher m = TEXT.matcher(text);
    if (m.matches()) {
      int number = Integer.parseInt(m.group(1));
      if (m.group(2).isEmpty()) {
        if (number <= MAX_MINUTES) {
          return number == 0 ? NEVER : new RotationLimit(60 * number, 0);
        }
      } else {
        long mib = m.group(2).equals("M") ? number : 1_024L * number;
        if (mib >= 1 && mib <= MAX_MIB) {
          return new RotationLimit(0, mib * MIB);
        }
      }
    }
    throw new IllegalArgumentException(
        text + " is neither minutes, 1..1440, nor a size, 1M..2048M or 1G..2G, nor 0 for never");
  }

  /** Returns whether there is a limit at all. */
  public boolean rotates() {
    return seconds > 0 || bytes > 0;
  }

  boolean isReached(double secondsWritten, long bytesWritten) {
    return (seconds > 0 && secondsWritten >= seconds)
        || (bytes > 0 && bytesWritten >= bytes && secondsWritten >= LEAST_SECONDS);
  }

  @Override
  public String toString() {
    return bytes > 0 ? bytes / MIB + " MiB" : seconds / 60 + " min";
  }
}
