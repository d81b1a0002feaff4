package carom.client.desktop.game;

import carom.client.desktop.hud.Hud;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.DebugPainter;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.Theme;
import carom.client.desktop.paint.ViewCamera;
import carom.client.desktop.sound.EventSounds;
import carom.client.events.EventListener;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.sim.Event;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.utils.Disposable;
import com.badlogic.gdx.utils.ScreenUtils;

/**
 * A game as its {@link ClientView} tells it, whoever plays or replays it: the level and what moves
 * in it, what its events look and sound like, names, scores and notices. Screens add what is theirs
 * with its {@link #hud}. Render thread only.
 */
public final class GamePicture implements Disposable {
  /** What happened while the line was down is told afterwards, but a flash of it would puzzle. */
  private static final float STALE_SECONDS = 1;

  private final ViewCamera camera = new ViewCamera();
  private final Flashes flashes = new Flashes();
  private final EventSounds sounds;
  private final WorldPainter world;
  private final DebugPainter debug;
  private final Hud hud;
  private boolean showDebug;
  private double seconds;

  /** Creates a picture. The arguments stay the property of the caller. */
  public GamePicture(Canvas canvas, Fonts fonts, EventSounds sounds) {
    this.sounds = sounds;
    world = new WorldPainter(canvas);
    debug = new DebugPainter(canvas);
    hud = new Hud(canvas, fonts);
  }

  /** Where the picture is taken from; follows the own player. */
  public ViewCamera camera() {
    return camera;
  }

  /** For text and panels over the picture. */
  public Hud hud() {
    return hud;
  }

  /** Shows or hides what the physics sees. */
  public void debug(boolean shown) {
    showDebug = shown;
  }

  /** Shows and plays what happens in a game; to be told by whoever fills the view. */
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

  /** Does what a key says about the picture; false when it says nothing. */
  public boolean key(int key) {
    switch (key) {
      case Keys.F4 -> showDebug = !showDebug;
      case Keys.M -> {
        sounds.mute(!sounds.muted());
        hud.tell(
            !sounds.audible() ? "No sound here" : sounds.muted() ? "Sound is off" : "Sound is on");
      }
      default -> {
        return false;
      }
    }
    return true;
  }

  /**
   * Draws it, on a cleared window; before the level is known only that.
   *
   * @param allScores whether to list as many players as fit
   * @param nowNs the clock of the view's notices
   * @param deltaSeconds since the last picture
   */
  public void draw(ClientView view, boolean allScores, long nowNs, float deltaSeconds) {
    int width = Gdx.graphics.getWidth();
    int height = Gdx.graphics.getHeight();
    ScreenUtils.clear(Theme.BACKDROP);
    hud.size(width, height);
    seconds += deltaSeconds;
    if (view.level() == null) {
      return;
    }
    Drawn own = view.own();
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
    hud.scores(view, allScores);
    hud.notices(view, nowNs);
    hud.told(deltaSeconds);
  }

  @Override
  public void dispose() {
    hud.dispose();
  }
}
