package carom.client.desktop;

import carom.client.desktop.menu.Widgets;
import carom.client.edit.Form;
import carom.client.edit.Gestures;
import carom.client.edit.Item;
import carom.client.edit.LevelEditor;
import carom.text.Json;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.scenes.scene2d.Actor;
import com.badlogic.gdx.scenes.scene2d.InputEvent;
import com.badlogic.gdx.scenes.scene2d.InputListener;
import com.badlogic.gdx.scenes.scene2d.Stage;
import com.badlogic.gdx.scenes.scene2d.ui.Label;
import com.badlogic.gdx.scenes.scene2d.ui.ScrollPane;
import com.badlogic.gdx.scenes.scene2d.ui.Table;
import com.badlogic.gdx.scenes.scene2d.ui.TextButton;
import com.badlogic.gdx.scenes.scene2d.ui.TextField;
import com.badlogic.gdx.scenes.scene2d.utils.FocusListener;
import java.util.List;
import java.util.Locale;
import java.util.Set;

/**
 * The panel at the right: what is wrong, the form of what is selected, or that of the level with
 * its triggers. It is built anew after each change.
 */
final class Inspector {
  private static final float INDENT = 12;
  private static final float LABEL_WIDTH = 112;
  private static final float ROW = 28;
  private static final int CHOICES_IN_A_ROW = 3;
  private static final int LONG = 9;
  private static final int MAX_LENGTH = 200;
  private static final int MOST_PROBLEMS = 5;

  private final Widgets widgets;
  private final LevelEditor editor;
  private final Gestures gestures;
  private final Runnable changed;
  private final Table content = new Table();
  private String open = ""; // path of the row whose choices are shown
  private float width;

  /**
   * Creates the panel.
   *
   * @param changed runs when the panel must be built anew although the level is the same
   */
  Inspector(Widgets widgets, LevelEditor editor, Gestures gestures, Runnable changed) {
    this.widgets = widgets;
    this.editor = editor;
    this.gestures = gestures;
    this.changed = changed;
  }

  /** Returns the panel's content, built anew. */
  ScrollPane build(float newWidth) {
    width = newWidth;
    content.clear();
    content.top().left();
    content.defaults().left().growX();
    problems();
    Set<Item> selection = editor.selection();
    if (selection.size() > 1) {
      content.add(widgets.heading(selection.size() + " things")).padBottom(6).row();
      Label note =
          widgets.note("Drag moves them, R turns, Ctrl+C copies, Ctrl+D doubles, Del deletes.");
      content.add(note).row();
    } else {
      Item item = editor.selected();
      content.add(widgets.heading(title(item))).padBottom(6).row();
      if (item == null) {
        lists();
      }
      for (Form.Row row : Form.of(editor, item)) {
        add(row);
      }
    }
    return widgets.scroll(content);
  }

  private String title(Item item) {
    if (item == null) {
      return "Level";
    }
    String list = item.list();
    String one =
        list.equals("bodies")
            ? "body"
            : list.equals("statics") ? "static" : list.substring(0, list.length() - 1);
    return one.substring(0, 1).toUpperCase(Locale.ROOT) + one.substring(1);
  }

  private void problems() {
    List<LevelEditor.Problem> problems = editor.problems();
    for (int i = 0; i < Math.min(MOST_PROBLEMS, problems.size()); i++) {
      LevelEditor.Problem problem = problems.get(i);
      Label text = widgets.problem(problem.text());
      text.addListener(
          new InputListener() {
            @Override
            public boolean touchDown(InputEvent event, float x, float y, int pointer, int button) {
              editor.select(problem.item());
              changed.run();
              return true;
            }
          });
      content.add(text).width(width).padBottom(4).row();
    }
    if (problems.size() > MOST_PROBLEMS) {
      content.add(widgets.small("and " + (problems.size() - MOST_PROBLEMS) + " more")).row();
    }
  }

  // ---- rows

  private void add(Form.Row row) {
    Table line = new Table();
    line.left().defaults().left();
    float indent = Math.max(0, row.depth - 1) * INDENT;
    if (row.kind == Form.Kind.ADD) {
      String only = row.choices.size() == 1 ? row.choices.get(0) : null;
      line.add(
              widgets.button(
                  "+ " + (only == null ? "more" : only),
                  () -> {
                    if (only == null) {
                      toggle(row.path);
                    } else {
                      row.fill(only);
                    }
                  }))
          .height(ROW);
    } else {
      Label label = row.kind == Form.Kind.HEADING ? widgets.label(row.label) : label(row);
      line.add(label).width(Math.max(40, LABEL_WIDTH - indent)).height(ROW);
      Actor value = value(row);
      line.add(value).height(ROW).minWidth(0).prefWidth(0).growX();
      tools(row, line);
    }
    content.add(line).padLeft(indent).padTop(2).row();
    if (open.equals(row.path)) {
      choices(row, indent);
    }
  }

  private Label label(Form.Row row) {
    Label label = widgets.muted(row.label);
    label.setEllipsis(true);
    return label;
  }

  private TextButton button(String text, Runnable action) {
    TextButton button = widgets.button(text, action);
    button.getLabel().setEllipsis(true);
    button.getLabelCell().minWidth(0);
    return button;
  }

  private Actor value(Form.Row row) {
    return switch (row.kind) {
      case FLAG ->
          button(
              row.value.equals("true") ? "yes" : "no",
              () -> row.fill(row.value.equals("true") ? "false" : "true"));
      case CHOICE -> button(row.value, () -> toggle(row.path));
      case TEXT, NUMBERS -> field(row);
      default -> widgets.small(row.value);
    };
  }

