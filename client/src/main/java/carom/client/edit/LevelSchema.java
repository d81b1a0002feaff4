package carom.client.edit;

import carom.sim.level.Level;
import carom.text.Json;
import carom.text.JsonException;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The rules of {@code level.schema.json}, of which forms are made: which fields a value may have,
 * of what kind they are, and with what a new one begins. Immutable.
 */
public final class LevelSchema {
  /** The rules of level files. */
  public static final LevelSchema LEVEL = new LevelSchema();

  private static final String DEFINITION = "#/$defs/";

  private final Json file;

  /**
   * The rules of a value.
   *
   * @param name of the definition, such as {@code point}; empty for rules in place
   * @param rules the schema's object
   * @param start what a new value is; null if nothing is said
   */
  public record Rules(String name, Json rules, Json start) {
    /** Returns the type: a word of JSON Schema, {@code enum} for words, or {@code anyOf}. */
    public String type() {
      return rules.fields.containsKey("enum")
          ? "enum"
          : rules.fields.containsKey("anyOf") ? "anyOf" : rules.fields.get("type").text;
    }

    /** Returns the words that the value may be; empty if it isn't one of some words. */
    public List<String> words() {
      Json words = rules.fields.get("enum");
      return words == null ? List.of() : words.items.stream().map(w -> w.text).toList();
    }

    /** Returns the names of the fields in their order; empty for what is no object. */
    public List<String> fields() {
      Json fields = rules.fields.get("properties");
      return fields == null ? List.of() : new ArrayList<>(fields.fields.keySet());
    }

    /** Returns the names of the fields that must be there. */
    public List<String> required() {
      Json fields = rules.fields.get("required");
      return fields == null ? List.of() : fields.items.stream().map(f -> f.text).toList();
    }

    /** Returns whose names a text may be: {@code bodies}, {@code sensors}; empty for any text. */
    public String names() {
      Json names = rules.fields.get("names");
      return names == null ? "" : names.text;
    }

    /** Returns a number among the rules, or another if it isn't there. */
    public double number(String rule, double otherwise) {
      Json number = rules.fields.get(rule);
      return number == null ? otherwise : number.number;
    }

    /** Returns whether the value is two numbers. */
    public boolean isPair() {
      return number("minItems", 0) == 2 && number("maxItems", 0) == 2;
    }
  }

  /** Supplies what new values begin with. */
  public interface Starts {
    /** Returns the point at which something new begins, metres. */
    double[] point();

    /** Returns the names of things of the level, such as {@code sensors}. */
    List<String> names(String of);
  }

  private LevelSchema() {
    try (InputStream in = Level.class.getResourceAsStream("/levels/level.schema.json")) {
      file = Json.parse(in.readAllBytes());
    } catch (IOException | JsonException e) {
      throw new IllegalStateException("the schema of levels can't be read: " + e.getMessage(), e);
    }
  }

  /** Returns the rules of a file. */
  public Rules root() {
    return new Rules("", file, null);
  }

  /** Returns the rules of an item of a list of the file, such as {@code bodies}. */
  public Rules item(String list) {
    return items(field(root(), list));
  }

  /** Returns the rules of a field of an object, or null if the object has no such field. */
  public Rules field(Rules object, String name) {
    Json fields = object.rules.fields.get("properties");
    Json rules = fields == null ? null : fields.fields.get(name);
    if (rules == null) {
      rules = object.rules.fields.get("additionalProperties");
      return rules == null || rules.kind != Json.Kind.OBJECT ? null : resolved(rules);
    }
    return resolved(rules);
  }

  /** Returns the rules of the items of a list. */
  public Rules items(Rules list) {
    return resolved(list.rules.fields.get("items"));
  }

  private Rules resolved(Json rules) {
    String name = "";
    Json start = rules.fields.get("default");
    Json found = rules;
    while (found.fields.containsKey("$ref")) {
      name = found.fields.get("$ref").text.substring(DEFINITION.length());
      found = file.fields.get("$defs").fields.get(name);
      start = start == null ? found.fields.get("default") : start;
    }
    return new Rules(name, found, start);
  }

  /** Returns what a value may be instead: the rules themselves if they leave no choice. */
  public List<Rules> options(Rules rules) {
    List<Rules> options = new ArrayList<>();
    if (rules.type().equals("anyOf")) {
      for (Json option : rules.rules.fields.get("anyOf").items) {
        options.addAll(options(resolved(option)));
      }
    } else {
      options.add(rules);
    }
    return options;
  }

