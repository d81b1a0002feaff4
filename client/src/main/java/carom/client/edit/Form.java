package carom.client.edit;

import carom.client.edit.LevelSchema.Rules;
import carom.text.Json;
import carom.text.JsonText;
import carom.text.Texts;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * A form for a thing of a level, made from the schema: a row for each value that is there, and the
 * names of those that may be added. It is made anew after each change. One thread.
 */
public final class Form {
  private static final LevelSchema SCHEMA = LevelSchema.LEVEL;

  /** Most items of a list that have rows of their own. */
  private static final int MOST_ITEMS = 32;

  /** The way to fill a row in. */
  public enum Kind {
    /** The begin of an object or list. */
    HEADING,
    /** A text or name. */
    TEXT,
    /** A number, or several. */
    NUMBERS,
    /** True or false. */
    FLAG,
    /** One of some words or kinds. */
    CHOICE,
    /** Names of fields or items that may be added. */
    ADD,
    /** A value that can't be changed here. */
    NOTE
  }

  /** A row of the form. */
  public static final class Row {
    /** Depth of objects within objects, from 0 on. */
    public final int depth;

    public final String label;
    public final Kind kind;

    /** The value as people read it. */
    public final String value;

    /** The words that it may be, or that may be added; names that fit a text. */
    public final List<String> choices;

    /** Range or form of the value, for people. */
    public final String hint;

    /** Identifies the row in the forms of the same thing. */
    public final String path;

    /** True for a point in the level, which a click may set. */
    public final boolean isPoint;

    /** True for the name of a body, which a click may give. */
    public final boolean isName;

    private Consumer<String> fill;
    private Runnable removal;

    private Row(
        int depth,
        String label,
        Kind kind,
        String value,
        List<String> choices,
        String hint,
        String path,
        Rules rules) {
      this.depth = depth;
      this.label = label;
      this.kind = kind;
      this.value = value;
      this.choices = choices;
      this.hint = hint;
      this.path = path;
      isPoint = rules != null && rules.name().equals("point");
      isName = rules != null && (rules.names().equals("bodies") || rules.names().equals("sensors"));
    }

    /** Fills the row in, as text; a value that doesn't fit is told and changes nothing. */
    public void fill(String text) {
      fill.accept(text);
    }

    /** Returns whether the value may be taken away. */
    public boolean isRemovable() {
      return removal != null;
    }

    /** Takes the value away. */
    public void remove() {
      removal.run();
    }
  }

  private final LevelEditor editor;
  private final LevelSource source;
  private final List<Row> rows = new ArrayList<>();

  private Form(LevelEditor editor) {
    this.editor = editor;
    source = editor.source();
  }

  /** Returns the rows for a thing; for null, those of the level itself, without its lists. */
  public static List<Row> of(LevelEditor editor, Item item) {
    Form form = new Form(editor);
    Rules rules = item == null ? SCHEMA.root() : SCHEMA.item(item.list());
    Json value = item == null ? form.source.root() : editor.json(item);
    if (value != null) {
      form.value(0, "type", value, rules, null);
    }
    return form.rows;
  }

  /** Does a change, unless the level has changed since the form was made. */
  private void change(Supplier<LevelSource> change) {
    if (editor.source() == source) {
      editor.change(change);
    }
  }

  private Row row(
      int depth,
      String label,
      Kind kind,
      String value,
      List<String> choices,
      String hint,
      String path,
      Rules rules) {
    Row row = new Row(depth, label, kind, value, choices, hint, path, rules);
    rows.add(row);
    return row;
  }

  /**
   * Adds the rows of a value.
   *
   * @param removal takes it away; null if it must be there
   */
  private void value(int depth, String label, Json value, Rules rules, Runnable removal) {
    List<Rules> options = SCHEMA.options(rules);
    Rules chosen = SCHEMA.chosen(rules, value);
    if (options.size() > 1) {
      choice(depth, label, value, options, chosen, removal);
    }
    boolean isTitled = options.size() > 1;
    int inner = isTitled ? depth + 1 : depth;
    switch (chosen.type()) {
      case "object" -> object(depth, label, value, chosen, isTitled, removal);
      case "array" -> list(inner, isTitled ? "" : label, value, chosen, isTitled ? null : removal);
      default -> scalar(inner, isTitled ? "" : label, value, chosen, isTitled ? null : removal);
    }
  }

