package carom.sim.scene;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.BodyType;
import carom.physics.Material;
import carom.physics.ShapeDef;
import carom.physics.World;
import carom.physics.WorldDef;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.SimulationHost;
import carom.sim.entity.Contact;
import carom.sim.entity.HostEntity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.sim.pool.ParticleWorld;
import carom.sim.pool.ShownParticles;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/**
 * A scene as a game that players only watch: they have no bodies, and their inputs mean nothing.
 * The server's world is that of {@link Scene#start} with sleep and continuous collision, bit for
 * bit.
 *
 * <p>Every body is an entity, and bodies that look the same share an archetype. Joints are sent as
 * in any game. A client of a scene with particles runs the scene, too, from a state of the
 * server's, and shows the particles of that. Both sides learn the archetypes by running the scene's
 * actions {@value #PREVIEW_TICKS} ticks ahead in a world that stands still. A body that first
 * appears later, with a look of its own, is seen as a dot.
 */
public final class SceneGame implements Game {
  /** Prefix of the names of these games; the scene's name follows. */
  public static final String PREFIX = "scene:";

  private static final int PREVIEW_TICKS = 1800;

  private final Scene scene;
  private final Map<String, Archetype> kinds = new TreeMap<>();
  private Archetype dot;
  private SceneWorld<HostEntity> stage;
  private boolean hasParticles;

  /**
   * Creates the game of a scene.
   *
   * @param scene the scene to watch
   */
  public SceneGame(Scene scene) {
    this.scene = scene;
  }

  /**
   * Returns the level of a scene: empty, and as large as the scene's view.
   *
   * @param scene the scene to watch
   * @return a level for the game of that scene
   */
  public static Level level(Scene scene) {
    View v = scene.view();
    String json =
        String.format(
            Locale.ROOT,
            "{\"name\":\"%s\",\"game\":\"%s\",\"gravity\":[%s,%s],"
                + "\"bounds\":{\"min\":[%s,%s],\"max\":[%s,%s]},"
                + "\"theme\":{\"background\":\"#0e1420\",\"sky\":\"#1d2838\"}}",
            scene.name(),
            PREFIX + scene.name(),
            scene.def().gravityX(),
            scene.def().gravityY(),
            v.x() - v.width() / 2,
            v.y() - v.height() / 2,
            v.x() + v.width() / 2,
            v.y() + v.height() / 2);
    try {
      return Level.parse(scene.name() + ".json", json.getBytes(StandardCharsets.UTF_8));
    } catch (LevelException e) {
      throw new IllegalStateException("scene=" + scene.name() + " has no valid level", e);
    }
  }

  @Override
  public String name() {
    return PREFIX + scene.name();
  }

  /** Returns true, because the actions of scenes keep state in fields. */
  @Override
  public boolean keepsMore() {
    return true;
  }

  @Override
  public String defaultLevel() {
    return scene.name();
  }

  @Override
  public String description() {
    return scene.description();
  }

  @Override
  public WorldDef world(Level level) {
    return scene.def().withSleeping(true).withContinuous(true);
  }

  @Override
  public boolean seesAll(Match m, Player p) {
    return true; // a spectator
  }

  @Override
  public void setUp(SetUp s) {
    World<HostEntity> still = new World<>(world(s.level()));
    SceneWorld<HostEntity> preview =
        new SceneWorld<>(
            still,
            def -> {
              kinds.computeIfAbsent(look(def), key -> s.archetype(kind(def)));
              return still.createBody(def, null);
            });
    scene.build(preview);
    for (int tick = 0; tick < PREVIEW_TICKS; tick++) {
      preview.runActions(tick);
    }
    dot = s.archetype(new ArchetypeDef("dot").shape(new Circle(0.1f), new Material(1, 0, 0)));
    hasParticles = !preview.particles().isEmpty();
    if (hasParticles) {
      s.showAtClients(() -> scene.with(world(s.level())).start());
    }
  }

  /** Builds the scene in the server's world, whose bodies are more than archetypes say. */
  @Override
  public void begin(Match m) {
    SimulationHost host = (SimulationHost) m;
    stage = new SceneWorld<>(host.world(), def -> enter(host, def), body -> leave(host, body));
    scene.build(stage);
    if (hasParticles) {
      host.pools().follow(new Told(host, stage));
    }
  }

  /** The scene that the server's simulation runs. */
  private record Told(SimulationHost simulation, SceneWorld<HostEntity> stage)
      implements ParticleWorld {
    @Override
    public List<ShownParticles> particles() {
      return stage.particles();
    }

    @Override
    public State save(State reuse) {
      return SceneState.save(
          simulation.world(), particles(), simulation.tick(), (SceneState) reuse);
    }
  }

  private Body<HostEntity> enter(SimulationHost s, BodyDef def) {
    return s.spawn(kinds.getOrDefault(look(def), dot), def).body();
  }

  private static void leave(SimulationHost s, Body<HostEntity> body) {
    s.despawn(body.user());
  }

  /** Returns a text that is equal for bodies that look the same. */
  private static String look(BodyDef def) {
    StringBuilder key = new StringBuilder(def.type().name());
    for (ShapeDef shape : def.shapes()) {
      key.append(' ').append(shape.material().tag()).append(shape.sensor() ? 's' : 'b');
      for (Convex part : shape.shape().parts()) {
        key.append(' ').append(part.radius());
        for (int i = 0; i < part.vertexCount(); i++) {
          key.append(' ').append(part.vertexX(i)).append(',').append(part.vertexY(i));
        }
      }
    }
    return key.toString();
  }

  private ArchetypeDef kind(BodyDef def) {
    ShapeDef first = def.shapes().get(0);
    int tag = first.material().tag();
    int rgb = tag == 0 ? SceneColors.untagged(def.type(), first.shape()) : tag;
    boolean wall = def.type() == BodyType.STATIC && !first.sensor();
    Appearance appearance =
        wall
            // Lines have nothing but an edge, so the edge must be visible.
            ? new Appearance(
                rgb, SceneColors.mix(rgb, SceneColors.STEEL, 0.5f), Appearance.Look.WALL)
            : Appearance.of(rgb);
    ArchetypeDef kind =
        new ArchetypeDef(scene.name() + "." + kinds.size())
            .type(def.type())
            .sensor(first.sensor())
            .appearance(appearance);
    for (ShapeDef shape : def.shapes()) {
      kind.shape(shape.shape(), shape.material());
    }
    return kind;
  }

  @Override
  public void join(Match m, Player p) {
    // A spectator has no body.
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    // There is nothing to steer.
  }

  @Override
  public void beforeStep(Match m) {
    stage.beforeStep(m.tick() - 1, m.tickSeconds());
  }

  @Override
  public boolean collision(Simulation s, Contact c) {
    return stage == null
        || stage.listener() == null
        || stage.listener().preSolve(Contact.engineOf(c));
  }
}
