package carom.client.look.platformer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.look.HudCanvas;
import carom.client.look.ViewSetup;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.sim.level.Level;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Goal: the ghost runs as the best run did. Method: a player who runs to the goal again and again,
 * always alike, so that the ghost is where the player is; a canvas that notes what is drawn.
 */
final class PlatformerViewTest {
  private static final String LEVEL =
      """
      {"name": "t", "game": "platformer", "gravity": [0, -26],
       "bounds": {"min": [-30, -6], "max": [30, 30]},
       "spawns": [{"at": [-18, 0.8]}],
       "zones": [{"name": "start", "min": [-20, 0], "max": [-15, 4]},
                 {"name": "goal", "min": [10, 0], "max": [14, 4]}],
       "statics": [{"at": [0, -1], "shape": {"type": "box", "width": 40, "height": 2}}]}
      """;

  /** Notes rectangles and texts; a point is a metre. */
  private static final class Notes implements HudCanvas {
    final List<Float> middles = new ArrayList<>();
    final List<String> texts = new ArrayList<>();

    @Override
    public float width() {
      return 60;
    }

    @Override
    public float height() {
      return 36;
    }

    @Override
    public float screenX(float x, float y) {
      return x;
    }

    @Override
    public float screenY(float x, float y) {
      return y;
    }

    @Override
    public void rect(float x, float y, float w, float h, int rgb, float alpha) {
      middles.add(x + w / 2);
    }

    @Override
    public void disc(float x, float y, float radius, int rgb, float alpha) {}

    @Override
    public void line(float x1, float y1, float x2, float y2, float w, int rgb, float alpha) {}

    @Override
    public void text(String text, float x, float y, int rgb) {
      texts.add(text);
    }

    @Override
    public void title(String text, float x, float y, int rgb) {}

    @Override
    public float textWidth(String text) {
      return 0;
    }

    @Override
    public float titleWidth(String text) {
      return 0;
    }

    @Override
    public void picture(String file, float x, float y, float w, float h) {}
  }

  @Test
  void theGhostIsWhereTheBestRunWas() throws Exception {
    ViewSetup view = new ViewSetup();
    new PlatformerView().setUp(view);
    Level level = Level.parse("t.json", LEVEL.getBytes(StandardCharsets.UTF_8));
    try (Stepper stepper = Stepper.of(level, ServerConfig.defaults())) {
      SimulatedClient p = stepper.join("p", Impairment.NONE, (v, tick, out) -> out.move(1, 0));
      int ghosts = 0;
      List<String> texts = List.of();
      for (int i = 0; i < 150; i++) {
        stepper.run(0.1);
        Notes notes = new Notes();
        view.painter().paint(notes, p.view());
        if (!notes.middles.isEmpty() && p.view().own() != null) {
          assertEquals(p.view().own().x(), notes.middles.get(0), 0.8f, "i=" + i);
          ghosts++;
          texts = notes.texts;
        }
      }
      assertTrue(ghosts > 40, "ghosts=" + ghosts);
      assertEquals(3, texts.size(), texts.toString());
      assertTrue(texts.get(0).startsWith("run "), texts.toString());
      assertEquals(texts.get(1).replace("own best", ""), texts.get(2).replace("best here", ""));
    }
  }
}
