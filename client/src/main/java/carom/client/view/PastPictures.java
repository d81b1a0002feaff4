package carom.client.view;

import carom.client.view.ClientView.Drawn;
import java.util.ArrayList;
import java.util.List;

/**
 * The entities of a view's last pictures, from which a moment of the past is drawn again. It keeps
 * {@value #MOST_PICTURES} pictures at most, and of each the first {@value #MOST_ENTITIES} entities.
 * Joints aren't kept. One thread; no allocation once it has seen as many entities as there are.
 */
public final class PastPictures {
  /** Most pictures that are kept, {@value #PER_SECOND} for each second. */
  public static final int MOST_PICTURES = 240;

  /** Most entities of a picture that are kept. */
  public static final int MOST_ENTITIES = 512;

  private static final int PER_SECOND = 60;

  /** The entities of one picture. */
  private static final class Picture {
    private final List<Drawn> drawn = new ArrayList<>();
    private double at;
    private int count;
    private int ofSlots;
    private int own;

    private void copy(ClientView view, int most) {
      count = Math.min(most, view.entityCount());
      for (int i = 0; i < count; i++) {
        if (i == drawn.size()) {
          drawn.add(new Drawn());
        }
        drawn.get(i).set(view.entity(i));
      }
      ofSlots = Math.min(count, view.slots());
      own = view.ownIndex() < count ? view.ownIndex() : -1;
    }

    /** Returns an entity that was at about this index, or null. */
    private Drawn find(Drawn wanted, int about) {
      if (about < count && isSame(drawn.get(about), wanted)) {
        return drawn.get(about);
      }
      for (int i = 0; i < count; i++) {
        if (isSame(drawn.get(i), wanted)) {
          return drawn.get(i);
        }
      }
      return null;
    }

    private static boolean isSame(Drawn a, Drawn b) {
      return a.id == b.id && a.generation == b.generation;
    }
  }

  private final List<Picture> ring = new ArrayList<>();
  private final Picture present = new Picture();
  private int next;
  private int kept;

  /** Creates an empty past. */
  public PastPictures() {}

  /** Forgets all. */
  public void clear() {
    kept = 0;
  }

  /**
   * Keeps what a view shows, unless a picture was kept just before.
   *
   * @param at the moment, seconds on any clock; never earlier than in the call before
   */
  public void keep(ClientView view, double at) {
    if (kept > 0 && at - picture(kept - 1).at < 0.9 / PER_SECOND) {
      return;
    }
    if (next == ring.size()) {
      ring.add(new Picture());
    }
    Picture picture = ring.get(next);
    picture.copy(view, MOST_ENTITIES);
    picture.at = at;
    next = (next + 1) % MOST_PICTURES;
    kept = Math.min(MOST_PICTURES, kept + 1);
  }

  /** Returns a kept picture, 0 for the oldest. */
  private Picture picture(int i) {
    return ring.get((next - kept + i + MOST_PICTURES) % MOST_PICTURES);
  }

  /**
   * Lets a view show a moment of the past while something runs. A moment before or after all that
   * is kept is the oldest or newest that is; when nothing is, the view shows the present.
   *
   * @param at the moment, on the clock of {@link #keep}
   */
  public void during(ClientView view, double at, Runnable drawn) {
    if (kept == 0) {
      drawn.run();
      return;
    }
    int before = 0;
    while (before + 1 < kept && picture(before + 1).at <= at) {
      before++;
    }
    Picture from = picture(before);
    Picture to = picture(Math.min(before + 1, kept - 1));
    double length = to.at - from.at;
    float share = length <= 0 ? 0 : (float) Math.max(0, Math.min(1, (at - from.at) / length));
    int joints = view.jointCount();
    present.copy(view, Integer.MAX_VALUE);
    show(view, from, to, share);
    try {
      drawn.run();
    } finally {
      show(view, present, present, 0);
      view.joints(joints);
    }
  }

  private static void show(ClientView view, Picture from, Picture to, float share) {
    view.clear();
    for (int i = 0; i < from.count; i++) {
      Drawn shown = view.add();
      shown.set(from.drawn.get(i));
      Drawn later = share == 0 ? null : to.find(shown, i);
      if (later != null) {
        shown.pose.x += share * (later.pose.x - shown.pose.x);
        shown.pose.y += share * (later.pose.y - shown.pose.y);
        float turn = (float) Math.IEEEremainder(later.pose.angle - shown.pose.angle, 2 * Math.PI);
        shown.pose.angle += share * turn;
      }
    }
    view.slots(from.ofSlots, from.own);
  }
}