  private void choice(
      int depth, String label, Json value, List<Rules> options, Rules chosen, Runnable removal) {
    List<String> titles = options.stream().map(SCHEMA::title).toList();
    Row row =
        row(depth, label, Kind.CHOICE, SCHEMA.title(chosen), titles, "", value.path() + "?", null);
    row.removal = removal;
    row.fill =
        title -> {
          Rules option = options.get(titles.indexOf(title));
          boolean wraps =
              option.type().equals("array")
                  && value.kind == Json.Kind.OBJECT; // an action becomes a list of one
          String text =
              wraps
                  ? "[" + source.text(value) + "]"
                  : JsonText.of(SCHEMA.start(option, label, editor.starts()));
          change(() -> source.edit().replace(value, text).done());
        };
  }

  private void object(
      int depth, String label, Json value, Rules rules, boolean isTitled, Runnable removal) {
    boolean isRoot = value == source.root();
    int inner = depth;
    if (depth > 0 || isTitled) {
      inner = depth + 1;
      if (!isTitled) {
        row(depth, label, Kind.HEADING, "", List.of(), "", value.path(), rules).removal = removal;
      }
    }
    for (String name : fieldsOf(value, rules)) {
      Json field = value.fields.get(name);
      Rules of = SCHEMA.field(rules, name);
      if (SCHEMA.isKind(rules, name) || (isRoot && (isList(of) || name.equals("$schema")))) {
        continue;
      }
      if (of == null) {
        row(inner, name, Kind.NOTE, field.shown(), List.of(), "", field.path(), null).removal =
            () -> change(() -> source.without(value, field));
        continue;
      }
      boolean mustStay = rules.required().contains(name);
      Runnable without = () -> change(() -> source.without(value, field));
      value(Math.max(inner, 1), name, field, of, mustStay ? null : without);
    }
    adds(Math.max(inner, 1), value, rules, isRoot);
  }

  /** Returns the names of the fields that are there: known ones in their order, then others. */
  private static List<String> fieldsOf(Json value, Rules rules) {
    List<String> names = new ArrayList<>(rules.fields());
    names.retainAll(value.fields.keySet());
    value.fields.keySet().stream().filter(name -> !names.contains(name)).forEach(names::add);
    return names;
  }

  private static boolean isList(Rules rules) {
    return rules != null && rules.type().equals("array") && !rules.isPair();
  }

  private void adds(int depth, Json value, Rules rules, boolean isRoot) {
    List<String> missing = new ArrayList<>(rules.fields());
    missing.removeAll(value.fields.keySet());
    missing.removeIf(name -> isRoot && (isList(SCHEMA.field(rules, name)) || name.startsWith("$")));
    boolean isOpen = rules.fields().isEmpty(); // names of one's own, such as those of materials
    if (missing.isEmpty() && !isOpen) {
      return;
    }
    Row row =
        row(
            depth,
            isOpen ? "new name" : "",
            isOpen ? Kind.TEXT : Kind.ADD,
            "",
            missing,
            "",
            value.path() + "+",
            null);
    row.fill =
        name -> {
          String clean = Texts.clean(name).strip();
          Rules field = clean.isEmpty() ? null : SCHEMA.field(rules, clean);
          if (field != null && !value.fields.containsKey(clean)) {
            Object start = SCHEMA.start(field, clean, editor.starts());
            change(() -> source.edit().put(value, clean, start, rules.fields()).done());
          }
        };
  }

