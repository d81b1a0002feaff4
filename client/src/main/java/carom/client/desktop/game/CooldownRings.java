package carom.client.desktop.game;

import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.UiColours;
import carom.client.field.FieldView;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.game.Games;
import carom.sim.field.Cooldown;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.math.MathUtils;
import java.util.List;

/**
 * The waits of the own player as rings around its body, where the eye is: each closes while its
 * wait runs, lights up for a moment, and goes. Render thread only; no allocation per picture.
 */
final class CooldownRings {
  private static final float WIDTH_M = 0.09f;
  private static final float GAP_M = 0.15f;

  /** Radius of the innermost ring, in radii of the body. */
  private static final float INNERMOST = 1.55f;

  private static final float LIT_SECONDS = 0.25f;
  private static final Color[] COLORS = {UiColours.ACCENT, UiColours.INFO, UiColours.GOOD};

  private final Color color = new Color();
  private String gameOf = "";
  private List<Cooldown> cooldowns = List.of();
  private float[] lit = {};

  /**
   * Draws the rings; between begin and end of the canvas.
   *
   * @param seconds since the last picture
   */
  void draw(ClientView view, Canvas canvas, float seconds) {
    if (!view.game().equals(gameOf)) {
      gameOf = view.game();
      cooldowns = Games.create(gameOf).cooldowns();
      lit = new float[cooldowns.size()];
    }
    Drawn own = view.own();
    if (own == null || cooldowns.isEmpty() || !view.knowsFields()) {
      return;
    }
    FieldView player = view.player(own.ownerId());
    for (int i = 0; i < cooldowns.size(); i++) {
      Cooldown cooldown = cooldowns.get(i);
      float left = player.get(cooldown.countdown()) / (cooldown.seconds() * view.tickRate());
      float radius = INNERMOST * WorldPainter.extent(own.archetype()) + i * GAP_M;
      Color tint = COLORS[i % COLORS.length];
      if (left > 0) {
        lit[i] = LIT_SECONDS;
        color.set(tint).a = 0.22f;
        canvas.ring(own.x(), own.y(), radius, WIDTH_M, color);
        float done = MathUtils.clamp(1 - left, 0, 1) * MathUtils.PI2;
        color.a = 0.9f;
        canvas.arc(own.x(), own.y(), radius, WIDTH_M, MathUtils.HALF_PI - done, done, color);
      } else if (lit[i] > 0) {
        color.set(tint).a = lit[i] / LIT_SECONDS;
        canvas.ring(own.x(), own.y(), radius, WIDTH_M, color);
        lit[i] -= seconds;
      }
    }
  }
}
