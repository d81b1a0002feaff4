package carom.testkit;

import carom.game.Games;
import carom.physics.Body;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.sim.Game;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Choice;
import carom.sim.field.Count;
import carom.sim.field.Countdown;
import carom.sim.field.Field;
import carom.sim.field.Scope;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/**
 * A game of players that dash, shoot and burn, with a field of each audience. Its match goes from
 * phase to phase, and players are slow while they wait.
 */
public final class FieldGame implements Game {
  /** What the match is doing. */
  public enum Phase {
    /** Players are slow. */
    WAIT,
    /** Players are fast. */
    PLAY
  }

  /** Told to all; the rules take some of it every second. */
  public static final Count HEALTH = Field.count("health", 0, 100).to(Audience.ALL).startsAt(100);

  /** Told to its owner alone; input takes some of it. */
  public static final Count AMMO = Field.count("ammo", 0, 500).to(Audience.OWNER).startsAt(400);

  /** Told to the team. */
  public static final Count PLAN = Field.count("plan", 0, 9).to(Audience.TEAM);

  /** Stays on the server. */
  public static final Count LUCK = Field.count("luck", 0, 1_000).to(Audience.NOBODY);

  /** Until the next dash; input reads and writes it. */
  public static final Countdown DASH = Field.countdown("dash");

  /** What a body has burnt; input writes it. */
  public static final Count BURNT = Field.count("burnt", 0, 100_000).of(Scope.ENTITY);

  /** The phase; input reads it, and the rules write it. */
  public static final Choice<Phase> PHASE =
      Field.choice("phase", Phase.class).of(Scope.MATCH).to(Audience.ALL);

  /** Ticks of a phase. */
  public static final int PHASE_TICKS = 150;

  private static final int DASH_TICKS = 45;

  private Archetype runner;

  /** Makes the game known, so that levels may name it. */
  public static void register() {
    Games.add(FieldGame::new);
  }

  /**
   * Returns a level with a floor between two walls, and two spawns.
   *
   * @param apart whether a wall is between the spawns; otherwise they are in one narrow pit
   */
  public static Level level(boolean apart) {
    register();
    String json =
        """
        {"name": "fields", "game": "fields", "gravity": [0, -10],
         "bounds": {"min": [-40, -8], "max": [40, 20]},
         "spawns": [{"name": "player", "at": [-15, -4]}, {"name": "player", "at": [%d, -4]}],
         "statics": [
           {"at": [0, -6], "shape": {"type": "box", "width": 60, "height": 2}},
           {"at": [%d, 0], "shape": {"type": "box", "width": 1, "height": 12}},
           {"at": [%d, 5], "shape": {"type": "box", "width": 2, "height": 20}},
           {"at": [30, 5], "shape": {"type": "box", "width": 2, "height": 20}}]}
        """
            .formatted(apart ? 15 : -13, apart ? 0 : -10, apart ? -30 : -18);
    try {
      return Level.parse("fields.json", json.getBytes(StandardCharsets.UTF_8));
    } catch (LevelException e) {
      throw new IllegalStateException(e);
    }
  }

  @Override
  public String name() {
    return "fields";
  }

  @Override
  public String defaultLevel() {
    return "fields";
  }

  @Override
  public List<Field<?>> fields() {
    return List.of(HEALTH, AMMO, PLAN, LUCK, DASH, BURNT, PHASE);
  }

  @Override
  public void setUp(Simulation s) {
    runner =
        s.archetypes()
            .add(
                new ArchetypeDef("runner")
                    .shape(new Box(0.5f, 0.5f), new Material(0.5f, 0.4f, 0.2f))
                    .fixedRotation(true)
                    .appearance(Appearance.of(0x4cc9f0, Appearance.Look.PLAYER)));
  }

  @Override
  public void join(Simulation s, Player p) {
    List<Level.Spawn> spots = s.level().spawns("player");
    Level.Spawn spot = spots.get(p.id() % spots.size());
    s.spawn(runner, spot.x(), spot.y(), 0, p);
    p.team(p.id() % 2);
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    Body<Entity> body = p.body().body();
    float speed = s.get(PHASE) == Phase.PLAY ? 6 : 2;
    body.seekVelocity(in.moveX() * speed, body.velocityY(), 8 * body.mass());
    if (in.moveX() != 0) {
      p.body().add(BURNT, 1);
    }
    if (in.held(Input.JUMP) && p.get(DASH) == 0) {
      p.set(DASH, DASH_TICKS);
      p.add(AMMO, -1);
      body.applyImpulse(in.moveX() * 2 * body.mass(), 3 * body.mass());
    }
  }

  @Override
  public void afterStep(Simulation s) {
    if (s.tick() % PHASE_TICKS == 0) {
      s.set(PHASE, s.get(PHASE) == Phase.WAIT ? Phase.PLAY : Phase.WAIT);
    }
    for (int id = 0; s.tick() % 60 == 0 && id < s.playerCapacity(); id++) {
      if (s.player(id) != null) {
        s.player(id).add(HEALTH, -1);
        s.player(id).add(LUCK, 7);
        s.player(id).set(PLAN, s.tick() / 60 % 10);
      }
    }
  }
}
