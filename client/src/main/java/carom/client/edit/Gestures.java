package carom.client.edit;

import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import carom.text.Json;
import carom.text.JsonText;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiConsumer;

/**
 * The mouse over a level: it selects, drags, forms, turns, and places new things, by the tool in
 * hand. Places are metres in the level. One thread.
 */
public final class Gestures {
  /** The sort of body as which shapes are placed. */
  public enum Sort {
    /** Never moves. */
    STATIC("static"),
    /** Moves by forces. */
    BODY("body"),
    /** Moves as told: doors and lifts. */
    MOVER("mover");

    /** Name for people. */
    public final String title;

    Sort(String title) {
      this.title = title;
    }
  }

  /** Distance from which things are under the mouse, as seen. */
  private static final float REACH_PX = 7;

  /** Distance below which a drag is a click, as seen. */
  private static final float CLICK_PX = 4;

  private static final double LEAST_SIZE = 0.05;
  private static final double TURN_STEP = 15;
  private static final List<String> AREAS =
      List.of("zone", "water", "wind", "gravity", "drag", "pool of water", "pool of sand");

  private final LevelEditor editor;
  private final List<double[]> points = new ArrayList<>();
  private Tool tool = Tool.SELECT;
  private Sort sort = Sort.STATIC;
  private int area;
  private int joint;
  private float unit = 0.02f;

  // the present drag
  private boolean down;
  private boolean moved;
  private boolean frames;
  private Handle handle;
  private Item dragged;
  private float fromX;
  private float fromY;
  private float mouseX;
  private float mouseY;
  private LevelSource before;
  private Sketch.Thing thing;
  private BiConsumer<Item, double[]> picker;

  /** Creates the mouse of an editor, with the tool that selects. */
  public Gestures(LevelEditor editor) {
    this.editor = editor;
  }

  /** Returns the tool in hand. */
  public Tool tool() {
    return tool;
  }

  /**
   * Takes a tool. Areas and joints come in several kinds: taking the tool again takes the next. The
   * trigger needs no place: it is made at once.
   */
  public void take(Tool taken) {
    cancel();
    if (taken == Tool.TRIGGER) {
      editor.addTrigger();
      tool = Tool.SELECT;
      return;
    }
    area = taken == tool && tool == Tool.AREA ? (area + 1) % AREAS.size() : area;
    joint = taken == tool && tool == Tool.JOINT ? (joint + 1) % jointKinds().size() : joint;
    tool = taken;
  }

  /** Returns what a tool places, if it comes in several kinds; empty otherwise. */
  public String kind(Tool of) {
    return of == Tool.AREA
        ? AREAS.get(area)
        : of == Tool.JOINT ? LevelSchema.LEVEL.title(jointKinds().get(joint)) : "";
  }

  private static List<LevelSchema.Rules> jointKinds() {
    return LevelSchema.LEVEL.options(LevelSchema.LEVEL.item("joints"));
  }

  /** Returns what shapes are placed as. */
  public Sort sort() {
    return sort;
  }

  /** Sets what shapes are placed as. */
  public void sort(Sort chosen) {
    sort = chosen;
  }

  /** Sets how large a pixel is, metres. */
  public void unit(float metres) {
    unit = metres;
  }

  /** Gives the next click to a receiver, with what is there (or null) and where. */
  public void pick(BiConsumer<Item, double[]> receiver) {
    picker = receiver;
  }

  // ---- what is shown of it

  /** Returns the points that were clicked so far, metres. */
  public List<double[]> points() {
    return points;
  }

  /** Returns the frame or shape that is being drawn: from x and y, to x and y; null for none. */
  public double[] drawn() {
    boolean shows = down && (frames || tool.draws() || tool == Tool.JOINT);
    return shows ? new double[] {fromX, fromY, mouseX, mouseY} : null;
  }

  /** Returns the handles of the selected thing; none while several or none are selected. */
  public List<Handle> handles() {
    Item item = editor.selected();
    Json json = item == null ? null : editor.json(item);
    return json == null || tool != Tool.SELECT
        ? List.of()
        : Handle.of(item, json, editor.sketch().of(item), unit);
  }

