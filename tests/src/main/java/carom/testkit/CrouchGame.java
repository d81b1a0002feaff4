package carom.testkit;

import carom.game.Games;
import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.Filter;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.sim.Game;
import carom.sim.Role;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Area;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.nio.charset.StandardCharsets;

/**
 * A game of bodies that become others: players crouch while they hold ACTION, and crates turn to
 * ice, ghosts and rock, one by one.
 */
public final class CrouchGame implements Game {
  private static final String JSON =
      """
      {"name": "become", "game": "become", "gravity": [0, -10],
       "bounds": {"min": [-20, -8], "max": [20, 20]},
       "materials": {"grass": {"color": "#2fbf4f"}, "lava": {"color": "#ff4020"}},
       "spawns": [{"at": [-6, 3]}, {"at": [6, 3]}],
       "statics": [
         {"at": [0, 17], "shape": {"type": "chain", "points": [[-9, 0], [-3, 0], [3, 0]],
          "materials": ["grass", "lava"]}},
         {"at": [0, -6], "shape": {"type": "box", "width": 40, "height": 2}},
         {"at": [-13, 5], "shape": {"type": "box", "width": 2, "height": 20}},
         {"at": [13, 5], "shape": {"type": "box", "width": 2, "height": 20}}]}
      """;

  /** What the rules do besides the players' crouching. */
  public enum Rule {
    /** There are players alone. */
    NOTHING,
    /** Ten crates become ice, ghosts and rock, and crates again. */
    CRATES_CHANGE,
    /** The gravity of the whole level changes every 150 ticks. */
    GRAVITY_CHANGES
  }

  private final Rule rule;
  private Archetype standing;
  private Archetype crouched;
  private Archetype crate;
  private Archetype ice;
  private Archetype ghost;
  private Archetype rock;
  private Archetype earth;
  private Archetype moon;

  /** Creates a game with these rules. */
  public CrouchGame(Rule rule) {
    this.rule = rule;
  }

  @Override
  public String name() {
    return "become";
  }

  @Override
  public String defaultLevel() {
    return "become";
  }

  @Override
  public void setUp(Simulation s) {
    Material skin = new Material(1, 0.4f, 0);
    standing = add(s, new ArchetypeDef("standing").fixedRotation(true), 0.4f, 0.9f, 0.9f, skin);
    crouched = add(s, new ArchetypeDef("crouched").fixedRotation(true), 0.4f, 0.5f, 0.5f, skin);
    crate = add(s, painted("crate", 0xb08968), 0.5f, 0.5f, 0, new Material(0.5f, 0.5f, 0.1f));
    ice = add(s, painted("ice", 0x66ddff), 0.6f, 0.4f, 0.1f, new Material(0.3f, 0.01f, 0));
    Filter floorOnly = new Filter(2, ~2, 0);
    ghost = add(s, painted("ghost", 0xcc88ee).filter(floorOnly), 0.5f, 0.5f, 0, skin);
    rock = add(s, new ArchetypeDef("rock").type(BodyType.STATIC), 0.5f, 0.5f, 0, skin);
    earth = weather(s, "earth", -10);
    moon = weather(s, "moon", -2);
    for (int i = 0; s.role() == Role.AUTHORITY && i < 10 && rule != Rule.NOTHING; i++) {
      int row = i / 5;
      s.spawn(crate, i % 5 * 1.5f - 3, 1 + row * 1.5f, 0, null);
    }
    if (s.role() == Role.AUTHORITY && rule == Rule.GRAVITY_CHANGES) {
      s.spawn(earth, 0, 15, 0, null);
    }
  }

  private static ArchetypeDef painted(String name, int rgb) {
    return new ArchetypeDef(name).appearance(Appearance.of(rgb, Appearance.Look.CRATE));
  }

  private static Archetype add(
      Simulation s, ArchetypeDef def, float halfWidth, float halfHeight, float up, Material m) {
    return s.archetypes().add(def.shape(new Box(halfWidth, halfHeight, 0, up), m));
  }

  private static Archetype weather(Simulation s, String name, float gravity) {
    return s.archetypes()
        .add(
            new ArchetypeDef(name)
                .type(BodyType.STATIC)
                .sensor(true)
                .shape(new Circle(0.1f), new Material(1, 0, 0))
                .area(Area.gravity(-60, -60, 60, 60, 0, gravity)));
  }

  @Override
  public void join(Simulation s, Player p) {
    s.spawn(standing, p.id() % 2 == 0 ? -6 : 6, 0, 0, p);
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    p.body().become(in.held(Input.ACTION) ? crouched : standing);
    Body<Entity> body = p.body().body();
    body.seekVelocity(in.moveX() * 5, body.velocityY(), 6 * body.mass());
    if (in.held(Input.JUMP) && Math.abs(body.velocityY()) < 0.1f) {
      body.setVelocity(body.velocityX(), 5);
    }
  }

  @Override
  public void beforeStep(Simulation s) {
    for (int id = 0; rule == Rule.CRATES_CHANGE && id < s.entityCapacity(); id++) {
      Entity e = s.entity(id);
      if (e != null && e.ownerId() == Entity.NO_OWNER && (s.tick() + 31 * id) % 310 == 0) {
        e.become(e.archetype() == crate ? ice : crate);
      }
    }
  }

  @Override
  public void afterStep(Simulation s) {
    for (int id = 0; rule != Rule.NOTHING && id < s.entityCapacity(); id++) {
      Entity e = s.entity(id);
      if (e == null || e.ownerId() != Entity.NO_OWNER) {
        continue;
      }
      int phase = (s.tick() + 31 * id) % 310;
      if (rule == Rule.GRAVITY_CHANGES) {
        if (e.archetype().area() != null && s.tick() % 150 == 0) {
          e.become(e.archetype() == earth ? moon : earth);
        }
      } else if (phase == 80) {
        e.become(ghost);
      } else if (phase == 160) {
        e.become(rock);
      } else if (phase == 240) {
        e.become(crate);
      }
    }
  }

  /** Makes the game known under these rules, and returns its level. */
  public static Level level(Rule rule) {
    Games.add(() -> new CrouchGame(rule));
    try {
      return Level.parse("become.json", JSON.getBytes(StandardCharsets.UTF_8));
    } catch (LevelException e) {
      throw new IllegalStateException(e);
    }
  }
}
