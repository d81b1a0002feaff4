package carom.client.interpolation;

/**
 * Interpolates a smooth path through the states that arrived. Velocities are derived from poses.
 *
 * <ul>
 *   <li>Between two states: the cubic Hermite curve through both positions with both velocities. It
 *       is exact for constant velocity and constant acceleration, and has corners only where
 *       something hits the body.
 *   <li>Between the states of neighbouring ticks: the straight line, as bodies move within a tick.
 *       A curve would show more of the rounding of poses.
 *   <li>Where velocities and positions don't fit, because of a bounce in between: the straight
 *       line. The curve would swing out.
 *   <li>At a teleport, which the server marks, and at a jump that the ways before and after don't
 *       explain: the old place until the new state's tick. Nothing slides across the screen.
 *   <li>After the newest state: extrapolation, straight on for {@value #STRAIGHT_MS} ms, then ever
 *       slower. After {@value #EXTRAPOLATION_MS} ms the body stands still, because longer guesses
 *       run through walls.
 *   <li>Before the first state: nothing. An entity appears and disappears at the ticks at which it
 *       did on the server.
 * </ul>
 *
 * One thread; allocates nothing.
 */
public final class Interpolator {
  /** Longest extrapolation beyond the newest state, milliseconds. */
  public static final int EXTRAPOLATION_MS = 250;

  /** Time for which an extrapolation keeps its speed, milliseconds. */
  public static final int STRAIGHT_MS = 100;

  /** Distance, relative to what the velocities explain, beyond which a jump is a teleport. */
  private static final float TELEPORT_FACTOR = 3;

  /** Distance that never is a teleport, metres. */
  private static final float TELEPORT_METRES = 1;

  /**
   * Mean speed that no teleport is below, m/s: over a gap of lost states, a body that was hit may
   * go far.
   */
  private static final float TELEPORT_SPEED = 100;

  private static final float STRAIGHT_SECONDS = STRAIGHT_MS * 1e-3f;
  private static final float FADE_SECONDS = (EXTRAPOLATION_MS - STRAIGHT_MS) * 1e-3f;

  private final float tickSeconds;
  private final Velocity velocity;
  private final Velocity before;
  private final Velocity after;

  /**
   * Creates an interpolator.
   *
   * @param tickRate the server's ticks per second, at least 1
   */
  public Interpolator(int tickRate) {
    tickSeconds = 1f / tickRate;
    velocity = new Velocity(tickRate);
    before = new Velocity(tickRate);
    after = new Velocity(tickRate);
  }

  /**
   * Finds where the entity of a slot was at a moment.
   *
   * @param states the known states
   * @param renderTick moment to draw, in ticks of the server
   * @param out receives the sample; the pose is unchanged if the entity did not exist then
   */
  public void sample(StateHistory states, double renderTick, Sample out) {
    int size = states.size();
    int from = 0;
    while (from < size && states.tick(from) > renderTick) {
      from++;
    }
    if (from == size || !states.alive(from)) {
      out.index = Sample.NONE;
      return;
    }
    int to = from - 1;
    out.index = from;
    out.fromTick = states.tick(from);
    out.toTick = to < 0 ? Sample.NONE : states.tick(to);
    if (to >= 0 && Velocity.areLinked(states, from, to) && !jumps(states, from, to)) {
      hermite(states, from, to, renderTick, out.pose);
    } else {
      extrapolate(states, from, to < 0 ? renderTick - out.fromTick : 0, out.pose);
    }
  }

  /** Returns whether the way between two states is longer than those beside it explain. */
  private boolean jumps(StateHistory states, int from, int to) {
    float way = length(states.x(to) - states.x(from), states.y(to) - states.y(from));
    if (way <= TELEPORT_METRES) {
      return false;
    }
    boolean early = Velocity.areLinked(states, from + 1, from);
    boolean late = Velocity.areLinked(states, to, to - 1);
    float fastest =
        Math.max(early ? speed(states, from + 1, from) : 0, late ? speed(states, to, to - 1) : 0);
    float seconds = (states.tick(to) - states.tick(from)) * tickSeconds;
    return way > TELEPORT_METRES + TELEPORT_FACTOR * fastest * seconds
        && way > TELEPORT_SPEED * seconds;
  }

  private float speed(StateHistory states, int older, int newer) {
    float way = length(states.x(newer) - states.x(older), states.y(newer) - states.y(older));
    return way / ((states.tick(newer) - states.tick(older)) * tickSeconds);
  }

  private void extrapolate(StateHistory states, int index, double ticks, Pose out) {
    float ahead = (float) (ticks * tickSeconds);
    float faded = Math.max(0, Math.min(FADE_SECONDS, ahead - STRAIGHT_SECONDS));
    float left = 1 - faded / FADE_SECONDS;
    float seconds = Math.min(ahead, STRAIGHT_SECONDS) + faded * (1 + left) / 2;
    velocity.measure(states, index);
    float vx = velocity.vx;
    float vy = velocity.vy;
    float omega = velocity.omega;
    out.set(
        states.x(index) + vx * seconds,
        states.y(index) + vy * seconds,
        states.angle(index) + omega * seconds,
        vx * left,
        vy * left,
        omega * left);
  }

  private void hermite(StateHistory states, int from, int to, double renderTick, Pose out) {
    int ticks = states.tick(to) - states.tick(from);
    float seconds = ticks * tickSeconds;
    float t = (float) ((renderTick - states.tick(from)) / ticks);
    before.atEnd(states, from, to, from + 1);
    after.atEnd(states, to, from, to - 1);
    velocity.mean(states, from, to);
    float dx = velocity.vx * seconds;
    float dy = velocity.vy * seconds;
    // A velocity that differs from the mean one by more than twice its size belongs to another
    // motion. Slow, coarsely quantised bodies get some slack.
    float slack = 0.05f + 2 * length(velocity.vx, velocity.vy);
    boolean fit =
        length(before.vx - velocity.vx, before.vy - velocity.vy) <= slack
            && length(after.vx - velocity.vx, after.vy - velocity.vy) <= slack;
    out.vx = fit ? before.vx + (after.vx - before.vx) * t : velocity.vx;
    out.vy = fit ? before.vy + (after.vy - before.vy) * t : velocity.vy;
    boolean line = !fit || ticks == 1;
    out.x =
        states.x(from) + (line ? dx * t : curve(t, dx, before.vx * seconds, after.vx * seconds));
    out.y =
        states.y(from) + (line ? dy * t : curve(t, dy, before.vy * seconds, after.vy * seconds));
    float turn = velocity.omega * seconds;
    float turnSlack = 0.1f + 2 * Math.abs(turn);
    boolean turnLine =
        ticks == 1
            || Math.abs(before.omega * seconds - turn) > turnSlack
            || Math.abs(after.omega * seconds - turn) > turnSlack;
    out.angle =
        states.angle(from)
            + (turnLine ? turn * t : curve(t, turn, before.omega * seconds, after.omega * seconds));
    out.omega = before.omega + (after.omega - before.omega) * t;
  }

  /**
   * Evaluates the cubic with value 0, slope {@code m0} at 0 and value {@code d}, slope {@code m1}
   * at 1.
   */
  private static float curve(float t, float d, float m0, float m1) {
    return t * (m0 + t * (3 * d - 2 * m0 - m1 + t * (m0 + m1 - 2 * d)));
  }

  private static float length(float x, float y) {
    return (float) Math.sqrt(x * x + y * y);
  }
}
