package carom.game;

import carom.physics.Collision;
import carom.physics.Joint;
import carom.physics.WorldDef;
import carom.sim.Game;
import carom.sim.MatchClock;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Cooldown;
import carom.sim.field.Field;
import carom.sim.level.Level;
import carom.sim.match.MatchPhase;
import carom.sim.message.Emote;
import carom.sim.message.Message;
import carom.sim.message.PlayerRole;
import java.util.List;
import java.util.Objects;

/**
 * Guards a game, so that its exceptions stop nothing. A callback that throws is reported, and the
 * step goes on as if it had returned. What the callback changed before it threw stays, so that a
 * run with failures is as repeatable as any other.
 *
 * <p>Set-up is not guarded: a game that cannot be set up must not start.
 */
public final class GuardedGame implements Game {
  /** Receives failures. */
  @FunctionalInterface
  public interface Watch {
    /**
     * Receives the failure of a callback.
     *
     * @param callback its name, and the player or entity it was called for
     * @param s the simulation that called it
     * @param failure what it threw
     */
    void failed(String callback, Simulation s, Throwable failure);
  }

  /** What a player is told whose wish made the game fail. */
  private static final String FAILED = "That is not possible now.";

  private final Game game;
  private final Watch watch;

  /**
   * Guards a game.
   *
   * @param game the game to guard
   * @param watch receives each failure, during the step
   */
  public GuardedGame(Game game, Watch watch) {
    this.game = game;
    this.watch = watch;
  }

  @Override
  public String name() {
    return game.name();
  }

  @Override
  public String defaultLevel() {
    return game.defaultLevel();
  }

  @Override
  public String description() {
    return game.description();
  }

  @Override
  public WorldDef world(Level level) {
    return game.world(level);
  }

  @Override
  public List<Field<?>> fields() {
    return game.fields();
  }

  @Override
  public boolean keepsMore() {
    return game.keepsMore();
  }

  @Override
  public boolean relaysAhead() {
    return game.relaysAhead();
  }

  @Override
  public boolean looksBack() {
    return game.looksBack();
  }

  @Override
  public void setUp(Simulation s) {
    game.setUp(s);
  }

  @Override
  public int maxPlayers() {
    return game.maxPlayers();
  }

  @Override
  public List<String> teams() {
    return game.teams();
  }

  @Override
  public String refuseTeam(Simulation s, Player p, int team) {
    try {
      return game.refuseTeam(s, p, team);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      watch.failed("refuseTeam of player " + p.id(), s, e);
      return FAILED;
    }
  }

  @Override
  public void teamChanged(Simulation s, Player p) {
    try {
      game.teamChanged(s, p);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      watch.failed("teamChanged of player " + p.id(), s, e);
    }
  }

  @Override
  public String refuseRole(Simulation s, Player p, PlayerRole role) {
    try {
      return game.refuseRole(s, p, role);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      watch.failed("refuseRole of player " + p.id(), s, e);
      return FAILED;
    }
  }

  @Override
  public void join(Simulation s, Player p) {
    try {
      game.join(s, p);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      watch.failed("join of player " + p.id(), s, e);
    }
  }

  @Override
  public void leave(Simulation s, Player p) {
    try {
      game.leave(s, p);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      watch.failed("leave of player " + p.id(), s, e);
    }
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    try {
      game.input(s, p, in);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      watch.failed("input of player " + p.id(), s, e);
    }
  }

  @Override
  public void message(Simulation s, Player p, Message m) {
    try {
      game.message(s, p, m);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      watch.failed("message " + m.kind().name() + " of player " + p.id(), s, e);
    }
  }

  @Override
  public String chat(Simulation s, Player p, String text) {
    try {
      return game.chat(s, p, text);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      watch.failed("chat of player " + p.id(), s, e);
      return null; // unfiltered, it might say what the game would not allow
    }
  }

  @Override
  public boolean mayFollow(Simulation s, Player watcher, Player player) {
    try {
      return game.mayFollow(s, watcher, player);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      watch.failed("mayFollow of player " + watcher.id(), s, e);
      return false;
    }
  }

  @Override
  public boolean emote(Simulation s, Player p, Emote emote) {
    try {
      return game.emote(s, p, emote);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      watch.failed("emote of player " + p.id(), s, e);
      return false;
    }
  }

  @Override
  public void forces(Simulation s, Entity e) {
    try {
      game.forces(s, e);
    } catch (RuntimeException | AssertionError | StackOverflowError failure) {
      watch.failed("forces of " + e, s, failure);
    }
  }

  @Override
  public List<Cooldown> cooldowns() {
    return game.cooldowns();
  }

  @Override
  public MatchClock clock() {
    return game.clock();
  }

  @Override
  public void phase(Simulation s, MatchPhase now) {
    try {
      game.phase(s, now);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      watch.failed("phase " + now.text(), s, e);
    }
  }

  @Override
  public void beforeStep(Simulation s) {
    try {
      game.beforeStep(s);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      watch.failed("beforeStep", s, e);
    }
  }

  @Override
  public void afterStep(Simulation s) {
    try {
      game.afterStep(s);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      watch.failed("afterStep", s, e);
    }
  }

  @Override
  public boolean collision(Simulation s, Collision<Entity> c) {
    try {
      return game.collision(s, c);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      watch.failed("collision", s, e);
      return true;
    }
  }

  @Override
  public void hit(Simulation s, Collision<Entity> c) {
    try {
      game.hit(s, c);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      watch.failed("hit", s, e);
    }
  }

  @Override
  public void broke(Simulation s, Joint<Entity> joint) {
    try {
      game.broke(s, joint);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      watch.failed("broke of " + joint, s, e);
    }
  }

  @Override
  public Audience audience(Simulation s, Entity e) {
    try {
      return Objects.requireNonNull(game.audience(s, e), "audience");
    } catch (RuntimeException | AssertionError | StackOverflowError failure) {
      watch.failed("audience of " + e, s, failure);
      return Audience.NOBODY;
    }
  }

  @Override
  public boolean seesAll(Simulation s, Player p) {
    try {
      return game.seesAll(s, p);
    } catch (RuntimeException | AssertionError | StackOverflowError | LinkageError e) {
      watch.failed("seesAll of player " + p.id(), s, e);
      return false;
    }
  }
}
