package carom.client;

import carom.client.interpolation.HistoryStates;
import carom.client.interpolation.Interpolator;
import carom.client.interpolation.Pose;
import carom.client.interpolation.VisualError;
import carom.client.prediction.Prediction;
import carom.net.snapshot.EntityHistory;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.snapshot.exact.OwnState;
import carom.sim.Simulation;
import carom.sim.level.Archetype;
import java.util.Arrays;

/**
 * Fills a client's view with what is visible at a moment: each entity as interpolated in the past,
 * as predicted in the present, or between.
 *
 * <p>Nothing jumps but what was teleported. What comes into sight fades in where it is, what goes
 * fades out where it was. Where the picture has to change at once, because a guess turned out
 * wrong, a late state changed the way, the clock jumped or the prediction ended, the difference is
 * shown on and fades ({@link VisualError}).
 *
 * <p>One client's, for one stay in a game; allocates once for each slot that is ever seen.
 */
final class Painter {
  private static final float FADE_IN_SECONDS = 0.15f;
  private static final float FADE_OUT_SECONDS = 0.12f;

  /** A change of the predicted share by more than this per second is no blend, but a jump. */
  private static final float SHARE_PER_SECOND = 12;

  /** The drawn moment runs by a tenth faster or slower than time at most; more is a jump, ticks. */
  private static final double MOMENT_SLACK = 3;

  /** The picture of one slot. */
  private static final class Track {
    boolean shown;

    /** Gone in the present, so it isn't shown in the past, where it still is, either. */
    boolean ghost;

    int generation;
    int teleports;
    int ownerId;
    Archetype archetype;
    float alpha;
    float share;
    boolean sampled;
    int fromTick;
    int toTick;

    /** As interpolated. */
    final Pose way = new Pose();

    /** As drawn, but for {@link #error}. */
    final Pose base = new Pose();

    final VisualError error = new VisualError();
  }

  private final ClientView view;
  private final SnapshotDecoder decoder;
  private final Simulation simulation;
  private final Prediction prediction;
  private final Interpolator interpolator;
  private final HistoryStates states = new HistoryStates();
  private final Pose pose = new Pose();
  private final Pose then = new Pose();
  private Track[] tracks = {};
  private boolean painted;
  private long paintedNs;
  private double paintedTick;
  private double renderTick;
  private float seconds;
  private float fraction;
  private boolean jumped;
  private boolean joining;

  /**
   * Starts with an empty picture.
   *
   * @param view is filled in
   * @param decoder has the histories
   * @param simulation knows the kinds of entities
   * @param prediction knows the present, or null
   * @param tickRate the server's ticks per second
   */
  Painter(
      ClientView view,
      SnapshotDecoder decoder,
      Simulation simulation,
      Prediction prediction,
      int tickRate) {
    this.view = view;
    this.decoder = decoder;
    this.simulation = simulation;
    this.prediction = prediction;
    interpolator = new Interpolator(tickRate);
  }

  /**
   * Paints a moment.
   *
   * @param nowNs the present
   * @param newTick the server's tick that is drawn of what is interpolated
   * @param newFraction how much of the newest predicted tick has passed, 0..1
   * @param isJoining whether what is new is only new to us: it doesn't fade in
   * @param own the own body
   */
  void paint(long nowNs, double newTick, float newFraction, boolean isJoining, OwnState own) {
    view.clear();
    seconds = painted ? Math.max(0, (nowNs - paintedNs) * 1e-9f) : 0;
    double expected = seconds * view.tickRate;
    jumped = painted && Math.abs(newTick - paintedTick - expected) > 0.1 * expected + MOMENT_SLACK;
    renderTick = newTick;
    fraction = newFraction;
    joining = isJoining;
    int limit = decoder.slotLimit();
    if (limit > tracks.length) {
      tracks = Arrays.copyOf(tracks, Math.max(64, Math.max(limit, 2 * tracks.length)));
    }
    for (int slot = 0; slot < limit; slot++) {
      EntityHistory history = decoder.history(slot);
      if (history != null && history.size() > 0) {
        paint(slot, history, own);
      }
    }
    painted = true;
    paintedNs = nowNs;
    paintedTick = newTick;
  }