  /** Returns which of the options a value is meant to be; the first if it is none of them. */
  public Rules chosen(Rules rules, Json value) {
    List<Rules> options = options(rules);
    Rules found = null;
    for (Rules option : options) {
      if (fits(option, value)) {
        return option;
      }
      found = found == null && isOfType(option, value) ? option : found;
    }
    return found == null ? options.get(0) : found;
  }

  private boolean fits(Rules option, Json value) {
    if (!isOfType(option, value) || value.kind != Json.Kind.OBJECT) {
      return isOfType(option, value);
    }
    String word = kindWord(option);
    if (!word.isEmpty()) {
      Json type = value.fields.get("type");
      return type != null && type.text.equals(word);
    }
    return option.required().isEmpty() || value.fields.containsKey(option.required().get(0));
  }

  private static boolean isOfType(Rules option, Json value) {
    return switch (option.type()) {
      case "enum", "string" -> value.kind == Json.Kind.STRING;
      case "integer", "number" -> value.kind == Json.Kind.NUMBER;
      default -> value.kind.name().equalsIgnoreCase(option.type());
    };
  }

  /** Returns the only word that the field {@code type} of an object may be; empty without. */
  private String kindWord(Rules object) {
    Rules type = object.fields().contains("type") ? field(object, "type") : null;
    return type != null && type.words().size() == 1 ? type.words().get(0) : "";
  }

  /** Returns a name of an option for people. */
  public String title(Rules option) {
    String word = kindWord(option);
    if (!word.isEmpty()) {
      return word;
    }
    return switch (option.type()) {
      case "object" -> option.required().isEmpty() ? option.name() : option.required().get(0);
      case "array" -> "list";
      case "string" -> option.names().isEmpty() ? "text" : "name";
      case "boolean" -> "true or false";
      default -> option.type();
    };
  }

  /** Returns whether a field says nothing, because the object's kind says it. */
  boolean isKind(Rules object, String field) {
    return field.equals("type") && !kindWord(object).isEmpty();
  }

  /**
   * Returns what a new value begins with.
   *
   * @param name of the field
   */
  public Object start(Rules rules, String name, Starts starts) {
    if (rules.start != null) {
      return rules.type().equals("boolean") ? (Object) !rules.start.truth : plain(rules.start);
    }
    return switch (rules.type()) {
      case "anyOf" -> start(options(rules).get(0), name, starts);
      case "enum" -> rules.words().get(0);
      case "object" -> {
        Map<String, Object> fields = new LinkedHashMap<>();
        rules.required().forEach(f -> fields.put(f, start(field(rules, f), f, starts)));
        yield fields;
      }
      case "array" -> startOfList(rules, name, starts);
      case "integer" -> (int) inside(rules);
      case "number" -> inside(rules);
      case "boolean" -> true;
      default -> startOfText(rules, name, starts);
    };
  }

  private Object startOfList(Rules rules, String name, Starts starts) {
    if (rules.name().equals("point")) {
      double[] at = starts.point();
      double right = name.equals("max") ? 2 : 0;
      double up = name.equals("to") ? 3 : right;
      return List.of(at[0] + right, at[1] + up);
    }
    if (rules.isPair()) {
      return List.of(name.equals("step") ? 2 : 0, 0);
    }
    Object item = start(items(rules), name, starts);
    return rules.number("minItems", 0) > 0 || item instanceof Map ? List.of(item) : List.of();
  }

  private static double inside(Rules rules) {
    return Math.max(rules.number("minimum", 1), Math.min(rules.number("maximum", 1), 1));
  }

  private static String startOfText(Rules rules, String name, Starts starts) {
    if (rules.name().equals("color")) {
      return "#ffd166";
    }
    if (rules.name().equals("fieldName")) {
      return "match.name";
    }
    List<String> names = rules.names().isEmpty() ? List.of() : starts.names(rules.names());
    return names.isEmpty() ? name : names.get(0);
  }

  private static Object plain(Json value) {
    return switch (value.kind) {
      case ARRAY -> value.items.stream().map(LevelSchema::plain).toList();
      case NUMBER -> value.number;
      case BOOLEAN -> value.truth;
      default -> value.text;
    };
  }
}
