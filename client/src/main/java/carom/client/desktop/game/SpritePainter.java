package carom.client.desktop.game;

import carom.client.desktop.paint.UiColours;
import carom.client.look.Background;
import carom.client.look.Sprite;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.physics.geometry.Box;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Shape;
import carom.physics.math.Aabb;
import carom.physics.math.Transform;
import carom.sim.level.Archetype;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.OrthographicCamera;
import com.badlogic.gdx.graphics.Texture;
import com.badlogic.gdx.graphics.g2d.SpriteBatch;
import com.badlogic.gdx.math.Affine2;
import com.badlogic.gdx.math.MathUtils;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;

/** Draws the sprites and backgrounds of a game's look, in metres. Render thread only. */
final class SpritePainter {
  /** Speed from which on a body's direction counts, m/s. */
  private static final float MOVES_M_S = 0.3f;

  private static final int VERTICES = 20;

  /** A sprite with its picture and its size, metres. */
  private record Ready(Sprite sprite, Texture picture, float width, float height) {}

  /** The way that an entity has gone, and where it went last. */
  private static final class Track extends SeenEntities.Seen {
    float lastX;
    float lastY;
    double metres;
    float wayRad;
    boolean left;
  }

  private final ShownLook look;
  private final LookPictures pictures;
  private final Reactions reactions;
  private final SeenEntities<Track> tracks = new SeenEntities<>(Track::new);
  private final IdentityHashMap<Archetype, List<Ready>> ready = new IdentityHashMap<>();
  private final Color color = new Color();
  private final float[] quad = new float[VERTICES];
  private final Aabb bounds = new Aabb();
  private final Transform still = new Transform();
  private double seconds;

  private final Affine2 affine = new Affine2();

  /** The way to where what is drawn next is shown, null for its own place. */
  private Affine2 bend;

  SpritePainter(ShownLook look, LookPictures pictures, Reactions reactions) {
    this.look = look;
    this.pictures = pictures;
    this.reactions = reactions;
  }

  /** Forgets what was measured, for another look or level. */
  void clear() {
    ready.clear();
    tracks.clear();
  }

  /** Returns whether an archetype has a sprite whose picture can be shown. */
  boolean has(Archetype archetype) {
    return !of(archetype).isEmpty();
  }

  private List<Ready> of(Archetype archetype) {
    List<Ready> known = ready.get(archetype);
    if (known == null) {
      known = new ArrayList<>();
      for (Sprite sprite : look.setup().sprites()) {
        if (sprite.archetype().equals(archetype.name())) {
          Texture picture = pictures.of(sprite.file());
          if (picture != null) {
            known.add(measured(sprite, picture, archetype));
          }
        }
      }
      ready.put(archetype, known);
    }
    return known;
  }

  private Ready measured(Sprite sprite, Texture picture, Archetype archetype) {
    float width = sprite.width();
    float height = sprite.height();
    if (width == 0) {
      float least = Float.MAX_VALUE;
      float most = -Float.MAX_VALUE;
      for (Shape shape : archetype.shapes()) {
        shape.aabb(still, bounds);
        least = Math.min(least, bounds.minX);
        most = Math.max(most, bounds.maxX);
      }
      width = most - least;
      height = width * picture.getHeight() * sprite.frames() / picture.getWidth();
    }
    return new Ready(sprite, picture, width, height);
  }

  /** Lets time pass and follows the bodies; call it once per picture. */
  void update(ClientView view, float delta) {
    seconds += delta;
    tracks.nextFrame();
    for (int i = 0; i < view.entityCount(); i++) {
      Drawn body = view.entity(i);
      if (has(body.archetype())) {
        follow(tracks.see(body.id(), body.generation()), body);
      }
    }
  }