  /** Returns what is under the mouse, or null. */
  public Item under() {
    List<Item> items = editor.sketch().at(mouseX, mouseY, REACH_PX * unit);
    return items.isEmpty() ? null : items.get(0);
  }

  // ---- the mouse

  /** Moves the mouse without a button. */
  public void hover(float x, float y) {
    mouseX = x;
    mouseY = y;
  }

  /** Presses the button. */
  public void press(float x, float y, boolean adds) {
    hover(x, y);
    fromX = x;
    fromY = y;
    down = true;
    moved = false;
    before = editor.source();
    if (picker != null) {
      BiConsumer<Item, double[]> receiver = picker;
      picker = null;
      down = false;
      receiver.accept(under(), new double[] {editor.snapped(x), editor.snapped(y)});
    } else if (tool == Tool.SELECT) {
      pressToSelect(adds);
    } else if (tool.draws()) {
      fromX = (float) editor.snapped(x);
      fromY = (float) editor.snapped(y);
    }
  }

  private void pressToSelect(boolean adds) {
    handle = handleAt(mouseX, mouseY);
    if (handle != null) {
      thing = editor.sketch().of(editor.selected());
      return;
    }
    List<Item> items = editor.sketch().at(mouseX, mouseY, REACH_PX * unit);
    Item selected = items.stream().filter(editor.selection()::contains).findFirst().orElse(null);
    Item hit = items.isEmpty() ? null : selected == null || adds ? items.get(0) : selected;
    boolean isFloor =
        hit != null
            && !hit.equals(selected)
            && isInside(hit); // of a rectangle: a frame begins there
    if (hit == null || isFloor) {
      frames = true;
      if (!adds) {
        editor.select((Item) null);
      }
    } else if (adds) {
      editor.toggle(hit);
    } else {
      if (selected == null) {
        editor.select(hit);
      }
      dragged = hit;
      thing = editor.sketch().of(hit);
    }
  }

  private boolean isInside(Item item) {
    Sketch.Thing found = editor.sketch().of(item);
    return found.isRectangle()
        && new Aabb().set(found.box()).grow(-REACH_PX * unit).contains(mouseX, mouseY);
  }

  private Handle handleAt(float x, float y) {
    Handle near = null;
    double least = (REACH_PX + 2) * unit;
    for (Handle each : handles()) {
      double distance = Math.hypot(each.x() - x, each.y() - y);
      if (distance <= least) {
        least = distance;
        near = each;
      }
    }
    return near;
  }

  /** Moves the mouse with the button down. */
  public void drag(float x, float y) {
    hover(x, y);
    moved |= Math.hypot(x - fromX, y - fromY) > CLICK_PX * unit;
    if (!down || !moved) {
      return;
    }
    if (handle != null) {
      editor.show(formed(x, y));
    } else if (dragged != null) {
      double dx = editor.snapped(thing.x() + x - fromX) - thing.x();
      double dy = editor.snapped(thing.y() + y - fromY) - thing.y();
      editor.show(editor.moved(before, editor.selection(), dx, dy));
    }
    if (tool.draws()) {
      mouseX = (float) editor.snapped(x);
      mouseY = (float) editor.snapped(y);
    }
  }

  /** Releases the button. */
  public void release(float x, float y, boolean adds) {
    if (!down) {
      return;
    }
    drag(x, y);
    down = false;
    if (handle != null || dragged != null) {
      editor.commit(editor.source());
    } else if (frames) {
      endFrame(adds);
    } else if (tool.draws() || tool == Tool.SPAWN) {
      place();
    } else if (tool.clicksPoints()) {
      click(x, y);
    } else if (tool == Tool.JOINT) {
      join(x, y);
    }
    handle = null;
    dragged = null;
    frames = false;
  }

