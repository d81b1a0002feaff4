package carom.client.desktop.paint;

import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.graphics.Texture.TextureFilter;
import com.badlogic.gdx.graphics.g2d.BitmapFont;
import com.badlogic.gdx.graphics.g2d.freetype.FreeTypeFontGenerator;
import com.badlogic.gdx.graphics.g2d.freetype.FreeTypeFontGenerator.FreeTypeFontParameter;
import com.badlogic.gdx.utils.Disposable;

/**
 * The typeface in the sizes the screens use. Glyphs are rasterised on first use, so that a player
 * may be called anything the typeface has. Render thread only.
 */
public final class Fonts implements Disposable {
  private final FreeTypeFontGenerator medium;
  private final FreeTypeFontGenerator bold;

  /** 13 px: net graph, hints. */
  public final BitmapFont small;

  /** 16 px: names, lists, input fields. */
  public final BitmapFont text;

  /** 24 px bold: scores, notices. */
  public final BitmapFont large;

  /** 64 px bold: the title. */
  public final BitmapFont title;

  /** Loads the typeface. Needs the toolkit to run. */
  public Fonts() {
    medium = new FreeTypeFontGenerator(Gdx.files.classpath("fonts/Roboto-Medium.ttf"));
    bold = new FreeTypeFontGenerator(Gdx.files.classpath("fonts/Roboto-Bold.ttf"));
    small = make(medium, 13);
    text = make(medium, 16);
    large = make(bold, 24);
    title = make(bold, 64);
  }

  private static BitmapFont make(FreeTypeFontGenerator generator, int sizePx) {
    FreeTypeFontParameter p = new FreeTypeFontParameter();
    p.size = sizePx;
    p.incremental = true;
    p.minFilter = TextureFilter.Linear;
    p.magFilter = TextureFilter.Linear;
    BitmapFont font = generator.generateFont(p);
    font.getData().markupEnabled = false; // names are data
    return font;
  }

  @Override
  public void dispose() {
    for (BitmapFont font : new BitmapFont[] {small, text, large, title}) {
      font.dispose();
    }
    medium.dispose();
    bold.dispose();
  }
}
