package carom.client.desktop;

import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.graphics.Pixmap;
import com.badlogic.gdx.graphics.PixmapIO;
import java.nio.file.Path;

/** Writes what the window shows to files. Render thread only. */
final class Pictures {
  private Pictures() {}

  /** Writes what the window shows to a PNG file. */
  static void save(String file) {
    Pixmap picture =
        Pixmap.createFromFrameBuffer(
            0, 0, Gdx.graphics.getBackBufferWidth(), Gdx.graphics.getBackBufferHeight());
    Pixmap opaque = new Pixmap(picture.getWidth(), picture.getHeight(), Pixmap.Format.RGB888);
    opaque.setBlending(
        Pixmap.Blending.None); // panels are seen through in the window, not in a file
    opaque.drawPixmap(picture, 0, 0);
    PixmapIO.writePNG(
        Gdx.files.absolute(Path.of(file).toAbsolutePath().toString()), opaque, 6, true);
    opaque.dispose();
    picture.dispose();
    System.err.println("screenshot saved: " + file);
  }
}
