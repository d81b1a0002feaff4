package carom.client.desktop.game;

import carom.client.look.Reaction;
import carom.client.look.ViewSetup;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import com.badlogic.gdx.math.Affine2;
import com.badlogic.gdx.math.MathUtils;
import com.badlogic.gdx.math.Vector2;

/** Keeps how struck bodies react, see {@link Reaction}. Render thread only. */
final class Reactions {
  /** Time in which a body that was held catches up, seconds. */
  private static final float CATCH_UP_SECONDS = 0.1f;

  /** Farthest from its place that a body is held, metres. */
  private static final float MAX_HELD_M = 2;

  /** Number of times that a squeezed body springs. */
  private static final float SPRINGS = 1.5f;

  private static final float FADE = 4;

  /** The reaction of one body. */
  static final class Shown extends SeenEntities.Seen {
    private Reaction reaction;
    private float share;
    private float age;
    private float normalX;
    private float normalY;
    private float heldX;
    private float heldY;

    /** Begins a reaction at a place, to a blow along a normal. */
    void begin(Reaction of, float x, float y, float blowX, float blowY, float hard) {
      boolean unit = Vector2.len2(blowX, blowY) > 0.5f;
      reaction = of;
      share = hard;
      age = 0;
      normalX = unit ? blowX : 0;
      normalY = unit ? blowY : 1;
      heldX = x;
      heldY = y;
    }

    /** Lets time pass. */
    void age(float delta) {
      age += delta;
    }

    /**
     * Returns how far along the blow it is squeezed now, a share of its size; below 0 stretched.
     */
    float squash() {
      if (reaction == null || age >= reaction.seconds()) {
        return 0;
      }
      float over = age / reaction.seconds();
      double spring = Math.exp(-FADE * over) * Math.cos(MathUtils.PI2 * SPRINGS * over);
      return (float) (reaction.squash() * share * spring);
    }

    /** Returns how bright it is lit up now, 0..1. */
    float flash() {
      return reaction == null || reaction.flashRgb() < 0
          ? 0
          : Math.max(0, 1 - age / reaction.seconds());
    }

    /** Returns the colour in which it is lit up, 0xRRGGBB. */
    int flashRgb() {
      return reaction.flashRgb();
    }

    /** Returns the part of the way back to where it was struck by which it is drawn there, 0..1. */
    private float back() {
      float late = reaction == null ? CATCH_UP_SECONDS : age - reaction.hold();
      return reaction == null || reaction.hold() == 0
          ? 0
          : MathUtils.clamp(1 - late / CATCH_UP_SECONDS, 0, 1);
    }

    /** Returns how far from its place it is drawn, metres. */
    private float moveX(float x) {
      return back() * MathUtils.clamp(heldX - x, -MAX_HELD_M, MAX_HELD_M);
    }

    /** Returns how far from its place it is drawn, metres. */
    private float moveY(float y) {
      return back() * MathUtils.clamp(heldY - y, -MAX_HELD_M, MAX_HELD_M);
    }

    /** Returns whether it is drawn elsewhere or squeezed now. */
    boolean isBent() {
      return squash() != 0 || back() != 0;
    }

    /**
     * Returns the way from a place of the body, in metres of the level, to where it is drawn: moved
     * back to where it was struck, and squeezed around the body's place along the blow, longer
     * across it, so that it keeps its size.
     */
    Affine2 bend(float x, float y, Affine2 out) {
      float squash = squash();
      float wider = 1 / (1 - squash);
      float less = 1 - squash - wider;
      out.m00 = wider + less * normalX * normalX;
      out.m01 = less * normalX * normalY;
      out.m10 = out.m01;
      out.m11 = wider + less * normalY * normalY;
      out.m02 = x + moveX(x) - out.m00 * x - out.m01 * y;
      out.m12 = y + moveY(y) - out.m10 * x - out.m11 * y;
      return out;
    }
  }

  private final SeenEntities<Shown> bodies = new SeenEntities<>(Shown::new);
  private boolean any;

  /** Forgets all, for another look or level. */
  void begin(ViewSetup setup) {
    bodies.clear();
    any = setup.effects().stream().anyMatch(Reaction.class::isInstance);
  }

  /** Lets time pass; call it once per picture. */
  void update(ClientView view, float seconds) {
    if (!any) {
      return;
    }
    bodies.nextFrame();
    for (int i = 0; i < view.entityCount(); i++) {
      Drawn body = view.entity(i);
      Shown shown = of(body);
      if (shown.isNew()) {
        shown.reaction = null;
      }
      shown.age(seconds);
    }
  }

  /** Returns what a body shows; null if the look has no reactions. */
  Shown of(Drawn body) {
    return any ? bodies.see(body.id(), body.generation()) : null;
  }

  /**
   * Lets a body react.
   *
   * @param normalX unit vector along which it was pushed
   * @param normalY unit vector along which it was pushed
   * @param share how hard, 0..1
   */
  void react(Reaction reaction, Drawn body, float normalX, float normalY, float share) {
    Shown shown = body == null ? null : of(body);
    if (shown != null) {
      shown.begin(reaction, body.x(), body.y(), normalX, normalY, share);
    }
  }
}
