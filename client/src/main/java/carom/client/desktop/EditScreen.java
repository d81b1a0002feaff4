package carom.client.desktop;

import carom.client.LevelSender;
import carom.client.app.LocalGames;
import carom.client.desktop.hud.Hud;
import carom.client.desktop.menu.Widgets;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.UiColours;
import carom.client.desktop.paint.ViewCamera;
import carom.client.edit.EditFile;
import carom.client.edit.Gestures;
import carom.client.edit.Gestures.Sort;
import carom.client.edit.Item;
import carom.client.edit.LevelEditor;
import carom.client.edit.LevelSource;
import carom.client.edit.Points;
import carom.client.edit.Tool;
import carom.sim.level.Level;
import carom.text.Json;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input.Buttons;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.InputAdapter;
import com.badlogic.gdx.InputMultiplexer;
import com.badlogic.gdx.ScreenAdapter;
import com.badlogic.gdx.math.Vector3;
import com.badlogic.gdx.scenes.scene2d.Actor;
import com.badlogic.gdx.scenes.scene2d.Stage;
import com.badlogic.gdx.scenes.scene2d.Touchable;
import com.badlogic.gdx.scenes.scene2d.ui.Label;
import com.badlogic.gdx.scenes.scene2d.ui.ScrollPane;
import com.badlogic.gdx.scenes.scene2d.ui.Table;
import com.badlogic.gdx.scenes.scene2d.ui.TextButton;
import com.badlogic.gdx.scenes.scene2d.ui.TextField;
import com.badlogic.gdx.utils.ScreenUtils;
import com.badlogic.gdx.utils.TimeUtils;
import com.badlogic.gdx.utils.viewport.ScreenViewport;
import java.io.IOException;
import java.util.List;
import java.util.Set;

/**
 * The editor of a level: tools at the left, commands above, the form at the right, and the level
 * between them. Render thread only.
 */
final class EditScreen extends ScreenAdapter {
  private static final float TOOLS_WIDTH = 120;
  private static final float FORM_WIDTH = 320;
  private static final float BAR_HEIGHT = 44;
  private static final float STATUS_HEIGHT = 30;
  private static final float PAD = 8;
  private static final float ZOOM = 1.15f;
  private static final float LOOK_SECONDS = 1;
  private static final double NUDGE = 0.05;
  private static final double TURN = 15;
  private static final long TWICE_MS = 300;

  private static final String[] HELP = {
    "V B C U P L S N A J T   tools",
    "1 2 3   static, body, mover",
    "drag   move; handles form and turn",
    "Shift   adds to the selection",
    "arrows   nudge    R   turn by 15 degrees",
    "Ctrl+C V D A   copy, paste, double, all",
    "Del   delete; over a corner, that corner",
    "double click on an edge   a new corner",
    "Ctrl+Z Y   undo, redo",
    "G   grid on, off    Shift+G   its step",
    "wheel   zoom    middle, right, Space   pan",
    "Home   whole level",
    "Ctrl+S   save    Ctrl+R   read anew",
    "F5   play    Shift+F5   from the mouse",
    "F6   send to a server that takes levels",
    "Esc   back, step by step    F1   this"
  };

  private final Widgets widgets;
  private final Fonts fonts;
  private final EditHost host;
  private final EditFile file;
  private final LevelEditor editor;
  private final Gestures gestures;
  private final ViewCamera camera = new ViewCamera();
  private final Hud hud;
  private final SketchPainter painter;
  private final Inspector inspector;
  private final ScreenViewport viewport = new ScreenViewport();
  private final Stage stage = new Stage(viewport);
  private Label status;
  private Label where;
  private ScrollPane pane;
  private LevelSource shown;
  private Set<Item> shownSelection = Set.of();
  private boolean stale = true;
  private boolean fitted;
  private boolean panning;
  private boolean asks;
  private boolean asksWhere;
  private LevelSender sender;
  private boolean help;
  private boolean control; // as the last key event left it; the frame's end is too late
  private boolean shift;
  private boolean overwrites; // saves although the file was changed by others
  private int bots;
  private long lastPress;
  private int lastX;
  private int lastY;
  private float untilLook = LOOK_SECONDS;

  /**
   * Opens an editor. Canvas, fonts and widgets stay the property of the caller.
   *
   * @param file is open
   * @param bots that play along at first
   */
  public EditScreen(
      Canvas canvas, Fonts fonts, Widgets widgets, EditFile file, int bots, EditHost host) {
    this.fonts = fonts;
    this.widgets = widgets;
    this.file = file;
    this.bots = bots;
    this.host = host;
    editor = new LevelEditor(file.opened());
    gestures = new Gestures(editor);
    hud = new Hud(canvas, fonts);
    painter = new SketchPainter(canvas, hud, fonts, camera, editor, gestures);
    inspector = new Inspector(widgets, editor, gestures, () -> stale = true);
    editor.message("F1: all keys");
  }

