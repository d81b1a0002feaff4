package carom.client.desktop;

import carom.client.desktop.hud.Hud;
import carom.client.view.ClientView.Drawn;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.Pixmap;
import com.badlogic.gdx.graphics.g2d.BitmapFont;
import com.badlogic.gdx.graphics.g2d.GlyphLayout;
import com.badlogic.gdx.math.Vector2;
import com.badlogic.gdx.math.Vector3;
import com.badlogic.gdx.scenes.scene2d.Actor;
import com.badlogic.gdx.scenes.scene2d.Group;
import com.badlogic.gdx.scenes.scene2d.Stage;
import com.badlogic.gdx.scenes.scene2d.ui.Label;
import com.badlogic.gdx.scenes.scene2d.ui.ScrollPane;
import com.badlogic.gdx.scenes.scene2d.ui.TextButton;
import com.badlogic.gdx.scenes.scene2d.ui.TextField;
import com.badlogic.gdx.scenes.scene2d.utils.Layout;
import com.badlogic.gdx.utils.Align;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/**
 * What a person would check on a screen: texts are large enough, in the window, off each other, and
 * stand out from their ground; panels cover neither each other nor the own body; one button alone
 * has the focus. Names and words over bodies belong to the world and may cover it.
 */
final class ScreenCheck implements Hud.Witness {
  /** Least height of capitals, px; those of the smallest font at 720p have 9. */
  private static final float LEAST_CAPITALS = 8;

  /** Least contrast of a text and its ground, by the formula of WCAG 2. */
  private static final double LEAST_CONTRAST = 3;

  private static final float TOLERANCE = 1;

  /** Light of each value of a colour's part. */
  private static final double[] LINEAR =
      IntStream.range(0, 256).mapToDouble(ScreenCheck::linear).toArray();

  private record Box(String what, float x, float y, float w, float h) {
    boolean meets(Box o) {
      return x + TOLERANCE < o.x + o.w
          && o.x + TOLERANCE < x + w
          && y + TOLERANCE < o.y + o.h
          && o.y + TOLERANCE < y + h;
    }

    boolean contains(Box o) {
      return o.x >= x - TOLERANCE
          && o.y >= y - TOLERANCE
          && o.x + o.w <= x + w + TOLERANCE
          && o.y + o.h <= y + h + TOLERANCE;
    }
  }

  private final String screen;
  private final int width;
  private final int height;
  private final List<String> problems = new ArrayList<>();
  private final List<Box> panels = new ArrayList<>();
  private final List<Box> texts = new ArrayList<>();
  private final List<Box> words = new ArrayList<>();
  private final GlyphLayout glyphs = new GlyphLayout();
  private float scale;

  /** Creates a check of a screen of a size, px. */
  ScreenCheck(String screen, int width, int height) {
    this.screen = screen;
    this.width = width;
    this.height = height;
  }

  /** Returns what is wrong, each in a line. */
  List<String> problems() {
    return problems;
  }

  private void problem(String format, Object... values) {
    problems.add(screen + " at " + width + ": " + String.format(Locale.ROOT, format, values));
  }

  @Override
  public void panel(float x, float y, float w, float h) {
    panels.add(new Box("panel", x, y, w, h));
  }

  @Override
  public void text(BitmapFont font, String text, float x, float y, Color tint) {
    if (tint.a < 0.9f) {
      return; // fades, or is a name in the world
    }
    glyphs.setText(font, text);
    texts.add(new Box(text, x, y - font.getCapHeight(), glyphs.width, font.getCapHeight()));
  }

  @Override
  public void word(BitmapFont font, String text, float x, float y) {
    glyphs.setText(font, text);
    words.add(new Box(text, x, y - font.getCapHeight(), glyphs.width, font.getCapHeight()));
  }

  /** Checks what the HUD drew since it is the witness. */
  void hud(Hud hud, GameScreen game, Pixmap pixels) {
    scale = width / hud.windowWidth();
    Box whole = new Box("window", -3, -3, hud.windowWidth() + 6, hud.height() + 6);
    for (int i = 0; i < panels.size(); i++) {
      Box panel = panels.get(i);
      if (!whole.contains(panel)) {
        problem("a panel at %.0f, %.0f leaves the window", panel.x, panel.y);
      }
      for (Box other : panels.subList(0, i)) {
        if (panel.meets(other)) {
          problem("panels at %.0f, %.0f and %.0f, %.0f meet", panel.x, panel.y, other.x, other.y);
        }
      }
    }
    for (Box word : words) {
      if (!whole.contains(word)) {
        problem("\"%s\" leaves the window", word.what);
      }
    }
    for (Box text : texts) {
      boolean inPanel = panels.stream().anyMatch(p -> p.contains(text));
      if (!inPanel && panels.stream().anyMatch(p -> p.meets(text))) {
        problem("\"%s\" crosses a panel's edge", text.what);
      }
      if (inPanel) {
        Box shown = pixelsOf(text, hud.height());
        contrast(text.what, shown, pixels);
      }
    }
    checkTexts(texts, whole, scale);
    Drawn own = game == null ? null : game.view().own();
    if (own != null && texts.stream().noneMatch(ScreenCheck::isOfDialog)) {
      Vector3 at = hud.at(game.camera(), own.x(), own.y());
      for (Box panel : panels) {
        if (panel.meets(new Box("own body", at.x - 8, at.y - 8, 16, 16))) {
          problem("the own body is below a panel at %.0f, %.0f", panel.x, panel.y);
        }
      }
    }
  }

