package carom.client.edit;

import carom.game.GameFault;
import carom.game.Games;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import carom.sim.Game;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.level.CheckedLevel;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.text.Json;
import carom.text.JsonException;
import carom.text.JsonText;
import carom.text.Texts;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;

/**
 * A level that is edited: its text, what is selected, and what can be undone. The reader of levels
 * judges each state. It knows no window; {@link Gestures} turns a mouse into its calls. One thread.
 */
public final class LevelEditor {
  /** Steps of the grid, metres. */
  private static final List<Double> GRIDS = List.of(0.1, 0.25, 0.5, 1.0, 2.0);

  private static final int TICK_RATE = 60;
  private static final int CENTIMETRES = 100;

  private final History history;
  private final Set<Item> selection = new LinkedHashSet<>();
  private final List<Clip> clipboard = new ArrayList<>();
  private LevelSource source;
  private CheckedLevel checked;
  private Sketch sketch;
  private LevelSource judged;
  private List<Problem> problems = List.of();
  private String message = "";
  private int grid = 2;
  private boolean snaps = true;

  /** A thing that was copied. */
  private record Clip(String list, String text) {}

  /**
   * A mistake in the level.
   *
   * @param item of the file that it is about; null for the level as a whole
   * @param text for the player
   */
  public record Problem(Item item, String text) {}

  /** Begins to edit a level. */
  public LevelEditor(LevelSource opened) {
    history = new History(opened);
    source = opened;
  }

  // ---- what there is

  /** Returns the text as it is now, in the middle of a drag, too. */
  public LevelSource source() {
    return source;
  }

  /** Returns the level as the reader of levels sees it. */
  public CheckedLevel checked() {
    look();
    return checked;
  }

  /** Returns where things are. */
  public Sketch sketch() {
    look();
    return sketch;
  }

  private void look() {
    if (checked == null) {
      checked = CheckedLevel.of("level", source.bytes());
      sketch = new Sketch(source, checked);
    }
  }

  /**
   * Returns what is wrong with the level: with the file, or else with it as a level of its game.
   * Costs the set-up of the game after each change.
   */
  public List<Problem> problems() {
    if (judged != source) {
      judged = source;
      problems = checked().level() == null ? ofFile() : ofGame();
    }
    return problems;
  }

  private List<Problem> ofFile() {
    List<Problem> found = new ArrayList<>();
    for (LevelException problem : checked().problems()) {
      String text = problem.getMessage();
      found.add(
          new Problem(Item.of(problem.field()), text.substring(text.indexOf(problem.field()))));
    }
    return found;
  }

  private List<Problem> ofGame() {
    Class<?> type = Game.class;
    try {
      Game game = Games.create(checked.level().gameName());
      type = game.getClass();
      new SimulationHost(game, checked.level(), 0, TICK_RATE, Role.AUTHORITY);
      return List.of();
    } catch (IllegalArgumentException e) {
      return List.of(new Problem(null, GameFault.refusal(type, e)));
    } catch (RuntimeException | LinkageError | AssertionError | StackOverflowError e) {
      return List.of(new Problem(null, "the game's set-up fails: " + GameFault.describe(e)));
    }
  }

  /** Returns what is selected, in the order of selection; unmodifiable. */
  public Set<Item> selection() {
    return Collections.unmodifiableSet(selection);
  }

  /** Returns the only thing that is selected, or null. */
  public Item selected() {
    return selection.size() == 1 ? selection.iterator().next() : null;
  }

  /** Returns the value of a thing. */
  public Json json(Item item) {
    return source.at(item.path());
  }

  /** Returns what the last command has to tell; empty if nothing. */
  public String message() {
    return message;
  }

  /** Tells the player something. */
  public void message(String text) {
    message = text;
  }

  // ---- the grid

  /** Returns the step of the grid, metres. */
  public double grid() {
    return GRIDS.get(grid);
  }

  /** Takes the next step of the grid. */
  public void nextGrid() {
    grid = (grid + 1) % GRIDS.size();
  }

  /** Returns whether points move to the grid. */
  public boolean snaps() {
    return snaps;
  }

  /** Switches the grid on or off. */
  public void toggleSnap() {
    snaps = !snaps;
  }

  /** Returns a place on an axis on the grid, or to the centimetre without one. */
  public double snapped(double metres) {
    return rounded(snaps ? Math.round(metres / grid()) * grid() : metres);
  }