  /** Returns the level that is edited. */
  public LevelEditor editor() {
    return editor;
  }

  /** Returns what the window shows of the level. */
  public ViewCamera camera() {
    return camera;
  }

  /** Tells the player something. */
  public void message(String text) {
    editor.message(text);
  }

  /** Returns whether closing the window would lose changes; asks the player if so. */
  public boolean asksToStay() {
    asks |= file.isUnsaved(editor.source());
    stale = true;
    return asks;
  }

  /** Keeps what isn't saved beside the file. Returns where, for the player; empty for nothing. */
  public String rescue() {
    try {
      return file.rescue(editor.source());
    } catch (IOException e) {
      return "; " + e.getMessage();
    }
  }

  // ---- commands

  private void save() {
    try {
      if (file.isChanged() && !overwrites) {
        overwrites = true;
        editor.message(
            "Another program has changed the file. Ctrl+S again overwrites it, Ctrl+R reads it.");
        return;
      }
      file.save(editor.source());
      overwrites = false;
      List<LevelEditor.Problem> problems = editor.problems();
      String warning = problems.isEmpty() ? host.warning(editor.checked().level()) : "";
      editor.message(
          !problems.isEmpty()
              ? "Saved, but it can't be played yet: " + problems.get(0).text()
              : warning.isEmpty() ? "Saved." : "Saved. " + warning);
    } catch (IOException e) {
      editor.message(e.getMessage());
    }
    stale = true;
  }

  private void reload() {
    try {
      editor.replace(file.reload());
      overwrites = false;
      editor.message("Read anew; Ctrl+Z leads back to what was here.");
    } catch (IOException e) {
      editor.message(e.getMessage());
    }
  }

  /** Plays the level as it is now. */
  private void play(boolean fromMouse) {
    if (!editor.problems().isEmpty()) {
      editor.message("It can't be played: " + editor.problems().get(0).text());
      return;
    }
    try {
      Vector3 at = camera.toWorld(Gdx.input.getX(), Gdx.input.getY());
      Level level = fromMouse ? editor.beginningAt(at.x, at.y) : editor.checked().level();
      host.play(level, bots);
    } catch (IllegalStateException e) {
      editor.message(e.getMessage());
    }
  }

  /** Asks to which server the level goes as it is now. */
  private void askWhere() {
    if (sender == null && editor.problems().isEmpty()) {
      asksWhere = true;
    } else {
      editor.message(
          sender != null ? sender.text() : "It can't be sent: " + editor.problems().get(0).text());
    }
    stale = true;
  }

  private void send(String server) {
    asksWhere = false;
    stale = true;
    try {
      sender = host.send(server, editor.checked().level().source());
    } catch (IllegalArgumentException e) {
      editor.message(e.getMessage());
    }
  }

  private void updateSender() {
    if (sender != null) {
      sender.update(System.nanoTime());
      editor.message(sender.text());
      sender = sender.isDone() ? null : sender;
    }
  }

  private void leave() {
    if (asksToStay()) {
      return;
    }
    host.leave();
  }

  private void take(Tool tool) {
    gestures.take(tool);
    editor.message(tool.help);
    stale = true;
  }

  private void bots(int by) {
    bots = Math.max(0, Math.min(LocalGames.MAX_BOTS, bots + by));
    stale = true;
  }

  // ---- keys and mouse

  @Override
  public void show() {
    Gdx.input.setInputProcessor(new InputMultiplexer(new Commands(), stage, new Picture()));
    stale = true;
  }

  private static boolean isDown(int key, int otherKey) {
    return Gdx.input.isKeyPressed(key) || Gdx.input.isKeyPressed(otherKey);
  }

  /** Keys that work wherever the focus is. */
  private final class Commands extends InputAdapter {
    @Override
    public boolean keyUp(int key) {
      note(key, false);
      return false;
    }

    private void note(int key, boolean isDown) {
      control = key == Keys.CONTROL_LEFT || key == Keys.CONTROL_RIGHT ? isDown : control;
      shift = key == Keys.SHIFT_LEFT || key == Keys.SHIFT_RIGHT ? isDown : shift;
    }

