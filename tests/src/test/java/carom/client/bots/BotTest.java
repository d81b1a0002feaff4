package carom.client.bots;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.sim.entity.Input;
import org.junit.jupiter.api.Test;

/**
 * Goal: a bot plays on in each match. Method: ticks that begin anew, as after a change of level.
 */
final class BotTest {
  @Test
  void aBotDecidesAgainAtOnceWhenTheNextMatchBeginsAtTickZero() {
    Bot bot = new Bot(7, true);
    for (int tick = 0; tick < 20_000; tick++) {
      bot.sample(null, tick, new Input());
    }
    int changes = 0;
    Input before = new Input();
    bot.sample(null, 0, before);
    for (int tick = 1; tick < 1_000; tick++) {
      Input now = new Input();
      bot.sample(null, tick, now);
      changes += now.moveX() != before.moveX() || now.moveY() != before.moveY() ? 1 : 0;
      before = now;
    }
    assertTrue(changes >= 4, "changes of direction in 1,000 ticks: " + changes);
  }
}