  private void list(int depth, String label, Json value, Rules rules, Runnable removal) {
    if (rules.isPair()) {
      numbers(depth, label, value, rules, removal);
      return;
    }
    Rules items = SCHEMA.items(rules);
    int count = value.items.size();
    boolean areShown = count <= MOST_ITEMS;
    Row heading =
        row(
            depth,
            label,
            Kind.HEADING,
            count + (count == 1 ? " item" : " items"),
            List.of(),
            "",
            value.path(),
            rules);
    heading.removal = removal;
    for (int i = 0; areShown && i < count; i++) {
      Json item = value.items.get(i);
      boolean mayGo = count > rules.number("minItems", 0);
      Runnable without = () -> change(() -> source.without(value, item));
      value(depth + 1, Integer.toString(i + 1), item, items, mayGo ? without : null);
    }
    if (count < rules.number("maxItems", Integer.MAX_VALUE)) {
      Row add = row(depth + 1, "", Kind.ADD, "", List.of("item"), "", value.path() + "+", null);
      add.fill =
          name -> {
            Object start = SCHEMA.start(items, name, editor.starts());
            change(() -> source.edit().insert(value, count - 1, start).done());
          };
    }
  }

  private void numbers(int depth, String label, Json value, Rules rules, Runnable removal) {
    StringBuilder shown = new StringBuilder();
    for (Json number : value.items) {
      shown.append(shown.length() == 0 ? "" : ", ").append(number.text);
    }
    Row row =
        row(
            depth,
            label,
            Kind.NUMBERS,
            shown.toString(),
            List.of(),
            range(SCHEMA.items(rules)) + ", two numbers",
            value.path(),
            rules);
    row.removal = removal;
    row.fill =
        text -> {
          String[] parts = text.strip().split("[,;\\s]+");
          List<Double> numbers = new ArrayList<>();
          for (String part : parts) {
            Double number = number(part);
            if (number != null) {
              numbers.add(number);
            }
          }
          if (parts.length != 2 || numbers.size() != 2) {
            editor.message(label + " needs two numbers, such as 1.5, 2");
            return;
          }
          change(
              () ->
                  value.items.size() == 2
                      ? source
                          .edit()
                          .set(value.items.get(0), numbers.get(0))
                          .set(value.items.get(1), numbers.get(1))
                          .done()
                      : source.edit().set(value, numbers).done());
        };
  }

  /** Returns a number that people typed, or null. */
  private static Double number(String text) {
    try {
      double number = Double.parseDouble(text.strip());
      return Double.isFinite(number) ? number : null;
    } catch (NumberFormatException e) {
      return null;
    }
  }

  private void scalar(int depth, String label, Json value, Rules rules, Runnable removal) {
    Row row =
        switch (rules.type()) {
          case "enum" ->
              row(depth, label, Kind.CHOICE, value.text, rules.words(), "", value.path(), rules);
          case "boolean" ->
              row(
                  depth,
                  label,
                  Kind.FLAG,
                  String.valueOf(value.truth),
                  List.of("true", "false"),
                  "",
                  value.path(),
                  rules);
          case "string" ->
              row(
                  depth,
                  label,
                  Kind.TEXT,
                  value.text,
                  rules.names().isEmpty() ? List.of() : editor.names(rules.names()),
                  rules.name().equals("color") ? "#rrggbb" : "",
                  value.path(),
                  rules);
          default ->
              row(
                  depth,
                  label,
                  Kind.NUMBERS,
                  value.text,
                  List.of(),
                  range(rules),
                  value.path(),
                  rules);
        };
    row.removal = removal;
    row.fill =
        text -> {
          Object typed =
              switch (row.kind) {
                case FLAG -> (Object) Boolean.valueOf(text);
                case NUMBERS -> number(text);
                default -> Texts.clean(text);
              };
          if (typed == null) {
            editor.message(label + "=" + Texts.clean(text) + " must be a number");
          } else {
            change(() -> source.edit().set(value, typed).done());
          }
        };
  }

  private static String range(Rules rules) {
    double min = rules.number("minimum", Double.NaN);
    double max = rules.number("maximum", Double.NaN);
    return Double.isNaN(min) || Double.isNaN(max) ? "" : JsonText.of(min) + ".." + JsonText.of(max);
  }
}
