package carom.sim.level;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * A node of a JSON document that knows where it stood, so that an error can name the line. The
 * reader is strict: no comments, no NaN, no key twice, nothing after the end.
 */
public final class Json {
  /** The type of a node. */
  public enum Kind {
    OBJECT("an object"),
    ARRAY("a list"),
    STRING("a text"),
    NUMBER("a number"),
    BOOLEAN("true or false"),
    NULL("null");

    final String words;

    Kind(String words) {
      this.words = words;
    }
  }

  private static final JsonFactory FACTORY =
      JsonFactory.builder()
          .streamReadConstraints(
              StreamReadConstraints.builder()
                  .maxNestingDepth(32)
                  .maxNumberLength(64)
                  .maxStringLength(4096)
                  .maxNameLength(256)
                  .build())
          .build();

  public final Kind kind;
  public final String path;
  public final int line;
  final int column;

  /** Text of a string, or of a number as written; empty otherwise. */
  public final String text;

  public final double number;
  final boolean truth;
  public final List<Json> items = new ArrayList<>();

  /** Fields of an object, in file order. */
  public final Map<String, Json> fields = new LinkedHashMap<>();

  private Json(Kind kind, String path, JsonParser p) throws IOException {
    this.kind = kind;
    this.path = path;
    JsonLocation at = p.currentTokenLocation();
    line = at.getLineNr();
    column = at.getColumnNr();
    text = kind == Kind.STRING || kind == Kind.NUMBER ? p.getText() : "";
    number = kind == Kind.NUMBER ? p.getDoubleValue() : 0;
    truth = p.currentToken() == JsonToken.VALUE_TRUE;
  }

  /** Reads a whole document. */
  public static Json parse(String file, byte[] bytes) throws LevelException {
    try (JsonParser p = FACTORY.createParser(bytes)) {
      if (p.nextToken() == null) {
        throw new LevelException(file, 1, 1, "", "the file is empty; it must be a JSON object");
      }
      Json root = read(file, p, "");
      if (p.nextToken() != null) {
        JsonLocation at = p.currentTokenLocation();
        throw new LevelException(
            file, at.getLineNr(), at.getColumnNr(), "", "nothing may follow the closing brace");
      }
      return root;
    } catch (JsonProcessingException e) {
      JsonLocation at = e.getLocation();
      int line = at == null ? 0 : at.getLineNr();
      int column = at == null ? 0 : at.getColumnNr();
      throw new LevelException(
          file, line, column, "", "not JSON: " + withoutSource(e.getOriginalMessage()));
    } catch (IOException e) {
      throw new LevelException(file, 0, 0, "", "not JSON: " + e.getMessage());
    }
  }

  /** Removes where the object began from Jackson's message, because Jackson names no file there. */
  private static String withoutSource(String message) {
    int at = message.indexOf(" (start marker at [");
    return at < 0 ? message : message.substring(0, at);
  }

  private static Json read(String file, JsonParser p, String path)
      throws IOException, LevelException {
    return switch (p.currentToken()) {
      case START_OBJECT -> readObject(file, p, path);
      case START_ARRAY -> readArray(file, p, path);
      case VALUE_STRING -> new Json(Kind.STRING, path, p);
      case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> new Json(Kind.NUMBER, path, p);
      case VALUE_TRUE, VALUE_FALSE -> new Json(Kind.BOOLEAN, path, p);
      default -> new Json(Kind.NULL, path, p);
    };
  }

  private static Json readArray(String file, JsonParser p, String path)
      throws IOException, LevelException {
    Json array = new Json(Kind.ARRAY, path, p);
    while (p.nextToken() != JsonToken.END_ARRAY) {
      array.items.add(read(file, p, path + "[" + array.items.size() + "]"));
    }
    return array;
  }

  private static Json readObject(String file, JsonParser p, String path)
      throws IOException, LevelException {
    Json object = new Json(Kind.OBJECT, path, p);
    while (p.nextToken() != JsonToken.END_OBJECT) {
      JsonLocation at = p.currentTokenLocation();
      String name = p.currentName();
      String fieldPath = path.isEmpty() ? name : path + "." + name;
      p.nextToken();
      if (object.fields.put(name, read(file, p, fieldPath)) != null) {
        throw new LevelException(
            file, at.getLineNr(), at.getColumnNr(), fieldPath, " stands here a second time");
      }
    }
    return object;
  }

  /** Returns the value as an error message shows it, shortened. */
  String shown() {
    return switch (kind) {
      case STRING -> '"' + shortened() + '"';
      case NUMBER -> shortened();
      case BOOLEAN -> String.valueOf(truth);
      case NULL -> "null";
      default -> kind.words;
    };
  }

  private String shortened() {
    return text.length() > 40 ? text.substring(0, 40) + "..." : text;
  }
}
