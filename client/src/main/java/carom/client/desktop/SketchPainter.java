package carom.client.desktop;

import carom.client.desktop.hud.Hud;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.ShapePainter;
import carom.client.desktop.paint.UiColours;
import carom.client.desktop.paint.ViewCamera;
import carom.client.edit.Gestures;
import carom.client.edit.Handle;
import carom.client.edit.Item;
import carom.client.edit.LevelEditor;
import carom.client.edit.Points;
import carom.client.edit.Sketch.Thing;
import carom.client.edit.Tool;
import carom.physics.geometry.Shape;
import carom.sim.level.Archetype;
import carom.sim.level.CheckedLevel;
import carom.text.Json;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.math.Vector3;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/** Draws a level that is edited, with what is selected, and what the mouse is about to do. */
final class SketchPainter {
  private static final float HANDLE_PX = 5;
  private static final float SPAWN_PX = 7;
  private static final float LEAST_GRID_PX = 9;
  private static final float LINE = 14;
  private static final Color GRID = new Color(1, 1, 1, 0.06f);
  private static final Color BOUNDS = new Color(1, 1, 1, 0.35f);
  private static final Color WRONG = UiColours.BAD;

  private final Canvas canvas;
  private final ShapePainter shapes;
  private final Hud hud;
  private final Fonts fonts;
  private final ViewCamera camera;
  private final LevelEditor editor;
  private final Gestures gestures;
  private final Color fill = new Color();
  private final Color edge = new Color();
  private float pixel;

  SketchPainter(
      Canvas canvas,
      Hud hud,
      Fonts fonts,
      ViewCamera camera,
      LevelEditor editor,
      Gestures gestures) {
    this.canvas = canvas;
    this.hud = hud;
    this.fonts = fonts;
    this.camera = camera;
    this.editor = editor;
    this.gestures = gestures;
    shapes = new ShapePainter(canvas);
  }

  /** Draws all. */
  void draw() {
    float pixelsPerMetre = camera.pixelsPerMetre(Gdx.graphics.getHeight());
    pixel = 1 / pixelsPerMetre;
    canvas.begin(camera.gdx().combined, pixelsPerMetre);
    ground();
    Set<Item> wrong = new HashSet<>();
    editor.problems().forEach(problem -> wrong.add(problem.item()));
    List<Thing> things = editor.sketch().things();
    for (Thing thing : things) {
      paint(thing);
    }
    for (Thing thing : things) {
      if (wrong.contains(thing.item())) {
        mark(thing, WRONG, 3);
      }
    }
    links();
    for (Item item : editor.selection()) {
      Thing thing = editor.sketch().of(item);
      if (thing != null) {
        mark(thing, UiColours.ACCENT, 2);
      }
    }
    handles();
    drawing();
    canvas.end();
    names(things);
  }

  private void ground() {
    float w = camera.gdx().viewportWidth;
    float h = camera.gdx().viewportHeight;
    float x = camera.gdx().position.x - w / 2;
    float y = camera.gdx().position.y - h / 2;
    Json theme = editor.source().root().fields.get("theme");
    int background = colour(theme, "background", 0x10161f);
    canvas.gradient(
        x,
        y,
        w,
        h,
        UiColours.shade(background, 1, 1, fill),
        UiColours.shade(colour(theme, "sky", background), 1, 1, edge));
    float step = (float) editor.grid();
    while (step < LEAST_GRID_PX * pixel) {
      step *= 2;
    }
    if (editor.snaps()) {
      canvas.grid(x, y, x + w, y + h, step, GRID);
    }
    Json bounds = editor.source().root().fields.get("bounds");
    float[] box = bounds == null ? null : Points.box(bounds);
    if (box != null) {
      float edgeWidth = 1.5f * pixel;
      canvas.frame(box[0], box[1], box[2] - box[0], box[3] - box[1], edgeWidth, BOUNDS);
    }
  }

  private static int colour(Json object, String field, int otherwise) {
    Json colour = object == null ? null : object.fields.get(field);
    return colour != null && colour.text.matches("#[0-9a-fA-F]{6}")
        ? Integer.parseInt(colour.text.substring(1), 16)
        : otherwise;
  }