  /** Returns a number with two decimals. */
  static double rounded(double value) {
    return Math.round(value * CENTIMETRES) / (double) CENTIMETRES;
  }

  // ---- selection

  /** Selects one thing, or nothing for null. */
  public void select(Item item) {
    selection.clear();
    if (item != null) {
      selection.add(item);
    }
  }

  /** Selects some things. */
  public void select(Iterable<Item> items) {
    selection.clear();
    items.forEach(selection::add);
  }

  /** Adds a thing to the selection, or takes it away. */
  public void toggle(Item item) {
    if (!selection.remove(item)) {
      selection.add(item);
    }
  }

  /** Selects all that has a place. */
  public void selectAll() {
    select(sketch().things().stream().map(Sketch.Thing::item).toList());
  }

  // ---- changes

  /** Goes on with another text, which undo leads back from. */
  void commit(LevelSource next) {
    LevelSource before = history.now().source();
    show(next);
    selection.removeIf(item -> json(item) == null);
    if (!before.isSame(next)) {
      history.add(next, selection);
    }
  }

  /** Shows a text for now. */
  void show(LevelSource next) {
    source = next;
    checked = null;
    sketch = null;
  }

  /** Goes back to the text before the present drag. */
  void revert() {
    show(history.now().source());
  }

  /** Goes a step back. Returns whether there was one. */
  public boolean undo() {
    return go(-1);
  }

  /** Goes forward to what was undone. Returns whether there was anything. */
  public boolean redo() {
    return go(1);
  }

  private boolean go(int by) {
    boolean gone = history.go(by);
    show(history.now().source());
    select(history.now().selection());
    selection.removeIf(item -> json(item) == null);
    message = gone ? "" : by < 0 ? "Nothing to undo." : "Nothing to redo.";
    return gone;
  }

  /** Takes the file's text as a step that can be undone. */
  public void replace(LevelSource text) {
    commit(text);
  }

  private static List<String> order(String list) {
    return LevelSchema.LEVEL.item(list).fields();
  }

  /** Adds things to a list of the file and selects them. Returns the first. */
  Item add(LevelSource to, String list, List<String> texts) {
    int first = to.list(list).size();
    LevelSource next = to.edit().append(list, texts, LevelSchema.LEVEL.root().fields()).done();
    selection.clear();
    for (int i = 0; i < texts.size(); i++) {
      selection.add(new Item(list, first + i));
    }
    commit(next);
    return new Item(list, first);
  }

  /** Returns a text with all selected things moved, and the joints that hold nothing else. */
  LevelSource moved(LevelSource from, Set<Item> items, double dx, double dy) {
    LevelSource.Edit edit = from.edit();
    for (Item item : withJoints(from, items)) {
      Points.forEach(
          item,
          from.at(item.path()),
          (pair, field, isLocal) -> {
            boolean isTarget = item.list().equals("triggers");
            if (!isLocal && !isTarget) {
              set(edit, pair, pair.items.get(0).number + dx, pair.items.get(1).number + dy);
            }
          });
    }
    return edit.done();
  }

  static void set(LevelSource.Edit edit, Json pair, double x, double y) {
    edit.set(pair.items.get(0), rounded(x)).set(pair.items.get(1), rounded(y));
  }

  private static Set<Item> withJoints(LevelSource from, Set<Item> items) {
    Set<Item> all = new LinkedHashSet<>(items);
    Set<String> names = new TreeSet<>();
    for (Item item : items) {
      Json name = item.isBody() ? from.at(item.path()).fields.get("name") : null;
      if (name != null) {
        names.add(name.text);
      }
    }
    List<Json> joints = from.list("joints");
    for (int i = 0; i < joints.size(); i++) {
      Json a = joints.get(i).fields.get("a");
      Json b = joints.get(i).fields.get("b");
      if (b != null && isOf(names, b) && (a == null || isOf(names, a))) {
        all.add(new Item("joints", i));
      }
    }
    return all;
  }

  private static boolean isOf(Set<String> names, Json name) {
    int bracket = name.text.indexOf('[');
    return names.contains(bracket > 0 ? name.text.substring(0, bracket) : name.text);
  }

  /** Moves what is selected. */
  public void move(double dx, double dy) {
    commit(moved(source, selection, dx, dy));
  }

