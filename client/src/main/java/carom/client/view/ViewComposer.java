package carom.client.view;

import carom.client.interpolation.DecodedHistory;
import carom.client.interpolation.Interpolator;
import carom.client.interpolation.Pose;
import carom.client.interpolation.Sample;
import carom.client.interpolation.VisualError;
import carom.client.prediction.Prediction;
import carom.net.snapshot.EntityHistory;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.frame.Ownership;
import carom.sim.SimulationHost;
import carom.sim.level.Archetype;
import carom.sim.outbox.Event;
import carom.sim.spawn.Origin;
import java.util.Arrays;

/**
 * Composes the entities of a client's view at a moment: each one as interpolated in the past, as
 * predicted in the present, or a blend of both.
 *
 * <p>Nothing jumps unless the server teleported it. An entity that appears fades in where it is;
 * one that goes fades out where it was. Sometimes the picture would have to change at once: a guess
 * was wrong, a late state changed the path, the clock jumped, or the prediction ended. Then the
 * difference is kept as a {@link VisualError} and fades.
 *
 * <p>One client's, for one stay in a game; allocates once for each slot that is ever seen.
 */
public final class ViewComposer {
  private static final float FADE_IN_SECONDS = 0.15f;
  private static final float FADE_OUT_SECONDS = 0.12f;

  /** Fastest blend: a larger change of the prediction's weight per second is a jump. */
  private static final float WEIGHT_PER_SECOND = 12;

  /** Largest error of the drawn moment beyond a tenth of the time passed; more is a jump, ticks. */
  private static final double MOMENT_SLACK = 3;

  /** The picture of one slot. */
  private static final class SlotPicture {
    boolean shown;

    /**
     * True if the entity is gone in the present and therefore hidden in the past, where it still
     * is.
     */
    boolean ghost;

    int generation;
    int teleports;
    int ownerId;
    Archetype archetype;
    float alpha;
    float weight;

    /** As interpolated. */
    final Sample interpolated = new Sample();

    /** Pose as drawn, without {@link #error}. */
    final Pose base = new Pose();

    final VisualError error = new VisualError();
  }

  private final ClientView view;
  private final SnapshotDecoder decoder;
  private final SimulationHost simulation;
  private final Prediction prediction;
  private final Interpolator interpolator;
  private final DecodedHistory states = new DecodedHistory();
  private final JointComposer joints;

  /** The slot as interpolated at the moment that is composed. */
  private final Sample past = new Sample();

  /** The slot as interpolated at the moment that was composed last, by what is known now. */
  private final Sample before = new Sample();

  private final Pose blended = new Pose();
  private SlotPicture[] tracks = {};
  private boolean composed;
  private long composedNs;
  private double composedTick;
  private double renderTick;
  private float seconds;
  private float fraction;
  private boolean jumped;
  private boolean joining;

  /**
   * Creates a composer of an empty picture.
   *
   * @param view receives the entities
   * @param decoder provides the histories
   * @param simulation provides the archetypes
   * @param prediction provides the present; null if nothing is predicted
   * @param tickRate the server's ticks per second
   */
  public ViewComposer(
      ClientView view,
      SnapshotDecoder decoder,
      SimulationHost simulation,
      Prediction prediction,
      int tickRate) {
    this.view = view;
    this.decoder = decoder;
    this.simulation = simulation;
    this.prediction = prediction;
    interpolator = new Interpolator(tickRate);
    joints = new JointComposer(view, decoder.tables(), prediction == null ? null : simulation);
  }

