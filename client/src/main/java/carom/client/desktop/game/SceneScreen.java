package carom.client.desktop.game;

import carom.client.desktop.game.DebugPainter.Layer;
import carom.client.desktop.hud.Hud;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.UiColours;
import carom.client.desktop.paint.ViewCamera;
import carom.physics.StepProfile;
import carom.sim.scene.Scene;
import carom.sim.scene.View;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input.Buttons;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.InputAdapter;
import com.badlogic.gdx.ScreenAdapter;
import com.badlogic.gdx.math.Vector3;
import com.badlogic.gdx.utils.ScreenUtils;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;

/**
 * The viewer of scenes: shows one scene at a time, without a server. Draws the state after the last
 * step, not between steps. Render thread only.
 */
public final class SceneScreen extends ScreenAdapter {
  private static final Layer[] LAYERS = Layer.values();
  private static final float PAD = 12;
  private static final float LINE = 19;
  private static final float REFRESH_SECONDS = 0.2f;
  private static final float ZOOM = 1.15f;
  private static final String[] HELP = {
    "Space  pause, go on",
    ".  Right  one step",
    "-  +  slower, faster",
    "R  restart",
    "Tab  PgDn  next scene",
    "Shift+Tab  PgUp  scene before",
    "drag a body  pull and fling it",
    "drag the ground  move the view",
    "wheel  zoom     0  whole scene",
    "1..7  shapes, boxes, fat boxes, tree,",
    "        contacts, joints, centres",
    "F4  all of these     F12  screenshot",
    "H  F1  this help     Esc  leave",
  };

  private final ViewCamera camera = new ViewCamera();
  private final ScenePlayer player = new ScenePlayer(System::nanoTime);
  private final ScenePainter painter;
  private final DebugPainter debug;
  private final Fonts fonts;
  private final Hud hud;
  private final Runnable exit;
  private final Set<Layer> layers = EnumSet.noneOf(Layer.class);
  private boolean help;
  private boolean fitted;
  private boolean panning;
  private int lastX;
  private int lastY;
  private float age = REFRESH_SECONDS;
  private String counts = "";
  private String clock = "";

  /**
   * Creates a viewer without a scene; call {@link #open} next.
   *
   * @param exit runs when the player wants to leave
   */
  public SceneScreen(Canvas canvas, Fonts fonts, Runnable exit) {
    this.fonts = fonts;
    this.exit = exit;
    painter = new ScenePainter(canvas);
    debug = new DebugPainter(canvas);
    hud = new Hud(canvas, fonts);
  }

  /** Shows a scene from its beginning. */
  public void open(Scene scene) {
    player.open(scene);
    fresh();
  }

  private void fresh() {
    fitted = false;
    panning = false;
    age = REFRESH_SECONDS;
  }

  /** Shows or hides the usual debug layers. */
  public void debug(boolean shown) {
    layers.clear();
    if (shown) {
      layers.addAll(EnumSet.complementOf(EnumSet.of(Layer.FAT_BOXES)));
    }
  }

  @Override
  public void show() {
    Gdx.input.setInputProcessor(
        new InputAdapter() {
          @Override
          public boolean keyDown(int key) {
            return key(key);
          }

          @Override
          public boolean touchDown(int x, int y, int pointer, int button) {
            Vector3 at = camera.toWorld(x, y);
            panning = button != Buttons.LEFT || !player.grab(at.x, at.y);
            lastX = x;
            lastY = y;
            return true;
          }

          @Override
          public boolean touchDragged(int x, int y, int pointer) {
            if (panning) {
              camera.pan(lastX, lastY, x, y);
            } else {
              Vector3 at = camera.toWorld(x, y);
              player.drag(at.x, at.y);
            }
            lastX = x;
            lastY = y;
            return true;
          }

          @Override
          public boolean touchUp(int x, int y, int pointer, int button) {
            panning = false;
            player.release();
            return true;
          }

          @Override
          public boolean scrolled(float amountX, float amountY) {
            camera.zoom(Gdx.input.getX(), Gdx.input.getY(), (float) Math.pow(ZOOM, amountY));
            return true;
          }
        });
  }

