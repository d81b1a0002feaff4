package carom.game;

import carom.physics.WorldDef;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.Rules;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.Skill;
import carom.sim.entity.Contact;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityJoint;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Cooldown;
import carom.sim.field.Field;
import carom.sim.field.Gauge;
import carom.sim.level.Level;
import carom.sim.message.Emote;
import carom.sim.message.Message;
import carom.sim.message.PlayerRole;
import carom.sim.outbox.NextMatch;
import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;

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
  public interface FailureListener {
    /**
     * Receives the failure of a callback.
     *
     * @param callback its name, and the player or entity it was called for
     * @param s the simulation that called it
     * @param failure what it threw
     */
    void failed(String callback, Simulation s, Throwable failure);
  }

  /** A callback about a subject, mostly a player, with one more argument. */
  @FunctionalInterface
  private interface Call<M, S, A> {
    void run(Game game, M m, S subject, A argument);
  }

  /** A callback that decides something. */
  @FunctionalInterface
  private interface Question<M, S, A, R> {
    R ask(Game game, M m, S subject, A argument);
  }

  /** Answer to a player whose request made the game fail. */
  private static final String FAILED = "That is not possible now.";

  private static final Question<Match, Object, Object, NextMatch> NEXT =
      (game, s, nothing, none) -> Objects.requireNonNull(game.next(s), "next");

  private static final Question<Match, Entity, Object, Audience> AUDIENCE =
      (game, s, e, none) -> Objects.requireNonNull(game.audience(s, e), "audience");

  private final Game game;
  private final FailureListener listener;

  /**
   * Guards a game.
   *
   * @param game the game to guard
   * @param listener receives each failure, during the step
   */
  public GuardedGame(Game game, FailureListener listener) {
    this.game = game;
    this.listener = listener;
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
  public void setUp(SetUp s) {
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
  public int teamRgb(int team) {
    return game.teamRgb(team);
  }

  @Override
  public boolean ownColours() {
    return game.ownColours();
  }

  @Override
  public List<Gauge> gauges() {
    return game.gauges();
  }

  @Override
  public List<Cooldown> cooldowns() {
    return game.cooldowns();
  }

  @Override
  public Skill skill() {
    return game.skill();
  }

  @Override
  public MatchClock clock() {
    return game.clock();
  }

  @Override
  public String refuseTeam(Match s, Player p, int team) {
    return ask("refuseTeam", s, p, team, Game::refuseTeam, FAILED);
  }

  @Override
  public void teamChanged(Match s, Player p) {
    call("teamChanged", s, p, null, (g, sim, player, none) -> g.teamChanged(sim, player));
  }

  @Override
  public String refuseRole(Match s, Player p, PlayerRole role) {
    return ask("refuseRole", s, p, role, Game::refuseRole, FAILED);
  }

  @Override
  public void begin(Match m) {
    game.begin(m); // like set-up, not guarded
  }

  @Override
  public void join(Match s, Player p) {
    call("join", s, p, null, (g, sim, player, none) -> g.join(sim, player));
  }

  @Override
  public void leave(Match s, Player p) {
    call("leave", s, p, null, (g, sim, player, none) -> g.leave(sim, player));
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    call("input", s, p, in, Game::input);
  }

  @Override
  public void message(Match s, Player p, Message m) {
    call("message " + m.kind().name(), s, p, m, Game::message);
  }

  @Override
  public String chat(Match s, Player p, String text) {
    // A failure sends nothing: unfiltered, the text might say what the game would not allow.
    return ask("chat", s, p, text, Game::chat, null);
  }

  @Override
  public boolean mayFollow(Match s, Player watcher, Player player) {
    return ask("mayFollow", s, watcher, player, Game::mayFollow, false);
  }

  @Override
  public boolean emote(Match s, Player p, Emote emote) {
    return ask("emote", s, p, emote, Game::emote, false);
  }

  @Override
  public Consumer<Rules> rules(Level level) {
    Consumer<Rules> rules = game.rules(level);
    if (rules == null) {
      return null;
    }
    Call<Rules, Void, Void> apply = (g, r, none, nothing) -> rules.accept(r);
    return r -> call("rules", r, null, null, apply);
  }

  @Override
  public void forces(Simulation s, Entity e) {
    call("forces", s, e, null, (g, sim, entity, none) -> g.forces(sim, entity));
  }

  @Override
  public void phase(Match s, MatchPhase now) {
    call("phase " + now.text(), s, null, now, (g, sim, none, phase) -> g.phase(sim, phase));
  }

  @Override
  public NextMatch next(Match s) {
    return ask("next", s, null, null, NEXT, NextMatch.OF_ROTATION);
  }

  @Override
  public void checkpoint(Match s, Player p, float x, float y) {
    call("checkpoint", s, p, null, (g, sim, player, none) -> g.checkpoint(sim, player, x, y));
  }

  @Override
  public void entered(Match s, Entity sensor, Entity visitor) {
    call("entered", s, sensor, visitor, Game::entered);
  }

  @Override
  public void left(Match s, Entity sensor, Entity visitor) {
    call("left", s, sensor, visitor, Game::left);
  }

  @Override
  public void beforeStep(Match s) {
    call("beforeStep", s, null, null, (g, sim, no, none) -> g.beforeStep(sim));
  }

  @Override
  public void afterStep(Match s) {
    call("afterStep", s, null, null, (g, sim, no, none) -> g.afterStep(sim));
  }

  @Override
  public boolean collision(Simulation s, Contact c) {
    return ask("collision", s, null, c, (g, sim, none, it) -> g.collision(sim, it), true);
  }

  @Override
  public void hit(Simulation s, Contact c) {
    call("hit", s, null, c, (g, sim, none, it) -> g.hit(sim, it));
  }

  @Override
  public void broke(Simulation s, EntityJoint joint) {
    call("broke", s, joint, null, (g, sim, it, none) -> g.broke(sim, it));
  }

  @Override
  public Audience audience(Match s, Entity e) {
    return ask("audience", s, e, null, AUDIENCE, Audience.NOBODY);
  }

  @Override
  public boolean seesAll(Match s, Player p) {
    return ask("seesAll", s, p, null, (g, sim, player, none) -> g.seesAll(sim, player), false);
  }

  private <M extends Simulation, S, A> void call(
      String callback, M s, S subject, A argument, Call<M, S, A> call) {
    try {
      call.run(game, s, subject, argument);
    } catch (Exception | Error e) { // checked ones, too, which other languages don't declare
      failed(callback, s, subject, e);
    }
  }

  /** Returns the game's answer, or another one if it fails. */
  private <M extends Simulation, S, A, R> R ask(
      String callback, M s, S subject, A argument, Question<M, S, A, R> question, R failed) {
    try {
      return question.ask(game, s, subject, argument);
    } catch (Exception | Error e) {
      failed(callback, s, subject, e);
      return failed;
    }
  }

  /**
   * Tells a failure of the game. One of the machine, such as a lack of memory, isn't the game's.
   */
  private void failed(String callback, Simulation s, Object subject, Throwable failure) {
    if (failure instanceof VirtualMachineError machine
        && !(machine instanceof StackOverflowError)) {
      throw machine;
    }
    String of = subject instanceof Player p ? " of player " + p.id() : " of " + subject;
    listener.failed(subject == null ? callback : callback + of, s, failure);
  }
}
