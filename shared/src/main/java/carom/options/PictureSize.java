package carom.options;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The size of pictures, as {@code --size 1280x720}.
 *
 * @param width 160..7,680 px
 * @param height 120..4,320 px
 */
public record PictureSize(int width, int height) {
  private static final Pattern SIZE = Pattern.compile("(\\d{1,5})x(\\d{1,5})");

  /**
   * Reads the value of the flag.
   *
   * @throws IllegalArgumentException with a message for people, if it is no size within the limits
   */
  public static PictureSize parse(String text) {
    Matcher sides = SIZE.matcher(text);
    int width = sides.matches() ? Integer.parseInt(sides.group(1)) : 0;
    int height = sides.matches() ? Integer.parseInt(sides.group(2)) : 0;
    if (width < 160 || width > 7_680 || height < 120 || height > 4_320) {
      throw new IllegalArgumentException("--size=" + text + " is not within 160x120..7680x4320");
    }
    return new PictureSize(width, height);
  }
}
