package carom.server.directory;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * A node of an answer of etcd. What is missing is empty, 0 or false, as etcd leaves such fields
 * out. Whole numbers of 64 bits come as texts. Immutable.
 */
final class EtcdJson {
  /** Longest text of an answer: a value in base 64, with room for what others put there. */
  private static final int MAX_TEXT = 4 << 20;

  private static final JsonFactory FACTORY =
      JsonFactory.builder()
          .streamReadConstraints(
              StreamReadConstraints.builder()
                  .maxNestingDepth(16)
                  .maxNumberLength(32)
                  .maxStringLength(MAX_TEXT)
                  .maxNameLength(256)
                  .build())
          .build();

  private static final EtcdJson NOTHING = new EtcdJson("", Map.of(), List.of());

  private final String text;
  private final Map<String, EtcdJson> fields;
  private final List<EtcdJson> items;

  private EtcdJson(String text, Map<String, EtcdJson> fields, List<EtcdJson> items) {
    this.text = text;
    this.fields = fields;
    this.items = items;
  }

  /**
   * Reads an answer.
   *
   * @throws IOException if it is no JSON, or beyond a limit
   */
  static EtcdJson parse(byte[] bytes) throws IOException {
    try (JsonParser p = FACTORY.createParser(bytes)) {
      if (p.nextToken() == null) {
        throw new IOException("the answer is empty");
      }
      return read(p);
    }
  }

  private static EtcdJson read(JsonParser p) throws IOException {
    if (p.currentToken() == JsonToken.START_OBJECT) {
      Map<String, EtcdJson> fields = new LinkedHashMap<>(8);
      for (String name = p.nextFieldName(); name != null; name = p.nextFieldName()) {
        p.nextToken();
        fields.put(name, read(p));
      }
      return new EtcdJson("", fields, List.of());
    }
    if (p.currentToken() == JsonToken.START_ARRAY) {
      List<EtcdJson> items = new ArrayList<>();
      while (p.nextToken() != JsonToken.END_ARRAY) {
        items.add(read(p));
      }
      return new EtcdJson("", Map.of(), items);
    }
    return new EtcdJson(p.getText(), Map.of(), List.of());
  }

  /** Returns whether an object has a field. */
  boolean has(String name) {
    return fields.containsKey(name);
  }

  /** Returns a field of an object. */
  EtcdJson get(String name) {
    return fields.getOrDefault(name, NOTHING);
  }

  /** Returns the items of a list. */
  List<EtcdJson> items() {
    return items;
  }

  /** Returns a text. */
  String text() {
    return text;
  }

  /** Returns whether it is true. */
  boolean isTrue() {
    return text.equals("true");
  }

  /**
   * Returns a whole number.
   *
   * @throws IOException if it is none
   */
  long number() throws IOException {
    try {
      return text.isEmpty() ? 0 : Long.parseLong(text);
    } catch (NumberFormatException e) {
      throw new IOException("the answer has no number where one belongs", e);
    }
  }

  /**
   * Returns the text that is encoded in base 64.
   *
   * @throws IOException if it isn't
   */
  String decoded() throws IOException {
    try {
      return new String(Base64.getDecoder().decode(text), UTF_8);
    } catch (IllegalArgumentException e) {
      throw new IOException("the answer isn't base 64 where it should be", e);
    }
  }

  /** Returns a text as a field of a request has it. */
  static String encode(String text) {
    return encode(text.getBytes(UTF_8));
  }

  /** Returns bytes as a field of a request has them. */
  static String encode(byte[] bytes) {
    return '"' + Base64.getEncoder().encodeToString(bytes) + '"';
  }
}
