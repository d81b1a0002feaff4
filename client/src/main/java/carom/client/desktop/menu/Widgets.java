package carom.client.desktop.menu;

import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.UiColours;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.Pixmap;
import com.badlogic.gdx.graphics.Texture;
import com.badlogic.gdx.graphics.g2d.BitmapFont;
import com.badlogic.gdx.graphics.g2d.NinePatch;
import com.badlogic.gdx.graphics.g2d.TextureRegion;
import com.badlogic.gdx.scenes.scene2d.Actor;
import com.badlogic.gdx.scenes.scene2d.ui.Image;
import com.badlogic.gdx.scenes.scene2d.ui.Label;
import com.badlogic.gdx.scenes.scene2d.ui.ScrollPane;
import com.badlogic.gdx.scenes.scene2d.ui.Table;
import com.badlogic.gdx.scenes.scene2d.ui.TextButton;
import com.badlogic.gdx.scenes.scene2d.ui.TextField;
import com.badlogic.gdx.scenes.scene2d.utils.ChangeListener;
import com.badlogic.gdx.scenes.scene2d.utils.Drawable;
import com.badlogic.gdx.scenes.scene2d.utils.NinePatchDrawable;
import com.badlogic.gdx.scenes.scene2d.utils.TextureRegionDrawable;
import com.badlogic.gdx.utils.Align;
import com.badlogic.gdx.utils.Array;
import com.badlogic.gdx.utils.Disposable;
import com.badlogic.gdx.utils.Scaling;

/**
 * Makes the parts of a menu: labels, buttons, fields, panels. A button's action is its user object,
 * so that a key can run it. The parts hold fonts, so they are made anew when the {@link Fonts}
 * change. Render thread only.
 */
public final class Widgets implements Disposable {
  /** Height of a field or button. */
  public static final float HEIGHT = 36;

  private static final float BAR_GAP = 12;

  /** Height of a card's picture. */
  private static final float CARD_PICTURE = 96;

  private final Fonts fonts;
  private final Array<Disposable> owned = new Array<>();
  private final Drawable panel;
  private final Drawable plain;
  private final Drawable over;
  private final Drawable focused;
  private final Drawable accent;
  private final Drawable accentOver;
  private final Drawable accentFocused;
  private final Drawable field;
  private final Drawable fieldFocused;
  private final Drawable selection;
  private final Drawable bar;
  private final Drawable caret;
  private final Drawable white;

  /** Creates the drawables. The fonts stay the property of the caller. */
  public Widgets(Fonts fonts) {
    this.fonts = fonts;
    panel = box(UiColours.DIALOG, UiColours.PANEL_LINE);
    plain = box(UiColours.rgb(0x1b2534), UiColours.PANEL_LINE);
    over = box(UiColours.rgb(0x223047), UiColours.PANEL_LINE);
    focused = box(UiColours.rgb(0x26354b), UiColours.ACCENT);
    accent = box(UiColours.ACCENT, UiColours.ACCENT);
    accentOver = box(UiColours.rgb(0xffc266), UiColours.ACCENT);
    accentFocused = box(UiColours.rgb(0xffd08a), UiColours.TEXT);
    field = box(UiColours.rgb(0x141b27), UiColours.PANEL_LINE);
    fieldFocused = box(UiColours.rgb(0x182234), UiColours.ACCENT);
    selection = box(UiColours.rgb(0x2f4d78), UiColours.rgb(0x2f4d78));
    bar = box(UiColours.PANEL_LINE, UiColours.PANEL_LINE);
    caret = line(UiColours.ACCENT);
    white = box(Color.WHITE, Color.WHITE);
  }

  /** Returns how many pixels a point has. */
  public float scale() {
    return fonts.scale();
  }

  /** Returns a line of text. */
  public Label label(String text) {
    return label(text, fonts.text(), UiColours.TEXT);
  }

  /** Returns a line of text that steps back. */
  public Label muted(String text) {
    return label(text, fonts.text(), UiColours.MUTED);
  }

  /** Returns a line of small text that steps back. */
  public Label small(String text) {
    return label(text, fonts.small(), UiColours.MUTED);
  }

  /** Returns small text that steps back and is broken into lines. */
  public Label note(String text) {
    Label label = small(text);
    label.setWrap(true);
    return label;
  }

  /** Returns a line of text that may be marked as the player's own. */
  Label mark(String text, boolean own) {
    return label(text, fonts.text(), own ? UiColours.ACCENT : UiColours.TEXT);
  }

  /** Returns a heading. */
  public Label heading(String text) {
    return label(text, fonts.large(), UiColours.TEXT);
  }

  /** Returns the largest text. */
  Label title(String text) {
    return label(text, fonts.title(), UiColours.TEXT);
  }

  /** Returns a text of several lines that says what is wrong. */
  public Label problem(String text) {
    Label label = label(text, fonts.text(), UiColours.BAD);
    label.setWrap(true);
    return label;
  }

  private static Label label(String text, BitmapFont font, Color color) {
    return new Label(text, new Label.LabelStyle(font, color));
  }

  /** Returns a button. */
  public TextButton button(String text, Runnable action) {
    return button(text, fonts.text(), UiColours.TEXT, plain, over, focused, action);
  }