  private static void follow(Track track, Drawn body) {
    float vx = body.velocityX();
    float vy = body.velocityY();
    if (track.isNew()) {
      track.metres = 0;
      track.wayRad = body.angle();
      track.left = false;
    } else {
      track.metres += Math.hypot(body.x() - track.lastX, body.y() - track.lastY);
    }
    if (vx * vx + vy * vy > MOVES_M_S * MOVES_M_S) {
      track.wayRad = MathUtils.atan2(vy, vx);
      track.left = Math.abs(vx) > MOVES_M_S ? vx < 0 : track.left;
    }
    track.lastX = body.x();
    track.lastY = body.y();
  }

  // ---- bodies

  /**
   * Draws the sprites of a body.
   *
   * @param rgb colour of the body, for tints
   * @param shadow whether to draw only where they darken the ground
   */
  void body(SpriteBatch batch, ClientView view, Drawn body, int rgb, boolean shadow) {
    List<Ready> sprites = of(body.archetype());
    Track track = tracks.see(body.id(), body.generation());
    Reactions.Shown reaction = reactions.of(body);
    float x = body.x();
    float y = body.y();
    bend = reaction == null || !reaction.isBent() ? null : reaction.bend(x, y, affine);
    for (int i = 0; i < sprites.size(); i++) {
      Ready r = sprites.get(i);
      Sprite sprite = r.sprite;
      float value =
          sprite.frameBy() == null ? 0 : sprite.frameBy().number(view, body.ownerId(), body);
      int frame = sprite.frame(value, seconds, track.metres);
      float angle =
          switch (sprite.turn()) {
            case BODY -> body.angle();
            case UPRIGHT -> 0;
            case MOVE -> track.wayRad;
            case AIM -> body == view.own() ? view.input().aim() : track.wayRad;
          };
      boolean upright = sprite.turn() == Sprite.Turn.UPRIGHT;
      boolean flipped = sprite.isFlipping() && (upright ? track.left : MathUtils.cos(angle) < 0);
      boolean mirrorX = flipped && upright;
      boolean mirrorY = flipped && !upright;
      paint(r, rgb, body.alpha(), shadow);
      draw(batch, r, r.picture, frame, x, y, angle, mirrorX, mirrorY);
      float flash = reaction == null || shadow ? 0 : reaction.flash();
      Texture white = flash > 0 ? pictures.silhouette(sprite.file()) : null;
      if (white != null) {
        UiColours.shade(reaction.flashRgb(), 1, flash * body.alpha(), color);
        draw(batch, r, white, frame, x, y, angle, mirrorX, mirrorY);
      }
    }
    bend = null;
  }

  /** Draws the sprites of a piece of the level. */
  void piece(
      SpriteBatch batch, Archetype archetype, float x, float y, float angle, boolean shadow) {
    List<Ready> sprites = of(archetype);
    for (int i = 0; i < sprites.size(); i++) {
      Ready r = sprites.get(i);
      paint(r, archetype.appearance().rgb(), 1, shadow);
      if (r.sprite.isTiled()) {
        for (Shape shape : archetype.shapes()) {
          tile(batch, r, shape, x, y, angle);
        }
      } else {
        int frame = r.sprite.frame(0, seconds, 0);
        draw(batch, r, r.picture, frame, x, y, angle, false, false);
      }
    }
  }

  private void paint(Ready r, int rgb, float alpha, boolean shadow) {
    if (shadow) {
      color.set(UiColours.SHADOW).a *= alpha;
      return;
    }
    UiColours.shade(r.sprite.rgb(), 1, alpha, color);
    if (r.sprite.isTinted()) {
      float red = color.r;
      float green = color.g;
      float blue = color.b;
      UiColours.shade(rgb, 1, alpha, color).mul(red, green, blue, 1);
    }
  }

  private void draw(
      SpriteBatch batch,
      Ready r,
      Texture picture,
      int frame,
      float x,
      float y,
      float angle,
      boolean mirrorX,
      boolean mirrorY) {
    float cos = MathUtils.cos(angle);
    float sin = MathUtils.sin(angle);
    float ox = mirrorX ? -r.sprite.offsetX() : r.sprite.offsetX();
    float oy = mirrorY ? -r.sprite.offsetY() : r.sprite.offsetY();
    float u = frame / (float) r.sprite.frames();
    float u2 = (frame + 1f) / r.sprite.frames();
    box(
        batch,
        picture,
        x + cos * ox - sin * oy,
        y + sin * ox + cos * oy,
        cos,
        sin,
        r.width / 2,
        r.height / 2,
        mirrorX ? u2 : u,
        mirrorX ? u : u2,
        mirrorY ? 0 : 1,
        mirrorY ? 1 : 0);
  }

