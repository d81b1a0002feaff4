package carom.client.desktop.game;

import carom.client.desktop.hud.Hud;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.UiColours;
import carom.client.desktop.paint.ViewCamera;
import carom.client.look.HudCanvas;
import carom.client.look.HudPainter;
import carom.client.view.ClientView;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.Texture;
import com.badlogic.gdx.graphics.g2d.BitmapFont;
import com.badlogic.gdx.graphics.g2d.TextureRegion;

/**
 * Lets the painter of a game's look draw over the picture. Figures and texts need batches of their
 * own, so it begins the one that is needed and ends the other. Render thread only.
 */
final class LookCanvas implements HudCanvas {
  private enum Batch {
    NONE,
    FIGURES,
    TEXTS
  }

  private final ShownLook look;
  private final LookPictures pictures;
  private final Hud hud;
  private final Canvas canvas;
  private final Fonts fonts;
  private final TextureRegion region = new TextureRegion();
  private final Color color = new Color();
  private ViewCamera camera;
  private Batch batch = Batch.NONE;

  LookCanvas(ShownLook look, LookPictures pictures, Hud hud, Canvas canvas, Fonts fonts) {
    this.look = look;
    this.pictures = pictures;
    this.hud = hud;
    this.canvas = canvas;
    this.fonts = fonts;
  }

  /** Lets the look's painter draw, if it has one. */
  public void draw(ClientView view, ViewCamera newCamera) {
    HudPainter painter = look.setup().painter();
    if (painter == null) {
      return;
    }
    camera = newCamera;
    batch = Batch.NONE; // the one of a picture that failed was abandoned
    painter.paint(this, view);
    use(Batch.NONE);
  }

  private void use(Batch needed) {
    if (batch == needed) {
      return;
    }
    if (batch == Batch.FIGURES) {
      canvas.end();
    } else if (batch == Batch.TEXTS) {
      hud.end();
    }
    batch = needed;
    if (batch == Batch.FIGURES) {
      hud.beginFigures();
    } else if (batch == Batch.TEXTS) {
      hud.begin();
    }
  }

  private Color figure(int rgb, float alpha) {
    use(Batch.FIGURES);
    return UiColours.shade(rgb, 1, Math.max(0, Math.min(1, alpha)), color);
  }

  @Override
  public float width() {
    return hud.windowWidth();
  }

  @Override
  public float height() {
    return hud.height();
  }

  @Override
  public float screenX(float x, float y) {
    return hud.at(camera, x, y).x;
  }

  @Override
  public float screenY(float x, float y) {
    return hud.at(camera, x, y).y;
  }

  @Override
  public void rect(float x, float y, float w, float h, int rgb, float alpha) {
    canvas.rect(x, y, w, h, figure(rgb, alpha));
  }

  @Override
  public void disc(float x, float y, float radius, int rgb, float alpha) {
    canvas.disc(x, y, radius, figure(rgb, alpha));
  }

  @Override
  public void line(float x1, float y1, float x2, float y2, float width, int rgb, float alpha) {
    canvas.line(x1, y1, x2, y2, width, figure(rgb, alpha));
  }

  @Override
  public void text(String text, float x, float y, int rgb) {
    write(fonts.text(), text, x, y, rgb);
  }

  @Override
  public void title(String text, float x, float y, int rgb) {
    write(fonts.title(), text, x, y, rgb);
  }

  private void write(BitmapFont font, String text, float x, float y, int rgb) {
    use(Batch.TEXTS);
    hud.shadowed(font, text, x, y, UiColours.shade(rgb, 1, 1, color));
  }

  @Override
  public float textWidth(String text) {
    return hud.width(fonts.text(), text);
  }

  @Override
  public float titleWidth(String text) {
    return hud.width(fonts.title(), text);
  }

  @Override
  public void picture(String file, float x, float y, float w, float h) {
    Texture texture = pictures.of(file);
    if (texture != null) {
      use(Batch.TEXTS);
      region.setRegion(texture);
      hud.picture(region, x, y, w, h);
    }
  }
}
