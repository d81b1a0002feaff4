package carom.server.thin.web;

import carom.game.GameJars;
import carom.server.http.SiteFiles;
import io.undertow.server.HttpServerExchange;
import io.undertow.util.StatusCodes;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.regex.Pattern;

/**
 * The looks of games as data, which jars bring as {@code carom/looks/GAME}, see {@code carom look}.
 * No code of a view is loaded. Any thread.
 */
final class LookSite {
  /** A game's name and a file's, neither of which leads to another folder. */
  private static final Pattern PATH =
      Pattern.compile("[A-Za-z0-9][A-Za-z0-9._ -]{0,63}/[A-Za-z0-9][A-Za-z0-9._-]{0,99}");

  /** Most bytes that are kept in memory; further files are read from their jars each time. */
  private static final long MAX_KEPT_BYTES = 64 << 20;

  private final Map<String, ByteBuffer> kept = new ConcurrentHashMap<>();
  private final AtomicLong keptBytes = new AtomicLong();
  private volatile ClassLoader loader = GameJars.loader();

  LookSite() {}

  /**
   * Sends the file of a path such as {@code cars/look.json}; returns false if there is none. A game
   * without a look has an empty answer.
   */
  boolean send(HttpServerExchange exchange, String path) {
    String type = SiteFiles.typeOf(path);
    if (type == null || !PATH.matcher(path).matches()) {
      return false;
    }
    if (loader != GameJars.loader()) { // other jars
      loader = GameJars.loader();
      kept.clear();
      keptBytes.set(0);
    }
    ByteBuffer bytes = kept.get(path);
    if (bytes == null) {
      bytes = read(path);
      if (bytes == null && path.endsWith("/look.json")) { // most games have none: no error
        exchange.setStatusCode(StatusCodes.NO_CONTENT);
        exchange.endExchange();
        return true;
      }
      if (bytes == null) {
        return false;
      }
      if (keptBytes.addAndGet(bytes.remaining()) <= MAX_KEPT_BYTES) {
        kept.put(path, bytes);
      }
    }
    SiteFiles.send(exchange, type, bytes);
    return true;
  }

  private ByteBuffer read(String path) {
    try (InputStream in = loader.getResourceAsStream(GameJars.LOOKS + path)) {
      byte[] bytes = in == null ? null : in.readNBytes(GameJars.MAX_LOOK_BYTES + 1);
      return bytes == null || bytes.length > GameJars.MAX_LOOK_BYTES
          ? null
          : ByteBuffer.wrap(bytes).asReadOnlyBuffer();
    } catch (IOException e) {
      throw new UncheckedIOException(GameJars.LOOKS + path + " can't be read", e);
    }
  }
}
