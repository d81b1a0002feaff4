package carom.game;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.sim.Game;
import java.lang.reflect.Method;
import org.junit.jupiter.api.Test;

class GuardedGameTest {
  /** A default method of Game that isn't handed on would silently replace the game's own. */
  @Test
  void everyMethodOfAGameIsHandedOn() throws Exception {
    for (Method method : Game.class.getMethods()) {
      Method guarded = GuardedGame.class.getMethod(method.getName(), method.getParameterTypes());
      assertEquals(GuardedGame.class, guarded.getDeclaringClass(), method.getName());
    }
  }
}