  private void paint(int slot, EntityHistory history, OwnState own) {
    Track track = tracks[slot];
    int index = interpolator.sample(states.of(history), renderTick, pose);
    ClientView.Drawn drawn = view.add();
    int generation = history.generation(0);
    float share =
        prediction == null || !history.alive()
            ? 0
            : prediction.drawn(slot, generation, fraction, drawn.pose);
    boolean visible = index >= 0 || share > 0;
    if (track != null && !history.alive()) {
      track.ghost |= track.share > 0.5f;
      visible &= !track.ghost;
    }
    int identity = share > 0 || index < 0 ? 0 : index;
    Archetype archetype = visible ? simulation.archetypes().get(history.archetype(identity)) : null;
    if (archetype == null) {
      leave(slot, track, drawn);
      return;
    }
    if (track == null) {
      track = new Track();
      tracks[slot] = track;
    }
    if (share == 0) {
      drawn.pose.set(pose);
    } else if (share < 1 && isSameWay(history, index)) {
      pose.blend(drawn.pose, share);
      drawn.pose.set(pose);
      interpolator.sample(states, renderTick, pose);
    }
    boolean fresh = !track.shown || track.generation != history.generation(identity);
    if (fresh || track.teleports != history.teleports(identity)) {
      track.error.clear();
    } else {
      glide(track, history, index, share, drawn.pose);
    }
    if (fresh) {
      track.alpha = joining ? 1 : 0;
    } else {
      track.alpha = Math.min(1, track.alpha + seconds / FADE_IN_SECONDS);
    }
    remember(track, history, identity, archetype, share);
    track.sampled = index >= 0;
    track.fromTick = interpolator.fromTick();
    track.toTick = interpolator.toTick();
    track.way.set(pose);
    track.base.set(drawn.pose);
    show(slot, track, drawn);
    track.error.addTo(drawn.pose);
    if (slot == own.slot() && drawn.generation == own.generation()) {
      view.own(view.lastIndex());
    }
  }

  /** Whether a state of the past leads to the present one: the same entity, not put elsewhere. */
  private static boolean isSameWay(EntityHistory history, int index) {
    return index >= 0
        && history.generation(index) == history.generation(0)
        && history.teleports(index) == history.teleports(0);
  }

  private static void remember(
      Track track, EntityHistory history, int identity, Archetype archetype, float share) {
    track.shown = true;
    track.ghost = false;
    track.generation = history.generation(identity);
    track.teleports = history.teleports(identity);
    track.ownerId = history.owner(identity);
    track.archetype = archetype;
    track.share = share;
  }

  private static void show(int slot, Track track, ClientView.Drawn drawn) {
    drawn.id = slot;
    drawn.generation = track.generation;
    drawn.archetype = track.archetype;
    drawn.ownerId = track.ownerId;
    drawn.predicted = track.share;
    drawn.alpha = track.alpha;
  }

  /** Keeps on showing what the picture would lose or gain at once. */
  private void glide(Track track, EntityHistory history, int index, float share, Pose present) {
    track.error.fade(seconds);
    float blended = SHARE_PER_SECOND * seconds + 0.1f;
    if (Math.abs(share - track.share) > blended || (jumped && share < 1)) {
      track.error.add(
          track.base.x - present.x,
          track.base.y - present.y,
          Pose.wrap(track.base.angle - present.angle));
      return;
    }
    if (index < 0 || share == 1 || !track.sampled || !isSurprise(track)) {
      return;
    }
    int from = interpolator.fromTick();
    int to = interpolator.toTick();
    int before = interpolator.sample(states, paintedTick, then);
    if (before >= 0
        && history.generation(before) == history.generation(index)
        && history.teleports(before) == history.teleports(index)) {
      float weight = 1 - share;
      track.error.add(
          weight * (track.way.x - then.x),
          weight * (track.way.y - then.y),
          weight * Pose.wrap(track.way.angle - then.angle));
    }
    if (from != interpolator.fromTick() || to != interpolator.toTick()) {
      interpolator.sample(states, renderTick, then); // leave it as it was
    }
  }

  /** Whether the way that was drawn last isn't part of the way that is known now. */
  private boolean isSurprise(Track track) {
    int from = interpolator.fromTick();
    int to = interpolator.toTick();
    if (from == track.fromTick && to == track.toTick) {
      return false;
    }
    return track.toTick == Interpolator.NONE || from < track.toTick;
  }

  /** Shows what is gone a little longer, going on as it went. */
  private void leave(int slot, Track track, ClientView.Drawn drawn) {
    if (track != null && track.shown) {
      track.alpha -= seconds / FADE_OUT_SECONDS;
      track.shown = track.alpha > 0;
    }
    if (track == null || !track.shown) {
      view.dropLast();
      return;
    }
    track.share = 0;
    track.error.fade(seconds);
    float ahead = seconds * track.alpha;
    track.base.x += track.base.vx * ahead;
    track.base.y += track.base.vy * ahead;
    track.base.angle += track.base.omega * ahead;
    drawn.pose.set(track.base);
    track.error.addTo(drawn.pose);
    show(slot, track, drawn);
  }
}
