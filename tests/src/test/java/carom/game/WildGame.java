package carom.game;

import carom.fixtures.WildCalls;
import carom.physics.Filter;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.MotionLocks;
import carom.physics.effects.Explosion;
import carom.physics.effects.Hover;
import carom.physics.effects.Spring;
import carom.physics.geometry.Box;
import carom.physics.geometry.Circle;
import carom.physics.mover.MoverDef;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.MatchClock;
import carom.sim.Rules;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Assembly;
import carom.sim.entity.AssemblyDef;
import carom.sim.entity.Contact;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityHit;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.EventKind;
import carom.sim.field.Choice;
import carom.sim.field.Cooldown;
import carom.sim.field.Count;
import carom.sim.field.Countdown;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.Flag;
import carom.sim.field.Gauge;
import carom.sim.field.PlayerRef;
import carom.sim.field.Ratio;
import carom.sim.field.Real;
import carom.sim.field.Scope;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Area;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.sim.level.ScriptedMotion;
import carom.sim.message.MessageKind;
import carom.sim.message.PlayerRole;
import carom.sim.outbox.NextMatch;
import carom.sim.pool.PoolDef;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.Consumer;

/**
 * A game that has one of each thing, shows them to {@link WildCalls}, and lets somebody do what he
 * likes in each of its callbacks. What it declares is changed before it is used.
 */
final class WildGame implements Game {
  private static final Count HEALTH = Field.count("health", 0, 100).startsAt(50);
  private static final Real REAL = Field.real("real");
  private static final Countdown WAIT = Field.countdown("wait");
  private static final EntityRef THING = Field.entity("thing");
  private static final Ratio POWER = Field.ratio("power").of(Scope.ENTITY);
  private static final Flag OPEN = Field.flag("open").of(Scope.MATCH).times(3);
  private static final PlayerRef IT = Field.player("it").of(Scope.MATCH);
  private static final Choice<PlayerRole> MODE =
      Field.choice("mode", PlayerRole.class).of(Scope.MATCH);
  private static final MessageKind BUY =
      MessageKind.named("buy").count("item", 0, 9).text("note", 9);

  private final WildCalls calls;
  private final Consumer<String> visitor;
  private Archetype ball;
  private Assembly pair;
  private Archetype changed;
  private Assembly changedPair;
  private EventKind boom;

  /**
   * Creates a game.
   *
   * @param visitor is told the name of each callback that runs
   */
  WildGame(WildCalls calls, Consumer<String> visitor) {
    this.calls = calls;
    this.visitor = visitor;
  }

  /** Returns a level with a floor, a sensor and a door. */
  static Level level() throws LevelException {
    String json =
        """
        {"name": "Wild", "game": "wild", "gravity": [0, -10],
         "bounds": {"min": [-20, -10], "max": [20, 10]}, "spawns": [{"at": [0, 0]}],
         "statics": [
           {"at": [0, -1], "shape": {"type": "box", "width": 40, "height": 1}},
           {"name": "plate", "sensor": true, "at": [0, 0], "shape": {"type": "circle", "radius": 1}}],
         "bodies": [
           {"name": "door", "type": "kinematic", "at": [4, 4],
            "shape": {"type": "box", "width": 1, "height": 3}}]}
        """;
    return Level.parse("wild", json.getBytes(StandardCharsets.UTF_8));
  }

  private static ArchetypeDef disc(String name) {
    return new ArchetypeDef(name).shape(new Circle(0.4f), Material.DEFAULT);
  }

  @Override
  public String name() {
    return "wild";
  }

  @Override
  public String defaultLevel() {
    return "wild";
  }

  @Override
  public List<Field<?>> fields() {
    return List.of(HEALTH, REAL, WAIT, THING, POWER, OPEN, IT, MODE);
  }

  @Override
  public boolean looksBack() {
    return true;
  }

  @Override
  public List<String> teams() {
    return List.of("Red", "Blue");
  }

