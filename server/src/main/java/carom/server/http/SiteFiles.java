package carom.server.http;

import io.undertow.server.HttpServerExchange;
import io.undertow.util.Headers;
import io.undertow.util.HttpString;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The files of a page, which come along with the program as resources of a class and load nothing
 * from elsewhere. Immutable.
 */
public final class SiteFiles {
  private static final Map<String, String> TYPES =
      Map.of(
          ".html", "text/html; charset=utf-8",
          ".css", "text/css; charset=utf-8",
          ".js", "text/javascript; charset=utf-8",
          ".json", "application/json",
          ".svg", "image/svg+xml",
          ".png", "image/png",
          ".jpg", "image/jpeg",
          ".jpeg", "image/jpeg",
          ".wav", "audio/wav",
          ".ogg", "audio/ogg");

  /** Headers that limit what browsers may do with the answers to what the page itself needs. */
  private static final Map<String, String> HEADERS =
      Map.of(
          "Content-Security-Policy",
          "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self';"
              + " connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
          "X-Content-Type-Options",
          "nosniff",
          "Referrer-Policy",
          "no-referrer",
          "Cross-Origin-Opener-Policy",
          "same-origin",
          "Cross-Origin-Resource-Policy",
          "same-origin",
          "Cache-Control",
          "no-cache");

  /** A file and its type. */
  private record SiteFile(String type, ByteBuffer bytes) {}

  private final Map<String, SiteFile> files = new HashMap<>();

  /**
   * Reads the files.
   *
   * @param place they are resources beside this class
   * @param paths of the files from there, or from {@code /}; the last part of a path is the file's
   *     name, and its end, such as {@code .js}, tells its type
   * @throws IllegalArgumentException if a file is missing or the end of its name isn't known
   */
  public SiteFiles(Class<?> place, List<String> paths) {
    for (String path : paths) {
      String name = path.substring(path.lastIndexOf('/') + 1);
      String type = typeOf(name);
      try (InputStream in = place.getResourceAsStream(path)) {
        if (type == null || in == null) {
          throw new IllegalArgumentException("path=" + path + " is no file of " + place);
        }
        files.put(name, new SiteFile(type, ByteBuffer.wrap(in.readAllBytes()).asReadOnlyBuffer()));
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }

  /** Returns the type of a file by the end of its name; null for an end that pages don't have. */
  public static String typeOf(String name) {
    return TYPES.get(name.substring(Math.max(0, name.lastIndexOf('.'))));
  }

  /** Adds the headers that protect the page to an answer. */
  public static void protect(HttpServerExchange exchange) {
    HEADERS.forEach(
        (name, value) -> exchange.getResponseHeaders().put(new HttpString(name), value));
  }

  /** Sends the file of a name and returns true, or returns false if there is none. */
  public boolean send(HttpServerExchange exchange, String name) {
    SiteFile file = files.get(name);
    if (file == null) {
      return false;
    }
    send(exchange, file.type, file.bytes);
    return true;
  }

  /** Answers with a file. */
  public static void send(HttpServerExchange exchange, String type, ByteBuffer bytes) {
    protect(exchange);
    exchange.getResponseHeaders().put(Headers.CONTENT_TYPE, type);
    exchange.getResponseSender().send(bytes.duplicate());
  }
}
