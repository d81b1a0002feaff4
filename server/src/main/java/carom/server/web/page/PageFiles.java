package carom.server.web.page;

import io.undertow.server.HttpServerExchange;
import io.undertow.util.Headers;
import io.undertow.util.HttpString;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.Map;

/** The files of the page, which come along with the program and load nothing from elsewhere. */
final class PageFiles {
  private static final Map<String, String> TYPES =
      Map.of(
          "index.html", "text/html; charset=utf-8",
          "page.css", "text/css; charset=utf-8",
          "app.js", "text/javascript; charset=utf-8",
          "scene.js", "text/javascript; charset=utf-8",
          "charts.js", "text/javascript; charset=utf-8",
          "icon.svg", "image/svg+xml");

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

  private final Map<String, ByteBuffer> files = new HashMap<>();

  PageFiles() {
    for (String name : TYPES.keySet()) {
      try (InputStream in = PageFiles.class.getResourceAsStream(name)) {
        files.put(name, ByteBuffer.wrap(in.readAllBytes()).asReadOnlyBuffer());
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }

  /** Adds the headers that protect the page to an answer. */
  static void protect(HttpServerExchange exchange) {
    HEADERS.forEach(
        (name, value) -> exchange.getResponseHeaders().put(new HttpString(name), value));
  }

  /** Sends the file of a path and returns true, or returns false if there is none. */
  boolean send(HttpServerExchange exchange) {
    String path = exchange.getRequestPath();
    String name = path.equals("/") ? "index.html" : path.substring(1);
    ByteBuffer file = files.get(name);
    if (file == null) {
      return false;
    }
    protect(exchange);
    exchange.getResponseHeaders().put(Headers.CONTENT_TYPE, TYPES.get(name));
    exchange.getResponseSender().send(file.duplicate());
    return true;
  }
}