  private void tile(SpriteBatch batch, Ready r, Shape shape, float x, float y, float angle) {
    float cos = MathUtils.cos(angle);
    float sin = MathUtils.sin(angle);
    for (Convex part : shape.parts()) {
      if (part instanceof Box box) {
        float w = box.halfWidth();
        float h = box.halfHeight();
        box(
            batch,
            r.picture,
            x + cos * box.centerX() - sin * box.centerY(),
            y + sin * box.centerX() + cos * box.centerY(),
            cos,
            sin,
            w,
            h,
            0,
            2 * w / r.width,
            2 * h / r.height,
            0);
      }
    }
  }

  /** Draws a part of a picture over a box; v is that of its lower edge, v2 that of its upper. */
  private void box(
      SpriteBatch batch,
      Texture picture,
      float x,
      float y,
      float cos,
      float sin,
      float halfWidth,
      float halfHeight,
      float u,
      float u2,
      float v,
      float v2) {
    float bits = color.toFloatBits();
    for (int corner = 0; corner < 4; corner++) {
      boolean right = corner == 2 || corner == 3;
      boolean top = corner == 1 || corner == 2;
      float px = right ? halfWidth : -halfWidth;
      float py = top ? halfHeight : -halfHeight;
      int at = corner * 5;
      quad[at] = x + cos * px - sin * py;
      quad[at + 1] = y + sin * px + cos * py;
      quad[at + 2] = bits;
      quad[at + 3] = right ? u2 : u;
      quad[at + 4] = top ? v2 : v;
      if (bend != null) {
        float bentX = bend.m00 * quad[at] + bend.m01 * quad[at + 1] + bend.m02;
        quad[at + 1] = bend.m10 * quad[at] + bend.m11 * quad[at + 1] + bend.m12;
        quad[at] = bentX;
      }
    }
    batch.draw(picture, quad, 0, VERTICES);
  }

  // ---- backgrounds

  /** Draws the backgrounds over all of the picture. */
  void backgrounds(SpriteBatch batch, OrthographicCamera camera) {
    List<Background> all = look.setup().backgrounds();
    for (int i = 0; i < all.size(); i++) {
      Texture picture = pictures.of(all.get(i).file());
      if (picture != null) {
        background(batch, all.get(i), picture, camera);
      }
    }
  }

  private void background(SpriteBatch batch, Background b, Texture picture, OrthographicCamera c) {
    float height = b.height();
    float width = height * picture.getWidth() / picture.getHeight();
    float left = c.position.x - c.viewportWidth / 2;
    float bottom = c.position.y - c.viewportHeight / 2;
    float viewHeight = c.viewportHeight;
    // How far the layer stays behind the level.
    double lagX = c.position.x * (1 - b.parallax()) + b.driftX() * seconds;
    double lagY = c.position.y * (1 - b.parallax()) + b.driftY() * seconds;
    float u = (float) ((left - lagX) / width % 1);
    color.set(1, 1, 1, b.alpha());
    if (Float.isNaN(b.bottom())) {
      float v = (float) ((bottom - lagY) / height % 1);
      box(
          batch,
          picture,
          c.position.x,
          c.position.y,
          1,
          0,
          c.viewportWidth / 2,
          viewHeight / 2,
          u,
          u + c.viewportWidth / width,
          1 - v,
          1 - v - viewHeight / height);
    } else {
      float y = (float) (b.bottom() + lagY) + height / 2;
      float u2 = u + c.viewportWidth / width;
      box(batch, picture, c.position.x, y, 1, 0, c.viewportWidth / 2, height / 2, u, u2, 1, 0);
    }
  }
}