    @Override
    public boolean keyDown(int key) {
      note(key, true);
      boolean isWriting = stage.getKeyboardFocus() instanceof TextField;
      if (key == Keys.F5 && !asks) {
        stage.setKeyboardFocus(null);
        play(shift);
      } else if (key == Keys.ESCAPE) {
        escape();
      } else if (asks || asksWhere) {
        return true;
      } else if (key == Keys.F6) {
        stage.setKeyboardFocus(null);
        askWhere();
      } else if (key == Keys.F1) {
        help = !help;
      } else if (control && key == Keys.S) {
        stage.setKeyboardFocus(null);
        save();
      } else if (isWriting || !control) {
        return !isWriting && key(key);
      } else {
        return control(key);
      }
      stale = true;
      return true;
    }
  }

  private boolean control(int key) {
    Vector3 at = camera.toWorld(Gdx.input.getX(), Gdx.input.getY());
    switch (key) {
      case Keys.Z -> {
        if (shift) {
          editor.redo();
        } else {
          editor.undo();
        }
      }
      case Keys.Y -> editor.redo();
      case Keys.C -> editor.copy();
      case Keys.X -> {
        editor.copy();
        editor.delete();
      }
      case Keys.V -> editor.pasteAt(at.x, at.y);
      case Keys.D -> editor.duplicate();
      case Keys.A -> editor.selectAll();
      case Keys.R -> reload();
      default -> {
        return false;
      }
    }
    stale = true;
    return true;
  }

  private boolean key(int key) {
    double step = (editor.snaps() ? editor.grid() : NUDGE) * (shift ? 10 : 1);
    switch (key) {
      case Keys.LEFT -> editor.move(-step, 0);
      case Keys.RIGHT -> editor.move(step, 0);
      case Keys.UP -> editor.move(0, step);
      case Keys.DOWN -> editor.move(0, -step);
      case Keys.R -> editor.turn(shift ? -TURN : TURN);
      case Keys.FORWARD_DEL, Keys.DEL -> {
        if (!gestures.backPoint() && !gestures.removePoint()) {
          editor.delete();
        }
      }
      case Keys.G -> {
        if (shift) {
          editor.nextGrid();
        } else {
          editor.toggleSnap();
        }
      }
      case Keys.HOME -> fitted = false;
      case Keys.ENTER, Keys.NUMPAD_ENTER -> gestures.finish();
      case Keys.NUM_1, Keys.NUM_2, Keys.NUM_3 -> gestures.sort(Sort.values()[key - Keys.NUM_1]);
      default -> {
        for (Tool tool : Tool.values()) {
          if (tool.key.equals(Keys.toString(key))) {
            take(tool);
            return true;
          }
        }
        return false;
      }
    }
    stale = true;
    return true;
  }

  /** Ends what is under way: a field, a question, a drag, a tool, the selection, the editor. */
  private void escape() {
    if (asks || asksWhere) {
      asks = false;
      asksWhere = false;
    } else if (help) {
      help = false;
    } else if (stage.getKeyboardFocus() instanceof TextField) {
      stage.setKeyboardFocus(null);
    } else if (gestures.cancel()) {
      editor.message("");
    } else if (gestures.tool() != Tool.SELECT) {
      take(Tool.SELECT);
    } else if (!editor.selection().isEmpty()) {
      editor.select((Item) null);
    } else {
      leave();
    }
    stale = true;
  }

  /** The mouse over the level. */
  private final class Picture extends InputAdapter {
    @Override
    public boolean touchDown(int x, int y, int pointer, int button) {
      stage.setKeyboardFocus(null);
      panning = button != Buttons.LEFT || Gdx.input.isKeyPressed(Keys.SPACE);
      lastX = x;
      lastY = y;
      if (!panning && !asks) {
        Vector3 at = camera.toWorld(x, y);
        long now = TimeUtils.millis();
        if (now - lastPress < TWICE_MS) {
          gestures.addPoint(at.x, at.y);
        }
        lastPress = now;
        gestures.press(at.x, at.y, shift);
      }
      return true;
    }

    @Override
    public boolean touchDragged(int x, int y, int pointer) {
      if (panning) {
        camera.pan(lastX, lastY, x, y);
      } else {
        Vector3 at = camera.toWorld(x, y);
        gestures.drag(at.x, at.y);
      }
      lastX = x;
      lastY = y;
      return true;
    }

    @Override
    public boolean touchUp(int x, int y, int pointer, int button) {
      if (!panning) {
        Vector3 at = camera.toWorld(x, y);
        gestures.release(at.x, at.y, shift);
      }
      panning = false;
      stale = true;
      return true;
    }

    @Override
    public boolean mouseMoved(int x, int y) {
      Vector3 at = camera.toWorld(x, y);
      gestures.hover(at.x, at.y);
      return true;
    }

