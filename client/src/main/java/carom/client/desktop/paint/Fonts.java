package carom.client.desktop.paint;

import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.graphics.Texture.TextureFilter;
import com.badlogic.gdx.graphics.g2d.BitmapFont;
import com.badlogic.gdx.graphics.g2d.freetype.FreeTypeFontGenerator;
import com.badlogic.gdx.graphics.g2d.freetype.FreeTypeFontGenerator.FreeTypeFontParameter;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.utils.Disposable;

/**
 * The typeface in the sizes that the screens use, and how large text and panels are. Sizes are in
 * points: a point is a pixel in a window of 1280 x 720, and grows with the window and with the text
 * size that the player chose. Glyphs are rasterised at their real size, on first use, so that names
 * may use all glyphs of the typeface. Render thread only.
 */
public final class Fonts implements Disposable {
  private static final float WIDTH = 1_280;
  private static final float HEIGHT = 720;

  /** Steps of the scale in a unit, so that dragging the window's edge seldom makes new glyphs. */
  private static final int STEPS = 8;

  private static final float SMALLEST = 0.75f;
  private static final float LARGEST = 4;

  private final FreeTypeFontGenerator medium;
  private final FreeTypeFontGenerator bold;
  private float textSize;
  private float scale = 1;
  private BitmapFont small;
  private BitmapFont text;
  private BitmapFont large;
  private BitmapFont title;

  /**
   * Loads the typeface. Needs the toolkit to run.
   *
   * @param textSize size that the player chose, 1 = as designed
   */
  public Fonts(float textSize) {
    this.textSize = textSize;
    medium = new FreeTypeFontGenerator(Gdx.files.classpath("fonts/Roboto-Medium.ttf"));
    bold = new FreeTypeFontGenerator(Gdx.files.classpath("fonts/Roboto-Bold.ttf"));
    make();
  }

  /** Sets the size that the player chose, 1 = as designed; {@link #fit} applies it. */
  public void textSize(float size) {
    textSize = size;
  }

  /**
   * Fits the scale to a window's size, px. When the scale changes, the fonts are new objects.
   *
   * @return whether the scale has changed
   */
  public boolean fit(int width, int height) {
    float fitted = scale(width, height, textSize);
    if (fitted == scale) {
      return false;
    }
    scale = fitted;
    disposeFonts();
    make();
    return true;
  }

  /** Returns the pixels of a point in a window of a size, px. */
  static float scale(int width, int height, float textSize) {
    float window = Math.min(width / WIDTH, height / HEIGHT);
    float steps = Math.round(STEPS * window * textSize);
    return MathUtils.clamp(steps / STEPS, SMALLEST, LARGEST);
  }

  /** Returns the pixels of a point. */
  public float scale() {
    return scale;
  }

  /** Returns the font of 13 points, for the net graph and hints. */
  public BitmapFont small() {
    return small;
  }

  /** Returns the font of 16 points, for names, lists and input fields. */
  public BitmapFont text() {
    return text;
  }

  /** Returns the bold font of 24 points, for scores and notices. */
  public BitmapFont large() {
    return large;
  }

  /** Returns the bold font of 64 points, for the title. */
  public BitmapFont title() {
    return title;
  }

  private void make() {
    small = make(medium, 13);
    text = make(medium, 16);
    large = make(bold, 24);
    title = make(bold, 64);
  }

  private BitmapFont make(FreeTypeFontGenerator generator, int points) {
    FreeTypeFontParameter p = new FreeTypeFontParameter();
    p.size = Math.round(points * scale);
    p.incremental = true;
    p.minFilter = TextureFilter.Linear;
    p.magFilter = TextureFilter.Linear;
    BitmapFont font = generator.generateFont(p);
    font.getData().markupEnabled = false; // names are data
    font.getData().setScale(1 / scale);
    font.setUseIntegerPositions(scale == 1);
    return font;
  }

  private void disposeFonts() {
    for (BitmapFont font : new BitmapFont[] {small, text, large, title}) {
      font.dispose();
    }
  }

  @Override
  public void dispose() {
    disposeFonts();
    medium.dispose();
    bold.dispose();
  }
}
