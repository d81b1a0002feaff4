package hill;

import static carom.sim.event.Audience.NEAR;
import static carom.sim.field.Scope.PLAYER;

import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.physics.math.Trig;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.field.Countdown;
import carom.sim.field.Field;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import java.util.List;

/** Players push each other off the summit. The one who stands on it gains a point a second. */
public final class HillGame implements Game {
  private static final Countdown DASH = Field.countdown("dash").of(PLAYER).to(NEAR);

  private Archetype disc;

  @Override
  public String name() {
    return "hill";
  }

  @Override
  public String defaultLevel() {
    return "hill";
  }

  @Override
  public List<Field<?>> fields() {
    return List.of(DASH);
  }

  @Override
  public void setUp(SetUp s) {
    disc =
        s.archetype(
            new ArchetypeDef("disc")
                .shape(new Circle(0.5f), new Material(1, 0.2f, 0.5f))
                .appearance(Appearance.of(0x4cc9f0, Appearance.Look.PLAYER)));
  }

  @Override
  public void join(Match m, Player p) {
    List<Level.Spawn> spots = m.level().spawns("player");
    Level.Spawn spot = spots.get(p.id() % spots.size());
    m.spawn(disc, spot.x(), spot.y(), 0, p);
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    Entity body = p.entity();
    body.seekVelocity(in.moveX() * 8, in.moveY() * 8, 12);
    if (in.held(Input.ACTION) && p.get(DASH) == 0) {
      p.set(DASH, s.ticks(1));
      float impulse = 10 * body.mass();
      body.applyImpulse(impulse * Trig.cos(in.aim()), impulse * Trig.sin(in.aim()));
    }
  }

  @Override
  public void afterStep(Match m) {
    if (m.tick() % m.tickRate() != 0) {
      return;
    }
    Level.Zone summit = m.level().zones("summit").get(0);
    for (Player p : m.players()) {
      if (summit.contains(p.entity().x(), p.entity().y())) {
        m.addScore(p, 1);
      }
    }
  }
}
