package carom.client.desktop.game;

import carom.client.look.Effect;
import carom.client.look.SlowMotion;
import carom.client.view.ClientView;
import carom.client.view.PastPictures;
import carom.sim.outbox.Event;
import java.util.List;

/**
 * The slow motion of an event that a game's look asks for: it begins a moment after the event, when
 * all has been seen at full speed, and goes on to that moment. Render thread only.
 */
final class SlowReplay {
  /** Time after the event that is shown again, too, seconds. */
  private static final float AFTER_SECONDS = 0.6f;

  private final ShownLook look;
  private final PastPictures past = new PastPictures();
  private final Event event = new Event();
  private SlowMotion motion; // of the event that waits or is shown; null for none
  private double now; // stands still during a replay
  private double happenedAt;
  private double at;
  private boolean isOn;
  private boolean wasOn; // in the last picture
  private boolean isKept; // whether the look asks for it at all
  private boolean isDue;

  SlowReplay(ShownLook look) {
    this.look = look;
  }

  /** Begins with another level or look. */
  void begin() {
    isKept = look.setup().hasSlowMotion();
    clear();
  }

  private void clear() {
    past.clear();
    motion = null;
    isOn = false;
    isDue = false;
  }

  /** Notes an event; one that happens while another waits or is shown has no replay. */
  void happened(Event newEvent) {
    SlowMotion asked = find(newEvent.kind().name());
    if (motion == null && asked != null) {
      motion = asked;
      event.set(newEvent);
      happenedAt = now;
    }
  }

  private SlowMotion find(String kind) {
    List<Effect> effects = look.setup().event(kind);
    for (int i = 0; effects != null && i < effects.size(); i++) {
      if (effects.get(i) instanceof SlowMotion asked) {
        return asked;
      }
    }
    return null;
  }

  /**
   * Lets time pass.
   *
   * @param mayShow whether nobody who plays would be disturbed
   * @return whether a replay has just begun or ended, so that what was seen is another time's
   */
  boolean update(ClientView view, float seconds, boolean mayShow) {
    if (isOn) {
      double before = at;
      at += motion.speed() * seconds;
      isDue = before < happenedAt && at >= happenedAt;
      if (at > now || !mayShow) {
        skip();
      }
    } else if (isKept) {
      now += seconds;
      past.keep(view, now);
      if (motion != null && now >= happenedAt + AFTER_SECONDS) {
        at = happenedAt - motion.seconds();
        isOn = mayShow;
        motion = mayShow ? motion : null;
      }
    }
    boolean changes = isOn != wasOn;
    wasOn = isOn;
    return changes;
  }

  /** Ends a replay, or does nothing. */
  void skip() {
    if (isOn) {
      clear();
    }
  }

  /** Returns whether the picture is one of the past. */
  boolean isOn() {
    return isOn;
  }

  /** Returns how fast time passes in the picture, a share of the game's. */
  float speed() {
    return isOn ? motion.speed() : 1;
  }

  /** Returns what is shown again; valid while {@link #isOn}. */
  Event event() {
    return event;
  }

  /** Returns whether the event happens again in this picture. */
  boolean happensAgain() {
    return isOn && isDue;
  }

  /** Lets a view show what is seen now, while something draws it. */
  void during(ClientView view, Runnable drawn) {
    if (isOn) {
      past.during(view, at, drawn);
    } else {
      drawn.run();
    }
  }
}