  private void paint(Thing thing) {
    if (thing.isRectangle()) {
      float[] box = Points.box(thing.json());
      if (box != null) {
        UiColours.shade(colour(thing.json(), "color", usualColour(thing)), 1, 0.25f, fill);
        canvas.rect(box[0], box[1], box[2] - box[0], box[3] - box[1], fill);
        fill.a = 0.7f;
        canvas.frame(box[0], box[1], box[2] - box[0], box[3] - box[1], pixel, fill);
      }
    } else if (thing.item().list().equals("areas")) {
      UiColours.shade(colour(thing.json(), "color", 0xb388eb), 1, 0.6f, fill);
      canvas.ring(thing.x(), thing.y(), thing.box().width() / 2, 1.5f * pixel, fill);
      canvas.disc(thing.x(), thing.y(), SPAWN_PX * pixel, fill);
    } else if (thing.item().list().equals("joints")) {
      joint(thing);
    } else if (thing.bodies().isEmpty()) {
      spot(thing);
    } else {
      motion(thing);
      for (CheckedLevel.Placed body : thing.bodies()) {
        body(body.kind(), body.at().x(), body.at().y(), body.at().angle(), 1);
      }
    }
  }

  private static int usualColour(Thing thing) {
    Json type = thing.json().fields.get("type");
    String kind = type == null ? "zone" : type.text;
    return switch (kind) {
      case "water" -> 0x3d8bd4;
      case "wind" -> 0xbfd7ea;
      case "gravity" -> 0xb388eb;
      case "drag" -> 0x8a6d3b;
      case "sand" -> 0xd9b56a;
      default -> 0x9fb8cc;
    };
  }

  /** Draws where players and things begin, or a body that can't be read. */
  private void spot(Thing thing) {
    float r = SPAWN_PX * pixel;
    boolean isSpawn = thing.item().list().equals("spawns");
    canvas.disc(thing.x(), thing.y(), r, isSpawn ? UiColours.INFO : WRONG);
    canvas.ring(thing.x(), thing.y(), r, 1.5f * pixel, UiColours.TEXT);
  }

  private void body(Archetype kind, float x, float y, float angle, float alpha) {
    float opacity = kind.sensor() ? 0.4f * alpha : alpha;
    shapes.pose(x, y, MathUtils.cos(angle), MathUtils.sin(angle));
    UiColours.shade(kind.appearance().rgb(), 1, opacity, fill);
    UiColours.shade(kind.appearance().outlineRgb(), 1, alpha, edge);
    for (Shape shape : kind.shapes()) {
      shapes.paint(shape, fill, 1.5f * pixel, edge);
    }
  }

  /** Draws the way of a body that moves to and fro. */
  private void motion(Thing thing) {
    Json motion = thing.json().fields.get("motion");
    Json to = motion == null ? null : motion.fields.get("to");
    if (Points.isPair(to)) {
      canvas.line(thing.x(), thing.y(), Points.x(to), Points.y(to), 2 * pixel, UiColours.INFO);
      ghosts(thing, Points.x(to), Points.y(to));
    }
  }

  private void ghosts(Thing thing, float x, float y) {
    if (!thing.bodies().isEmpty()) {
      CheckedLevel.Placed body = thing.bodies().get(0);
      body(body.kind(), x, y, body.at().angle(), 0.35f);
    }
  }

  private void joint(Thing thing) {
    Color colour = UiColours.GOOD;
    for (String[] ends :
        new String[][] {{"from", "to"}, {"groundFrom", "from"}, {"groundTo", "to"}}) {
      Json from = thing.json().fields.get(ends[0]);
      Json to = thing.json().fields.get(ends[1]);
      if (Points.isPair(from) && Points.isPair(to)) {
        canvas.line(Points.x(from), Points.y(from), Points.x(to), Points.y(to), 2 * pixel, colour);
      }
    }
    for (String end : List.of("a", "b")) {
      Json name = thing.json().fields.get(end);
      Thing body = name == null ? null : editor.sketch().ofName(name.text);
      if (body != null && !thing.json().fields.containsKey("from")) {
        canvas.line(thing.x(), thing.y(), body.x(), body.y(), pixel, colour);
      }
    }
    canvas.ring(thing.x(), thing.y(), SPAWN_PX * pixel, 2.5f * pixel, colour);
  }