  /** Returns whether a text is that of the table or the list of rooms, which the player called. */
  private static boolean isOfDialog(Box text) {
    return text.what.endsWith("are here") || text.what.equals("Rooms");
  }

  private Box pixelsOf(Box points, float windowHeight) {
    return new Box(
        points.what,
        points.x * scale,
        (windowHeight - points.y - points.h) * scale,
        points.w * scale,
        points.h * scale);
  }

  private void checkTexts(List<Box> all, Box whole, float pixelsPerPoint) {
    for (int i = 0; i < all.size(); i++) {
      Box text = all.get(i);
      if (!whole.contains(text)) {
        problem("\"%s\" leaves the window", text.what);
      }
      if (text.h * pixelsPerPoint < LEAST_CAPITALS) {
        problem("\"%s\" is %.1f px high", text.what, text.h * pixelsPerPoint);
      }
      for (Box other : all.subList(0, i)) {
        if (text.meets(other)) {
          problem("\"%s\" lies on \"%s\"", text.what, other.what);
        }
      }
    }
  }

  /** Checks the parts of a menu. */
  void menu(Stage stage, Pixmap pixels) {
    scale = width / stage.getWidth();
    List<Box> labels = new ArrayList<>();
    collect(stage.getRoot(), null, labels);
    ScrollPane pane = pane(stage.getRoot());
    float needed = pane == null ? 0 : ((Layout) pane.getActor()).getMinWidth();
    if (pane != null && needed > pane.getWidth() + TOLERANCE) {
      problem("a page needs a width of %.0f and has %.0f", needed, pane.getWidth());
    }
    Box whole = new Box("window", 0, 0, stage.getWidth(), stage.getHeight());
    checkTexts(labels, whole, scale);
    for (Box label : labels) {
      contrast(label.what, pixelsOf(label, stage.getHeight()), pixels);
    }
    boolean edits = Gdx.input.getInputProcessor() != stage; // keys are an editor's commands
    if (!edits
        && !(stage.getKeyboardFocus() instanceof TextButton)
        && !(stage.getKeyboardFocus() instanceof TextField)) {
      problem("nothing has the focus");
    }
  }

  private void collect(Actor actor, Box clip, List<Box> labels) {
    if (!actor.isVisible()) {
      return;
    }
    if (actor instanceof Label label && !label.getText().isEmpty()) {
      BitmapFont font = label.getStyle().font;
      GlyphLayout shown = label.getGlyphLayout();
      if (shown.width > label.getWidth() + TOLERANCE) {
        problem("\"%s\" is wider than its place", label.getText());
      }
      Vector2 at = label.localToStageCoordinates(new Vector2());
      float h = Math.max(font.getCapHeight(), shown.height);
      float y = at.y + (label.getHeight() - h) / 2;
      float slack = label.getWidth() - shown.width;
      boolean left = Align.isLeft(label.getLabelAlign());
      float x = at.x + (left ? 0 : Align.isRight(label.getLabelAlign()) ? slack : slack / 2);
      Box box = new Box(label.getText().toString(), x, y, shown.width, h);
      if (clip == null || clip.contains(box)) {
        labels.add(box);
      }
    } else if (actor instanceof Group group) {
      Box inner = clip;
      if (actor instanceof ScrollPane) {
        Vector2 at = actor.localToStageCoordinates(new Vector2());
        inner = new Box("pane", at.x, at.y, actor.getWidth(), actor.getHeight());
      }
      for (Actor child : group.getChildren()) {
        collect(child, inner, labels);
      }
    }
  }

  /** Returns the pane that scrolls, or null. */
  static ScrollPane pane(Actor actor) {
    if (actor instanceof ScrollPane pane) {
      return pane;
    }
    if (actor instanceof Group group) {
      for (Actor child : group.getChildren()) {
        ScrollPane found = pane(child);
        if (found != null) {
          return found;
        }
      }
    }
    return null;
  }

  /** Compares a text's pixels that differ most from its ground with the ground, the median. */
  private void contrast(String text, Box at, Pixmap pixels) {
    List<Double> seen = new ArrayList<>();
    for (int y = Math.max(0, (int) at.y - 3); y < Math.min(height, at.y + at.h + 3); y++) {
      for (int x = Math.max(0, (int) at.x - 3); x < Math.min(width, at.x + at.w + 3); x++) {
        seen.add(luminance(pixels.getPixel(x, height - 1 - y)));
      }
    }
    if (seen.size() < 20) {
      return;
    }
    seen.sort(null);
    double ground = seen.get(seen.size() / 2);
    double ratio =
        Math.max(
            (seen.get(seen.size() - 3) + 0.05) / (ground + 0.05),
            (ground + 0.05) / (seen.get(2) + 0.05));
    if (ratio < LEAST_CONTRAST) {
      problem("\"%s\" has a contrast of %.1f", text, ratio);
    }
  }

  private static double luminance(int rgba) {
    return 0.2126 * LINEAR[rgba >>> 24]
        + 0.7152 * LINEAR[rgba >>> 16 & 0xff]
        + 0.0722 * LINEAR[rgba >>> 8 & 0xff];
  }

  private static double linear(int part) {
    double c = part / 255.0;
    return c <= 0.04045 ? c / 12.92 : Math.pow((c + 0.055) / 1.055, 2.4);
  }
}