  @Override
  public MatchClock clock() {
    return MatchClock.playing(60);
  }

  @Override
  public void setUp(SetUp s) {
    ball = s.archetype(disc("ball"));
    pair =
        s.assembly(
            new AssemblyDef("pair")
                .body("a", disc("a"), 0, 0)
                .body("b", disc("b"), 1, 0)
                .joint("rod", "a", "b", (a, b) -> JointDef.distance(a, b, 0, 0, 1, 0)));
    boom = s.event("boom", 1, 2, "boom");
    s.message(BUY);
    ArchetypeDef def = disc("changed");
    AssemblyDef assembly = new AssemblyDef("changed pair").body("a", disc("a"), 0, 0);
    calls.see(s, s.level(), ball, pair, boom, def, assembly);
    calls.see(s.pool(PoolDef.water("lake", -5, -5, 5, -3, 0.5f)), s.mover(mover()));
    fields().forEach(calls::see);
    calls.see(BUY, BUY.of(3, "x"), MessageKind.named("sold"), mover());
    calls.see(PoolDef.water("w", -5, -5, 5, -3, 0.5f), spout(), Filter.DEFAULT, Material.DEFAULT);
    calls.see(Appearance.of(1), Area.drag(-1, -1, 1, 1, 2, 2), MotionLocks.NONE, clock());
    calls.see(NextMatch.level("x"), NextMatch.game("y"), new Circle(0.5f), new Box(1, 1));
    calls.see(new Explosion(0, 0, 5), new Spring(0, 0, 4), new Hover<>(1.5f), new EntityHit());
    calls.see(Gauge.bar("health", HEALTH), new Cooldown("w", WAIT, 1));
    calls.see(new ScriptedMotion(0, 0, 1, 1, 2, 0, true));
    visitor.accept("setUp");
    changed = s.archetype(def);
    changedPair = s.assembly(assembly);
  }

  private static MoverDef<?> mover() {
    return new MoverDef<>(1.8f, 0.4f);
  }

  private static PoolDef.Spout spout() {
    return new PoolDef.Spout("x", 0, 0, 1, 0, 0.5f, 4, true);
  }

  @Override
  public void begin(Match m) {
    Entity root = m.spawn(pair, 4, 0, 0, null);
    Entity loose = m.spawn(ball, 0.2f, 0.8f);
    Entity gone = m.spawn(ball, 9, 9);
    gone.despawn();
    calls.see(root, loose, gone, root.joint("rod"));
    calls.see(m.connect(loose, root, (a, b) -> JointDef.rope(a, b, 0, 0, 4, 0, 9)));
    m.spawn(changed, -8, 2);
    m.spawn(changedPair, -4, 2, 0, null);
  }

  @Override
  public void join(Match m, Player p) {
    m.spawn(ball, p.id() * 2, 0, 0, p);
    calls.see(m, p, p.entity(), m.input(p));
    visitor.accept("join");
  }

  @Override
  public void beforeStep(Match m) {
    calls.see(m);
    visitor.accept("beforeStep");
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    calls.see(s, p, in, p.entity(), p.entity().ground(), s.queries());
    visitor.accept("input");
  }

  @Override
  public Consumer<Rules> rules(Level level) {
    return r -> {
      calls.see(r);
      visitor.accept("rules");
    };
  }

  @Override
  public void forces(Simulation s, Entity e) {
    calls.see(s, e);
    visitor.accept("forces");
  }

  @Override
  public boolean collision(Simulation s, Contact c) {
    calls.see(s, c);
    visitor.accept("collision");
    return true;
  }

  @Override
  public void hit(Simulation s, Contact c) {
    calls.see(s, c);
    visitor.accept("hit");
  }

  @Override
  public void afterStep(Match m) {
    calls.see(m, m.emit(boom), m.send(BUY.of(1, "")));
    for (Player p : m.players()) {
      calls.see(m.asSeenBy(p));
    }
    visitor.accept("afterStep");
  }
}