  /** Draws what the selected triggers are about, and those that are about what is selected. */
  private void links() {
    List<Json> triggers = editor.source().list("triggers");
    for (int i = 0; i < triggers.size(); i++) {
      Item item = new Item("triggers", i);
      if (editor.selection().contains(item) || isAboutSelection(triggers.get(i))) {
        link(triggers.get(i));
      }
    }
  }

  private boolean isAboutSelection(Json value) {
    Thing named = value.kind == Json.Kind.STRING ? editor.sketch().ofName(value.text) : null;
    boolean isAbout = named != null && editor.selection().contains(named.item());
    for (Json inner : value.items) {
      isAbout |= isAboutSelection(inner);
    }
    for (Json inner : value.fields.values()) {
      isAbout |= isAboutSelection(inner);
    }
    return isAbout;
  }

  /** Draws lines from the bodies that a condition names to those on which actions act. */
  private void link(Json trigger) {
    Json when = trigger.fields.get("when");
    Thing from = when == null ? null : firstNamed(when);
    for (String part : List.of("do", "else")) {
      Json actions = trigger.fields.get(part);
      if (actions == null) {
        continue;
      }
      for (Json action : actions.kind == Json.Kind.ARRAY ? actions.items : List.of(actions)) {
        Thing to = firstNamed(action);
        Json at = action.fields.containsKey("to") ? action.fields.get("to") : place(action);
        if (to != null && from != null) {
          canvas.line(from.x(), from.y(), to.x(), to.y(), 1.5f * pixel, UiColours.ACCENT);
        }
        if (Points.isPair(at)) {
          Thing begin = to == null ? from : to;
          if (begin != null) {
            canvas.line(
                begin.x(), begin.y(), Points.x(at), Points.y(at), 1.5f * pixel, UiColours.INFO);
          }
          if (to != null) {
            ghosts(to, Points.x(at), Points.y(at));
          }
          canvas.ring(Points.x(at), Points.y(at), SPAWN_PX * pixel, 2 * pixel, UiColours.INFO);
        }
      }
    }
  }

  private static Json place(Json action) {
    Json teleport = action.fields.get("teleport");
    return teleport == null ? action.fields.get("at") : teleport;
  }

  private Thing firstNamed(Json value) {
    Thing found = value.kind == Json.Kind.STRING ? editor.sketch().ofName(value.text) : null;
    for (Json inner : value.items) {
      found = found == null ? firstNamed(inner) : found;
    }
    for (Json inner : value.fields.values()) {
      found = found == null ? firstNamed(inner) : found;
    }
    return found;
  }

  private void mark(Thing thing, Color colour, float widthPx) {
    if (thing.bodies().isEmpty()) {
      if (thing.isRectangle()) {
        float[] box = Points.box(thing.json());
        float w = widthPx * pixel;
        canvas.frame(box[0], box[1], box[2] - box[0], box[3] - box[1], w, colour);
      } else {
        canvas.ring(thing.x(), thing.y(), (SPAWN_PX + 4) * pixel, widthPx * pixel, colour);
      }
      return;
    }
    for (CheckedLevel.Placed body : thing.bodies()) {
      float angle = body.at().angle();
      shapes.pose(body.at().x(), body.at().y(), MathUtils.cos(angle), MathUtils.sin(angle));
      for (Shape shape : body.kind().shapes()) {
        shapes.outline(shape, widthPx * pixel, colour);
      }
    }
  }

  private void handles() {
    for (Handle handle : gestures.handles()) {
      boolean turns = handle.kind() == Handle.Kind.TURN;
      float r = HANDLE_PX * pixel;
      if (turns) {
        Thing thing = editor.sketch().of(editor.selected());
        canvas.line(thing.x(), thing.y(), handle.x(), handle.y(), pixel, UiColours.ACCENT);
      }
      canvas.disc(handle.x(), handle.y(), r, turns ? UiColours.ACCENT : UiColours.TEXT);
      canvas.ring(handle.x(), handle.y(), r, 1.5f * pixel, UiColours.BACKDROP);
    }
  }

