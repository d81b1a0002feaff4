package carom.lab.mixed;

import carom.sim.Game;
import carom.sim.Match;
import carom.sim.entity.Entity;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.Map;

/** Keeps where all bodies were in the server's last ticks. The room writes, any thread reads. */
final class ServerStates {
  private static final int KEPT = 300;

  private final ArrayDeque<State> states = new ArrayDeque<>();
  private final Map<Integer, Pose> last = new HashMap<>();

  /**
   * A body.
   *
   * @param sinceTick tick since which it is there
   */
  record Pose(float x, float y, float angle, int sinceTick) {}

  /** A tick. */
  record State(int tick, Map<Integer, Pose> bodies) {}

  /** Returns a game that does what another one does, and notes the bodies after each step. */
  Game watch(Game game) {
    return (Game)
        Proxy.newProxyInstance(
            Game.class.getClassLoader(),
            new Class<?>[] {Game.class},
            (proxy, method, arguments) -> {
              Object result = call(game, method, arguments);
              if (method.getName().equals("afterStep")) {
                note((Match) arguments[0]);
              }
              return result;
            });
  }

  private static Object call(Game game, Method method, Object[] arguments) throws Throwable {
    try {
      return method.invoke(game, arguments);
    } catch (InvocationTargetException e) {
      throw e.getCause();
    }
  }

  private synchronized void note(Match match) {
    Map<Integer, Pose> bodies = new HashMap<>();
    for (Entity e : match.entities()) {
      if (!e.isLevel()) {
        Pose before = last.get(e.id());
        boolean moved =
            before == null
                || before.x() != e.x()
                || before.y() != e.y()
                || before.angle() != e.angle();
        bodies.put(e.id(), moved ? new Pose(e.x(), e.y(), e.angle(), match.tick()) : before);
      }
    }
    last.clear();
    last.putAll(bodies);
    states.addLast(new State(match.tick(), bodies));
    if (states.size() > KEPT) {
      states.removeFirst();
    }
  }

  /** Returns the state of a tick, or null if it isn't kept. */
  synchronized State at(int tick) {
    for (State state : states) {
      if (state.tick() == tick) {
        return state;
      }
    }
    return null;
  }

  /** Returns the newest state, or null. */
  synchronized State newest() {
    return states.peekLast();
  }
}
