package carom.client.desktop.game;

import carom.client.EventListener;
import carom.client.desktop.hud.Hud;
import carom.client.desktop.paint.Canvas;
import carom.client.desktop.paint.UiColours;
import carom.client.desktop.paint.ViewCamera;
import carom.sim.event.EventKind;
import carom.sim.outbox.Event;
import com.badlogic.gdx.graphics.Color;
import com.badlogic.gdx.math.MathUtils;
import java.util.function.Predicate;

/**
 * Visual effects of events: a ring that opens and a word that rises, as the event's kind says. So
 * the window shows the events of any game. Render thread only.
 */
final class Flashes implements EventListener {
  private static final int FLASHES = 64;
  private static final float RING_SECONDS = 0.45f;
  private static final float LABEL_SECONDS = 1.4f;
  private static final float RISE_M_S = 1.2f;

  private final Event[] events = new Event[FLASHES];
  private final float[] age = new float[FLASHES];
  private final Color color = new Color();
  private final Predicate<EventKind> ringless;
  private int next;

  /** Creates effects; {@code ringless} says for which events something else shows than a ring. */
  Flashes(Predicate<EventKind> ringless) {
    this.ringless = ringless;
    for (int i = 0; i < FLASHES; i++) {
      events[i] = new Event();
      age[i] = LABEL_SECONDS;
    }
  }

  @Override
  public void happened(Event event, boolean predicted) {
    if (event.kind().radius() == 0 && event.kind().label().isEmpty()) {
      return;
    }
    events[next].set(event);
    age[next] = 0;
    next = (next + 1) % FLASHES;
  }

  @Override
  public void retracted(Event event) {
    for (int i = 0; i < FLASHES; i++) {
      if (age[i] < LABEL_SECONDS && events[i].tick() == event.tick() && events[i].isLike(event)) {
        age[i] = LABEL_SECONDS;
        return;
      }
    }
  }

  /** Lets the flashes fade. */
  void age(float seconds) {
    for (int i = 0; i < FLASHES; i++) {
      age[i] = Math.min(LABEL_SECONDS, age[i] + seconds);
    }
  }

  /** Draws the rings. */
  void draw(Canvas canvas) {
    for (int i = 0; i < FLASHES; i++) {
      float left = 1 - age[i] / RING_SECONDS;
      if (left > 0 && events[i].kind().radius() > 0 && !ringless.test(events[i].kind())) {
        float radius = events[i].kind().radius() * (1 - left * left);
        canvas.ring(
            events[i].x(),
            events[i].y(),
            radius,
            0.05f + 0.2f * left * Math.min(1, radius),
            UiColours.shade(events[i].kind().rgb(), 1, left, color));
      }
    }
  }

  /** Writes the words; between begin and end of the hud's batch. */
  void label(Hud hud, ViewCamera camera) {
    for (int i = 0; i < FLASHES; i++) {
      if (age[i] < LABEL_SECONDS && !events[i].kind().label().isEmpty()) {
        UiColours.shade(events[i].kind().rgb(), 1, 1 - age[i] / LABEL_SECONDS, color);
        float y = events[i].y() + RISE_M_S * age[i];
        float size = MathUtils.clamp(events[i].kind().radius(), 0.5f, 4);
        hud.label(events[i].kind().label(), hud.at(camera, events[i].x(), y), size >= 2, color);
      }
    }
  }
}
