package carom.client.edit;

import carom.text.Json;
import carom.text.JsonException;
import carom.text.JsonText;
import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * A level file as its text, with the values in it. What is edited is the text: a change replaces
 * the bytes of one value, so order, layout, numbers and fields of which the editor knows nothing
 * stay as they are. Immutable.
 */
public final class LevelSource {
  private final byte[] bytes;
  private final Json root;

  private LevelSource(byte[] bytes, Json root) {
    this.bytes = bytes;
    this.root = root;
  }

  /**
   * Reads a text.
   *
   * @throws JsonException if it is no JSON, with the place
   */
  public static LevelSource of(String text) throws JsonException {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    return new LevelSource(bytes, Json.parse(bytes));
  }

  /** Returns the text as UTF-8; a live array, which must not be changed. */
  public byte[] bytes() {
    return bytes;
  }

  /** Returns the value of the whole file. */
  public Json root() {
    return root;
  }

  /** Returns the items of a list of the file, such as {@code bodies}; none if it is missing. */
  public List<Json> list(String name) {
    Json list = root.fields.get(name);
    return list == null ? List.of() : list.items;
  }

  /** Returns the text of a value, as it is written. */
  public String text(Json value) {
    return new String(bytes, value.start, value.end() - value.start, StandardCharsets.UTF_8);
  }

  /** Returns whether the text is the same. */
  public boolean isSame(LevelSource other) {
    return Arrays.equals(bytes, other.bytes);
  }

  /** Begins some changes, which take effect together. */
  public Edit edit() {
    return new Edit();
  }

  /** Collects changes of this text. They must not overlap. */
  public final class Edit {
    private record Splice(int from, int to, String text) {}

    private final List<Splice> splices = new ArrayList<>();

    private Edit() {}

    /** Replaces a value. Does nothing if it is written like that already. */
    public Edit set(Json value, Object by) {
      String text = JsonText.of(by);
      if (!text.equals(text(value))) {
        splice(value.start, value.end(), text);
      }
      return this;
    }

    /** Replaces a value by a text of JSON. */
    public Edit replace(Json value, String text) {
      splice(value.start, value.end(), text);
      return this;
    }

    /**
     * Sets a field of an object, or adds it.
     *
     * @param order names of fields, in which a new one takes its place
     */
    public Edit put(Json object, String name, Object value, List<String> order) {
      Json present = object.fields.get(name);
      return present == null
          ? add(object, name, JsonText.of(value), order, null)
          : set(present, value);
    }

    /** Adds a field behind blanks; null for those that the field before has. */
    private Edit add(Json object, String name, String value, List<String> order, String blanks) {
      String field = JsonText.of(name) + ": " + value;
      List<Json> fields = new ArrayList<>(object.fields.values());
      int after = -1;
      int at = 0;
      for (String other : object.fields.keySet()) {
        if (order.indexOf(other) <= order.indexOf(name) || !order.contains(name)) {
          after = at;
        }
        at++;
      }
      if (fields.isEmpty()) {
        splice(object.start, object.end(), "{ " + field + " }");
      } else if (after < 0) {
        int first = begin(object, fields, 0);
        String lead = lead(object, fields, 0);
        splice(first, first, field + "," + (lead.isEmpty() ? " " : lead));
      } else {
        int end = fields.get(after).end();
        String lead = blanks == null ? newLead(object, fields, after) : blanks;
        splice(end, end, "," + lead + field);
      }
      return this;
    }

    /**
     * Adds items to the end of a list of the file, each on a line of its own; makes the list if it
     * isn't there.
     *
     * @param items texts of JSON
     * @param order names of the file's fields
     */
    public Edit append(String list, List<String> items, List<String> order) {
      Json present = root.fields.get(list);
      if (present != null && !present.items.isEmpty()) {
        int last = present.items.size() - 1;
        String lead = newLead(present, present.items, last);
        int end = present.items.get(last).end();
        splice(end, end, "," + lead + String.join("," + lead, items));
        return this;
      }
      String outer = "\n" + " ".repeat(2);
      for (int i = 0; i < root.fields.size(); i++) {
        String lead = lead(root, new ArrayList<>(root.fields.values()), i);
        outer = lead.contains("\n") ? lead : outer;
      }
      String inner = outer + outer.substring(outer.lastIndexOf('\n') + 1);
      String text = "[" + inner + String.join("," + inner, items) + outer + "]";
      return present == null ? add(root, list, text, order, outer) : replace(present, text);
    }