  /** Turns what is selected about its middle, degrees counter-clockwise. */
  public void turn(double degrees) {
    Aabb all = new Aabb().setEmpty();
    List<Sketch.Thing> things =
        selection.stream().map(sketch()::of).filter(Objects::nonNull).toList();
    things.forEach(thing -> all.add(thing.box()));
    boolean alone = things.size() == 1;
    float middleX = alone ? things.get(0).x() : (all.minX + all.maxX) / 2;
    float middleY = alone ? things.get(0).y() : (all.minY + all.maxY) / 2;
    Transform turn = new Transform(0, 0, (float) Math.toRadians(degrees));
    LevelSource.Edit edit = source.edit();
    for (Sketch.Thing thing : things) {
      float centreX = (thing.box().minX + thing.box().maxX) / 2 - middleX;
      float centreY = (thing.box().minY + thing.box().maxY) / 2 - middleY;
      Points.forEach(
          thing.item(),
          thing.json(),
          (pair, field, isLocal) -> {
            if (isLocal) {
              return;
            }
            float x = Points.x(pair) - middleX;
            float y = Points.y(pair) - middleY;
            if (thing.isRectangle()) { // it stays along the axes
              set(
                  edit,
                  pair,
                  Points.x(pair) + turn.worldX(centreX, centreY) - centreX,
                  Points.y(pair) + turn.worldY(centreX, centreY) - centreY);
            } else {
              set(edit, pair, middleX + turn.worldX(x, y), middleY + turn.worldY(x, y));
            }
          });
      if (thing.item().isBody()) {
        Json angle = thing.json().fields.get("angle");
        turnTo(edit, thing, (angle == null ? 0 : angle.number) + degrees);
      }
    }
    commit(edit.done());
  }

  static void turnTo(LevelSource.Edit edit, Sketch.Thing thing, double degrees) {
    double angle = rounded(degrees % 360);
    if (angle != 0 || thing.json().fields.containsKey("angle")) {
      edit.put(thing.json(), "angle", angle, order(thing.item().list()));
    }
  }

  /** Deletes what is selected, and the joints that hold it. */
  public void delete() {
    Set<Item> gone = new LinkedHashSet<>(selection);
    Set<String> names = new TreeSet<>();
    for (Item item : selection) {
      Json name = item.isBody() ? json(item).fields.get("name") : null;
      if (name != null) {
        names.add(name.text);
      }
    }
    for (Sketch.Thing thing : sketch().things()) {
      if (thing.item().isBody() && !gone.contains(thing.item())) {
        names.remove(thing.name());
      }
    }
    List<Json> joints = source.list("joints");
    for (int i = 0; i < joints.size(); i++) {
      for (String end : List.of("a", "b")) {
        Json name = joints.get(i).fields.get(end);
        if (name != null && isOf(names, name)) {
          gone.add(new Item("joints", i));
        }
      }
    }
    commit(without(source, gone));
    select((Item) null);
    message = gone.isEmpty() ? "Nothing is selected." : "";
  }

  private static LevelSource without(LevelSource from, Set<Item> gone) {
    List<Item> last = new ArrayList<>(gone);
    last.sort((p, q) -> Integer.compare(q.index(), p.index())); // indices before it stay
    LevelSource next = from;
    for (Item item : last) {
      next = next.without(next.root().fields.get(item.list()), next.at(item.path()));
    }
    return next;
  }

  // ---- names

  /** Returns the names of things of the level, to which others refer. */
  public List<String> names(String of) {
    return names(source, of);
  }

  private static List<String> names(LevelSource from, String of) {
    if (of.equals("games")) {
      return Games.names();
    }
    if (of.equals("materials")) {
      Json materials = from.root().fields.get(of);
      return materials == null ? List.of() : new ArrayList<>(materials.fields.keySet());
    }
    Set<String> names = new LinkedHashSet<>();
    boolean ofTriggers = of.equals("triggers");
    for (String list : ofTriggers ? List.of(of) : List.of("bodies", "statics")) {
      for (Json item : from.list(list)) {
        Json name = item.fields.get("name");
        boolean isSensor = isSensor(item);
        if (name != null && (ofTriggers || isSensor == of.equals("sensors"))) {
          Json repeat = item.fields.get("repeat");
          names.add(name.text + (repeat == null || isSensor ? "" : "[0]"));
        }
      }
    }
    return new ArrayList<>(names);
  }

