package carom.text;

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
 * reader is strict: no comments, no NaN, no key twice, nothing after the end, and no character that
 * can't be seen, as a document's texts end up on terminals and screens.
 *
 * <p>A document may come from a hostile server, so what it can make a reader allocate is bounded:
 * {@value #MAX_NODES} nodes of about a hundred bytes, {@value #MAX_DEPTH} levels, and short names
 * and texts. Immutable once parsed; any thread.
 */
public final class Json {
  /** Most nodes of a document. */
  public static final int MAX_NODES = 500_000;

  /** Most levels of a document. */
  public static final int MAX_DEPTH = 32;

  /** The type of a node. */
  public enum Kind {
    OBJECT("an object"),
    ARRAY("a list"),
    STRING("a text"),
    NUMBER("a number"),
    BOOLEAN("true or false"),
    NULL("null");

    /** Name of the kind for people. */
    public final String words;

    Kind(String words) {
      this.words = words;
    }
  }

  private static final int MAX_TEXT = 4096;
  private static final JsonFactory FACTORY = factory(MAX_TEXT);

  public final Kind kind;

  /** Line from 1. */
  public final int line;

  /** Column from 1. */
  public final int column;

  /** Offset of the first byte in the document. */
  public final int start;

  /** Text of a string, or of a number as written; empty otherwise. */
  public final String text;

  /** Value of a number; 0 otherwise. */
  public final double number;

  /** Value of true or false; false otherwise. */
  public final boolean truth;

  /** Items of a list, in file order; empty otherwise. */
  public final List<Json> items;

  /** Fields of an object, in file order; empty otherwise. */
  public final Map<String, Json> fields;

  private final Json parent;
  private final String name;
  private final int index;
  private int end;

  private Json(Kind kind, Json parent, String name, int index, JsonParser p) throws IOException {
    this.kind = kind;
    this.parent = parent;
    this.name = name;
    this.index = index;
    JsonLocation at = p.currentTokenLocation();
    line = at.getLineNr();
    column = at.getColumnNr();
    start = (int) at.getByteOffset();
    text = kind == Kind.STRING || kind == Kind.NUMBER ? p.getText() : "";
    number = kind == Kind.NUMBER ? p.getDoubleValue() : 0;
    truth = p.currentToken() == JsonToken.VALUE_TRUE;
    items = kind == Kind.ARRAY ? new ArrayList<>(2) : List.of();
    fields = kind == Kind.OBJECT ? new LinkedHashMap<>(4) : Map.of();
  }

  /**
   * Reads a whole document that people wrote.
   *
   * @throws JsonException if it is no JSON, beyond a limit, or has characters that can't be shown
   */
  public static Json parse(byte[] bytes) throws JsonException {
    return parse(bytes, FACTORY, true);
  }

  /**
   * Reads a whole document that a program made, whose texts may have characters that can't be
   * shown: clean them before people see them.
   *
   * @throws JsonException if it is no JSON, or beyond a limit
   */
  public static Json parseMachineMade(byte[] bytes) throws JsonException {
    return parse(bytes, FACTORY, false);
  }

  /**
   * Reads a document as {@link #parseMachineMade(byte[])}, with longer texts, such as packed data.
   *
   * @param maxText most characters of a text
   * @throws JsonException if it is no JSON, or beyond a limit
   */
  public static Json parseMachineMade(byte[] bytes, int maxText) throws JsonException {
    return parse(bytes, factory(maxText), false);
  }

  private static JsonFactory factory(int maxText) {
    return JsonFactory.builder()
        .streamReadConstraints(
            StreamReadConstraints.builder()
                .maxNestingDepth(MAX_DEPTH)
                .maxNumberLength(64)
                .maxStringLength(maxText)
                .maxNameLength(256)
                .build())
        .build();
  }

  private static Json parse(byte[] bytes, JsonFactory factory, boolean visible)
      throws JsonException {
    try (JsonParser p = factory.createParser(bytes)) {
      if (p.nextToken() == null) {
        throw new JsonException(1, 1, "", "the file is empty; it must be a JSON object");
      }
      Json root = new Reader(p, visible).read(null, "", -1);
      if (p.nextToken() != null) {
        JsonLocation at = p.currentTokenLocation();
        throw new JsonException(
            at.getLineNr(), at.getColumnNr(), "", "nothing may follow the closing brace");
      }
      return root;
    } catch (JsonProcessingException e) {
      JsonLocation at = e.getLocation();
      int line = at == null ? 0 : at.getLineNr();
      int column = at == null ? 0 : at.getColumnNr();
      throw new JsonException(
          line, column, "", "not JSON: " + Texts.clean(withoutContent(e.getOriginalMessage())));
    } catch (IOException e) {
      throw new JsonException(0, 0, "", "not JSON: " + e.getMessage());
    }
  }

  /**
   * Returns Jackson's message if it tells no more of the document than one character, or else what
   * a document is made of: somebody may have named a file whose content is secret.
   */
  private static String withoutContent(String message) {
    int source = message.indexOf(" (start marker at ["); // Jackson names no file there
    String text = source < 0 ? message : message.substring(0, source);
    boolean harmless =
        text.startsWith("Unexpected character (")
            || text.startsWith("Unexpected end-of-input")
            || text.startsWith("Illegal unquoted character")
            || text.startsWith("Document nesting depth");
    if (text.contains("surrogate")) {
      return "an invisible character, half of a surrogate pair";
    }
    return harmless
        ? text
        : "this is no object, list, number, text in double quotes, true, false or null";
  }

  /** Turns the tokens of one document into nodes. */
  private static final class Reader {
    private final JsonParser tokens;
    private final boolean visible;
    private int nodes;

    Reader(JsonParser tokens, boolean visible) {
      this.tokens = tokens;
      this.visible = visible;
    }

    /** Reads the node of the present token. */
    Json read(Json parent, String name, int index) throws IOException, JsonException {
      Json node = new Json(kind(tokens.currentToken()), parent, name, index, tokens);
      if (++nodes > MAX_NODES) {
        throw new JsonException(
            node.line, node.column, "", "the file has more than " + MAX_NODES + " values");
      }
      if (node.kind == Kind.STRING) {
        requireVisible(node.text, node);
      }
      if (node.kind == Kind.OBJECT) {
        readFields(node);
      } else if (node.kind == Kind.ARRAY) {
        while (tokens.nextToken() != JsonToken.END_ARRAY) {
          node.items.add(read(node, "", node.items.size()));
        }
      }
      node.end = (int) tokens.currentLocation().getByteOffset();
      return node;
    }

    private void readFields(Json object) throws IOException, JsonException {
      while (tokens.nextToken() != JsonToken.END_OBJECT) {
        JsonLocation at = tokens.currentTokenLocation();
        String name = tokens.currentName();
        requireVisible(name, object);
        tokens.nextToken();
        Json field = read(object, name, -1);
        if (object.fields.put(name, field) != null) {
          throw new JsonException(
              at.getLineNr(), at.getColumnNr(), field.path(), " stands here a second time");
        }
      }
    }

    /** Refuses a text that would change how a terminal or a screen shows its neighbours. */
    private void requireVisible(String text, Json node) throws JsonException {
      String clean = Texts.clean(text);
      if (visible && !clean.equals(text)) {
        throw new JsonException(
            node.line, node.column, node.path(), " has an invisible character; remove it");
      }
    }

    private static Kind kind(JsonToken token) {
      return switch (token) {
        case START_OBJECT -> Kind.OBJECT;
        case START_ARRAY -> Kind.ARRAY;
        case VALUE_STRING -> Kind.STRING;
        case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> Kind.NUMBER;
        case VALUE_TRUE, VALUE_FALSE -> Kind.BOOLEAN;
        default -> Kind.NULL;
      };
    }
  }

  /** Returns the offset behind the last byte in the document. */
  public int end() {
    return end;
  }

  /** Returns the way from the root, such as {@code bodies[3].at}; empty for the root. Allocates. */
  public String path() {
    if (parent == null) {
      return "";
    }
    String before = parent.path();
    if (index >= 0) {
      return before + "[" + index + "]";
    }
    return before.isEmpty() ? name : before + "." + name;
  }

  /** Returns the value as an error message shows it, shortened. */
  public String shown() {
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