    /** Adds an item to a list within an item, behind the item of an index; -1 for the first. */
    public Edit insert(Json list, int after, Object item) {
      String text = JsonText.of(item);
      if (list.items.isEmpty()) {
        return replace(list, "[" + text + "]");
      } else if (after < 0) {
        int first = list.items.get(0).start;
        splice(first, first, text + ", ");
      } else {
        int end = list.items.get(after).end();
        splice(end, end, "," + newLead(list, list.items, after) + text);
      }
      return this;
    }

    private void splice(int from, int to, String text) {
      splices.add(new Splice(from, to, text));
    }

    /** Returns the text with the changes. */
    public LevelSource done() {
      splices.sort(Comparator.comparingInt(Splice::from));
      ByteArrayOutputStream out = new ByteArrayOutputStream(bytes.length + 64);
      int from = 0;
      for (Splice splice : splices) {
        out.write(bytes, from, splice.from - from);
        out.writeBytes(splice.text.getBytes(StandardCharsets.UTF_8));
        from = splice.to;
      }
      out.write(bytes, from, bytes.length - from);
      return made(out.toByteArray());
    }
  }

  /**
   * Returns the text without a value: a field with its name, or an item of a list.
   *
   * @param parent the object or list that holds it
   */
  public LevelSource without(Json parent, Json value) {
    List<Json> children = children(parent);
    int index = children.indexOf(value);
    int from = index == 0 ? begin(parent, children, 0) : children.get(index - 1).end();
    int to = value.end();
    if (children.size() == 1) {
      from = parent.start + 1;
      to = parent.end() - 1;
    } else if (index == 0) {
      to = begin(parent, children, 1);
    }
    ByteArrayOutputStream out = new ByteArrayOutputStream(bytes.length);
    out.write(bytes, 0, from);
    out.write(bytes, to, bytes.length - to);
    return made(out.toByteArray());
  }

  private static LevelSource made(byte[] bytes) {
    try {
      return new LevelSource(bytes, Json.parse(bytes));
    } catch (JsonException e) {
      throw new IllegalArgumentException(
          "the change would leave no JSON: line " + e.line() + " " + e.path() + e.getMessage(), e);
    }
  }

  private static List<Json> children(Json parent) {
    return parent.kind == Json.Kind.ARRAY ? parent.items : new ArrayList<>(parent.fields.values());
  }

  /** Returns where an item begins, or the name of a field. */
  private int begin(Json parent, List<Json> children, int index) {
    int at = index == 0 ? parent.start + 1 : children.get(index - 1).end();
    while (bytes[at] == ',' || isBlank(bytes[at])) {
      at++;
    }
    return at;
  }

  /** Returns the blanks before an item or field. */
  private String lead(Json parent, List<Json> children, int index) {
    int end = begin(parent, children, index);
    int start = end;
    while (isBlank(bytes[start - 1])) {
      start--;
    }
    return new String(bytes, start, end - start, StandardCharsets.UTF_8);
  }

  /** Returns the blanks before a new item or field behind one of an index. */
  private String newLead(Json parent, List<Json> children, int index) {
    String lead = lead(parent, children, index);
    return index > 0 || lead.contains("\n") ? lead : " ";
  }

  private static boolean isBlank(byte b) {
    return b == ' ' || b == '\n' || b == '\r' || b == '\t';
  }

  /**
   * Returns the value at the end of a way.
   *
   * @param path names of fields and numbers of items
   * @return null if there is none
   */
  public Json at(List<Object> path) {
    Json value = root;
    for (Object step : path) {
      if (value == null) {
        return null;
      }
      if (step instanceof Integer index) {
        value = index < value.items.size() ? value.items.get(index) : null;
      } else {
        value = value.fields.get(step);
      }
    }
    return value;
  }
}
