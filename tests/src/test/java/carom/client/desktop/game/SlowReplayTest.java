package carom.client.desktop.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.stats.NetStatsRecorder;
import carom.client.view.ClientView;
import carom.client.view.ViewWriter;
import carom.game.GamesTest;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.event.EventKind;
import carom.sim.level.Archetype;
import carom.sim.outbox.Event;
import org.junit.jupiter.api.Test;

/**
 * Goal: a goal of the arena is seen again, slower, and nobody who plays is disturbed. Method: a
 * view whose ball goes 6 m/s to the right, 60 pictures a second, in virtual time.
 */
final class SlowReplayTest {
  private static final float FRAME = 1 / 60f;

  private final ViewWriter writer = new ViewWriter(new NetStatsRecorder().stats());
  private final ClientView view = writer.view();
  private final SimulationHost s = GamesTest.start("arena", 1, Role.AUTHORITY);
  private final Archetype ball = s.archetypes().find("ball");
  private final SlowReplay slow;
  private float x;
  private boolean hasBall = true;

  SlowReplayTest() {
    ShownLook look = new ShownLook(told -> {});
    look.show("arena");
    slow = new SlowReplay(look);
    slow.begin();
  }

  /** Draws a picture of the game; returns where its ball is seen, or NaN. */
  private float picture(boolean mayShow) {
    x += 6 * FRAME;
    writer.clear();
    writer.add(3, 1, ball, -1, 1, 0).set(-5, 0, 0, 0, 0, 0);
    if (hasBall) {
      writer.add(7, 1, ball, -1, 1, 0).set(x, 0, 0, 6, 0, 0);
    }
    slow.update(view, FRAME, mayShow);
    float[] seen = {Float.NaN};
    slow.during(view, () -> seen[0] = view.entityCount() < 2 ? Float.NaN : view.entity(1).x());
    assertEquals(hasBall ? 2 : 1, view.entityCount(), "the present is there again");
    assertEquals(hasBall ? x : -5, view.entity(view.entityCount() - 1).x());
    return seen[0];
  }

  /** Plays until a goal, and on until its slow motion may begin; returns where the ball was. */
  private float goal(boolean mayShow) {
    for (int i = 0; i < 120; i++) {
      assertEquals(x + 6 * FRAME, picture(mayShow), 1e-4f, "live");
    }
    float at = x;
    hasBall = false;
    slow.happened(event("goal"));
    while (!slow.isOn() && x < at + 6) {
      picture(mayShow);
    }
    return at;
  }

  private Event event(String kind) {
    int index = 0;
    while (!s.eventKinds().get(index).name().equals(kind)) {
      index++;
    }
    EventKind of = s.eventKinds().get(index);
    return new Event().set(of, 1, Event.NONE, Event.NONE, Event.NONE, x, 0, 1, 0);
  }

  @Test
  void theLastSecondIsSeenAgainAtItsSpeedAndTheEventHappensInIt() {
    float goalAt = goal(true);
    assertTrue(slow.isOn());
    assertEquals(0.4f, slow.speed());
    float first = picture(true);
    assertEquals(goalAt - 6, first, 0.2f, "a second before");
    float last = first;
    int again = 0;
    int pictures = 1;
    for (; slow.isOn(); pictures++) {
      float now = picture(true);
      if (now < goalAt - 0.2f && slow.isOn()) {
        assertEquals(0.4f * 6 * FRAME, now - last, 0.02f, "between the pictures that were kept");
        last = now;
      }
      again += slow.happensAgain() ? 1 : 0;
    }
    assertEquals(goalAt, last, 0.3f);
    assertEquals(1, again);
    assertEquals(1.6f / 0.4f, pictures * FRAME, 0.1f);
    hasBall = true;
    assertEquals(x + 6 * FRAME, picture(true), "live again");
  }

  @Test
  void whoPlaysSeesNoneAndWhoBeginsToPlaySeesNoMoreOfIt() {
    goal(false);
    assertFalse(slow.isOn());
    picture(true);
    assertFalse(slow.isOn(), "it isn't kept for later");
    hasBall = true;
    goal(true);
    assertTrue(slow.isOn());
    picture(false);
    assertFalse(slow.isOn());
  }

  @Test
  void aKeyEndsIt() {
    goal(true);
    picture(true);
    slow.skip();
    assertFalse(slow.isOn());
    hasBall = true;
    assertEquals(x + 6 * FRAME, picture(true));
  }

  @Test
  void onlyWhatTheLookAsksForIsShownAgain() {
    for (int i = 0; i < 120; i++) {
      picture(true);
    }
    slow.happened(event("dash"));
    for (int i = 0; i < 120; i++) {
      picture(true);
      assertFalse(slow.isOn());
    }
  }
}