  /** Draws what the mouse is drawing. */
  private void drawing() {
    Color colour = UiColours.ACCENT;
    List<double[]> points = gestures.points();
    for (int i = 0; i < points.size(); i++) {
      float x = (float) points.get(i)[0];
      float y = (float) points.get(i)[1];
      boolean isLast = i == points.size() - 1;
      Vector3 mouse = camera.toWorld(Gdx.input.getX(), Gdx.input.getY());
      float nextX = isLast ? (float) editor.snapped(mouse.x) : (float) points.get(i + 1)[0];
      float nextY = isLast ? (float) editor.snapped(mouse.y) : (float) points.get(i + 1)[1];
      canvas.line(x, y, nextX, nextY, 2 * pixel, colour);
      canvas.disc(x, y, (i == 0 ? HANDLE_PX + 2 : HANDLE_PX) * pixel, colour);
    }
    double[] drawn = gestures.drawn();
    if (drawn == null) {
      return;
    }
    float x = (float) Math.min(drawn[0], drawn[2]);
    float y = (float) Math.min(drawn[1], drawn[3]);
    float w = (float) Math.abs(drawn[2] - drawn[0]);
    float h = (float) Math.abs(drawn[3] - drawn[1]);
    Tool tool = gestures.tool();
    if (tool == Tool.CIRCLE) {
      float r = (float) Math.hypot(w, h);
      canvas.ring((float) drawn[0], (float) drawn[1], r, 2 * pixel, colour);
    } else if (tool == Tool.CAPSULE || tool == Tool.JOINT) {
      canvas.line(
          (float) drawn[0],
          (float) drawn[1],
          (float) drawn[2],
          (float) drawn[3],
          tool == Tool.JOINT ? 2 * pixel : 0.6f,
          colour);
    } else {
      fill.set(colour).a = 0.12f;
      canvas.rect(x, y, w, h, fill);
      canvas.frame(x, y, w, h, 1.5f * pixel, colour);
    }
  }

  /** Writes names where they have room; those of what is selected first. */
  private void names(List<Thing> things) {
    List<float[]> taken = new ArrayList<>();
    hud.begin();
    for (Thing thing : things) {
      if (editor.selection().contains(thing.item())) {
        name(thing, UiColours.ACCENT, taken);
      }
    }
    for (int i = things.size() - 1; i >= 0; i--) {
      Thing thing = things.get(i);
      boolean isRoomy = thing.box().width() > 60 * pixel || !thing.item().isBody();
      if (isRoomy && !editor.selection().contains(thing.item())) {
        name(thing, UiColours.TEXT, taken);
      }
    }
    hud.end();
  }

  private void name(Thing thing, Color tint, List<float[]> taken) {
    String name = name(thing);
    float w = hud.width(fonts.small(), name);
    boolean isRectangle = thing.isRectangle();
    Vector3 at = hud.at(camera, thing.x(), isRectangle ? thing.box().maxY : thing.y());
    boolean isInside = !thing.bodies().isEmpty() && thing.box().height() > 2 * LINE * pixel;
    float x = isRectangle ? at.x + 4 : at.x - w / 2;
    float y = isRectangle ? at.y - 6 : isInside ? at.y + 5 : at.y - 12;
    boolean isFree =
        taken.stream().noneMatch(t -> x < t[0] + t[2] && t[0] < x + w && Math.abs(y - t[1]) < LINE);
    if (isFree && !name.isEmpty()) {
      taken.add(new float[] {x, y, w});
      hud.shadowed(fonts.small(), name, x, y, tint);
    }
  }

  private static String name(Thing thing) {
    Json type = thing.json().fields.get("type");
    String kind = type == null || thing.item().isBody() ? "" : type.text;
    return thing.name().isEmpty() ? kind : thing.name();
  }

  /** Returns where the mouse is, for people. */
  String place() {
    Vector3 at = camera.toWorld(Gdx.input.getX(), Gdx.input.getY());
    return String.format(Locale.ROOT, "%.2f, %.2f", at.x, at.y);
  }

  /** Returns what is under the mouse, for people; empty for nothing. */
  String under() {
    Item item = gestures.under();
    Thing thing = item == null ? null : editor.sketch().of(item);
    return thing == null ? "" : item + (thing.name().isEmpty() ? "" : " " + thing.name());
  }
}
