package carom.client.desktop.game;

import carom.client.desktop.hud.Hud;
import carom.client.desktop.hud.PlayerColours;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.Fonts;
import carom.client.desktop.paint.PictureParts;
import carom.client.look.Reaction;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.sim.level.Archetype;
import com.badlogic.gdx.graphics.OrthographicCamera;
import com.badlogic.gdx.graphics.g2d.SpriteBatch;
import com.badlogic.gdx.utils.Disposable;
import java.util.Collection;
import java.util.function.ToIntFunction;

/**
 * Paints what a game's look declares into the picture of the world: backgrounds, sprites and
 * effects. Each layer is a part of the picture that may fail alone; then the usual look takes its
 * place. Render thread only.
 */
final class LookPainter implements Disposable {
  private static final String BACKGROUNDS = "the look's backgrounds";
  private static final String SPRITES = "the look's sprites";
  private static final String EFFECTS = "the look's effects";
  private static final float SHADOW_X_M = 0.10f;
  private static final float SHADOW_Y_M = -0.14f;

  private final PictureParts parts;
  private final LookPictures pictures;
  private final SpritePainter sprites;
  private final LookEffects effects;
  private final Reactions reactions = new Reactions();
  private final SpriteBatch batch = new SpriteBatch();
  private final ShownLook look;
  private boolean isPlain = true;

  /** Creates a painter. The arguments stay the property of the caller. */
  public LookPainter(ShownLook look, PictureParts parts, HeardEffects ears) {
    this.look = look;
    this.parts = parts;
    pictures = new LookPictures(look::tell);
    sprites = new SpritePainter(look, pictures, reactions);
    effects = new LookEffects(look, pictures, reactions, ears);
  }

  /** Returns what draws the look's lines about the own player. */
  public LookHud hud(Hud hud, Canvas canvas, Fonts fonts) {
    return new LookHud(look, pictures, hud, canvas, fonts);
  }

  /** Returns what lets the look's painter draw over the picture. */
  public LookCanvas canvas(Hud hud, Canvas canvas, Fonts fonts) {
    return new LookCanvas(look, pictures, hud, canvas, fonts);
  }

  /** Returns what draws the look's minimap. */
  public Minimap minimap(Hud hud, Canvas canvas, PlayerColours colours) {
    return new Minimap(look, hud, canvas, colours);
  }

  /** Begins with another look. */
  public void renew() {
    pictures.home(look.home());
    look.setup().pictures().forEach(pictures::of); // now, not as the first rocket flies
    boolean flashes =
        look.setup().effects().stream().anyMatch(e -> e instanceof Reaction r && r.flashRgb() >= 0);
    if (flashes) {
      look.setup().sprites().forEach(sprite -> pictures.silhouette(sprite.file()));
    }
    isPlain = look.setup().isPlain();
    clear();
  }

  /** Forgets what was seen, for another level. */
  public void clear() {
    sprites.clear();
    effects.clear();
  }

  /** Logs what the look declares for things that there aren't, see {@link ShownLook#check}. */
  public void check(
      Collection<String> things, Collection<String> events, Collection<String> zones) {
    look.check(things, events, zones);
  }

  /** Ends a batch that a part has begun before it threw. */
  public void abandon() {
    if (batch.isDrawing()) {
      batch.end();
    }
  }

  /** Returns whether there is nothing to paint, so that all has the usual look. */
  public boolean isPlain() {
    return isPlain;
  }

  /** Returns what events, blows and movements set off. */
  public LookEffects effects() {
    return effects;
  }

  /** Returns how a body reacts to a blow or an event; null if the look has no reactions. */
  Reactions.Shown reaction(Drawn body) {
    return isPlain || parts.isBroken(EFFECTS) ? null : reactions.of(body);
  }

  /** Returns whether sprites take the place of an archetype's shapes. */
  public boolean paints(Archetype archetype) {
    return !look.setup().sprites().isEmpty() && !parts.isBroken(SPRITES) && sprites.has(archetype);
  }

  /** Returns whether a trail takes the place of an archetype's streak. */
  public boolean hasTrail(Archetype archetype) {
    return look.setup().trail(archetype.name()) != null && !parts.isBroken(EFFECTS);
  }

  /** Returns whether backgrounds take the place of the level's grid. */
  public boolean hasBackground() {
    return !look.setup().backgrounds().isEmpty() && !parts.isBroken(BACKGROUNDS);
  }

  /** Lets time pass; call it once per picture. */
  public void update(ClientView view, float seconds, ToIntFunction<Drawn> bodyRgb) {
    if (isPlain) {
      return;
    }
    parts.run(SPRITES, () -> sprites.update(view, seconds));
    parts.run(EFFECTS, () -> effects.update(view, seconds, bodyRgb));
  }

  private void run(String part, OrthographicCamera camera, Runnable drawn) {
    parts.run(
        part,
        () -> {
          batch.setProjectionMatrix(camera.combined);
          batch.begin();
          drawn.run();
          batch.end();
        });
  }

  /** Draws the backgrounds. */
  public void backgrounds(OrthographicCamera camera) {
    run(BACKGROUNDS, camera, () -> sprites.backgrounds(batch, camera));
  }

  /** Draws the shadows of bodies that have sprites. */
  public void shadows(ClientView view, OrthographicCamera camera) {
    camera.position.sub(SHADOW_X_M, SHADOW_Y_M, 0);
    camera.update();
    bodies(view, camera, body -> 0, true);
    camera.position.add(SHADOW_X_M, SHADOW_Y_M, 0);
    camera.update();
  }

  /** Draws the sprites of bodies; {@code bodyRgb} returns the colours for tints. */
  public void bodies(ClientView view, OrthographicCamera camera, ToIntFunction<Drawn> bodyRgb) {
    bodies(view, camera, bodyRgb, false);
  }

  private void bodies(
      ClientView view, OrthographicCamera camera, ToIntFunction<Drawn> bodyRgb, boolean shadow) {
    run(
        SPRITES,
        camera,
        () -> {
          for (int i = 0; i < view.entityCount(); i++) {
            Drawn body = view.entity(i);
            if (sprites.has(body.archetype())) {
              sprites.body(batch, view, body, bodyRgb.applyAsInt(body), shadow);
            }
          }
        });
  }

  /** Draws pieces of the level that have sprites; the argument calls {@link #piece} for each. */
  public void pieces(OrthographicCamera camera, Runnable all) {
    run(SPRITES, camera, all);
  }

  /** Draws the sprites of a piece of the level. */
  public void piece(Archetype archetype, float x, float y, float angle) {
    sprites.piece(batch, archetype, x, y, angle, false);
  }

  /** Draws the particles that cover what is behind them, or those that glow. */
  public void particles(OrthographicCamera camera, boolean glowing) {
    if (effects.flying() > 0) {
      run(EFFECTS, camera, () -> effects.draw(batch, glowing));
    }
  }

  @Override
  public void dispose() {
    batch.dispose();
    pictures.dispose();
  }
}