  private static boolean isSensor(Json item) {
    Json sensor = item.fields.get("sensor");
    return sensor != null && sensor.truth;
  }

  /** Returns a name that nothing has yet: {@code door}, {@code door-2} and so on. */
  static String newName(LevelSource in, String wanted) {
    Set<String> taken = new TreeSet<>();
    for (String list : List.of("bodies", "statics", "triggers", "joints")) {
      for (Json item : in.list(list)) {
        Json name = item.fields.get("name");
        if (name != null) {
          taken.add(name.text);
        }
      }
    }
    String base = wanted.replaceFirst("-\\d+$", "");
    String name = wanted;
    for (int i = 2; taken.contains(name); i++) {
      name = base + "-" + i;
    }
    return name;
  }

  /** Names a body if it has no name of its own yet. Returns the text with it. */
  static LevelSource named(LevelSource from, Item body) {
    Json json = from.at(body.path());
    if (json.fields.containsKey("name")) {
      return from;
    }
    String wanted = isSensor(json) ? "sensor" : body.list().equals("statics") ? "wall" : "body";
    return from.edit().put(json, "name", newName(from, wanted + "-1"), order(body.list())).done();
  }

  /** Returns the name by which joints and triggers find a body: of a repeated one the first. */
  static String reference(LevelSource from, Item body) {
    Json json = from.at(body.path());
    String name = json.fields.get("name").text;
    boolean isOne = isSensor(json) || !json.fields.containsKey("repeat");
    return isOne ? name : name + "[0]";
  }

  // ---- the clipboard

  /** Copies what is selected. */
  public void copy() {
    clipboard.clear();
    for (Item item : selection) {
      clipboard.add(new Clip(item.list(), source.text(json(item))));
    }
    message = selection.size() + " copied.";
  }

  /**
   * Pastes what was copied, moved by metres, under names of its own where these are referred to.
   */
  public void paste(double dx, double dy) {
    if (clipboard.isEmpty()) {
      message = "Nothing was copied.";
      return;
    }
    Map<String, String> renamed = new LinkedHashMap<>();
    Set<Item> pasted = new LinkedHashSet<>();
    LevelSource next = source;
    for (Clip clip : clipboard) {
      next =
          next.edit()
              .append(clip.list, List.of(clip.text), LevelSchema.LEVEL.root().fields())
              .done();
      Item item = new Item(clip.list, next.list(clip.list).size() - 1);
      pasted.add(item);
      Json name = next.at(item.path()).fields.get("name");
      if (name != null && isReferred(source, clip.list, name.text)) {
        String fresh = newName(source, name.text);
        for (int i = 2; renamed.containsValue(fresh); i++) {
          fresh = newName(source, name.text.replaceFirst("-\\d+$", "") + "-" + i);
        }
        renamed.put(name.text, fresh);
        next = next.edit().set(name, fresh).done();
      }
    }
    LevelSource.Edit edit = next.edit();
    for (Item item : pasted) {
      if (item.list().equals("joints")) {
        for (String end : List.of("a", "b")) {
          Json name = next.at(item.path()).fields.get(end);
          if (name != null && renamed.containsKey(name.text)) {
            edit.set(name, renamed.get(name.text));
          }
        }
      }
    }
    selection.clear();
    selection.addAll(pasted);
    commit(moved(edit.done(), pasted, rounded(dx), rounded(dy)));
    message = "";
  }

  /** Pastes what was copied, its middle at a point. */
  public void pasteAt(float x, float y) {
    Aabb all = new Aabb().setEmpty();
    for (Clip clip : clipboard) {
      try {
        Json json = LevelSource.of(clip.text).root();
        Points.forEach(
            new Item(clip.list, 0),
            json,
            (pair, field, isLocal) -> {
              if (!isLocal) {
                all.add(Points.x(pair), Points.y(pair));
              }
            });
      } catch (JsonException e) {
        throw new IllegalStateException("what was copied is no JSON: " + e.getMessage(), e);
      }
    }
    if (all.isEmpty()) {
      paste(0, 0);
    } else {
      double middleX = (all.minX + all.maxX) / 2.0;
      double middleY = (all.minY + all.maxY) / 2.0;
      paste(snapped(x - middleX), snapped(y - middleY));
    }
  }

  /** Copies what is selected and pastes it beside. */
  public void duplicate() {
    copy();
    paste(grid(), -grid());
  }

