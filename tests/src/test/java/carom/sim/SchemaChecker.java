package carom.sim;

import carom.sim.level.Level;
import carom.text.Json;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** As much of JSON Schema as {@code level.schema.json} uses; an unknown keyword is an error. */
public final class SchemaChecker {
  private final Json root;

  private SchemaChecker(Json root) {
    this.root = root;
  }

  public static SchemaChecker levels() throws Exception {
    try (InputStream in = Level.class.getResourceAsStream("/levels/level.schema.json")) {
      return new SchemaChecker(Json.parse(in.readAllBytes()));
    }
  }

  /** The fields of a definition in order; null for the file itself. */
  public List<String> fields(String definition) {
    Json node = definition == null ? root : root.fields.get("$defs").fields.get(definition);
    return new ArrayList<>(node.fields.get("properties").fields.keySet());
  }

  /** The fields that may stand beside the first, which each object of a definition needs. */
  public Map<String, List<String>> kinds(String definition) {
    Map<String, List<String>> kinds = new TreeMap<>();
    for (Json kind : root.fields.get("$defs").fields.get(definition).fields.get("anyOf").items) {
      List<String> fields = new ArrayList<>(kind.fields.get("properties").fields.keySet());
      kinds.put(kind.fields.get("required").items.get(0).text, fields.subList(1, fields.size()));
    }
    return kinds;
  }

  public List<String> words(String definition) {
    List<String> words = new ArrayList<>();
    for (Json word : root.fields.get("$defs").fields.get(definition).fields.get("enum").items) {
      words.add(word.text);
    }
    return words;
  }

  /** Empty when the value agrees, else the first disagreement. */
  public String check(Json value) {
    return check(root, value);
  }

  private String check(Json schema, Json value) {
    for (Map.Entry<String, Json> keyword : schema.fields.entrySet()) {
      String problem = check(keyword.getKey(), keyword.getValue(), schema, value);
      if (!problem.isEmpty()) {
        return problem;
      }
    }
    return "";
  }

  private String check(String keyword, Json rule, Json schema, Json value) {
    boolean number = value.kind == Json.Kind.NUMBER;
    boolean text = value.kind == Json.Kind.STRING;
    return switch (keyword) {
      case "$schema", "$defs", "title", "description", "default", "names" -> "";
      case "$ref" -> check(root.fields.get("$defs").fields.get(rule.text.substring(8)), value);
      case "type" -> when(isType(rule.text, value), value, "type " + rule.text);
      case "minimum" -> when(!number || value.number >= rule.number, value, keyword);
      case "maximum" -> when(!number || value.number <= rule.number, value, keyword);
      case "minLength" -> when(!text || value.text.length() >= rule.number, value, keyword);
      case "maxLength" -> when(!text || value.text.length() <= rule.number, value, keyword);
      case "pattern" -> when(!text || value.text.matches(rule.text), value, keyword);
      case "minItems" -> when(value.items.size() >= rule.number, value, keyword);
      case "maxItems" -> when(value.items.size() <= rule.number, value, keyword);
      case "enum" ->
          when(rule.items.stream().anyMatch(w -> w.text.equals(value.text)), value, keyword);
      case "anyOf" ->
          when(rule.items.stream().anyMatch(s -> check(s, value).isEmpty()), value, keyword);
      case "required" ->
          when(rule.items.stream().allMatch(f -> value.fields.containsKey(f.text)), value, keyword);
      case "items" -> first(value.items, rule);
      case "properties" -> properties(rule, value);
      case "additionalProperties" ->
          rule.kind == Json.Kind.OBJECT
              ? first(new ArrayList<>(value.fields.values()), rule)
              : when(
                  schema
                      .fields
                      .get("properties")
                      .fields
                      .keySet()
                      .containsAll(value.fields.keySet()),
                  value,
                  keyword);
      default ->
          throw new AssertionError("the schema uses " + keyword + "; teach it to this class");
    };
  }

  private String properties(Json rule, Json value) {
    for (Map.Entry<String, Json> field : rule.fields.entrySet()) {
      Json present = value.fields.get(field.getKey());
      String problem = present == null ? "" : check(field.getValue(), present);
      if (!problem.isEmpty()) {
        return problem;
      }
    }
    return "";
  }

  private String first(List<Json> values, Json schema) {
    for (Json value : values) {
      String problem = check(schema, value);
      if (!problem.isEmpty()) {
        return problem;
      }
    }
    return "";
  }

  private static boolean isType(String type, Json value) {
    if (type.equals("integer")) {
      return value.kind == Json.Kind.NUMBER && value.number == Math.rint(value.number);
    }
    return value.kind.name().equalsIgnoreCase(type);
  }

  private static String when(boolean agrees, Json value, String keyword) {
    return agrees ? "" : value.path() + " at line " + value.line + ": " + keyword;
  }
}
