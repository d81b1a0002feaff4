package carom.server;

import carom.fixtures.PlainGame;
import carom.sim.Match;
import carom.sim.Skill;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.field.Scope;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/**
 * A game in which a player earns a coin in each tick that it holds the action. The match knows what
 * each account has earned in it, so both must agree for ever.
 */
final class EarnGame extends PlainGame {
  static final int ACCOUNTS = 4;
  static final Count COINS = Field.count("coins").of(Scope.ACCOUNT).to(Audience.ALL);
  static final Count PAID = Field.count("paid").of(Scope.MATCH).to(Audience.NOBODY).times(ACCOUNTS);

  EarnGame() {
    super("earn");
  }

  static Level level() {
    try {
      return Level.parse(
          "earn",
          """
          { "name": "earn", "game": "earn", "gravity": [0, 0],
            "bounds": { "min": [-10, -10], "max": [10, 10] } }
          """
              .getBytes(StandardCharsets.UTF_8));
    } catch (LevelException e) {
      throw new AssertionError(e);
    }
  }

  @Override
  public Skill skill() {
    return Skill.of(COINS).within(4).widening(1);
  }

  @Override
  public List<Field<?>> fields() {
    return List.of(COINS, PAID);
  }

  @Override
  public void afterStep(Match m) {
    for (Player p : m.players()) {
      if (m.input(p).held(Input.ACTION) && !p.account().isEmpty()) {
        p.add(COINS, 1);
        m.add(PAID, Integer.parseInt(p.account()), 1);
      }
    }
  }
}
