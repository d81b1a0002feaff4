package carom.client.desktop;

import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.graphics.Pixmap;
import com.badlogic.gdx.graphics.PixmapIO;
import java.nio.file.Path;

/** Writes what the window shows to files. Render thread only. */
final class Pictures {
  private Pictures() {}

  /** Writes what the window shows to a PNG file, and says so. */
  static void save(String file) {
    save(file, Gdx.graphics.getBackBufferWidth(), Gdx.graphics.getBackBufferHeight());
    System.err.println("screenshot saved: " + file);
  }

  /** Writes what is drawn to a PNG file, from the lower left corner on, px. */
  static void save(String file, int width, int height) {
    Pixmap picture = Pixmap.createFromFrameBuffer(0, 0, width, height);
    Pixmap opaque = new Pixmap(width, height, Pixmap.Format.RGB888);
    opaque.setBlending(
        Pixmap.Blending.None); // panels are seen through in the window, not in a file
    opaque.drawPixmap(picture, 0, 0);
    PixmapIO.writePNG(
        Gdx.files.absolute(Path.of(file).toAbsolutePath().toString()), opaque, 6, true);
    opaque.dispose();
    picture.dispose();
  }
}
