package carom.client.edit;

import carom.physics.geometry.Chain;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Segment;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import carom.sim.level.Archetype;
import carom.sim.level.CheckedLevel;
import carom.text.Json;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * A level as it lies on the table: where its things are, and which of them is under the mouse.
 * Bodies have the shapes that the reader of levels gives them. Immutable.
 */
public final class Sketch {
  /** Lists of the file that have a place, from what is drawn first to what lies on top. */
  public static final List<String> LISTS =
      List.of("zones", "areas", "pools", "statics", "bodies", "spawns", "joints");

  /**
   * A thing with its place.
   *
   * @param item which it is
   * @param json its value in the file
   * @param bodies its bodies; empty for what has none or can't be read
   * @param x its anchor, metres
   * @param y its anchor, metres
   * @param box around it, metres
   */
  public record Thing(
      Item item, Json json, List<CheckedLevel.Placed> bodies, float x, float y, Aabb box) {
    /** Returns whether it is a rectangle along the axes. */
    public boolean isRectangle() {
      return json.fields.containsKey("min");
    }

    /** Returns its name in the file; empty without. */
    public String name() {
      Json name = json.fields.get("name");
      return name == null ? "" : name.text;
    }
  }

  private final List<Thing> things = new ArrayList<>();
  private final Map<Item, Thing> found = new HashMap<>();
  private final Map<String, Thing> named = new HashMap<>();

  Sketch(LevelSource source, CheckedLevel checked) {
    Map<String, List<CheckedLevel.Placed>> placed = new HashMap<>();
    for (CheckedLevel.Placed body : checked.placed()) {
      placed.computeIfAbsent(body.path(), path -> new ArrayList<>()).add(body);
    }
    for (String list : LISTS) {
      List<Json> items = source.list(list);
      for (int i = 0; i < items.size(); i++) {
        Item item = new Item(list, i);
        Thing thing = thing(item, items.get(i), placed.getOrDefault(item.toString(), List.of()));
        if (thing != null) {
          things.add(thing);
          found.put(item, thing);
          if (item.isBody()) {
            named.putIfAbsent(thing.name(), thing);
          }
        }
      }
    }
  }

  private Thing thing(Item item, Json json, List<CheckedLevel.Placed> bodies) {
    Aabb box = new Aabb().setEmpty();
    float[] anchor = {Float.NaN, 0};
    Points.forEach(
        item,
        json,
        (pair, field, isLocal) -> {
          if (!isLocal && !field.equals("motion")) {
            box.add(Points.x(pair), Points.y(pair));
            if (Float.isNaN(anchor[0]) || field.equals("at")) {
              anchor[0] = Points.x(pair);
              anchor[1] = Points.y(pair);
            }
          }
        });
    Json range = json.fields.get("range");
    if (range != null && !box.isEmpty()) {
      box.grow((float) range.number);
    }
    Aabb part = new Aabb();
    for (CheckedLevel.Placed body : bodies) {
      Transform at = new Transform(body.at().x(), body.at().y(), body.at().angle());
      for (Shape shape : body.kind().shapes()) {
        shape.aabb(at, part);
        box.add(part);
      }
    }
    Thing held = Float.isNaN(anchor[0]) ? holder(json) : null;
    if (held != null) {
      return new Thing(item, json, bodies, held.x, held.y, new Aabb().set(held.box));
    }
    return Float.isNaN(anchor[0]) ? null : new Thing(item, json, bodies, anchor[0], anchor[1], box);
  }

  /** Returns the body that a joint without a point holds, or null. */
  private Thing holder(Json joint) {
    Json b = joint.fields.get("b");
    return b == null ? null : ofName(b.text);
  }

  /** Returns all things from below to above. */
  public List<Thing> things() {
    return things;
  }

  /** Returns a thing, or null if it has no place. */
  public Thing of(Item item) {
    return found.get(item);
  }

  /** Returns the first body or static of a name, or of {@code name[n]}; null without. */
  public Thing ofName(String name) {
    int bracket = name.indexOf('[');
    return named.get(bracket > 0 ? name.substring(0, bracket) : name);
  }

  /**
   * Returns what is at a point, the topmost first. Of rectangles only edges count, unless nothing
   * else is there.
   *
   * @param reach distance in metres that still counts, of points and lines
   */
  public List<Item> at(float x, float y, float reach) {
    List<Item> hit = new ArrayList<>();
    List<Item> inside = new ArrayList<>();
    for (int i = things.size() - 1; i >= 0; i--) {
      Thing thing = things.get(i);
      if (isAt(thing, x, y, reach)) {
        hit.add(thing.item);
      } else if (thing.isRectangle() && thing.box.contains(x, y)) {
        inside.add(thing.item);
      }
    }
    hit.addAll(inside);
    return hit;
  }

  private static boolean isAt(Thing thing, float x, float y, float reach) {
    Aabb box = new Aabb().set(thing.box).grow(reach);
    if (!box.contains(x, y)) {
      return false;
    }
    if (thing.isRectangle()) {
      return !new Aabb().set(thing.box).grow(-reach).contains(x, y);
    }
    if (thing.bodies.isEmpty()) {
      return isNear(thing, x, y, 2 * reach);
    }
    for (CheckedLevel.Placed body : thing.bodies) {
      if (isIn(body.kind(), body.at().x(), body.at().y(), body.at().angle(), x, y, reach)) {
        return true;
      }
    }
    return false;
  }

  private static boolean isNear(Thing thing, float x, float y, float reach) {
    Json from = thing.json.fields.get("from");
    Json to = thing.json.fields.get("to");
    if (Points.isPair(from) && Points.isPair(to)) {
      float fromX = Points.x(from);
      float fromY = Points.y(from);
      return distance(x, y, fromX, fromY, Points.x(to), Points.y(to)) <= reach;
    }
    return Math.hypot(x - thing.x, y - thing.y) <= reach;
  }

  private static boolean isIn(
      Archetype kind, float atX, float atY, float angle, float x, float y, float reach) {
    Transform at = new Transform(atX, atY, angle);
    for (Shape shape : kind.shapes()) {
      if (shape.containsPoint(at, x, y)) {
        return true;
      }
      if (shape instanceof Chain || shape instanceof Segment) {
        float localX = at.localX(x, y);
        float localY = at.localY(x, y);
        for (Convex line : shape.parts()) {
          if (distance(
                  localX,
                  localY,
                  line.vertexX(0),
                  line.vertexY(0),
                  line.vertexX(1),
                  line.vertexY(1))
              <= reach) {
            return true;
          }
        }
      }
    }
    return false;
  }

  /** Returns the distance of a point to a line between two others. */
  static float distance(float x, float y, float ax, float ay, float bx, float by) {
    float dx = bx - ax;
    float dy = by - ay;
    float length = dx * dx + dy * dy;
    float t = length == 0 ? 0 : ((x - ax) * dx + (y - ay) * dy) / length;
    t = Math.max(0, Math.min(1, t));
    return (float) Math.hypot(x - ax - t * dx, y - ay - t * dy);
  }

  /** Returns what lies in a rectangle as a whole. */
  public List<Item> within(Aabb rectangle) {
    return things.stream().filter(t -> rectangle.contains(t.box)).map(Thing::item).toList();
  }
}
