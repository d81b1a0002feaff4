package carom.game.tag;

import static carom.sim.event.Audience.ALL;
import static carom.sim.field.Scope.MATCH;

import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.field.Countdown;
import carom.sim.field.Field;
import carom.sim.field.PlayerRef;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import java.util.List;

/** The player who is "it" passes it on by a touch. All others gain a point a second. */
public final class TagGame implements Game {
  private static final PlayerRef IT = Field.player("it").of(MATCH).to(ALL);
  private static final Countdown GRACE = Field.countdown("grace").of(MATCH).to(ALL);

  private Archetype runner;
  private Archetype chaser;

  @Override
  public String name() {
    return "tag";
  }

  @Override
  public String defaultLevel() {
    return "tag";
  }

  @Override
  public List<Field<?>> fields() {
    return List.of(IT, GRACE);
  }

  @Override
  public void setUp(SetUp s) {
    runner = s.archetype(disc("runner", 0x4cc9f0));
    chaser = s.archetype(disc("chaser", 0xef476f));
  }

  private static ArchetypeDef disc(String name, int rgb) {
    return new ArchetypeDef(name)
        .shape(new Circle(0.5f), new Material(1, 0.2f, 0.5f))
        .fixedRotation(true)
        .appearance(Appearance.of(rgb, Appearance.Look.PLAYER));
  }

  @Override
  public void join(Match m, Player p) {
    Level.Spawn spot = m.level().spawns("player").get(0);
    m.spawn(runner, spot.x() + m.random().between(-3, 3), spot.y(), 0, p);
    if (m.get(IT) == null) {
      makeIt(m, p);
    }
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    p.entity().seekVelocity(in.moveX() * 8, in.moveY() * 8, 10);
  }

  @Override
  public void afterStep(Match m) {
    Player it = m.get(IT);
    for (Player p : m.players()) {
      if (p == it) {
        continue;
      }
      if (it == null || (m.get(GRACE) == 0 && touches(it, p))) {
        makeIt(m, p);
        it = p;
      } else if (m.tick() % m.tickRate() == 0) {
        m.addScore(p, 1);
      }
    }
  }

  private static boolean touches(Player a, Player b) {
    float dx = a.entity().x() - b.entity().x();
    float dy = a.entity().y() - b.entity().y();
    return dx * dx + dy * dy < 1.05f * 1.05f;
  }

  private void makeIt(Match m, Player p) {
    if (m.get(IT) != null) {
      m.get(IT).entity().become(runner);
    }
    p.entity().become(chaser); // a look belongs to an archetype
    m.set(IT, p);
    m.set(GRACE, m.ticks(1.5f)); // counts down by itself
    m.notice(m.name(p) + " is it!");
  }
}