  /** Returns the button that a page is there for. */
  public TextButton primary(String text, Runnable action) {
    return button(
        text, fonts.large(), UiColours.BACKDROP, accent, accentOver, accentFocused, action);
  }

  /** Returns a button that is a line of a list. */
  public TextButton row(String text, Runnable action) {
    TextButton row = button(text, action);
    row.getLabel().setAlignment(Align.left);
    row.getLabel().setEllipsis(true);
    row.getLabelCell().minWidth(0);
    return row;
  }

  /** Returns a button that is a line of a list, with a second text at its right. */
  public TextButton row(String text, Label right, Runnable action) {
    TextButton row = row(text, action);
    row.add(right).padLeft(12);
    return row;
  }

  /**
   * Returns a button that is a picture with two lines below it.
   *
   * @param picture 16:9; null for one that isn't there yet
   */
  TextButton card(TextureRegion picture, String text, String about, Runnable action) {
    TextButton card = button(text, action);
    Label label = card.getLabel();
    label.setEllipsis(true);
    Label line = small(about);
    line.setEllipsis(true);
    line.setAlignment(Align.center);
    Image image = picture == null ? new Image() : new Image(picture);
    image.setScaling(Scaling.fit);
    card.clearChildren();
    card.add(image).height(CARD_PICTURE).prefWidth(0).growX().padTop(6).row();
    card.add(label).minWidth(0).prefWidth(0).growX().padTop(4).row();
    card.add(line).minWidth(0).prefWidth(0).growX().padBottom(6);
    return card;
  }

  private static TextButton button(
      String text,
      BitmapFont font,
      Color color,
      Drawable up,
      Drawable over,
      Drawable focused,
      Runnable action) {
    TextButton.TextButtonStyle style = new TextButton.TextButtonStyle();
    style.font = font;
    style.fontColor = color;
    style.up = up;
    style.over = over;
    style.focused = focused;
    style.down = focused;
    TextButton button =
        new TextButton(text, style) {
          @Override
          protected Drawable getBackgroundDrawable() {
            // The focus shows under the mouse, too, so that exactly one button has its frame.
            return hasKeyboardFocus() ? focused : super.getBackgroundDrawable();
          }
        };
    button.setUserObject(action);
    button.addListener(
        new ChangeListener() {
          @Override
          public void changed(ChangeEvent event, Actor actor) {
            action.run();
          }
        });
    return button;
  }

  /** Returns a field for a line of text. */
  public TextField field(String text, int maxLength) {
    TextField.TextFieldStyle style = new TextField.TextFieldStyle();
    style.font = fonts.text();
    style.fontColor = UiColours.TEXT;
    style.background = field;
    style.focusedBackground = fieldFocused;
    style.cursor = caret;
    style.selection = selection;
    TextField made = new TextField(text, style);
    made.setMaxLength(maxLength);
    made.setFocusTraversal(false);
    return made;
  }

  /** Returns a square of a colour, as the player's palette shows it. */
  public Image swatch(int rgb) {
    Image square = new Image(white);
    UiColours.shade(rgb, 1, 1, square.getColor());
    return square;
  }

  /** Returns an empty panel. */
  public Table panel() {
    Table table = new Table();
    table.setBackground(panel);
    table.pad(22);
    return table;
  }

  /** Returns a frame that scrolls what is too high for it; keeps its bar off the content. */
  public ScrollPane scroll(Table content) {
    content.padRight(BAR_GAP);
    ScrollPane.ScrollPaneStyle style = new ScrollPane.ScrollPaneStyle();
    style.vScrollKnob = bar;
    ScrollPane pane = new ScrollPane(content, style);
    pane.setFadeScrollBars(false);
    pane.setScrollingDisabled(true, false);
    pane.setOverscroll(false, false);
    return pane;
  }

  /** Returns a line that stands beside a letter, not on it. */
  private Drawable line(Color color) {
    Pixmap pixels = new Pixmap(3, 1, Pixmap.Format.RGBA8888);
    pixels.setBlending(Pixmap.Blending.None);
    pixels.setColor(color);
    pixels.fillRectangle(1, 0, 2, 1);
    Texture texture = new Texture(pixels);
    pixels.dispose();
    owned.add(texture);
    return new TextureRegionDrawable(texture);
  }

  private Drawable box(Color fill, Color line) {
    Pixmap pixels = new Pixmap(9, 9, Pixmap.Format.RGBA8888);
    pixels.setBlending(Pixmap.Blending.None);
    pixels.setColor(line);
    pixels.fill();
    pixels.setColor(fill);
    pixels.fillRectangle(1, 1, 7, 7);
    for (int corner = 0; corner < 4; corner++) {
      pixels.drawPixel(corner % 2 * 8, corner / 2 * 8, 0);
    }
    Texture texture = new Texture(pixels);
    pixels.dispose();
    owned.add(texture);
    NinePatchDrawable drawable = new NinePatchDrawable(new NinePatch(texture, 3, 3, 3, 3));
    drawable.setLeftWidth(10);
    drawable.setRightWidth(10);
    return drawable;
  }

  @Override
  public void dispose() {
    owned.forEach(Disposable::dispose);
  }
}
