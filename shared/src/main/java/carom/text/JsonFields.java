package carom.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Reads values out of JSON nodes and refuses what doesn't fit, with a sentence that names the
 * place, the value and the limit.
 */
public final class JsonFields {
  private JsonFields() {}

  /** Returns the corners of a box, "min" and "max" of a node: min x and y, max x and y. */
  public static float[] box(Json node, float limit) throws JsonException {
    float[] min = vector(required(node, "min"), limit);
    float[] max = vector(required(node, "max"), limit);
    requireOrder(node, min, max);
    return new float[] {min[0], min[1], max[0], max[1]};
  }

  private static void requireOrder(Json node, float[] min, float[] max) throws JsonException {
    if (!(min[0] < max[0] && min[1] < max[1])) {
      throw wrong(
          node.fields.get("max"),
          String.format(
              Locale.ROOT,
              "=[%s, %s] must be right of and above min=[%s, %s]",
              max[0],
              max[1],
              min[0],
              min[1]));
    }
  }

  /** Returns the items of an array in a field, none if it is missing; at most so many. */
  public static List<Json> list(Json parent, String field, int limit) throws JsonException {
    Json node = parent.fields.get(field);
    if (node == null) {
      return List.of();
    }
    require(node, Json.Kind.ARRAY);
    if (node.items.size() > limit) {
      throw wrong(node, " has " + node.items.size() + " items, the limit is " + limit);
    }
    return node.items;
  }

  /** Returns two numbers, each from -limit to limit. */
  public static float[] vector(Json node, float limit) throws JsonException {
    require(node, Json.Kind.ARRAY);
    if (node.items.size() != 2) {
      throw wrong(node, " has " + node.items.size() + " numbers, needs 2: [x, y]");
    }
    return new float[] {
      number(node.items.get(0), -limit, limit), number(node.items.get(1), -limit, limit)
    };
  }

  /** Returns a number in a range, or another if the field is missing. */
  public static float number(Json parent, String field, float otherwise, float min, float max)
      throws JsonException {
    Json node = parent.fields.get(field);
    return node == null ? otherwise : number(node, min, max);
  }

  private static float number(Json node, float min, float max) throws JsonException {
    require(node, Json.Kind.NUMBER);
    float value = (float) node.number; // compared as one: 0.1 is a limit of 0.1f
    if (!(value >= min && value <= max)) {
      throw wrong(node, "=" + node.shown() + " must be in " + plain(min) + ".." + plain(max));
    }
    return value;
  }

  /** Returns a whole number in a range, or another if the field is missing. */
  public static int integer(Json parent, String field, int otherwise, int min, int max)
      throws JsonException {
    Json node = parent.fields.get(field);
    if (node == null) {
      return otherwise;
    }
    float value = number(node, min, max);
    if (value != Math.round(value)) {
      throw wrong(node, "=" + node.shown() + " must be a whole number");
    }
    return Math.round(value);
  }

  /** Returns a truth, or another if the field is missing. */
  public static boolean bool(Json parent, String field, boolean otherwise) throws JsonException {
    Json node = parent.fields.get(field);
    if (node == null) {
      return otherwise;
    }
    require(node, Json.Kind.BOOLEAN);
    return node.truth;
  }

  /** Returns a text of 1..64 characters. */
  public static String text(Json node) throws JsonException {
    require(node, Json.Kind.STRING);
    if (node.text.isBlank() || node.text.length() > 64) {
      throw wrong(node, "=" + node.shown() + " must have 1..64 characters");
    }
    return node.text;
  }

  /** Returns one of some words, or another if the field is missing. */
  public static String word(Json parent, String field, List<String> words, String otherwise)
      throws JsonException {
    Json node = parent.fields.get(field);
    if (node == null) {
      return otherwise;
    }
    require(node, Json.Kind.STRING);
    if (!words.contains(node.text)) {
      throw unknownWord(node, words, "one of " + words);
    }
    return node.text;
  }

  /** Returns a colour as 0xrrggbb, or another if the field is missing. */
  public static int color(Json parent, String field, int otherwise) throws JsonException {
    Json node = parent.fields.get(field);
    if (node == null) {
      return otherwise;
    }
    require(node, Json.Kind.STRING);
    if (!node.text.matches("#[0-9a-fA-F]{6}")) {
      throw wrong(node, "=" + node.shown() + " must be a colour such as \"#ffd166\"");
    }
    return Integer.parseInt(node.text.substring(1), 16);
  }

  /** Checks that a node is an object of known fields only. */
  public static void knownFields(Json node, List<String> known) throws JsonException {
    require(node, Json.Kind.OBJECT);
    for (Map.Entry<String, Json> entry : node.fields.entrySet()) {
      if (!known.contains(entry.getKey())) {
        String hint = Suggestion.didYouMean(entry.getKey(), known);
        throw wrong(
            entry.getValue(), " is unknown" + (hint.isEmpty() ? "; known are " + known : hint));
      }
    }
  }

  /** Returns a field that must be there. */
  public static Json required(Json parent, String field) throws JsonException {
    require(parent, Json.Kind.OBJECT);
    Json node = parent.fields.get(field);
    if (node == null) {
      String path = parent.path().isEmpty() ? field : parent.path() + "." + field;
      throw new JsonException(parent.line, parent.column, path, " is missing");
    }
    return node;
  }

  /** Checks the kind of a node. */
  public static void require(Json node, Json.Kind kind) throws JsonException {
    if (node.kind != kind) {
      // The whole of a file may be a secret that happens to be a number or a text.
      String held =
          node.path().isEmpty() ? "the file holds " + node.kind.words : "=" + node.shown();
      throw wrong(node, held + ", must be " + kind.words);
    }
  }

  /** Returns an exception that says what a word must be, and what may be meant by it. */
  public static JsonException unknownWord(Json node, Iterable<String> words, String limit) {
    List<String> known = new ArrayList<>();
    words.forEach(known::add);
    return wrong(
        node, "=" + node.shown() + " must be " + limit + Suggestion.didYouMean(node.text, known));
  }

  /** Returns an exception that names the place of a node and its path. */
  public static JsonException wrong(Json node, String problem) {
    return new JsonException(node.line, node.column, node.path(), problem);
  }

  /** Returns a number as people write it: 0.05, but 2000 rather than 2000.0. */
  private static String plain(float value) {
    return value == Math.rint(value) ? String.valueOf((long) value) : String.valueOf(value);
  }
}
