package carom.testkit;

import carom.game.Games;
import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.QueryHit;
import carom.physics.effects.Explosion;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.sim.Game;
import carom.sim.Role;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.Ratio;
import carom.sim.field.Scope;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Area;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/**
 * A game of players that fly through areas and forces. Its level says what else there is; its
 * {@link #forces} act on bodies by their tag.
 */
public final class ForceGame implements Game {
  /** Tag of bodies that a spring pulls to x = 0. */
  public static final int SPRING = 1;

  /** Tag of bodies with an engine that goes on and off. */
  public static final int ENGINE = 2;

  /** Tag of bodies that look at the ground and hover over it. */
  public static final int HOVER = 3;

  /** Tag of bodies that the rules push before every step, which no client can predict. */
  public static final int PUSHED = 4;

  /** Tag of bodies that the rules throw up every second and a half. */
  public static final int THROWN = 5;

  /** Ten crates; the parameter is their tag. */
  private static final String CRATES =
      """
      {"at": [-3, 1], "shape": {"type": "box", "width": 1, "height": 1}, "tag": %d,
       "material": {"density": 0.5}, "repeat": {"columns": 5, "rows": 2, "step": [1.5, 1.5]}}\
      """;

  /** Fields of a level: water that flows, a raft and ten crates. */
  public static final String WATER =
      """
      , "areas": [{"type": "water", "min": [-12, -5], "max": [12, 1], "density": 1, "drag": 1.5,
         "flow": [0.6, 0]}],
        "bodies": [{"at": [0, 1.2], "shape": {"type": "box", "width": 5, "height": 0.8},
         "material": {"density": 0.3}}, %s]
      """
          .formatted(crates(0));

  /** Fields of a level: wind that drives ten crates round and round. */
  public static final String WIND =
      """
      , "areas": [
         {"type": "wind", "min": [-12, -5], "max": [12, 0], "velocity": [8, 0], "rate": 2},
         {"type": "wind", "min": [5, -5], "max": [12, 11], "velocity": [0, 16], "rate": 2},
         {"type": "wind", "min": [-12, 6], "max": [12, 15], "velocity": [-9, 2], "rate": 2},
         {"type": "drag", "min": [-12, -5], "max": [-8, 0], "drag": 1}],
        "bodies": [%s]
      """
          .formatted(crates(0));

  private static final String SPOT = ", {\"name\": \"%s\", \"at\": [0, -4.5]}";
  private static final int THROW_TICKS = 90;
  private static final int EXPLOSION_TICKS = 150;
  private static final int SWITCH_TICKS = 100;
  private static final Flag THRUST = Field.flag("thrust");
  private static final Ratio POWER = Field.ratio("power").of(Scope.ENTITY).to(Audience.NEAR);

  private final QueryHit<Entity> hit = new QueryHit<>();
  private Archetype flyer;

  /** Makes the game known, so that levels may name it. */
  public static void register() {
    Games.add(ForceGame::new);
  }

  /**
   * Returns a level with a floor between two walls, 24 m apart, and one spawn.
   *
   * @param gravityY gravity, m/s^2
   * @param more further fields of the file, each after a comma
   */
  public static Level level(float gravityY, String more) {
    return level(gravityY, "", more);
  }

