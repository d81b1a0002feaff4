package carom.client.bots;

import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.game.shooter.ShooterFields;
import carom.game.shooter.ShooterGame;
import carom.game.shooter.Weapon;
import carom.net.transport.Impairment;
import carom.server.config.ServerConfig;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.SimulationHost;
import carom.sim.entity.Entity;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;
import carom.testkit.Stepper;
import java.util.Locale;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: bots of {@code shooter} play it. Method: whole matches of a strong bot against a weak one
 * on a usual line, in virtual time. {@code -Dcarom.matches=10} plays as many on each level and
 * requires eight wins; docs/games/SHOOTER.md has the figures.
 */
final class ShooterBotTest {
  private static final int MATCHES = Integer.getInteger("carom.matches", 1);
  private static final Impairment LINE =
      Impairment.NONE.withLatency(25, 2).withLoss(0.5).withSeed(Stepper.SEED);

  /** What happened in a match. */
  private static final class Played {
    int winner;
    double seconds;
    int happened;
    double longestQuiet;
    double longestStuck;

    @Override
    public String toString() {
      return String.format(
          Locale.ROOT,
          "winner=%d seconds=%.0f events=%d quiet=%.1f stuck=%.1f",
          winner,
          seconds,
          happened,
          longestQuiet,
          longestStuck);
    }
  }

  /** What a player was a moment ago. */
  private static final class Watched {
    private int damage;
    private int lives = ShooterGame.LIVES;
    private Weapon weapon = Weapon.PISTOL;
    private int ammo;
    private float x;
    private float y;
    private double movedAt;

    /** Returns whether the player was hit, took something or was knocked out. */
    boolean look(HostPlayer p, double now) {
      boolean happened =
          p.get(ShooterFields.DAMAGE) != damage
              || p.get(ShooterFields.LIVES) != lives
              || p.get(ShooterFields.WEAPON).ordinal() > weapon.ordinal()
              || p.get(ShooterFields.AMMO) > ammo;
      damage = p.get(ShooterFields.DAMAGE);
      lives = p.get(ShooterFields.LIVES);
      weapon = p.get(ShooterFields.WEAPON);
      ammo = p.get(ShooterFields.AMMO);
      float bodyX = p.isAlive() ? p.entity().x() : Float.NaN; // NaN is always elsewhere
      float bodyY = p.isAlive() ? p.entity().y() : Float.NaN;
      if (!(Math.hypot(bodyX - x, bodyY - y) < 1)) {
        x = bodyX;
        y = bodyY;
        movedAt = now;
      }
      return happened;
    }
  }

  private static Played play(Level level, long seed, Strength first, Strength second) {
    Played played = new Played();
    try (Stepper stepper = Stepper.of(level, ServerConfig.defaults())) {
      Strength[] strengths = {first, second};
      for (int i = 0; i < 2; i++) {
        stepper.add("b" + i, LINE.withSeed(i), new Bot(seed + i, new ShooterBrain(strengths[i])));
        stepper.run(0.3); // so that ids are in this order
      }
      SimulationHost s = stepper.room().simulation();
      Watched[] watched = {new Watched(), new Watched()};
      while (MatchClock.phase(s) != MatchPhase.PLAYING) {
        stepper.step(5);
      }
      double begin = stepper.nowNs() / 1e9;
      double lastAt = begin;
      int pieces = 0;
      while (MatchClock.isPlaying(s)) {
        stepper.step(5);
        double now = stepper.nowNs() / 1e9;
        for (int i = 0; i < 2; i++) {
          if (watched[i].look(s.player(i), now)) {
            played.happened++;
            lastAt = now;
          }
          played.longestStuck = Math.max(played.longestStuck, now - watched[i].movedAt);
        }
        int left = cover(s);
        if (left < pieces) {
          played.happened++;
          lastAt = now;
        }
        pieces = left;
        played.longestQuiet = Math.max(played.longestQuiet, now - lastAt);
        played.seconds = now - begin;
      }
      played.winner = MatchClock.winner(s);
    }
    return played;
  }

  /** Returns how much of what breaks is left. */
  private static int cover(SimulationHost s) {
    int count = 0;
    for (Entity e : s.entities()) {
      count += e.get(ShooterFields.COVER) > 0 ? 1 : 0;
    }
    return count;
  }

  @ParameterizedTest
  @ValueSource(strings = {"shooter", "towers"})
  void theStrongBeatTheWeakAndNobodyIsBoredOrStuck(String name) throws Exception {
    int won = 0;
    for (int i = 0; i < MATCHES; i++) {
      boolean strongFirst = i % 2 == 0; // neither seat is the better one
      Strength first = strongFirst ? Strength.STRONG : Strength.WEAK;
      Strength second = strongFirst ? Strength.WEAK : Strength.STRONG;
      Played played = play(Level.builtIn(name), Stepper.SEED + 10L * i, first, second);
      if (MATCHES > 1) {
        System.out.println(name + " " + i + " " + played);
      }
      won += played.winner == (strongFirst ? 0 : 1) ? 1 : 0;
      assertTrue(played.longestQuiet <= 10, played.toString());
      assertTrue(played.longestStuck <= 5, played.toString());
    }
    assertTrue(won >= Math.ceil(0.8 * MATCHES), "won=" + won + " of " + MATCHES);
  }
}
