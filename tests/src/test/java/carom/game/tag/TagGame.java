package carom.game.tag;

import static carom.sim.event.Audience.ALL;
import static carom.sim.field.Scope.MATCH;

import carom.physics.Body;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.sim.Game;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.Input;
import carom.sim.entity.HostPlayer;
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
  public void setUp(SimulationHost s) {
    runner = s.archetypes().add(disc("runner", 0x4cc9f0));
    chaser = s.archetypes().add(disc("chaser", 0xef476f));
  }

  private static ArchetypeDef disc(String name, int rgb) {
    return new ArchetypeDef(name)
        .shape(new Circle(0.5f), new Material(1, 0.2f, 0.5f))
        .fixedRotation(true)
        .appearance(Appearance.of(rgb, Appearance.Look.PLAYER));
  }

  @Override
  public void join(SimulationHost s, HostPlayer p) {
    Level.Spawn spot = s.level().spawns("player").get(0);
    s.spawn(runner, spot.x() + s.random().between(-3, 3), spot.y(), 0, p);
    if (s.get(IT) == null) {
      makeIt(s, p);
    }
  }

  @Override
  public void input(SimulationHost s, HostPlayer p, Input in) {
    Body<HostEntity> body = p.body().body();
    body.seekVelocity(in.moveX() * 8, in.moveY() * 8, 10 * body.mass());
  }

  @Override
  public void afterStep(SimulationHost s) {
    HostPlayer it = s.get(IT);
    for (int id = 0; id < s.playerCapacity(); id++) {
      HostPlayer p = s.player(id);
      if (p == null || p == it) {
        continue;
      }
      if (it == null || (s.get(GRACE) == 0 && touches(it, p))) {
        makeIt(s, p);
        it = p;
      } else if (s.tick() % s.tickRate() == 0) {
        p.score(p.score() + 1);
      }
    }
  }

  private static boolean touches(HostPlayer a, HostPlayer b) {
    float dx = a.body().body().x() - b.body().body().x();
    float dy = a.body().body().y() - b.body().body().y();
    return dx * dx + dy * dy < 1.05f * 1.05f;
  }

  private void makeIt(SimulationHost s, HostPlayer p) {
    if (s.get(IT) != null) {
      s.get(IT).body().become(runner);
    }
    p.body().become(chaser); // a look belongs to an archetype
    s.set(IT, p);
    s.set(GRACE, s.ticks(1.5f)); // counts down by itself
    s.notice(p.name() + " is it!");
  }
}
