package carom.client.desktop.game;

import carom.client.look.LookFiles;
import carom.text.FileErrors;
import com.badlogic.gdx.graphics.Pixmap;
import com.badlogic.gdx.graphics.Texture;
import com.badlogic.gdx.graphics.Texture.TextureFilter;
import com.badlogic.gdx.graphics.Texture.TextureWrap;
import com.badlogic.gdx.utils.Disposable;
import com.badlogic.gdx.utils.GdxRuntimeException;
import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The pictures of a game's look, each read once. One that is missing or can't be read is told once;
 * what it should show keeps the usual look. Render thread only.
 */
final class LookPictures implements Disposable {
  /** Longest side of a picture, px: what each graphics card takes. */
  static final int MAX_SIDE = 4_096;

  /** Largest file, bytes. */
  static final int MAX_BYTES = 16 << 20;

  private static final int DOT_PX = 64;
  private static final Logger LOG = LoggerFactory.getLogger(LookPictures.class);

  private final Map<String, Texture> read = new HashMap<>();
  private final Map<String, Texture> silhouettes = new HashMap<>();
  private final Consumer<String> player;
  private Class<?> home;
  private Texture dot;

  LookPictures(Consumer<String> player) {
    this.player = player;
  }

  /** Forgets all pictures; the next ones are beside another class. */
  void home(Class<?> newHome) {
    read.values().forEach(picture -> dispose(picture));
    read.clear();
    silhouettes.values().forEach(picture -> dispose(picture));
    silhouettes.clear();
    home = newHome;
  }

  private static void dispose(Texture picture) {
    if (picture != null) {
      picture.dispose();
    }
  }

  /** Returns a picture, or null if it can't be read. */
  Texture of(String file) {
    if (!read.containsKey(file)) {
      read.put(file, load(file, false));
    }
    return read.get(file);
  }

  /** Returns a picture whose colours are all white, or null if it can't be read. */
  Texture silhouette(String file) {
    if (!silhouettes.containsKey(file)) {
      silhouettes.put(file, of(file) == null ? null : load(file, true));
    }
    return silhouettes.get(file);
  }

  private static Pixmap whitened(Pixmap pixels) {
    Pixmap white = new Pixmap(pixels.getWidth(), pixels.getHeight(), Pixmap.Format.RGBA8888);
    white.setBlending(Pixmap.Blending.None);
    for (int y = 0; y < pixels.getHeight(); y++) {
      for (int x = 0; x < pixels.getWidth(); x++) {
        white.drawPixel(x, y, 0xffffff00 | (pixels.getPixel(x, y) & 0xff));
      }
    }
    pixels.dispose();
    return white;
  }

  private Texture load(String file, boolean white) {
    try {
      byte[] bytes = LookFiles.read(home, file, MAX_BYTES);
      Pixmap coloured = new Pixmap(bytes, 0, bytes.length);
      Pixmap pixels = white ? whitened(coloured) : coloured;
      try {
        return texture(pixels);
      } finally {
        pixels.dispose();
      }
    } catch (IOException e) {
      LOG.error("the picture {} of {} can't be read: {}", file, home, FileErrors.reason(e));
    } catch (GdxRuntimeException | IllegalArgumentException e) {
      LOG.error("the picture {} of {} can't be used", file, home, e);
    }
    player.accept("A picture of the game's look can't be shown: " + file);
    return null;
  }

  private static Texture texture(Pixmap pixels) {
    if (pixels.getWidth() > MAX_SIDE || pixels.getHeight() > MAX_SIDE) {
      throw new IllegalArgumentException(
          pixels.getWidth() + " x " + pixels.getHeight() + " px, at most " + MAX_SIDE);
    }
    Texture texture = new Texture(pixels, true);
    texture.setFilter(TextureFilter.MipMapLinearLinear, TextureFilter.Linear);
    texture.setWrap(TextureWrap.Repeat, TextureWrap.Repeat);
    return texture;
  }

  /** Returns a soft white dot. */
  Texture dot() {
    if (dot == null) {
      Pixmap pixels = new Pixmap(DOT_PX, DOT_PX, Pixmap.Format.RGBA8888);
      pixels.setBlending(Pixmap.Blending.None);
      for (int y = 0; y < DOT_PX; y++) {
        for (int x = 0; x < DOT_PX; x++) {
          double away = Math.hypot(x + 0.5 - DOT_PX / 2.0, y + 0.5 - DOT_PX / 2.0) / (DOT_PX / 2.0);
          double left = Math.max(0, 1 - away);
          pixels.drawPixel(x, y, 0xffffff00 | (int) Math.round(255 * left * left * (3 - 2 * left)));
        }
      }
      dot = texture(pixels);
      pixels.dispose();
    }
    return dot;
  }

  @Override
  public void dispose() {
    home(null);
    dispose(dot);
  }
}