  private void endFrame(boolean adds) {
    Item hit = under();
    if (!moved && hit != null) {
      editor.select(hit);
    } else if (moved) {
      Aabb frame =
          new Aabb(
              Math.min(fromX, mouseX),
              Math.min(fromY, mouseY),
              Math.max(fromX, mouseX),
              Math.max(fromY, mouseY));
      List<Item> all = new ArrayList<>(adds ? editor.selection() : Set.of());
      all.addAll(editor.sketch().within(frame));
      editor.select(all);
    }
  }

  /** Ends what was begun: a drag, a row of clicks, a pick. Returns whether there was anything. */
  public boolean cancel() {
    boolean any = down || !points.isEmpty() || picker != null;
    if (down && (handle != null || dragged != null)) {
      editor.revert();
    }
    down = false;
    handle = null;
    dragged = null;
    frames = false;
    picker = null;
    points.clear();
    return any;
  }

  // ---- forming

  private LevelSource formed(float x, float y) {
    Item item = editor.selected();
    Json json = before.at(item.path());
    LevelSource.Edit edit = before.edit();
    Transform frame = Handle.frame(json);
    Json shape = json.fields.get("shape");
    double px = editor.snapped(x);
    double py = editor.snapped(y);
    switch (handle.kind()) {
      case POINT, OFFSET -> formPoint(item, json, edit, frame, px, py);
      case TURN -> {
        double degrees = Math.toDegrees(Math.atan2(y - frame.y, x - frame.x)) - 90;
        double step = editor.snaps() ? TURN_STEP : 1;
        LevelEditor.turnTo(edit, thing, Math.round(degrees / step) * step);
      }
      case RADIUS -> {
        float[] middle = Handle.middle(shape);
        double radius =
            Math.hypot(
                px - frame.worldX(middle[0], middle[1]), py - frame.worldY(middle[0], middle[1]));
        if (shape.fields.containsKey("from")) {
          radius = across(shape, frame, x, y);
        }
        edit.set(shape.fields.get("radius"), size(radius));
      }
      default -> formBox(json, edit, frame, (float) px, (float) py);
    }
    return edit.done();
  }

  private static double across(Json capsule, Transform frame, float x, float y) {
    Json from = capsule.fields.get("from");
    Json to = capsule.fields.get("to");
    return Sketch.distance(
        frame.localX(x, y),
        frame.localY(x, y),
        Points.x(from),
        Points.y(from),
        Points.x(to),
        Points.y(to));
  }

  private static double size(double metres) {
    return Math.max(LEAST_SIZE, LevelEditor.rounded(metres));
  }

  private void formPoint(
      Item item, Json json, LevelSource.Edit edit, Transform frame, double x, double y) {
    boolean isLocal = handle.kind() == Handle.Kind.OFFSET;
    float px = (float) x;
    float py = (float) y;
    LevelEditor.set(
        edit,
        point(item, json, handle),
        isLocal ? frame.localX(px, py) : x,
        isLocal ? frame.localY(px, py) : y);
  }

  /** Returns the two numbers that a handle of a point drags. */
  private static Json point(Item item, Json json, Handle handle) {
    List<Json> pairs = new ArrayList<>();
    Points.forEach(
        item,
        json,
        (pair, field, isLocal) -> {
          if (!field.equals("at")) {
            pairs.add(pair);
          }
        });
    return pairs.get(handle.index());
  }

  // ---- points of polygons and chains

  /** Returns the points of the selected polygon or chain; null for anything else. */
  private Json corners() {
    Item item = editor.selected();
    Json shape = item == null || !item.isBody() ? null : editor.json(item).fields.get("shape");
    return shape == null ? null : shape.fields.get("points");
  }

