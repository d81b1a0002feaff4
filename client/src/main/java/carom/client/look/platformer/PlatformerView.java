package carom.client.look.platformer;

import carom.client.field.FieldView;
import carom.client.look.Action;
import carom.client.look.GameView;
import carom.client.look.HudCanvas;
import carom.client.look.HudItem;
import carom.client.look.Particles;
import carom.client.look.Reaction;
import carom.client.look.Shake;
import carom.client.look.SoundFile;
import carom.client.look.ViewSetup;
import carom.client.view.ClientView;
import carom.game.platformer.PlatformerFields;
import carom.game.platformer.PlatformerGame;
import carom.game.platformer.Runs;
import carom.sim.entity.Input;
import carom.sim.level.Level;
import java.util.Locale;

/**
 * The look of {@code PlatformerGame}: its shapes as they are before hills, with a moment for each
 * coin, blow and fall, the times of runs, and the ghost of the best one.
 */
public final class PlatformerView implements GameView {
  private static final String SMOKE = "/carom/client/look/rockets/smoke.png";
  private static final int GHOST = 0xcfe8ff;
  private static final Particles DUST =
      Particles.burst(8)
          .picture(SMOKE)
          .speed(0.5f, 2.5f)
          .drag(3)
          .seconds(0.2f, 0.5f)
          .size(0.15f, 0.5f)
          .colour(0xf0ead8, 0xc9bfa5)
          .alpha(0.4f);
  private static final Particles GLITTER =
      Particles.burst(14)
          .speed(1, 5)
          .drag(3)
          .seconds(0.2f, 0.6f)
          .size(0.12f, 0.02f)
          .colour(0xffffff, 0xffd166)
          .glow();
  private static final Particles GOLD =
      Particles.burst(60)
          .speed(3, 12)
          .drag(2)
          .seconds(0.5f, 1.2f)
          .size(0.16f, 0.04f)
          .gravity(0.5f)
          .colour(0xfff3b0, 0xff9a2e)
          .glow();
  private static final Particles BITS =
      Particles.burst(18)
          .picture("/carom/client/look/rockets/scrap.png")
          .speed(2, 8)
          .drag(1.5f)
          .seconds(0.4f, 0.9f)
          .size(0.25f, 0.1f)
          .gravity(1)
          .colour(0xd0a8f0, 0x6d597a);
  private static final Particles STARS =
      Particles.burst(16)
          .speed(3, 9)
          .drag(2.5f)
          .seconds(0.2f, 0.5f)
          .size(0.14f, 0.03f)
          .colour(0xffffff, 0xef476f)
          .glow();

  /** Creates the view, for the service loader. */
  public PlatformerView() {}

  @Override
  public String game() {
    return "platformer";
  }

  @Override
  public void setUp(ViewSetup v) {
    v.actions(
        Action.moveX("left", "right").keys("A", "D").keys("Left", "Right").stick("left"),
        Action.button("jump", Input.JUMP).key("Space", "W", "Up").pad("A"),
        Action.button("drop through planks", Input.DOWN).key("S", "Down").pad("B"));
    v.background("/carom/client/look/shooter/clouds.png")
        .height(8)
        .parallax(0.08f)
        .drifts(0.4f, 0)
        .standsAt(14);
    v.event("jump", sound("shooter/jump").volume(0.4f), DUST);
    v.event("coin", sound("cars/ring").volume(0.4f), GLITTER);
    v.event("flag", sound("cars/lap"), GOLD);
    v.event("fall", sound("shooter/out").volume(0.6f), STARS, Shake.by(0.2f));
    v.event("checkpoint", sound("cars/gate").volume(0.6f), GLITTER);
    v.event("stomp", sound("playground/boing"), BITS, new Reaction().squash(0.5f));
    v.event("hurt", sound("shooter/hit"), STARS, Shake.by(0.3f), new Reaction().flash(0xffffff));
    v.event("goal", sound("cars/lap"), GOLD);
    v.event("best", sound("cars/flip"), GOLD, GLITTER);
    v.hud(
        HudItem.time("safe", PlatformerFields.HURT)
            .whileSet(PlatformerFields.HURT)
            .at(HudItem.Place.TOP));
    v.minimap(HudItem.Place.BOTTOM_RIGHT);
    v.paint(PlatformerView::paint);
    v.camera().height(17).lead(0.35f);
  }

  private static SoundFile sound(String name) {
    return SoundFile.of("/carom/client/look/" + name + ".wav");
  }

  // ---- over the picture

  /** Draws the times, and while the player runs the ghost of the best run. */
  private static void paint(HudCanvas c, ClientView view) {
    if (!view.knowsFields() || view.playerId() < 0) {
      return;
    }
    FieldView match = view.match();
    FieldView player = view.player(view.playerId());
    int left = player.get(PlatformerFields.RUN);
    float seconds = Runs.LIMIT_SECONDS - left / (float) view.tickRate();
    float y = c.height() - 96;
    if (left > 0) {
      c.text("run " + time(seconds), 16, y, 0xffffff);
      ghost(c, match, view.level().bounds(), seconds);
    }
    line(c, "own best", player.get(PlatformerFields.OWN_BEST), y - 20);
    line(c, "best here", match.get(PlatformerFields.BEST_RUN), y - 40);
  }

  private static void line(HudCanvas c, String what, int ms, float y) {
    if (ms > 0) {
      c.text(what + " " + time(ms / 1_000f), 16, y, GHOST);
    }
  }

  private static String time(float seconds) {
    return String.format(Locale.ROOT, "%.2f s", seconds);
  }

  private static void ghost(HudCanvas c, FieldView match, Level.Bounds bounds, float seconds) {
    float at = seconds * Runs.SAMPLES_PER_SECOND;
    int sample = (int) at;
    if (sample + 1 >= match.get(PlatformerFields.BEST_LENGTH)) {
      return;
    }
    int from = match.get(PlatformerFields.BEST_PATH, sample);
    int to = match.get(PlatformerFields.BEST_PATH, sample + 1);
    float share = at - sample;
    float x = Runs.x(from, bounds) + share * (Runs.x(to, bounds) - Runs.x(from, bounds));
    float y = Runs.y(from, bounds) + share * (Runs.y(to, bounds) - Runs.y(from, bounds));
    float halfWidth = PlatformerGame.PLAYER_WIDTH / 2;
    float halfHeight = PlatformerGame.PLAYER_HEIGHT / 2;
    float x1 = c.screenX(x - halfWidth, y);
    float x2 = c.screenX(x + halfWidth, y);
    float y1 = c.screenY(x, y - halfHeight);
    float y2 = c.screenY(x, y + halfHeight);
    c.rect(x1, y1, x2 - x1, y2 - y1, GHOST, 0.35f);
    c.disc((x1 + x2) / 2, y2, (x2 - x1) / 2, GHOST, 0.35f);
  }
}
