package carom.client.interpolation;

/**
 * Interpolates a smooth path through the states that arrived.
 *
 * <ul>
 *   <li>Between two states: the cubic Hermite curve through both positions with both velocities. It
 *       is exact for constant velocity and constant acceleration, and has no corners at the states.
 *   <li>Where velocities and positions don't fit, because of a bounce in between: the straight
 *       line. The curve would swing out.
 *   <li>At a teleport, which the server marks, and at a jump that the velocities don't explain: the
 *       old place until the new state's tick. Nothing slides across the screen.
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

  /** Takes the place of a tick where there is none. */
  public static final int NONE = -1;

  /** Distance, relative to what the velocities explain, beyond which a jump is a teleport. */
  private static final float TELEPORT_FACTOR = 3;

  /** Distance that never is a teleport, metres. */
  private static final float TELEPORT_METRES = 1;

  private static final float STRAIGHT_SECONDS = STRAIGHT_MS * 1e-3f;
  private static final float FADE_SECONDS = (EXTRAPOLATION_MS - STRAIGHT_MS) * 1e-3f;

  private final float tickSeconds;
  private int fromTick = NONE;
  private int toTick = NONE;

  /**
   * Creates an interpolator.
   *
   * @param tickRate the server's ticks per second, at least 1
   */
  public Interpolator(int tickRate) {
    tickSeconds = 1f / tickRate;
  }

  /**
   * Finds where the entity of a slot was at a moment.
   *
   * @param states the known states
   * @param renderTick moment to draw, in ticks of the server
   * @param out receives the pose; unchanged if the result is negative
   * @return index of the last state before that moment, or -1 if the entity did not exist then
   */
  public int sample(StateHistory states, double renderTick, Pose out) {
    int size = states.size();
    int from = 0;
    while (from < size && states.tick(from) > renderTick) {
      from++;
    }
    if (from == size || !states.alive(from)) {
      return -1;
    }
    int to = from - 1;
    fromTick = states.tick(from);
    toTick = to < 0 ? NONE : states.tick(to);
    if (to >= 0
        && states.alive(to)
        && states.generation(to) == states.generation(from)
        && !teleports(states, from, to)) {
      hermite(states, from, to, renderTick, out);
    } else {
      extrapolate(states, from, to < 0 ? renderTick - fromTick : 0, out);
    }
    return from;
  }

  /** Returns the tick of the state before the moment of the last successful {@link #sample}. */
  public int fromTick() {
    return fromTick;
  }

  /** Returns the tick of the state after that moment; {@link #NONE} if it was extrapolated. */
  public int toTick() {
    return toTick;
  }

  private boolean teleports(StateHistory states, int from, int to) {
    if (states.teleports(from) != states.teleports(to)) {
      return true;
    }
    float seconds = (states.tick(to) - states.tick(from)) * tickSeconds;
    float fastest =
        Math.max(length(states.vx(from), states.vy(from)), length(states.vx(to), states.vy(to)));
    float way = length(states.x(to) - states.x(from), states.y(to) - states.y(from));
    return way > TELEPORT_METRES + TELEPORT_FACTOR * fastest * seconds;
  }

  private void extrapolate(StateHistory states, int index, double ticks, Pose out) {
    float ahead = (float) (ticks * tickSeconds);
    float faded = Math.max(0, Math.min(FADE_SECONDS, ahead - STRAIGHT_SECONDS));
    float left = 1 - faded / FADE_SECONDS;
    float seconds = Math.min(ahead, STRAIGHT_SECONDS) + faded * (1 + left) / 2;
    float vx = states.vx(index);
    float vy = states.vy(index);
    float omega = states.omega(index);
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
    float x0 = states.x(from);
    float y0 = states.y(from);
    float vx0 = states.vx(from);
    float vy0 = states.vy(from);
    float vx1 = states.vx(to);
    float vy1 = states.vy(to);
    float dx = states.x(to) - x0;
    float dy = states.y(to) - y0;
    // A velocity that differs from the mean one by more than twice its size belongs to another
    // motion. Slow, coarsely quantised bodies get some slack.
    float slack = 0.05f + 2 * length(dx, dy) / seconds;
    if (length(vx0 - dx / seconds, vy0 - dy / seconds) > slack
        || length(vx1 - dx / seconds, vy1 - dy / seconds) > slack) {
      out.x = x0 + dx * t;
      out.y = y0 + dy * t;
      out.vx = dx / seconds;
      out.vy = dy / seconds;
    } else {
      out.x = x0 + curve(t, dx, vx0 * seconds, vx1 * seconds);
      out.y = y0 + curve(t, dy, vy0 * seconds, vy1 * seconds);
      out.vx = vx0 + (vx1 - vx0) * t;
      out.vy = vy0 + (vy1 - vy0) * t;
    }
    float omega0 = states.omega(from);
    float omega1 = states.omega(to);
    float angle0 = states.angle(from);
    // Angles are known modulo a turn. Takes the turn nearest to what the spin explains.
    float spun = (omega0 + omega1) * 0.5f * seconds;
    float turn = spun + Pose.wrap(states.angle(to) - angle0 - spun);
    if (Math.abs(omega0 * seconds - turn) > 0.1f + 2 * Math.abs(turn)
        || Math.abs(omega1 * seconds - turn) > 0.1f + 2 * Math.abs(turn)) {
      out.angle = angle0 + turn * t;
    } else {
      out.angle = angle0 + curve(t, turn, omega0 * seconds, omega1 * seconds);
    }
    out.omega = omega0 + (omega1 - omega0) * t;
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