  /** Adds a point to the line of the selected polygon or chain that is at a place, if any. */
  public void addPoint(float x, float y) {
    Json corners = corners();
    if (corners == null || tool != Tool.SELECT || handleAt(x, y) != null) {
      return;
    }
    Json shape = editor.json(editor.selected()).fields.get("shape");
    Json loop = shape.fields.get("loop");
    boolean isClosed = shape.fields.get("type").text.equals("polygon") || isTrue(loop);
    Transform frame = Handle.frame(editor.json(editor.selected()));
    float localX = frame.localX(x, y);
    float localY = frame.localY(x, y);
    int count = corners.items.size();
    int nearest = -1;
    float least = 2 * REACH_PX * unit;
    for (int i = 0; i < (isClosed ? count : count - 1); i++) {
      Json from = corners.items.get(i);
      Json to = corners.items.get((i + 1) % count);
      float distance =
          Sketch.distance(
              localX, localY, Points.x(from), Points.y(from), Points.x(to), Points.y(to));
      if (distance <= least) {
        least = distance;
        nearest = i;
      }
    }
    if (nearest >= 0) {
      List<Double> point = List.of(LevelEditor.rounded(localX), LevelEditor.rounded(localY));
      editor.commit(editor.source().edit().insert(corners, nearest, point).done());
    }
  }

  private static boolean isTrue(Json flag) {
    return flag != null && flag.truth;
  }

  /** Takes the point under the mouse from the selected polygon or chain. Returns whether it did. */
  public boolean removePoint() {
    Json corners = corners();
    Handle under = corners == null ? null : handleAt(mouseX, mouseY);
    if (under == null || under.kind() != Handle.Kind.OFFSET) {
      return false;
    }
    Item item = editor.selected();
    Json point = point(item, editor.json(item), under);
    boolean isCorner = corners.items.contains(point);
    if (isCorner) {
      editor.commit(editor.source().without(corners, point));
    }
    return isCorner;
  }

  /** Moves a corner of a box; the opposite one stays where it is. */
  private void formBox(Json json, LevelSource.Edit edit, Transform frame, float x, float y) {
    Json shape = json.fields.get("shape");
    float[] middle = Handle.middle(shape);
    float halfW = (float) shape.fields.get("width").number / 2;
    float halfH = (float) shape.fields.get("height").number / 2;
    float fixedX = middle[0] - handle.cornerX() * halfW;
    float fixedY = middle[1] - handle.cornerY() * halfH;
    double width = size(Math.abs(frame.localX(x, y) - fixedX));
    double height = size(Math.abs(frame.localY(x, y) - fixedY));
    float sideX = frame.localX(x, y) < fixedX ? -1 : 1;
    float sideY = frame.localY(x, y) < fixedY ? -1 : 1;
    float newX = (float) (fixedX + sideX * width / 2 - middle[0]);
    float newY = (float) (fixedY + sideY * height / 2 - middle[1]);
    edit.set(shape.fields.get("width"), width).set(shape.fields.get("height"), height);
    Json at = json.fields.get("at");
    edit.set(at.items.get(0), thousandths(frame.worldX(newX, newY)));
    edit.set(at.items.get(1), thousandths(frame.worldY(newX, newY)));
  }

  /** Returns a number with three decimals: half of a size with two. */
  private static double thousandths(double value) {
    return Math.round(value * 1_000) / 1_000.0;
  }

  // ---- placing

  private void place() {
    double x = (fromX + mouseX) / 2.0;
    double y = (fromY + mouseY) / 2.0;
    double width = Math.abs(mouseX - fromX);
    double height = Math.abs(mouseY - fromY);
    boolean clicked = width < LEAST_SIZE && height < LEAST_SIZE;
    switch (tool) {
      case BOX ->
          placeShape(
              clicked ? fromX : x,
              clicked ? fromY : y,
              LevelEditor.fields(
                  "type",
                  "box",
                  "width",
                  clicked ? 1 : size(width),
                  "height",
                  clicked ? 1 : size(height)));
      case CIRCLE ->
          placeShape(
              fromX,
              fromY,
              LevelEditor.fields(
                  "type", "circle", "radius", clicked ? 0.5 : size(Math.hypot(width, height))));
      case CAPSULE -> placeCapsule(clicked, x, y);
      case SENSOR ->
          placeSensor(
              clicked ? fromX : x,
              clicked ? fromY : y,
              clicked ? 2 : size(width),
              clicked ? 0.5 : size(height));
      case AREA -> placeArea();
      default ->
          place(
              "spawns",
              LevelEditor.fields(
                  "name", spawnName(), "at", at(editor.snapped(mouseX), editor.snapped(mouseY))));
    }
  }

