package carom.client.edit;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A thing of a level by its place in the file.
 *
 * @param list name of its list, such as {@code bodies}
 * @param index number in the list, from 0 on
 */
public record Item(String list, int index) {
  private static final Pattern PATH = Pattern.compile("(\\w+)\\[(\\d+)\\].*");

  /** Returns the item that a path such as {@code bodies[3].shape} leads into, or null. */
  public static Item of(String path) {
    Matcher found = PATH.matcher(path);
    return found.matches() ? new Item(found.group(1), Integer.parseInt(found.group(2))) : null;
  }

  /** Returns the way to it from the file's value. */
  public List<Object> path() {
    return List.of(list, index);
  }

  /** Returns whether it is one of {@code statics} or {@code bodies}. */
  public boolean isBody() {
    return list.equals("statics") || list.equals("bodies");
  }

  @Override
  public String toString() {
    return list + "[" + index + "]";
  }
}
