package carom.client.desktop.paint;

import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.graphics.Texture.TextureFilter;
import com.badlogic.gdx.graphics.g2d.BitmapFont;
import com.badlogic.gdx.graphics.g2d.freetype.FreeTypeFontGenerator;
import com.badlogic.gdx.graphics.g2d.freetype.FreeTypeFontGenerator.FreeTypeFontParameter;
import com.badlogic.gdx.utils.Disposable;

/**
 * The typeface in the sizes that the screens use. Glyphs are rasterised on first use, so that names
 * may use all glyphs of the typeface. Render thread only.
 */
public final class Fonts implements Disposable {
  private final FreeTypeFontGenerator medium;
  private final FreeTypeFontGenerator bold;

  /** Font of 13 px, for the net graph and hints. */
  public final BitmapFont small;

  /** Font of 16 px, for names, lists and input fields. */
  public final BitmapFont text;

  /** Bold font of 24 px, for scores and notices. */
  public final BitmapFont large;

  /** Bold font of 64 px, for the title. */
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