  private TextField field(Form.Row row) {
    TextField field = widgets.field(row.value, MAX_LENGTH);
    field.setName(row.path);
    field.setMessageText(row.hint);
    field.addListener(
        new InputListener() {
          @Override
          public boolean keyDown(InputEvent event, int key) {
            if (key == Keys.ENTER || key == Keys.NUMPAD_ENTER) {
              field.getStage().setKeyboardFocus(null); // keys are commands again
              return true;
            }
            return false;
          }
        });
    field.addListener(
        new FocusListener() {
          @Override
          public void keyboardFocusChanged(FocusEvent event, Actor actor, boolean focused) {
            if (focused) {
              editor.message(row.hint.isEmpty() ? "" : row.label + ": " + row.hint);
              field.selectAll();
            } else {
              commit(row, field);
            }
          }
        });
    return field;
  }

  private void commit(Form.Row row, TextField field) {
    if (!field.getText().equals(row.value)) {
      row.fill(field.getText());
      changed.run();
    }
  }

  /** Adds the small buttons at the end of a row. */
  private void tools(Form.Row row, Table line) {
    if (row.kind == Form.Kind.TEXT && !row.choices.isEmpty()) {
      line.add(widgets.button("...", () -> toggle(row.path))).size(ROW).padLeft(2);
    }
    if (row.isPoint || row.isName) {
      line.add(widgets.button("pick", () -> pick(row))).height(ROW).padLeft(2);
    }
    if (row.label.equals("color") || row.hint.startsWith("#")) {
      if (row.value.matches("#[0-9a-fA-F]{6}")) {
        line.add(widgets.swatch(Integer.parseInt(row.value.substring(1), 16)))
            .size(ROW - 6)
            .padLeft(4);
      }
    }
    if (row.isRemovable()) {
      line.add(widgets.button("x", row::remove)).size(ROW).padLeft(2);
    }
  }

  private void pick(Form.Row row) {
    editor.message(row.isPoint ? "Click a place in the picture." : "Click a body in the picture.");
    gestures.pick(
        (item, at) -> {
          if (row.isPoint) {
            row.fill(at[0] + ", " + at[1]);
          } else if (item != null && item.isBody()) {
            Json name = editor.json(item).fields.get("name");
            if (name == null) {
              editor.message("That body has no name; select it and give it one first.");
            } else {
              boolean isRepeated = editor.json(item).fields.containsKey("repeat");
              boolean isPlain = row.choices.contains(name.text) || !isRepeated;
              row.fill(isPlain ? name.text : name.text + "[0]");
            }
          }
        });
  }

  private void toggle(String path) {
    open = open.equals(path) ? "" : path;
    changed.run();
  }

  private void choices(Form.Row row, float indent) {
    Table grid = new Table();
    grid.defaults().height(ROW).minWidth(0).prefWidth(0).growX().uniformX().space(2);
    boolean areLong = row.choices.stream().anyMatch(choice -> choice.length() > LONG);
    int columns = CHOICES_IN_A_ROW - (areLong ? 1 : 0);
    for (int i = 0; i < row.choices.size(); i++) {
      String choice = row.choices.get(i);
      grid.add(
          button(
              choice,
              () -> {
                open = "";
                row.fill(choice);
                changed.run();
              }));
      if (i % columns == columns - 1) {
        grid.row();
      }
    }
    content.add(grid).padLeft(indent).padTop(2).padBottom(4).row();
  }

  // ---- the level's lists

  /** Adds a row for each trigger, and for each joint. */
  private void lists() {
    for (String list : List.of("triggers", "joints")) {
      List<Json> items = editor.source().list(list);
      String title = list.substring(0, 1).toUpperCase(Locale.ROOT) + list.substring(1);
      content.add(widgets.label(title + ": " + items.size())).padTop(4).row();
      for (int i = 0; i < items.size(); i++) {
        Item item = new Item(list, i);
        String text = list.equals("triggers") ? sentence(items.get(i)) : joint(items.get(i));
        content
            .add(
                widgets.row(
                    text,
                    () -> {
                      editor.select(item);
                      changed.run();
                    }))
            .height(ROW)
            .minWidth(0)
            .prefWidth(0)
            .padTop(2)
            .row();
      }
    }
    content
        .add(widgets.note("T makes a trigger of the sensor and the mover that are selected."))
        .padTop(6)
        .padBottom(10)
        .row();
  }

  private static String sentence(Json trigger) {
    Json name = trigger.fields.get("name");
    String text = words(trigger.fields.get("when")) + ": " + words(trigger.fields.get("do"));
    return name == null ? text : name.text + ": " + text;
  }

  private static String words(Json part) {
    Json first = part != null && !part.items.isEmpty() ? part.items.get(0) : part;
    if (first == null || first.fields.isEmpty()) {
      return "?";
    }
    String verb = first.fields.keySet().iterator().next();
    Json what = first.fields.get(verb);
    String more = part.items.size() > 1 ? " ..." : "";
    return verb + (what.text.isEmpty() ? "" : " " + what.text) + more;
  }

  private static String joint(Json joint) {
    StringBuilder text = new StringBuilder();
    for (String field : List.of("type", "a", "b")) {
      Json value = joint.fields.get(field);
      text.append(value == null ? "" : value.text + " ");
    }
    return text.toString().strip();
  }

  /** Moves the focus to the field of a row. Returns whether it is there. */
  boolean focus(Stage stage, String path) {
    Actor field = path == null ? null : content.findActor(path);
    if (field != null) {
      stage.setKeyboardFocus(field);
    }
    return field != null;
  }
}
