package carom.client.edit;

import carom.physics.math.Transform;
import carom.text.Json;
import java.util.ArrayList;
import java.util.List;

/**
 * A place of the selected thing that can be dragged.
 *
 * @param kind what it changes
 * @param index number among those of the thing, to find it again after a change
 * @param x metres
 * @param y metres
 * @param cornerX side of a box, -1 or 1; 0 for others
 * @param cornerY side of a box, -1 or 1; 0 for others
 */
public record Handle(Kind kind, int index, float x, float y, int cornerX, int cornerY) {
  /** The part of a thing that a handle changes. */
  public enum Kind {
    /** A point in the level. */
    POINT,
    /** A point in the body's frame. */
    OFFSET,
    /** A corner of a box; the opposite one stays. */
    CORNER,
    /** The radius of a circle or capsule. */
    RADIUS,
    /** The angle. */
    TURN
  }

  /** Most handles of a thing; a chain may have 65,536 points. */
  private static final int MOST = 1_000;

  /** Distance of the handle that turns, as seen. */
  private static final float TURN_PX = 30;

  /**
   * Returns the handles of a thing.
   *
   * @param thing null for one without a place, such as a trigger
   * @param unit metres of a pixel
   */
  static List<Handle> of(Item item, Json json, Sketch.Thing thing, float unit) {
    List<Handle> handles = new ArrayList<>();
    Transform frame = frame(json);
    Points.forEach(
        item,
        json,
        (pair, field, isLocal) -> {
          if (field.equals("at") || handles.size() == MOST) {
            return; // the thing itself is dragged
          }
          float x = Points.x(pair);
          float y = Points.y(pair);
          handles.add(
              isLocal
                  ? new Handle(
                      Kind.OFFSET, handles.size(), frame.worldX(x, y), frame.worldY(x, y), 0, 0)
                  : new Handle(Kind.POINT, handles.size(), x, y, 0, 0));
        });
    if (item.isBody() && thing != null && !thing.bodies().isEmpty()) {
      ofBody(json, frame, unit, handles);
    }
    return handles;
  }

  /** Returns the frame of a body by its value. */
  static Transform frame(Json json) {
    Json at = json.fields.get("at");
    Json angle = json.fields.get("angle");
    float turned = angle == null ? 0 : (float) Math.toRadians(angle.number);
    return Points.isPair(at)
        ? new Transform(Points.x(at), Points.y(at), turned)
        : new Transform(0, 0, turned);
  }

  private static void ofBody(Json json, Transform frame, float unit, List<Handle> handles) {
    Json shape = json.fields.get("shape");
    String type = shape.fields.get("type").text;
    float[] middle = middle(shape);
    if (type.equals("box")) {
      float w = (float) shape.fields.get("width").number / 2;
      float h = (float) shape.fields.get("height").number / 2;
      for (int i = 0; i < 4; i++) {
        int sx = i % 2 * 2 - 1;
        int sy = i / 2 * 2 - 1;
        handles.add(
            local(Kind.CORNER, handles, frame, middle[0] + sx * w, middle[1] + sy * h, sx, sy));
      }
    } else if (shape.fields.containsKey("radius")) {
      float r = (float) shape.fields.get("radius").number;
      float[] away = away(shape);
      handles.add(
          local(
              Kind.RADIUS, handles, frame, middle[0] + r * away[0], middle[1] + r * away[1], 0, 0));
    }
    float top = middle[1];
    for (Handle handle : handles) {
      if (handle.kind != Kind.POINT) {
        top = Math.max(top, frame.localY(handle.x, handle.y));
      }
    }
    handles.add(local(Kind.TURN, handles, frame, 0, Math.max(0, top) + TURN_PX * unit, 0, 0));
  }

  private static Handle local(
      Kind kind, List<Handle> handles, Transform frame, float x, float y, int sx, int sy) {
    return new Handle(kind, handles.size(), frame.worldX(x, y), frame.worldY(x, y), sx, sy);
  }

  /** Returns the middle of a box, circle or capsule in the body's frame. */
  static float[] middle(Json shape) {
    Json from = shape.fields.get("from");
    Json to = shape.fields.get("to");
    Json at = shape.fields.get("at");
    if (Points.isPair(from) && Points.isPair(to)) {
      return new float[] {(Points.x(from) + Points.x(to)) / 2, (Points.y(from) + Points.y(to)) / 2};
    }
    return Points.isPair(at) ? new float[] {Points.x(at), Points.y(at)} : new float[2];
  }

  /** Returns the direction in which a radius is shown: across a capsule, right of a circle. */
  private static float[] away(Json shape) {
    Json from = shape.fields.get("from");
    Json to = shape.fields.get("to");
    if (from == null || to == null) {
      return new float[] {1, 0};
    }
    float dx = Points.x(to) - Points.x(from);
    float dy = Points.y(to) - Points.y(from);
    float length = Math.max(1e-6f, (float) Math.hypot(dx, dy));
    return new float[] {dy / length, -dx / length};
  }
}