  private static List<Double> at(double x, double y) {
    return List.of(thousandths(x), thousandths(y));
  }

  private void place(String list, Map<String, Object> fields) {
    editor.add(editor.source(), list, List.of(JsonText.of(fields)));
  }

  private void placeShape(double x, double y, Map<String, Object> shape) {
    Map<String, Object> body = new LinkedHashMap<>();
    Sort placed = sort;
    if (shape.get("type").equals("chain") && sort == Sort.BODY) {
      placed = Sort.STATIC; // a line has no mass
    }
    if (placed == Sort.MOVER) {
      body.put("name", LevelEditor.newName(editor.source(), "mover-1"));
    }
    body.put("at", at(x, y));
    body.put("shape", shape);
    if (placed == Sort.MOVER) {
      body.put("type", "kinematic");
    }
    place(placed == Sort.STATIC ? "statics" : "bodies", body);
  }

  private void placeCapsule(boolean clicked, double x, double y) {
    double fromDx = clicked ? 0 : LevelEditor.rounded(fromX - x);
    double fromDy = clicked ? -0.5 : LevelEditor.rounded(fromY - y);
    placeShape(
        clicked ? fromX : x,
        clicked ? fromY : y,
        LevelEditor.fields(
            "type",
            "capsule",
            "from",
            List.of(fromDx, fromDy),
            "to",
            List.of(-fromDx, -fromDy),
            "radius",
            0.3));
  }

  private void placeSensor(double x, double y, double width, double height) {
    place(
        "statics",
        LevelEditor.fields(
            "name",
            LevelEditor.newName(editor.source(), "sensor-1"),
            "sensor",
            true,
            "at",
            at(x, y),
            "shape",
            LevelEditor.fields("type", "box", "width", width, "height", height),
            "color",
            "#ffd166"));
  }

  private void placeArea() {
    boolean isThin = Math.min(Math.abs(mouseX - fromX), Math.abs(mouseY - fromY)) < LEAST_SIZE;
    double maxX = Math.max(fromX, mouseX) + (isThin ? 4 : 0);
    double maxY = Math.max(fromY, mouseY) + (isThin ? 2 : 0);
    List<Double> min = at(Math.min(fromX, mouseX), Math.min(fromY, mouseY));
    List<Double> max = at(maxX, maxY);
    String kind = AREAS.get(area);
    if (kind.equals("zone")) {
      place(
          "zones", LevelEditor.fields("name", "zone", "min", min, "max", max, "color", "#4da3ff"));
    } else if (kind.startsWith("pool")) {
      String type = kind.substring(kind.lastIndexOf(' ') + 1);
      Map<String, Object> filled = LevelEditor.fields("min", min, "max", max);
      place(
          "pools",
          LevelEditor.fields(
              "type", type, "name", type, "min", min, "max", max, "fill", List.of(filled)));
    } else {
      LevelSchema.Rules rules =
          LevelSchema.LEVEL.options(LevelSchema.LEVEL.item("areas")).stream()
              .filter(option -> LevelSchema.LEVEL.title(option).equals(kind))
              .findFirst()
              .orElseThrow();
      @SuppressWarnings("unchecked")
      Map<String, Object> fields =
          (Map<String, Object>) LevelSchema.LEVEL.start(rules, "", editor.starts());
      fields.put("min", min);
      fields.put("max", max);
      place("areas", fields);
    }
  }

  /** Returns the name of the spawn that was placed last. */
  private String spawnName() {
    List<Json> spawns = editor.source().list("spawns");
    Json name = spawns.isEmpty() ? null : spawns.get(spawns.size() - 1).fields.get("name");
    return name == null ? "player" : name.text;
  }

  // ---- points one by one

