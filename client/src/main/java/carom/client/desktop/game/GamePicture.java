package carom.client.desktop.game;

import carom.client.desktop.hud.ClockPanel;
import carom.client.desktop.hud.Hud;
import carom.client.desktop.hud.ScoreBoard;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.DebugPainter;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.Theme;
import carom.client.desktop.paint.ViewCamera;
import carom.client.desktop.sound.EventSounds;
import carom.client.events.EventListener;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.sim.outbox.Event;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.utils.Disposable;
import com.badlogic.gdx.utils.ScreenUtils;

/**
 * The picture of a game from its {@link ClientView}, played or replayed: the level, the entities,
 * effects and sounds of events, names, scores and notices. A screen adds its own parts with the
 * {@link #hud}. Render thread only.
 */
public final class GamePicture implements Disposable {
  /** Age beyond which an event isn't shown. Events from before a reconnect would puzzle players. */
  private static final float STALE_SECONDS = 1;

  private final ViewCamera camera = new ViewCamera();
  private final Flashes flashes = new Flashes();
  private final EventSounds sounds;
  private final WorldPainter world;
  private final DebugPainter debug;
  private final Hud hud;
  private final ClockPanel clock;
  private final ScoreBoard scores;
  private boolean showDebug;
  private double seconds;

  /** Creates a picture. The arguments stay the property of the caller. */
  public GamePicture(Canvas canvas, Fonts fonts, EventSounds sounds) {
    this.sounds = sounds;
    world = new WorldPainter(canvas);
    debug = new DebugPainter(canvas);
    hud = new Hud(canvas, fonts);
    clock = new ClockPanel(hud, fonts);
    scores = new ScoreBoard(hud, fonts);
  }

  /** Returns the camera, which follows the own player. */
  public ViewCamera camera() {
    return camera;
  }

  /** Returns the HUD, for text and panels over the picture. */
  public Hud hud() {
    return hud;
  }

  /** Returns the table of players, which knows the teams' names. */
  public ScoreBoard scores() {
    return scores;
  }

  /** Shows or hides the debug layers. */
  public void debug(boolean shown) {
    showDebug = shown;
  }

  /** Returns a listener that shows and plays the events of a view's game. */
  public EventListener events(ClientView view) {
    return new EventListener() {
      @Override
      public void happened(Event event, boolean predicted) {
        double ago = view.renderTick() - event.tick();
        if (ago < STALE_SECONDS * view.tickRate()) {
          flashes.happened(event, predicted);
          sounds.happened(event, predicted);
        }
      }

      @Override
      public void retracted(Event event) {
        flashes.retracted(event);
        sounds.retracted(event);
      }
    };
  }

  /** Handles a key; returns false if the key doesn't concern the picture. */
  public boolean key(int key) {
    if (key == Keys.F4) {
      showDebug = !showDebug;
    }
    return key == Keys.F4;
  }

  /** Switches the sound off or on. */
  public void toggleSound() {
    sounds.mute(!sounds.muted());
    hud.showAnswer(
        !sounds.audible() ? "No sound here" : sounds.muted() ? "Sound is off" : "Sound is on");
  }

  /**
   * Draws it, on a cleared window; before the level is known only that.
   *
   * @param scoreBoard whether to list as many players as fit
   * @param nowNs the clock of the view's notices
   * @param deltaSeconds since the last picture
   */
  public void draw(ClientView view, boolean scoreBoard, long nowNs, float deltaSeconds) {
    int width = Gdx.graphics.getWidth();
    int height = Gdx.graphics.getHeight();
    ScreenUtils.clear(Theme.BACKDROP);
    hud.size(width, height);
    seconds += deltaSeconds;
    if (view.level() == null) {
      return;
    }
    Drawn own = view.own() == null ? view.watched() : view.own();
    camera.update(
        view.level().bounds(),
        own != null,
        own == null ? 0 : own.x(),
        own == null ? 0 : own.y(),
        width,
        height,
        deltaSeconds);
    sounds.listen(
        own == null ? camera.gdx().position.x : own.x(),
        own == null ? camera.gdx().position.y : own.y(),
        deltaSeconds);
    float pixelsPerMetre = camera.pixelsPerMetre(height);
    world.draw(view, flashes, camera.gdx(), pixelsPerMetre, (float) seconds, deltaSeconds);
    if (showDebug && view.predictedWorld() != null) {
      debug.draw(view.predictedWorld().world(), camera.gdx(), pixelsPerMetre);
    }
    hud.names(view, camera, pixelsPerMetre);
    hud.begin();
    flashes.label(hud, camera);
    hud.end();
    boolean over = clock.isOver(view);
    if (scoreBoard || over) {
      scores.draw(view, over ? ClockPanel.RESULT : 0);
    } else {
      hud.scores(view);
    }
    clock.draw(view);
    hud.notices(view, nowNs, over ? ClockPanel.RESULT : 0);
    hud.drawAnswer(deltaSeconds);
  }

  @Override
  public void dispose() {
    hud.dispose();
  }
}
