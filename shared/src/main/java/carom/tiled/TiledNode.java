package carom.tiled;

import carom.sim.level.LevelException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * An object of a Tiled file, in the form of Tiled's JSON, whether it was read from JSON or XML.
 * Numbers and truths may be texts, as in XML.
 */
final class TiledNode {
  /** Values: {@link String}, {@link Double}, {@link Boolean}, a node, or a list of such. */
  final Map<String, Object> fields = new LinkedHashMap<>();

  private final String file;

  /**
   * Creates an empty object.
   *
   * @param file begins the messages about it
   */
  TiledNode(String file) {
    this.file = file;
  }

  /** Returns whether a field is there. */
  boolean has(String field) {
    return fields.containsKey(field);
  }

  /** Returns a text, or another one if the field is missing. */
  String text(String field, String otherwise) {
    Object value = fields.get(field);
    if (value instanceof Double number && number == Math.rint(number)) {
      return String.valueOf(number.longValue());
    }
    return value == null || value instanceof List || value instanceof TiledNode
        ? otherwise
        : value.toString();
  }

  /** Returns a number, or another one if the field is missing. */
  double number(String field, double otherwise) throws LevelException {
    Object value = fields.get(field);
    if (value == null) {
      return otherwise;
    }
    double number = value instanceof Double d ? d : parsed(value);
    if (!(Math.abs(number) <= 1e12)) {
      throw wrong(field + "=" + shown(value) + " must be a number");
    }
    return number;
  }

  private static double parsed(Object value) {
    try {
      return value instanceof String text ? Double.parseDouble(text) : Double.NaN;
    } catch (NumberFormatException e) {
      return Double.NaN;
    }
  }

  /** Returns a whole number in a range, or another one if the field is missing. */
  int whole(String field, int otherwise, int min, int max) throws LevelException {
    double value = number(field, otherwise);
    if (!(value >= min && value <= max && value == Math.rint(value))) {
      throw wrong(
          field
              + "="
              + shown(fields.get(field))
              + " must be a whole number in "
              + min
              + ".."
              + max);
    }
    return (int) value;
  }

  /** Returns whether a field is there and true. */
  boolean flag(String field) {
    Object value = fields.get(field);
    return Boolean.TRUE.equals(value) || "true".equals(value) || "1".equals(value);
  }

  /** Returns the objects of a list, none if it is missing. */
  List<TiledNode> nodes(String field) {
    List<TiledNode> nodes = new ArrayList<>();
    if (fields.get(field) instanceof List<?> items) {
      for (Object item : items) {
        if (item instanceof TiledNode node) {
          nodes.add(node);
        }
      }
    }
    return nodes;
  }

  /** Returns the object of a field, or null. */
  TiledNode node(String field) {
    return fields.get(field) instanceof TiledNode node ? node : null;
  }

  /** Adds to a list. */
  @SuppressWarnings("unchecked") // only this method makes lists of XML
  void add(String list, Object value) {
    ((List<Object>) fields.computeIfAbsent(list, name -> new ArrayList<>())).add(value);
  }

  /** Returns an exception about this object. */
  LevelException wrong(String problem) {
    return new LevelException(file, 0, 0, "", problem);
  }

  private static String shown(Object value) {
    String text = String.valueOf(value);
    String kind = value instanceof List || value instanceof TiledNode ? "a list" : text;
    return kind.length() > 40 ? kind.substring(0, 40) + "..." : kind;
  }
}