  private static boolean isReferred(LevelSource in, String list, String name) {
    if (list.equals("triggers") || list.equals("joints")) {
      return true;
    }
    String quoted = JsonText.of(name);
    String indexed = quoted.substring(0, quoted.length() - 1) + "[";
    for (String other : List.of("joints", "triggers")) {
      Json all = in.root().fields.get(other);
      String text = all == null || !new Item(list, 0).isBody() ? "" : in.text(all);
      if (text.contains(quoted) || text.contains(indexed)) {
        return true;
      }
    }
    return false;
  }

  /**
   * Returns the level with one place for players to begin at.
   *
   * @throws IllegalStateException in words for the player, if it can't be played then
   */
  public Level beginningAt(float x, float y) {
    Set<Item> begins = new LinkedHashSet<>();
    List<Json> spawns = source.list("spawns");
    for (int i = 0; i < spawns.size(); i++) {
      Json name = spawns.get(i).fields.get("name");
      if (name == null || name.text.equals("player")) {
        begins.add(new Item("spawns", i));
      }
    }
    String here = JsonText.of(fields("name", "player", "at", List.of(rounded(x), rounded(y))));
    List<String> order = LevelSchema.LEVEL.root().fields();
    LevelSource next = without(source, begins).edit().append("spawns", List.of(here), order).done();
    try {
      return Level.parse("level", next.bytes());
    } catch (LevelException e) {
      throw new IllegalStateException(e.getMessage(), e);
    }
  }

  // ---- forms

  /** Returns what new values begin with: points where the selected thing is, or the first spawn. */
  LevelSchema.Starts starts() {
    Sketch.Thing selected = selected() == null ? null : sketch().of(selected());
    Sketch.Thing thing = selected == null ? sketch().of(new Item("spawns", 0)) : selected;
    return new LevelSchema.Starts() {
      @Override
      public double[] point() {
        return thing == null
            ? new double[2]
            : new double[] {rounded(thing.x()), rounded(thing.y())};
      }

      @Override
      public List<String> names(String of) {
        return LevelEditor.this.names(of);
      }
    };
  }

  /** Does a change of a form; one that leaves no JSON is told and not done. */
  void change(Supplier<LevelSource> change) {
    try {
      message = "";
      commit(change.get());
    } catch (IllegalArgumentException e) {
      message = Texts.clean(String.valueOf(e.getMessage()));
    }
  }

  /** Adds a trigger about what is selected: a sensor sets it off, a kinematic body moves. */
  public void addTrigger() {
    LevelSource next = source;
    String sensor = "";
    Item mover = null;
    for (Item item : selection) {
      if (item.isBody()) {
        Json json = json(item);
        Json type = json.fields.get("type");
        if (isSensor(json)) {
          next = named(next, item);
          sensor = reference(next, item);
        } else if (type != null && type.text.equals("kinematic")) {
          mover = item;
          next = named(next, item);
        }
      }
    }
    List<String> sensors = names(next, "sensors");
    sensor = sensor.isEmpty() && !sensors.isEmpty() ? sensors.get(0) : sensor;
    Map<String, Object> trigger = new LinkedHashMap<>();
    boolean lasts = mover != null;
    trigger.put(
        "when",
        sensor.isEmpty()
            ? Map.of("timer", 5)
            : fields(lasts ? "inside" : "enter", sensor, "who", "player"));
    if (lasts) {
      Json at = next.at(mover.path()).fields.get("at");
      String name = reference(next, mover);
      Map<String, Object> there = fields("move", name, "to", at(at, 3));
      trigger.put("do", there);
      if (!sensor.isEmpty()) {
        trigger.put("else", fields("move", name, "to", at(at, 0)));
      }
    } else {
      trigger.put("do", Map.of("notice", "Well done!"));
    }
    add(next, "triggers", List.of(JsonText.of(trigger)));
  }

  private static List<Double> at(Json pair, double up) {
    return List.of(pair.items.get(0).number, rounded(pair.items.get(1).number + up));
  }

  static Map<String, Object> fields(Object... namesAndValues) {
    Map<String, Object> fields = new LinkedHashMap<>();
    for (int i = 0; i < namesAndValues.length; i += 2) {
      fields.put(String.valueOf(namesAndValues[i]), namesAndValues[i + 1]);
    }
    return fields;
  }
}