    @Override
    public boolean scrolled(float amountX, float amountY) {
      camera.zoom(Gdx.input.getX(), Gdx.input.getY(), (float) Math.pow(ZOOM, amountY));
      return true;
    }
  }

  // ---- the picture

  @Override
  public void render(float deltaSeconds) {
    int width = Gdx.graphics.getWidth();
    int height = Gdx.graphics.getHeight();
    if (!fitted) {
      fit(width, height);
    }
    camera.resize(width, height);
    gestures.unit(1 / camera.pixelsPerMetre(height));
    ScreenUtils.clear(UiColours.BACKDROP);
    hud.size(width, height);
    control = isDown(Keys.CONTROL_LEFT, Keys.CONTROL_RIGHT);
    shift = isDown(Keys.SHIFT_LEFT, Keys.SHIFT_RIGHT);
    painter.draw();
    lookAtFile(deltaSeconds);
    updateSender();
    boolean isDragging = Gdx.input.isButtonPressed(Buttons.LEFT);
    if (stale
        || (!isDragging && shown != editor.source())
        || !shownSelection.equals(editor.selection())) {
      build();
    }
    status.setText(editor.message());
    where.setText(painter.under() + "   " + painter.place());
    viewport.apply();
    stage.act(deltaSeconds);
    stage.draw();
    if (help) {
      help();
    }
  }

  /** Shows the whole level between the panels. */
  private void fit(int width, int height) {
    Json bounds = editor.source().root().fields.get("bounds");
    float[] box = bounds == null ? null : Points.box(bounds);
    if (box == null || !(box[0] < box[2] && box[1] < box[3])) {
      box = new float[] {-20, -10, 20, 10};
    }
    float scale = fonts.scale();
    float left = TOOLS_WIDTH * scale;
    float right = FORM_WIDTH * scale;
    float freeWidth = Math.max(width - left - right, width / 4f);
    float freeHeight = Math.max(height - (BAR_HEIGHT + STATUS_HEIGHT) * scale, height / 2f);
    float metres = 1.08f * Math.max((box[2] - box[0]) / freeWidth, (box[3] - box[1]) / freeHeight);
    float x = (box[0] + box[2]) / 2 + (right - left) / 2 * metres;
    float y = (box[1] + box[3]) / 2 + (BAR_HEIGHT - STATUS_HEIGHT) / 2 * scale * metres;
    camera.fit(x, y, width * metres, height * metres, width, height);
    fitted = true;
  }

  private void lookAtFile(float seconds) {
    untilLook -= seconds;
    if (untilLook <= 0) {
      untilLook = LOOK_SECONDS;
      if (file.isChanged() && !overwrites && editor.message().isEmpty()) {
        editor.message("Another program has changed the file. Ctrl+R reads it.");
      }
    }
  }

  private void help() {
    float line = 19;
    float w = 330;
    float h = HELP.length * line + 24;
    float x = (hud.windowWidth() - w) / 2;
    float top = hud.height() / 2 + h / 2;
    hud.panel(x, top - h, w, h, UiColours.DIALOG);
    hud.begin();
    for (int i = 0; i < HELP.length; i++) {
      hud.left(fonts.small(), HELP[i], x + 14, top - 14 - i * line, UiColours.TEXT);
    }
    hud.end();
  }

  // ---- the panels

  private void build() {
    stale = false;
    shown = editor.source();
    shownSelection = Set.copyOf(editor.selection());
    float scrolled = pane == null ? 0 : pane.getScrollY();
    Actor focus = stage.getKeyboardFocus();
    String focused = focus == null ? null : focus.getName();
    stage.setKeyboardFocus(null);
    stage.clear();
    Table root = new Table();
    root.setFillParent(true);
    root.add(bar()).height(BAR_HEIGHT).colspan(3).growX().row();
    root.add(tools()).width(TOOLS_WIDTH).growY();
    root.add().grow();
    Table right = side();
    pane = inspector.build(FORM_WIDTH - 3 * PAD - 12);
    right.add(pane).grow();
    root.add(right).width(FORM_WIDTH).growY().row();
    root.add(statusLine()).height(STATUS_HEIGHT).colspan(3).growX();
    stage.addActor(root);
    if (asks) {
      stage.addActor(question());
    } else if (asksWhere) {
      stage.addActor(servers());
    }
    root.validate();
    pane.validate();
    pane.setScrollY(scrolled);
    pane.updateVisualScroll();
    inspector.focus(stage, focused);
  }

  private Table side() {
    Table side = widgets.panel();
    side.pad(PAD);
    side.setTouchable(Touchable.enabled); // clicks don't go through to the level
    return side;
  }

