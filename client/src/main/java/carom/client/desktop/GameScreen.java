package carom.client.desktop;

import carom.client.ClientView;
import carom.client.ClientView.Drawn;
import carom.client.ConnectionPhase;
import carom.client.GameClient;
import carom.client.InputSource;
import carom.client.events.EventListener;
import carom.sim.Event;
import carom.sim.Input;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.InputAdapter;
import com.badlogic.gdx.ScreenAdapter;
import com.badlogic.gdx.graphics.g2d.SpriteBatch;
import com.badlogic.gdx.math.Matrix4;
import com.badlogic.gdx.utils.ScreenUtils;

/**
 * One visit to a server, from connecting to leaving: drives the client, draws its view, plays the
 * devices. Render thread only.
 */
final class GameScreen extends ScreenAdapter {
  /** Told when the visit is over. */
  interface Exit {
    /**
     * The player left, or can't stay.
     *
     * @param reason in words for the player; empty when the player wanted to leave
     */
    void leave(String reason);
  }

  /** What happened while the line was down is told afterwards, but a flash of it would puzzle. */
  private static final float STALE_SECONDS = 1;

  private final SpriteBatch batch = new SpriteBatch();
  private final Matrix4 pixels = new Matrix4();
  private final ViewCamera camera = new ViewCamera();
  private final WorldPainter world;
  private final DebugPainter debug;
  private final Hud hud;
  private final Flashes flashes = new Flashes();
  private final NetGraph netGraph;
  private final Controls controls = new Controls();
  private final Exit exit;
  private GameClient client;
  private boolean showNetGraph;
  private boolean showDebug;
  private float seconds;
  private float secondsPlayed;

  GameScreen(Canvas canvas, Fonts fonts, Exit exit) {
    this.exit = exit;
    world = new WorldPainter(canvas);
    debug = new DebugPainter(canvas);
    hud = new Hud(canvas, batch, fonts);
    netGraph = new NetGraph(canvas, batch, hud, fonts);
  }

  /** The devices, as a source of input for a client that is drawn here. */
  InputSource devices() {
    return (view, tick, out) -> sample(view, out);
  }

  /** Hands in the client to drive; it is closed with this screen. */
  void client(GameClient client) {
    this.client = client;
    client.events(
        new EventListener() {
          @Override
          public void happened(Event event, boolean foreseen) {
            double ago = client.view().renderTick() - event.tick();
            if (ago < STALE_SECONDS * client.view().tickRate()) {
              flashes.happened(event, foreseen);
            }
          }

          @Override
          public void retracted(Event event) {
            flashes.retracted(event);
          }
        });
  }

  /** Shows or hides the net graph. */
  void netGraph(boolean shown) {
    showNetGraph = shown;
  }

  /** Shows or hides what the physics sees. */
  void debug(boolean shown) {
    showDebug = shown;
  }

  ClientView view() {
    return client.view();
  }

  private void sample(ClientView view, Input out) {
    Drawn own = view.own();
    controls.sample(out, camera, own == null ? 0 : own.x(), own == null ? 0 : own.y());
  }

  @Override
  public void show() {
    Gdx.input.setInputProcessor(
        new InputAdapter() {
          @Override
          public boolean keyDown(int key) {
            switch (key) {
              case Keys.F3 -> showNetGraph = !showNetGraph;
              case Keys.F4 -> showDebug = !showDebug;
              case Keys.ESCAPE -> exit.leave("");
              default -> {
                return false;
              }
            }
            return true;
          }
        });
  }

  @Override
  public void render(float deltaSeconds) {
    long nowNs = System.nanoTime();
    client.update(nowNs);
    seconds += deltaSeconds;
    ClientView view = client.view();
    if (view.phase() == ConnectionPhase.ENDED) {
      exit.leave(view.message());
      return;
    }
    secondsPlayed = view.phase() == ConnectionPhase.PLAYING ? secondsPlayed + deltaSeconds : 0;
    draw(view, nowNs, deltaSeconds);
  }

  private void draw(ClientView view, long nowNs, float deltaSeconds) {
    int width = Gdx.graphics.getWidth();
    int height = Gdx.graphics.getHeight();
    ScreenUtils.clear(Theme.BACKDROP);
    pixels.setToOrtho2D(0, 0, width, height);
    batch.setProjectionMatrix(pixels);
    if (view.level() != null) {
      Drawn own = view.own();
      camera.update(
          view.level().bounds(),
          own != null,
          own == null ? 0 : own.x(),
          own == null ? 0 : own.y(),
          width,
          height,
          deltaSeconds);
      camera.tell(client);
      float pixelsPerMetre = camera.pixelsPerMetre(height);
      world.draw(view, flashes, camera.gdx(), pixelsPerMetre, seconds, deltaSeconds);
      if (showDebug && view.predictedWorld() != null) {
        debug.draw(view.predictedWorld().world(), camera.gdx(), pixelsPerMetre);
      }
      hud.names(view, camera, pixelsPerMetre);
      hud.labels(flashes, camera);
      hud.scores(view, width, height, Gdx.input.isKeyPressed(Keys.TAB));
      hud.notices(view, nowNs, width, height);
      hud.hints(view, secondsPlayed, width);
      if (own == null && camera.hasFollowed() && secondsPlayed > 1) {
        hud.bodiless(width, height);
      }
    }
    hud.phase(view, width, height);
    if (showNetGraph) {
      netGraph.draw(view.stats(), nowNs, Gdx.graphics.getFramesPerSecond(), deltaSeconds);
    }
  }

  @Override
  public void dispose() {
    if (client != null) {
      client.close();
    }
    batch.dispose();
  }
}
