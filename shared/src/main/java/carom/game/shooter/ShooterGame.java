package carom.game.shooter;

import static carom.game.shooter.ShooterFields.AMMO;
import static carom.game.shooter.ShooterFields.DAMAGE;
import static carom.game.shooter.ShooterFields.SUDDEN;

import carom.physics.WorldDef;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.MatchClock;
import carom.sim.MatchPhase;
import carom.sim.Rules;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Contact;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.field.Field;
import carom.sim.field.Gauge;
import carom.sim.level.Level;
import java.util.List;
import java.util.function.Consumer;

/**
 * A platform shooter, everybody for themselves. Each has {@value #LIVES} lives. Damage grows from
 * hit to hit, and with it the blows that throw a player off the stage; at its most, or beyond the
 * bounds, the player is out. The last one standing wins. In the last {@value #SUDDEN_SECONDS}
 * seconds, sudden death, nobody comes back and the level takes the ground away.
 *
 * <p>{@link Input#ACTION} fires along the aim and throws the player back a little; {@link
 * Input#JUMP} jumps, and once more in the air; down drops through one-way platforms. Weapons and
 * medkits lie about, and come back. What a level gives a {@code cover} breaks under fire.
 *
 * <p>{@code input} moves players and fires, {@code rules} hands out pick-ups, so a player sees both
 * at once. Blows, damage and knock-outs are the server's.
 *
 * <p>A level needs spawns {@code player} and a kinematic sensor {@code lava}, which takes out what
 * it touches. It may have spawns {@code medkit}, {@code shotgun}, {@code rifle} and {@code
 * launcher}. Its triggers say what happens when {@code match.sudden} is set.
 *
 * <pre>
 *   ShooterGame       the order of a tick, and who wins
 *     ShooterFields   the state that is saved, hashed and sent
 *     Stage           kinds of entities and events, the level's places
 *     Weapon          what shots do
 *     Fighters        running, jumping, being thrown
 *     Shots           firing, hits and blasts
 *     Pickups         weapons and medkits
 *     Lives           players who are knocked out and come back
 * </pre>
 */
public final class ShooterGame implements Game {
  /** Number of lives of a player in a match. */
  public static final int LIVES = 4;

  /** Longest match, seconds. */
  public static final float MATCH_SECONDS = 150;

  /** Length of the sudden death at the end of a match, seconds. */
  public static final float SUDDEN_SECONDS = 40;

  /** Running speed, m/s. */
  public static final float SPEED = 8.5f;

  /** Speed at the start of a jump, m/s. */
  public static final float JUMP_SPEED = 13;

  /** Width of a player, metres. */
  public static final float PLAYER_WIDTH = 0.8f;

  /** Height of a player, metres. The body's origin is in the middle. */
  public static final float PLAYER_HEIGHT = 1.4f;

  /** Fastest fall, m/s. */
  static final float MAX_FALL = 20;

  private static final MatchClock CLOCK = MatchClock.playing(MATCH_SECONDS).warmUp(2).countdown(3);

  private Stage stage;
  private Fighters fighters;
  private Shots shots;
  private Pickups pickups;
  private Lives lives;

  /** Creates the game, for the service loader. */
  public ShooterGame() {}

  @Override
  public String name() {
    return "shooter";
  }

  @Override
  public String defaultLevel() {
    return "shooter";
  }

  @Override
  public String description() {
    return "knock the others off the stage: the last one standing wins";
  }

  @Override
  public WorldDef world(Level level) {
    // Seen a tick ahead, a fall at full speed ends on the ground and not 0.3 m inside it.
    return Game.super.world(level).withSpeculativeDistance(MAX_FALL / 60).withMaxPushSpeed(6);
  }

  @Override
  public List<Field<?>> fields() {
    return ShooterFields.all();
  }

  @Override
  public List<Gauge> gauges() {
    return List.of(
        Gauge.bar("damage", DAMAGE),
        Gauge.number("lives", ShooterFields.LIVES),
        Gauge.number("ammo", AMMO),
        Gauge.overHeads("damage", DAMAGE));
  }

  @Override
  public boolean ownColours() {
    return false; // a ragdoll has the colour of its player
  }

  @Override
  public MatchClock clock() {
    return CLOCK;
  }

  @Override
  public void setUp(SetUp s) {
    stage = new Stage(s);
    fighters = new Fighters(stage);
    shots = new Shots(stage);
    pickups = new Pickups(stage);
    lives = new Lives(stage);
  }

  @Override
  public void join(Match m, Player p) {
    lives.join(m, p);
  }

  @Override
  public void leave(Match m, Player p) {
    lives.forget(p);
  }

  @Override
  public void beforeStep(Match m) {
    pickups.bringBack(m);
    lives.bringBack(m);
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    fighters.move(s, p, in);
    shots.input(s, p, in);
  }

  @Override
  public Consumer<Rules> rules(Level level) {
    return this::apply;
  }

  private void apply(Rules r) {
    boolean late = MatchClock.ticksLeft(r) <= r.ticks(SUDDEN_SECONDS);
    if (MatchClock.isPlaying(r) && late && !r.get(SUDDEN)) {
      r.set(SUDDEN, true);
    }
    pickups.take(r);
  }

  /** Shots pass through their player and one-way platforms. */
  @Override
  public boolean collision(Simulation s, Contact c) {
    Entity self = c.self();
    Entity other = c.other();
    if (stage.isShot(self) || stage.isShot(other)) {
      boolean passes = self.archetype().oneWay() || other.archetype().oneWay();
      return !passes && !self.isOfSameOwner(other);
    }
    boolean drops = Fighters.drops(self, other) || Fighters.drops(other, self);
    return !drops && c.holdsOneWay();
  }

  @Override
  public void entered(Match m, Entity sensor, Entity visitor) {
    Player p = visitor.owner();
    if (sensor.archetype() == stage.lava && p != null && p.entity() == visitor) {
      p.set(DAMAGE, DAMAGE.max());
    }
  }

  @Override
  public void afterStep(Match m) {
    for (Player p : m.players()) {
      shots.afterStep(m, p);
    }
    lives.afterStep(m);
    if (MatchClock.isPlaying(m)) {
      finishIfDecided(m);
    }
  }

  private static void finishIfDecided(Match m) {
    Player last = null;
    int left = 0;
    for (Player p : m.players()) {
      if (p.get(ShooterFields.LIVES) > 0) {
        last = p;
        left++;
      }
    }
    if (left == 1) {
      CLOCK.finish(m, last);
      m.notice(m.name(last) + " wins: the last one standing");
    } else if (left == 0) {
      CLOCK.finish(m);
      m.notice("A draw: nobody is left");
    }
  }

  @Override
  public void phase(Match m, MatchPhase now) {
    if (now == MatchPhase.PLAYING) {
      for (Player p : m.players()) { // what was practised is forgotten
        lives.begin(m, p);
      }
    } else if (now == MatchPhase.OVER) {
      if (MatchClock.winner(m) < 0 && isUndecided(m)) {
        Player best = m.leader();
        CLOCK.decide(m, best, 0);
        m.notice(best == null ? "A draw!" : m.name(best) + " wins by knock-outs: " + m.score(best));
      }
      Player winner = m.player(MatchClock.winner(m));
      if (winner != null) {
        winner.add(ShooterFields.WINS, 1);
      }
    }
  }

  private static boolean isUndecided(Match m) {
    for (Player p : m.players()) {
      if (p.get(ShooterFields.LIVES) > 0) {
        return true;
      }
    }
    return false;
  }
}