  private Table bar() {
    Table bar = side();
    bar.pad(4);
    bar.defaults().height(BAR_HEIGHT - 10).padRight(4);
    String mark = file.isUnsaved(editor.source()) ? " *" : "";
    Label name = widgets.label(file.path().getFileName() + mark);
    name.setEllipsis(true);
    bar.add(name).minWidth(0).growX().padLeft(8);
    bar.add(widgets.button("Undo", () -> editor.undo()));
    bar.add(widgets.button("Redo", () -> editor.redo()));
    bar.add(
        widgets.button(
            editor.snaps() ? "Grid " + editor.grid() + " m" : "Grid off",
            () -> {
              editor.toggleSnap();
              stale = true;
            }));
    bar.add(widgets.button("Save", this::save));
    bar.add(widgets.label("Bots " + bots)).padLeft(10);
    bar.add(widgets.button("-", () -> bots(-1))).width(BAR_HEIGHT - 10);
    bar.add(widgets.button("+", () -> bots(1))).width(BAR_HEIGHT - 10);
    bar.add(widgets.button("Play  F5", () -> play(false)));
    bar.add(widgets.button("Send", this::askWhere)).padLeft(10);
    bar.add(widgets.button("Leave", this::leave)).padLeft(10);
    return bar;
  }

  private Table tools() {
    Table tools = side();
    int rows = Tool.values().length + Sort.values().length + 1;
    float room = viewport.getWorldHeight() - BAR_HEIGHT - STATUS_HEIGHT - 2 * PAD;
    tools.top().defaults().height(Math.min(30, room / rows - 3)).space(3);
    tools.defaults().minWidth(0).prefWidth(0).growX();
    for (Tool tool : Tool.values()) {
      boolean isTaken = tool == gestures.tool();
      String kind = gestures.kind(tool);
      String title = isTaken && !kind.isEmpty() ? kind : tool.title;
      tools.add(toolButton((isTaken ? "> " : "") + title, tool.key, () -> take(tool))).row();
    }
    tools.add(widgets.small("shapes are")).row();
    for (Sort sort : Sort.values()) {
      String mark = sort == gestures.sort() ? "> " : "";
      tools
          .add(
              toolButton(
                  mark + sort.title,
                  Integer.toString(sort.ordinal() + 1),
                  () -> {
                    gestures.sort(sort);
                    stale = true;
                  }))
          .row();
    }
    return tools;
  }

  private TextButton toolButton(String text, String key, Runnable action) {
    return widgets.row(text, widgets.small(key), action);
  }

  private Table statusLine() {
    Table line = side();
    line.pad(0, PAD, 0, PAD);
    status = widgets.label("");
    status.setEllipsis(true);
    where = widgets.muted("");
    line.add(status).minWidth(0).prefWidth(0).growX();
    line.add(where).padLeft(PAD);
    return line;
  }

  /** Returns the question whether changes may be lost. */
  private Table question() {
    Table panel = widgets.panel();
    panel.setTouchable(Touchable.enabled);
    panel.defaults().space(8).growX();
    panel.add(widgets.heading("Save " + file.path().getFileName() + "?")).row();
    panel
        .add(
            widgets.primary(
                "Save and leave",
                () -> {
                  save();
                  asks = false;
                  if (!file.isUnsaved(editor.source())) {
                    host.leave();
                  }
                }))
        .row();
    panel.add(widgets.button("Leave without saving", host::leave)).row();
    panel
        .add(
            widgets.button(
                "Stay",
                () -> {
                  asks = false;
                  stale = true;
                }))
        .row();
    Table root = new Table();
    root.setFillParent(true);
    root.add(panel);
    return root;
  }

  /** Returns the question to which server the level goes. */
  private Table servers() {
    Table panel = widgets.panel();
    panel.setTouchable(Touchable.enabled);
    panel.defaults().space(8).growX();
    panel.add(widgets.heading("Send " + file.path().getFileName() + " to")).row();
    for (String server : host.servers()) {
      panel.add(widgets.button(server, () -> send(server))).row();
    }
    panel.add(widgets.button("Not now", this::escape)).row();
    Table root = new Table();
    root.setFillParent(true);
    root.add(panel);
    return root;
  }

  @Override
  public void resize(int width, int height) {
    viewport.setUnitsPerPixel(1 / widgets.scale());
    viewport.update(width, height, true);
    stale = true;
  }

  @Override
  public void dispose() {
    if (sender != null) {
      sender.close();
    }
    stage.dispose();
    hud.dispose();
  }
}