  /**
   * Composes a moment.
   *
   * @param nowNs the present
   * @param newTick the server's tick at which interpolated entities are drawn
   * @param newFraction how much of the newest predicted tick has passed, 0..1
   * @param isJoining whether the client has just joined: then entities don't fade in
   * @param own the own body
   */
  public void compose(
      long nowNs, double newTick, float newFraction, boolean isJoining, OwnState own) {
    view.clear();
    seconds = composed ? Math.max(0, (nowNs - composedNs) * 1e-9f) : 0;
    double expected = seconds * view.tickRate;
    jumped =
        composed && Math.abs(newTick - composedTick - expected) > 0.1 * expected + MOMENT_SLACK;
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
        compose(slot, history, own);
      }
    }
    view.endSlots();
    composeUntold();
    joints.compose();
    composed = true;
    composedNs = nowNs;
    composedTick = newTick;
  }

  /** Adds what the own input has spawned and no record tells yet. */
  private void composeUntold() {
    for (int i = 0; prediction != null && i < prediction.pictures(); i++) {
      int id = prediction.pictureId(i);
      int generation = prediction.pictureGeneration(i);
      if (!isOwnSpawn(id, generation) || isTold(id, generation)) {
        continue;
      }
      ClientView.Drawn drawn = view.add();
      drawn.alpha = prediction.readPicture(i, fraction, drawn.pose);
      if (drawn.alpha == 0) {
        view.removeLast();
        continue;
      }
      drawn.id = id;
      drawn.generation = generation;
      drawn.archetype = prediction.pictureArchetype(i);
      drawn.ownerId = prediction.player().id();
      drawn.predicted = 1;
    }
  }

  private boolean isOwnSpawn(int id, int generation) {
    return Origin.isProvisional(id)
        || prediction.spawns().origin(Event.key(id, generation)) != Origin.NONE;
  }

  private boolean isTold(int id, int generation) {
    EntityHistory history = id < decoder.slotLimit() ? decoder.history(id) : null;
    return history != null && history.size() > 0 && history.generation(0) == generation;
  }

  private void compose(int slot, EntityHistory history, OwnState own) {
    SlotPicture track = tracks[slot];
    interpolator.sample(states.of(history), renderTick, past);
    ClientView.Drawn drawn = view.add();
    int generation = history.generation(0);
    float weight =
        prediction == null || !history.alive()
            ? 0
            : prediction.readPose(slot, generation, fraction, drawn.pose);
    boolean visible = past.exists() || weight > 0;
    boolean hidden = prediction != null && prediction.hides(slot, generation);
    visible &= !hidden;
    if (track != null && (hidden || !history.alive())) {
      track.ghost |= hidden || track.weight > 0.5f;
      visible &= !track.ghost;
    }
    int identity = weight > 0 || !past.exists() ? 0 : past.index;
    Archetype archetype = visible ? simulation.archetypes().get(history.archetype(identity)) : null;
    if (archetype != null && weight > 0) {
      archetype = prediction.archetype(slot, generation);
    }
    if (archetype == null) {
      fadeOut(slot, track, drawn);
      return;
    }
    if (track == null) {
      track = new SlotPicture();
      tracks[slot] = track;
    }
    if (weight == 0) {
      drawn.pose.set(past.pose);
    } else if (weight < 1 && isSamePath(history, past.index)) {
      blended.set(past.pose);
      blended.blend(drawn.pose, weight);
      drawn.pose.set(blended);
    }
    boolean fresh = !track.shown || track.generation != history.generation(identity);
    if (fresh || track.teleports != history.teleports(identity)) {
      track.error.clear();
    } else {
      smooth(track, history, weight, drawn.pose);
    }
    if (fresh) {
      boolean wasDrawn = weight == 1 && isOwnSpawn(slot, generation); // as a provisional one
      track.alpha = joining || wasDrawn ? 1 : 0;
    } else {
      track.alpha = Math.min(1, track.alpha + seconds / FADE_IN_SECONDS);
    }
    remember(track, history, identity, archetype, weight);
    track.interpolated.set(past);
    track.base.set(drawn.pose);
    show(slot, track, drawn);
    track.error.addTo(drawn.pose);
    if (slot == own.slot() && drawn.generation == own.generation()) {
      view.markLastAsOwn();
    }
  }

  /** Returns whether a past state leads to the newest: same entity, no teleport in between. */
  private static boolean isSamePath(EntityHistory history, int index) {
    return index != Sample.NONE
        && history.generation(index) == history.generation(0)
        && history.teleports(index) == history.teleports(0);
  }

  private static void remember(
      SlotPicture track, EntityHistory history, int identity, Archetype archetype, float weight) {
    track.shown = true;
    track.ghost = false;
    track.generation = history.generation(identity);
    track.teleports = history.teleports(identity);
    track.ownerId = Ownership.player(history.ownership(identity));
    track.archetype = archetype;
    track.weight = weight;
  }

  private static void show(int slot, SlotPicture track, ClientView.Drawn drawn) {
    drawn.id = slot;
    drawn.generation = track.generation;
    drawn.archetype = track.archetype;
    drawn.ownerId = track.ownerId;
    drawn.predicted = track.weight;
    drawn.alpha = track.alpha;
  }

  /** Turns what would change at once into a visual error. */
  private void smooth(SlotPicture track, EntityHistory history, float weight, Pose present) {
    track.error.fade(seconds);
    float blended = WEIGHT_PER_SECOND * seconds + 0.1f;
    if (Math.abs(weight - track.weight) > blended || (jumped && weight < 1)) {
      track.error.add(
          track.base.x - present.x,
          track.base.y - present.y,
          Pose.wrap(track.base.angle - present.angle));
      return;
    }
    Sample last = track.interpolated;
    if (!past.exists() || weight == 1 || !last.exists() || !isNewPath(last, past)) {
      return;
    }
    interpolator.sample(states, composedTick, before);
    if (before.exists()
        && history.generation(before.index) == history.generation(past.index)
        && history.teleports(before.index) == history.teleports(past.index)) {
      float share = 1 - weight;
      track.error.add(
          share * (last.pose.x - before.pose.x),
          share * (last.pose.y - before.pose.y),
          share * Pose.wrap(last.pose.angle - before.pose.angle));
    }
  }

  /** Returns whether the path drawn last isn't part of the path known now. */
  private static boolean isNewPath(Sample last, Sample now) {
    if (now.fromTick == last.fromTick && now.toTick == last.toTick) {
      return false;
    }
    return last.toTick == Sample.NONE || now.fromTick < last.toTick;
  }

  /** Shows an entity that is gone a little longer, on its last course. */
  private void fadeOut(int slot, SlotPicture track, ClientView.Drawn drawn) {
    if (track != null && track.shown) {
      track.alpha -= seconds / FADE_OUT_SECONDS;
      track.shown = track.alpha > 0;
    }
    if (track == null || !track.shown) {
      view.removeLast();
      return;
    }
    track.weight = 0;
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