  /**
   * Returns the same with something in the middle of the floor.
   *
   * @param thing {@code bomb} explodes every 2.5 s, {@code magnet} goes on and off; empty for none
   */
  public static Level level(float gravityY, String thing, String more) {
    register();
    String json =
        """
        {"name": "forces", "game": "forces", "gravity": [0, %s],
         "bounds": {"min": [-20, -8], "max": [20, 20]},
         "spawns": [{"name": "player", "at": [-6, 3]}, {"name": "player", "at": [6, 3]}%s],
         "statics": [
           {"at": [0, -6], "shape": {"type": "box", "width": 40, "height": 2}},
           {"at": [0, 16], "shape": {"type": "box", "width": 40, "height": 2}},
           {"at": [-13, 5], "shape": {"type": "box", "width": 2, "height": 20}},
           {"at": [13, 5], "shape": {"type": "box", "width": 2, "height": 20}}]%s}
        """
            .formatted(gravityY, thing.isEmpty() ? "" : SPOT.formatted(thing), more);
    try {
      return Level.parse("forces.json", json.getBytes(StandardCharsets.UTF_8));
    } catch (LevelException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Returns the items of a level's bodies that are ten crates with a tag. */
  public static String crates(int tag) {
    return CRATES.formatted(tag);
  }

  /** Returns a level with water that flows, a raft and ten crates. */
  public static Level water() {
    return level(-10, WATER);
  }

  /** Returns a level with wind from two sides, mud between, and ten crates. */
  public static Level wind() {
    return level(-10, WIND);
  }

  @Override
  public String name() {
    return "forces";
  }

  @Override
  public String defaultLevel() {
    return "forces";
  }

  @Override
  public List<Field<?>> fields() {
    return List.of(THRUST, POWER);
  }

  @Override
  public void setUp(Simulation s) {
    Archetype magnet =
        s.archetypes()
            .add(
                new ArchetypeDef("magnet")
                    .type(BodyType.KINEMATIC)
                    .sensor(true)
                    .shape(new Circle(0.4f), new Material(1, 0, 0))
                    .area(Area.attractor(0, 0, 9, 25), POWER));
    for (Level.Spawn spot : s.level().spawns("magnet")) {
      if (s.role() == Role.AUTHORITY) {
        s.spawn(magnet, spot.x(), spot.y(), 0, null);
      }
    }
    flyer =
        s.archetypes()
            .add(
                new ArchetypeDef("flyer")
                    .shape(new Box(0.5f, 0.5f), new Material(0.5f, 0.4f, 0.2f))
                    .appearance(Appearance.of(0x4cc9f0, Appearance.Look.PLAYER)));
  }

  @Override
  public void join(Simulation s, Player p) {
    List<Level.Spawn> spots = s.level().spawns("player");
    Level.Spawn spot = spots.get(p.id() % spots.size());
    s.spawn(flyer, spot.x(), spot.y(), 0, p);
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    Body<Entity> body = p.body().body();
    body.seekVelocity(in.moveX() * 5, body.velocityY(), 6 * body.mass());
    p.set(THRUST, in.held(Input.JUMP) || in.moveY() > 0.3f);
  }

  @Override
  public void beforeStep(Simulation s) {
    for (int id = 0; id < s.entityCapacity(); id++) {
      Entity e = s.entity(id);
      if (e != null && e.archetype().tag() == PUSHED) {
        e.body().applyImpulse(s.tick() / 60 % 2 == 0 ? 0.1f : -0.1f, 0);
      }
    }
  }

  @Override
  public void afterStep(Simulation s) {
    for (int id = 0; s.tick() % SWITCH_TICKS == 0 && id < s.entityCapacity(); id++) {
      Entity e = s.entity(id);
      if (e != null && e.archetype().areaPower() == POWER) {
        e.set(POWER, s.tick() / SWITCH_TICKS % 2);
      }
    }
    if (s.tick() % EXPLOSION_TICKS == 0 && !s.level().spawns("bomb").isEmpty()) {
      Level.Spawn bomb = s.level().spawns("bomb").get(0);
      new Explosion(bomb.x(), bomb.y(), 8).impulse(2).explode(s.world());
    }
    for (int id = 0; s.tick() % THROW_TICKS == 0 && id < s.entityCapacity(); id++) {
      Entity e = s.entity(id);
      if (e != null && e.archetype().tag() == THROWN) {
        e.body().setVelocity(id % 3 - 1, 6);
      }
    }
  }

  @Override
  public void forces(Simulation s, Entity e) {
    Body<Entity> body = e.body();
    Player owner = s.owner(e);
    if (owner != null && owner.get(THRUST)) {
      body.applyForce(0, 16 * body.mass());
      return;
    }
    switch (e.archetype().tag()) {
      case SPRING -> body.applyForce(-8 * body.mass() * body.x(), 0);
      case ENGINE -> body.applyForce((s.tick() / 40) % 2 == 0 ? 6 * body.mass() : 0, 0);
      case HOVER -> {
        if (s.world().queries().rayClosest(body.x(), body.y(), 0, -3, null, hit)) {
          body.applyForce(0, 30 * body.mass() * (1 - hit.fraction()));
        }
      }
      default -> {}
    }
  }
}
