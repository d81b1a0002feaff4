package carom.client.edit;

import carom.client.edit.LevelSchema.Rules;
import carom.text.Json;
import java.util.Map;

/** Points in values of a level, which the schema tells: in the level, or in the frame of a body. */
public final class Points {
  /** Receives a point. */
  interface Visitor {
    /**
     * Takes a point.
     *
     * @param pair two numbers
     * @param field the field of the item that it is, or is in
     * @param isLocal whether it is in the body's frame
     */
    void point(Json pair, String field, boolean isLocal);
  }

  private Points() {}

  /** Visits all points of an item in the order of the file. */
  static void forEach(Item item, Json value, Visitor visitor) {
    Rules rules = LevelSchema.LEVEL.chosen(LevelSchema.LEVEL.item(item.list()), value);
    for (Map.Entry<String, Json> field : value.fields.entrySet()) {
      boolean isCarried = item.isBody() && field.getKey().equals("area");
      walk(
          field.getValue(),
          LevelSchema.LEVEL.field(rules, field.getKey()),
          field.getKey(),
          isCarried,
          visitor);
    }
  }

  private static void walk(
      Json value, Rules rules, String field, boolean isLocal, Visitor visitor) {
    if (rules == null) {
      return;
    }
    Rules chosen = LevelSchema.LEVEL.chosen(rules, value);
    boolean isOffset = chosen.name().equals("offset");
    if (isOffset || chosen.name().equals("point")) {
      if (isPair(value)) {
        visitor.point(value, field, isLocal || isOffset);
      }
    } else if (value.kind == Json.Kind.ARRAY && chosen.rules().fields.containsKey("items")) {
      Rules items = LevelSchema.LEVEL.items(chosen);
      value.items.forEach(item -> walk(item, items, field, isLocal, visitor));
    } else {
      value.fields.forEach(
          (name, inner) ->
              walk(inner, LevelSchema.LEVEL.field(chosen, name), field, isLocal, visitor));
    }
  }

  /** Returns whether a value is two numbers. */
  public static boolean isPair(Json value) {
    return value != null
        && value.items.size() == 2
        && value.items.get(0).kind == Json.Kind.NUMBER
        && value.items.get(1).kind == Json.Kind.NUMBER;
  }

  /** Returns the first of two numbers. */
  public static float x(Json pair) {
    return (float) pair.items.get(0).number;
  }

  /** Returns the second of two numbers. */
  public static float y(Json pair) {
    return (float) pair.items.get(1).number;
  }

  /** Returns min x, min y, max x and max y of a rectangle; null for what is none. */
  public static float[] box(Json value) {
    Json min = value.fields.get("min");
    Json max = value.fields.get("max");
    return isPair(min) && isPair(max) ? new float[] {x(min), y(min), x(max), y(max)} : null;
  }
}