  private void click(float x, float y) {
    double[] point = {editor.snapped(x), editor.snapped(y)};
    boolean closes =
        points.size() >= 3
            && Math.hypot(points.get(0)[0] - x, points.get(0)[1] - y) <= 1.5 * REACH_PX * unit;
    if (closes) {
      finish(true);
      return;
    }
    double[] last = points.isEmpty() ? null : points.get(points.size() - 1);
    if (last == null || last[0] != point[0] || last[1] != point[1]) {
      points.add(point);
    }
  }

  /** Makes a polygon or chain of the points that were clicked. */
  public void finish() {
    finish(false);
  }

  private void finish(boolean closed) {
    boolean isPolygon = tool == Tool.POLYGON;
    if (points.size() < (isPolygon ? 3 : 2)) {
      editor.message(
          isPolygon ? "A polygon has at least 3 corners." : "A chain has at least 2 points.");
      return;
    }
    double x = 0;
    double y = 0;
    for (double[] point : points) {
      x += point[0] / points.size();
      y += point[1] / points.size();
    }
    double middleX = editor.snapped(x);
    double middleY = editor.snapped(y);
    List<List<Double>> offsets = new ArrayList<>();
    for (double[] point : points) {
      offsets.add(at(point[0] - middleX, point[1] - middleY));
    }
    points.clear();
    Map<String, Object> shape =
        LevelEditor.fields("type", isPolygon ? "polygon" : "chain", "points", offsets);
    if (closed && !isPolygon) {
      shape.put("loop", true);
    }
    placeShape(middleX, middleY, shape);
  }

  /** Takes back the last point. Returns whether there was one. */
  public boolean backPoint() {
    return !points.isEmpty() && points.remove(points.size() - 1) != null;
  }

  // ---- joints

  private void join(float x, float y) {
    List<Item> here = bodiesAt(fromX, fromY);
    List<Item> there = bodiesAt(x, y);
    Item b = there.isEmpty() ? null : there.get(0);
    Item a = here.isEmpty() ? null : here.get(0);
    if (b != null && b.equals(a)) {
      a = !moved && there.size() > 1 ? there.get(1) : null;
    }
    if (b == null) {
      b = a; // held to the world
      a = null;
    }
    if (b == null) {
      editor.message("A joint needs a body: click on one, or drag from one to another.");
      return;
    }
    if (b.list().equals("statics") && a != null) {
      Item swapped = a;
      a = b;
      b = swapped;
    }
    LevelSource next = LevelEditor.named(editor.source(), b);
    next = a == null ? next : LevelEditor.named(next, a);
    LevelSchema.Rules rules = jointKinds().get(joint);
    @SuppressWarnings("unchecked")
    Map<String, Object> fields =
        (Map<String, Object>) LevelSchema.LEVEL.start(rules, "", editor.starts());
    Map<String, Object> made = new LinkedHashMap<>();
    made.put("type", fields.get("type"));
    if (rules.fields().contains("a") && a != null) {
      made.put("a", LevelEditor.reference(next, a));
    }
    made.put("b", LevelEditor.reference(next, b));
    fields.forEach(made::putIfAbsent);
    List<Double> from = at(editor.snapped(fromX), editor.snapped(fromY));
    List<Double> to = at(editor.snapped(x), editor.snapped(y));
    made.computeIfPresent("at", (name, old) -> to);
    made.computeIfPresent("from", (name, old) -> from);
    made.computeIfPresent("to", (name, old) -> to);
    made.computeIfPresent("groundFrom", (name, old) -> at(from.get(0), from.get(1) + 4));
    made.computeIfPresent("groundTo", (name, old) -> at(to.get(0), to.get(1) + 4));
    made.computeIfPresent(
        "length",
        (name, old) ->
            LevelEditor.rounded(Math.hypot(to.get(0) - from.get(0), to.get(1) - from.get(1))));
    editor.add(next, "joints", List.of(JsonText.of(made)));
  }

  private List<Item> bodiesAt(float x, float y) {
    return editor.sketch().at(x, y, REACH_PX * unit).stream().filter(Item::isBody).toList();
  }
}