  private boolean key(int key) {
    boolean shift =
        Gdx.input.isKeyPressed(Keys.SHIFT_LEFT) || Gdx.input.isKeyPressed(Keys.SHIFT_RIGHT);
    switch (key) {
      case Keys.SPACE -> player.pause(!player.paused());
      case Keys.PERIOD, Keys.RIGHT -> player.single();
      case Keys.MINUS, Keys.NUMPAD_SUBTRACT -> player.speedUp(-1);
      case Keys.EQUALS, Keys.PLUS, Keys.NUMPAD_ADD -> player.speedUp(1);
      case Keys.R -> player.restart();
      case Keys.TAB -> turn(shift ? -1 : 1);
      case Keys.PAGE_DOWN -> turn(1);
      case Keys.PAGE_UP -> turn(-1);
      case Keys.NUM_0 -> fitted = false;
      case Keys.F4 -> debug(layers.isEmpty());
      case Keys.H, Keys.F1 -> help = !help;
      case Keys.ESCAPE -> exit.run();
      default -> {
        int layer = key - Keys.NUM_1;
        if (layer < 0 || layer >= LAYERS.length) {
          return false;
        }
        if (!layers.remove(LAYERS[layer])) {
          layers.add(LAYERS[layer]);
        }
      }
    }
    age = REFRESH_SECONDS;
    return true;
  }

  private void turn(int by) {
    player.turn(by);
    fresh();
  }

  @Override
  public void render(float deltaSeconds) {
    player.advance(deltaSeconds);
    int width = Gdx.graphics.getWidth();
    int height = Gdx.graphics.getHeight();
    if (!fitted) {
      View view = player.scene().view();
      // The title covers the top.
      float sky = Math.max(view.height(), view.width() * height / width) * 0.06f;
      camera.fit(view.x(), view.y() + sky, view.width(), view.height() + 2 * sky, width, height);
      fitted = true;
    }
    camera.resize(width, height);
    ScreenUtils.clear(UiColours.BACKDROP);
    hud.size(width, height);
    float pixelsPerMetre = camera.pixelsPerMetre(height);
    painter.draw(player.run(), camera.gdx(), pixelsPerMetre);
    if (!layers.isEmpty()) {
      debug.draw(player.run().world(), camera.gdx(), pixelsPerMetre, layers);
    }
    age += deltaSeconds;
    if (age >= REFRESH_SECONDS) {
      age = 0;
      write();
    }
    title();
    if (help) {
      help();
    }
  }

  private void write() {
    StepProfile p = player.run().world().profile();
    counts =
        String.format(
            Locale.ROOT,
            "%,d bodies   %,d awake   %,d contacts   %,d joints   %.2f ms a step   %d frames/s",
            p.bodies(),
            p.awake(),
            p.contacts(),
            player.run().world().jointCount(),
            player.stepMs(),
            Gdx.graphics.getFramesPerSecond());
    StringBuilder text = new StringBuilder();
    text.append("tick ").append(player.run().tick());
    text.append("   hash ").append(String.format(Locale.ROOT, "%016x", player.run().stateHash()));
    text.append(player.paused() ? "   paused" : "");
    if (player.speed() != 1) {
      text.append("   speed ").append(player.speed());
    }
    String separator = "   ";
    for (Layer layer : layers) {
      text.append(separator).append(layer.label);
      separator = ", ";
    }
    clock = text.toString();
  }

  private void title() {
    float y = hud.height() - PAD;
    float room = Math.max(560, hud.width(fonts.text(), player.scene().description()) + 2 * PAD);
    hud.panel(PAD / 2, y - 3 * LINE - 30, room, 3 * LINE + 36);
    hud.begin();
    hud.left(fonts.large(), player.scene().name().replace('_', ' '), PAD, y, UiColours.TEXT);
    hud.left(fonts.text(), player.scene().description(), PAD, y - 28, UiColours.ACCENT);
    hud.left(fonts.small(), counts, PAD, y - 50, UiColours.TEXT);
    hud.left(fonts.small(), clock, PAD, y - 67, UiColours.MUTED);
    hud.left(fonts.small(), "H: keys     Tab: next scene", PAD, PAD + 12, UiColours.MUTED);
    hud.end();
  }

  private void help() {
    float w = 290;
    float h = HELP.length * LINE + 2 * PAD;
    float x = hud.windowWidth() - w - PAD;
    float top = hud.height() - PAD;
    hud.panel(x, top - h, w, h);
    hud.begin();
    for (int i = 0; i < HELP.length; i++) {
      hud.left(fonts.small(), HELP[i], x + PAD, top - PAD - i * LINE, UiColours.TEXT);
    }
    hud.end();
  }

  @Override
  public void dispose() {
    hud.dispose();
  }
}
