package carom.client.desktop.game;

import carom.client.EventListener;
import carom.client.desktop.hud.ClockPanel;
import carom.client.desktop.hud.GaugePanel;
import carom.client.desktop.hud.Hud;
import carom.client.desktop.hud.PlayerColours;
import carom.client.desktop.hud.Pointers;
import carom.client.desktop.hud.ScoreBoard;
import carom.client.desktop.hud.ScoreList;
import carom.client.desktop.hud.ShownGame;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.PictureParts;
import carom.client.desktop.paint.UiColours;
import carom.client.desktop.paint.ViewCamera;
import carom.client.look.CameraSetup;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.physics.math.Aabb;
import carom.sim.level.Appearance;
import carom.sim.level.Level;
import carom.sim.outbox.Event;
import com.badlogic.gdx.Gdx;
import com.badlogic.gdx.Input.Keys;
import com.badlogic.gdx.math.Vector3;
import com.badlogic.gdx.utils.Disposable;
import com.badlogic.gdx.utils.ScreenUtils;
import java.util.List;
import java.util.function.UnaryOperator;

/**
 * The picture of a game from its {@link ClientView}, played or replayed: the level, the entities,
 * effects and sounds of events, names, scores and notices. A screen adds its own parts with the
 * {@link #hud}. Render thread only.
 */
public final class GamePicture implements Disposable {
  /** Words of others over bodies, such as emotes. They stand below all panels. */
  @FunctionalInterface
  public interface Labels {
    /** Draws them. */
    void draw(ClientView view, Hud hud, ViewCamera camera, long nowNs);
  }

  /** Age beyond which an event isn't shown. Events from before a reconnect would puzzle players. */
  private static final float STALE_SECONDS = 1;

  /** Space around all players, metres. */
  private static final float AROUND_ALL_M = 4;

  private static final String LINES = "the look's lines";

  private final ViewCamera camera = new ViewCamera();
  private final PictureParts parts;
  private final Flashes flashes;
  private final EventSounds sounds;
  private final WorldPainter world;
  private final DebugPainter debug;
  private final Hud hud;
  private final ClockPanel clock;
  private final ShownGame game = new ShownGame();
  private final PlayerColours colours;
  private final ShownLook look;
  private final LookPainter lookPainter;
  private final ScoreBoard scoreBoard;
  private final ScoreList scores;
  private final GaugePanel gauges;
  private final LookHud lines;
  private final Minimap minimap;
  private final LookCanvas lookCanvas;
  private final SlowReplay slow;
  private final Pointers pointers;
  private final Aabb subject = new Aabb();
  private final Vector3 words = new Vector3();
  private Labels labels = (view, hud, camera, nowNs) -> {};
  private boolean showDebug;
  private boolean showPanels = true;
  private boolean showSlowMotion;
  private double seconds;
  private Level level;

  /** Creates a picture. The arguments stay the property of the caller. */
  public GamePicture(Canvas canvas, Fonts fonts, EventSounds sounds) {
    this.sounds = sounds;
    hud = new Hud(canvas, fonts);
    parts = new PictureParts(this::repair, hud::showAnswer);
    look = new ShownLook(hud::showAnswer);
    lookPainter = new LookPainter(look, parts, sounds);
    slow = new SlowReplay(look);
    flashes = new Flashes(lookPainter.effects()::replacesRing);
    colours = new PlayerColours(game);
    world = new WorldPainter(canvas, parts, colours, lookPainter);
    debug = new DebugPainter(canvas);
    clock = new ClockPanel(hud, canvas, fonts, game);
    scoreBoard = new ScoreBoard(hud, canvas, fonts, game);
    scores = new ScoreList(hud, canvas, fonts, game, colours);
    gauges = new GaugePanel(hud, canvas, fonts, game);
    lines = lookPainter.hud(hud, canvas, fonts);
    lookCanvas = lookPainter.canvas(hud, canvas, fonts);
    minimap = lookPainter.minimap(hud, canvas, colours);
    pointers = new Pointers(hud, canvas, fonts, game);
  }

