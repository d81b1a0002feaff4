package carom.client.desktop.game;

import carom.client.EventListener;
import carom.client.desktop.paint.UiColours;
import carom.client.look.Effect;
import carom.client.look.Particles;
import carom.client.look.Reaction;
import carom.client.look.Shake;
import carom.client.look.SoundFile;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.sim.event.EventKind;
import carom.sim.level.Archetype;
import carom.sim.near.Neighbourhood;
import carom.sim.outbox.Event;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.graphics.GL20;
import com.badlogic.gdx.graphics.Texture;
import com.badlogic.gdx.graphics.g2d.SpriteBatch;
import com.badlogic.gdx.math.MathUtils;
import java.util.List;
import java.util.function.ToIntFunction;

/**
 * The particles that a game's look sets off by events, by blows and behind moving bodies. Render
 * thread only; no allocation per picture.
 */
final class LookEffects implements EventListener, BlowListener {
  /** Blow from which on a burst is whole, m/s. */
  private static final float HARD_M_S = 20;

  /** Least share of a burst. */
  private static final float LEAST = 0.2f;

  /** Speed from which on a body leaves a trail, m/s. */
  private static final float MOVES_M_S = 0.5f;

  private final ShownLook look;
  private final LookPictures pictures;
  private final HeardEffects ears;
  private final Sparks sparks = new Sparks();
  private final Tremor tremor = new Tremor();
  private final Reactions reactions;
  private final Color color = new Color();
  private final Color last = new Color();
  private ClientView view; // of the last picture

  LookEffects(ShownLook look, LookPictures pictures, Reactions reactions, HeardEffects ears) {
    this.reactions = reactions;
    this.look = look;
    this.pictures = pictures;
    this.ears = ears;
  }

  /** Returns the shake of the picture. */
  public Tremor tremor() {
    return tremor;
  }

  /** Ends all that flies, for another level. */
  public void clear() {
    sparks.clear();
    tremor.clear();
    reactions.begin(look.setup());
    view = null;
  }

  /** Returns whether an event's particles take the place of its ring. */
  public boolean replacesRing(EventKind kind) {
    return hasParticles(look.setup().event(kind.name()));
  }

  private static boolean hasParticles(List<Effect> effects) {
    for (int i = 0; effects != null && i < effects.size(); i++) {
      if (effects.get(i) instanceof Particles) {
        return true;
      }
    }
    return false;
  }

  @Override
  public void happened(Event event, boolean predicted) {
    float full = event.kind().fullStrength();
    float share = full == 0 ? 1 : MathUtils.clamp(event.strength() / full, LEAST, 1);
    List<Effect> effects = look.setup().event(event.kind().name());
    set(effects, event.x(), event.y(), MathUtils.HALF_PI, share, event.kind().rgb());
    if (event.first() != Event.NONE) {
      react(effects, Neighbourhood.id(event.first()), 0, 1, share);
    }
  }

  @Override
  public boolean blow(int body, Archetype kind, float x, float y, float nx, float ny, float blow) {
    List<Effect> effects = look.setup().blow(kind.name());
    float share = MathUtils.clamp(blow / HARD_M_S, LEAST, 1);
    set(effects, x, y, MathUtils.atan2(ny, nx), share, kind.appearance().rgb());
    react(effects, body, nx, ny, share);
    for (int i = 0; effects != null && i < effects.size(); i++) {
      if (effects.get(i) instanceof SoundFile file) {
        ears.play(file, x, y, share);
      }
    }
    return hasParticles(effects);
  }

  private void react(List<Effect> effects, int body, float nx, float ny, float share) {
    for (int i = 0; effects != null && view != null && i < effects.size(); i++) {
      if (effects.get(i) instanceof Reaction reaction) {
        reactions.react(reaction, view.find(body), nx, ny, share);
      }
    }
  }

  /** Sets off what is seen; the sounds of events are {@code EventSounds}'. */
  private void set(List<Effect> effects, float x, float y, float way, float share, int rgb) {
    for (int i = 0; effects != null && i < effects.size(); i++) {
      if (effects.get(i) instanceof Particles burst) {
        sparks.burst(burst, x, y, way, share, rgb);
      } else if (effects.get(i) instanceof Shake shake) {
        tremor.add(shake, x, y, share);
      }
    }
  }

  /** Lets time pass: particles fly, and moving bodies leave their trails. */
  public void update(ClientView newView, float seconds, ToIntFunction<Drawn> bodyRgb) {
    view = newView;
    reactions.update(view, seconds);
    sparks.fly(view.level().gravityX(), view.level().gravityY(), seconds);
    for (int i = 0; i < view.entityCount(); i++) {
      Drawn body = view.entity(i);
      Particles trail = look.setup().trail(body.archetype().name());
      float vx = body.velocityX();
      float vy = body.velocityY();
      if (trail != null && vx * vx + vy * vy > MOVES_M_S * MOVES_M_S) {
        sparks.stream(trail, body.x(), body.y(), vx, vy, seconds, bodyRgb.applyAsInt(body));
      }
    }
  }

  /** Draws what flies; {@code glowing} ones add their light, the others cover. */
  void draw(SpriteBatch batch, boolean glowing) {
    batch.setBlendFunction(GL20.GL_SRC_ALPHA, glowing ? GL20.GL_ONE : GL20.GL_ONE_MINUS_SRC_ALPHA);
    for (int i = 0; i < Sparks.MOST; i++) {
      Particles of = sparks.kind(i);
      if (of == null || of.isGlowing() != glowing) {
        continue;
      }
      Texture picture = of.picture().isEmpty() ? null : pictures.of(of.picture());
      float over = sparks.over(i);
      UiColours.shade(of.rgbAtFirst() < 0 ? sparks.rgb(i) : of.rgbAtFirst(), 1, 1, color);
      UiColours.shade(of.rgbAtLast() < 0 ? sparks.rgb(i) : of.rgbAtLast(), 1, 1, last);
      color.lerp(last, over);
      color.a = of.alpha() * (1 - over * over);
      batch.setColor(color);
      float size = Math.max(0, of.size(over));
      batch.draw(
          picture == null ? pictures.dot() : picture,
          sparks.x(i) - size,
          sparks.y(i) - size,
          2 * size,
          2 * size);
    }
    batch.setColor(Color.WHITE);
    batch.setBlendFunction(GL20.GL_SRC_ALPHA, GL20.GL_ONE_MINUS_SRC_ALPHA);
  }

  /** Returns the number of particles that fly. */
  public int flying() {
    return sparks.flying();
  }
}
