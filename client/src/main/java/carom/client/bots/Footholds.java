package carom.client.bots;

import carom.client.view.ClientView;
import carom.sim.level.Level;
import java.util.Arrays;

/**
 * The places of a level where a player can stand, a metre apart, and the shortest ways between
 * them. Made of the level's static geometry when a match begins; one bot's.
 */
final class Footholds {
  private static final int MOST = 400;
  private static final float HALF_HEIGHT = 0.7f; // of a player

  /** Cost of a way that isn't there. */
  static final float UNREACHED = 1e6f;

  private final ClientView view;
  private final float rise;
  private final float reach;
  private float[] x = new float[MOST];
  private float[] y = new float[MOST];
  private int count;
  private final float[][] cost; // [from][to]
  private final float[] left; // cost from each to the goal
  private final float[] spent; // cost from one to each
  private final boolean[] done;
  private int goal = -1;

  /** Looks for footholds in the level that is shown, see {@link Hopper}. */
  Footholds(ClientView view, float rise, float reach) {
    this.view = view;
    this.rise = rise;
    this.reach = reach;
    Level.Bounds b = view.level().bounds();
    for (float column = b.minX() + 0.5f; column < b.maxX(); column += 1) {
      boolean above = true; // the stretch above is free
      for (float top = b.maxY(); top > b.minY() && count < MOST; top -= 0.5f) {
        boolean free = !view.isWall(column, top, 0, -0.5f);
        if (above && !free) {
          add(column, top);
        }
        above = free;
      }
    }
    x = Arrays.copyOf(x, count);
    y = Arrays.copyOf(y, count);
    cost = new float[count][count];
    left = new float[count];
    spent = new float[count];
    done = new boolean[count];
    for (int from = 0; from < count; from++) {
      for (int to = 0; to < count; to++) {
        cost[from][to] = cost(from, to);
      }
    }
  }

  /** Adds the ground between a height and half a metre below, if a player fits above. */
  private void add(float column, float top) {
    float length = 0.5f;
    for (float half = 0.25f; half > 0.01f; half /= 2) {
      length += view.isWall(column, top, 0, half - length) ? -half : 0;
    }
    float ground = top - length;
    boolean fits = !view.isSolid(column, ground + 0.1f, 0, 2 * HALF_HEIGHT);
    boolean wide =
        view.isWall(column - 0.4f, ground + 0.3f, 0, -0.7f)
            && view.isWall(column + 0.4f, ground + 0.3f, 0, -0.7f);
    if (fits && wide) {
      x[count] = column;
      y[count++] = ground;
    }
  }

  /** Returns what a way costs without a stop, in metres, or {@link #UNREACHED}. */
  private float cost(int from, int to) {
    float dx = Math.abs(x[to] - x[from]);
    float up = y[to] - y[from];
    if (dx < 1.1f && Math.abs(up) < 0.7f) {
      return dx;
    }
    if (up > rise || dx > reach - 0.8f * Math.max(0, up) || isBlocked(from, to)) {
      return UNREACHED;
    }
    return 2 + dx + Math.abs(up);
  }

  /** Returns whether something solid is in the way of a jump: up, over, and down. */
  private boolean isBlocked(int from, int to) {
    float over = Math.max(y[from], y[to]) + 2 * HALF_HEIGHT;
    float start = y[from] + HALF_HEIGHT;
    float end = y[to] + HALF_HEIGHT;
    return view.isSolid(x[from], start, 0, over - start)
        || view.isSolid(x[from], over, x[to] - x[from], 0)
        || view.isSolid(x[to], over, 0, end - over);
  }

  int count() {
    return count;
  }

  float x(int foothold) {
    return x[foothold];
  }

  float y(int foothold) {
    return y[foothold];
  }

  /** Returns the foothold nearest to a point; those above it count as further; -1 without any. */
  int nearest(float px, float py) {
    int best = -1;
    float least = Float.MAX_VALUE;
    for (int i = 0; i < count; i++) {
      float dx = x[i] - px;
      float dy = y[i] - py;
      float far = dx * dx + dy * dy * (dy > 0.3f ? 6 : 1);
      if (far < least) {
        least = far;
        best = i;
      }
    }
    return best;
  }

  /** Returns the highest foothold, of several the one nearest to a point. */
  int highest(float px) {
    int best = 0;
    for (int i = 1; i < count; i++) {
      float higher = y[i] - y[best];
      boolean nearer = Math.abs(x[i] - px) < Math.abs(x[best] - px);
      if (higher > 0.1f || (higher > -0.1f && nearer)) {
        best = i;
      }
    }
    return best;
  }

  /** Returns the next foothold on the way to a goal; the same if it is there or there is no way. */
  int next(int from, int to) {
    if (to != goal) {
      goal = to;
      measure(left, to, true);
    }
    int best = from;
    float least = from == to ? 0 : UNREACHED;
    for (int i = 0; i < count; i++) {
      float whole = cost[from][i] + left[i];
      if (i != from && whole < least) {
        least = whole;
        best = i;
      }
    }
    return best;
  }

  /** Measures the ways from a foothold to all, for {@link #way}. */
  void measureFrom(int from) {
    measure(spent, from, false);
  }

  /** Returns what the way to a foothold costs, metres and more; {@link #UNREACHED} without one. */
  float way(int to) {
    return spent[to];
  }

  /** Measures the ways from all to one, or from one to all (Dijkstra). */
  private void measure(float[] ways, int end, boolean towards) {
    Arrays.fill(ways, UNREACHED);
    Arrays.fill(done, false);
    ways[end] = 0;
    for (int round = 0; round < count; round++) {
      int nearest = -1;
      for (int i = 0; i < count; i++) {
        if (!done[i] && (nearest < 0 || ways[i] < ways[nearest])) {
          nearest = i;
        }
      }
      done[nearest] = true;
      for (int i = 0; i < count; i++) {
        float step = towards ? cost[i][nearest] : cost[nearest][i];
        ways[i] = Math.min(ways[i], step + ways[nearest]);
      }
    }
  }
}