  /** Ends what a part of the picture that threw has begun. */
  private void repair() {
    hud.abandon();
    lookPainter.abandon();
  }

  /** Returns the camera, which follows the own player. */
  public ViewCamera camera() {
    return camera;
  }

  /** Returns the HUD, for text and panels over the picture. */
  public Hud hud() {
    return hud;
  }

  /** Returns what runs the parts of the picture, for those that a screen adds. */
  public PictureParts parts() {
    return parts;
  }

  /** Returns what the game that is shown says of itself. */
  public ShownGame game() {
    return game;
  }

  /** Returns the look that the game has of its own. */
  public ShownLook look() {
    return look;
  }

  /** Sets what draws words over bodies. */
  public void labels(Labels drawn) {
    labels = drawn;
  }

  /** Sets what a player is told who waits alone for others; empty for nothing. */
  public void adviceAlone(UnaryOperator<String> ofRoom) {
    clock.adviceAlone(ofRoom);
  }

  /** Shows or hides clock, scores, gauges and notices, which a dialog would cover. */
  public void panels(boolean shown) {
    showPanels = shown;
  }

  /** Shows what the look wants to be seen again in slow motion, unless the own player plays. */
  public void showSlowMotion() {
    showSlowMotion = true;
  }

  /** Goes on with the present if a slow motion is shown. */
  public void skipSlowMotion() {
    slow.skip();
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
          parts.run("flashes", () -> flashes.happened(event, predicted));
          parts.run("effects of events", () -> lookPainter.effects().happened(event, predicted));
          slow.happened(event);
          parts.run("sounds", () -> sounds.happened(event, predicted));
        }
      }

      @Override
      public void retracted(Event event) {
        parts.run("flashes", () -> flashes.retracted(event));
        parts.run("sounds", () -> sounds.retracted(event));
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
   * @param table whether to list as many players as fit
   * @param nowNs the clock of the view's notices
   * @param deltaSeconds since the last picture
   */
  public void draw(ClientView view, boolean table, long nowNs, float deltaSeconds) {
    int width = Gdx.graphics.getWidth();
    int height = Gdx.graphics.getHeight();
    ScreenUtils.clear(UiColours.BACKDROP);
    hud.size(width, height);
    seconds += deltaSeconds;
    if (view.level() == null) {
      return;
    }
    if (view.level() != level) {
      level = view.level();
      parts.renew();
      slow.begin();
    }
    if (look.show(view.game())) {
      parts.renew();
      lookPainter.renew();
      camera.zooms(look.setup().camera().isZooming());
      parts.run("the look's sounds", () -> sounds.look(look));
      slow.begin();
    }
    boolean plays = view.own() != null && !isOver(view);
    if (slow.update(view, deltaSeconds, showSlowMotion && !plays)) {
      world.forget();
    }
    if (slow.happensAgain()) {
      flashes.happened(slow.event(), false);
      lookPainter.effects().happened(slow.event(), false);
    }
    float passed = slow.speed() * deltaSeconds;
    slow.during(view, () -> game(view, width, height, nowNs, passed));
    if (slow.isOn()) {
      parts.run("slow motion", this::sayHowToGoOn);
    } else if (showPanels) {
      panels(view, table, nowNs);
    }
    hud.drawAnswer(deltaSeconds);
  }

  private boolean isOver(ClientView view) {
    return !parts.isBroken("clock") && clock.isOver(view);
  }

  private void sayHowToGoOn() {
    hud.begin();
    hud.label(
        "Slow motion. Any key goes on",
        words.set(hud.windowWidth() / 2, 0.75f * hud.height(), 0), // below who is watched
        false,
        UiColours.TEXT);
    hud.end();
  }

  /** Draws the game as the view shows it, with what stands at its bodies. */
  private void game(ClientView view, int width, int height, long nowNs, float deltaSeconds) {
    Drawn own = view.own() == null ? view.watched() : view.own();
    Aabb shown = slow.isOn() ? place(slow.event()) : own == null ? null : subject(view, own);
    float least = least(view, own);
    camera.update(view.level().bounds(), shown, least, width, height, deltaSeconds);
    float x = own == null ? camera.gdx().position.x : own.x();
    float y = own == null ? camera.gdx().position.y : own.y();
    parts.run("sounds", () -> sounds.listen(x, y, deltaSeconds));
    Tremor tremor = lookPainter.effects().tremor();
    tremor.update(x, y, deltaSeconds);
    camera.shake(tremor.x(), tremor.y());
    parts.run("the game's own words", () -> game.look(view));
    parts.run("players' colours", () -> colours.look(view));
    float pixelsPerMetre = camera.pixelsPerMetre(height);
    world.draw(view, flashes, camera.gdx(), pixelsPerMetre, (float) seconds, deltaSeconds);
    if (showDebug && view.predictedWorld() != null) {
      parts.run(
          "debug layers",
          () -> debug.draw(view.predictedWorld().world(), camera.gdx(), pixelsPerMetre));
    }
    if (own != null) {
      float radius = WorldPainter.extent(own.archetype());
      hud.keepFree(camera, own.x(), own.y(), radius, pixelsPerMetre);
    }
    parts.run("gauges over heads", () -> gauges.heads(view, camera, pixelsPerMetre));
    parts.run(
        "words of events",
        () -> {
          hud.begin();
          flashes.label(hud, camera);
          hud.end();
        });
    parts.run("emotes", () -> labels.draw(view, hud, camera, nowNs));
    parts.run("pointers", () -> pointers.draw(view, camera));
    parts.run("names", () -> hud.names(view, camera, pixelsPerMetre));
    parts.run("the look's own lines", () -> lookCanvas.draw(view, camera));
  }

  private Aabb place(Event event) {
    return subject.set(event.x(), event.y(), event.x(), event.y());
  }

  /** Returns the least height that the camera shows, metres; 0 for the usual. */
  private float least(ClientView view, Drawn own) {
    CameraSetup setup = look.setup().camera();
    boolean isOther =
        own != null
            && setup.condition() != null
            && setup.condition().number(view, own.ownerId(), own) != 0;
    return isOther ? setup.otherHeight() : setup.height();
  }

  /**
   * Returns what the camera shows: the zone that the own body is in, or a point ahead of it, or all
   * bodies of players.
   */
  private Aabb subject(ClientView view, Drawn own) {
    CameraSetup setup = look.setup().camera();
    List<Level.Zone> zones = view.level().zones();
    for (int i = 0; !setup.zones().isEmpty() && i < zones.size(); i++) {
      Level.Zone zone = zones.get(i);
      subject.set(zone.minX(), zone.minY(), zone.maxX(), zone.maxY());
      if (subject.contains(own.x(), own.y()) && setup.zones().contains(zone.name())) {
        return subject;
      }
    }
    float x = own.x() + setup.leadSeconds() * own.velocityX();
    float y = own.y() + setup.leadSeconds() * own.velocityY();
    subject.set(x, y, x, y);
    for (int i = 0; setup.isFramingAll() && i < view.entityCount(); i++) {
      Drawn body = view.entity(i);
      if (body.archetype().appearance().look() == Appearance.Look.PLAYER) {
        subject.add(body.x(), body.y());
      }
    }
    return setup.isFramingAll() ? subject.grow(AROUND_ALL_M) : subject;
  }

  private void panels(ClientView view, boolean table, long nowNs) {
    boolean over = isOver(view);
    parts.run("clock", () -> clock.draw(view));
    if (table || over) {
      parts.run("table of players", () -> scoreBoard.draw(view, clock.depth()));
    } else {
      parts.run("scores", () -> scores.draw(view));
      if (lines.hasLines() && !parts.isBroken(LINES)) {
        parts.run(LINES, () -> lines.draw(view));
      } else {
        parts.run("gauges", () -> gauges.draw(view));
      }
    }
    if (!camera.shows(view.level().bounds())) {
      parts.run("minimap", () -> minimap.draw(view, world.scenery()));
    }
    if (!over) { // the result says the same
      parts.run("notices", () -> hud.notices(view, nowNs));
    }
  }

  @Override
  public void dispose() {
    sounds.look(null);
    lookPainter.dispose();
    hud.dispose();
  }
}
