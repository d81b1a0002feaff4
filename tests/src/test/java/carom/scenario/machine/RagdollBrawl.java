package carom.scenario.machine;

import carom.physics.Body;
import carom.physics.JointDef;
import carom.physics.Material;
import carom.physics.geometry.Capsule;
import carom.physics.geometry.Circle;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Assembly;
import carom.sim.entity.AssemblyDef;
import carom.sim.entity.Contact;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.EventKind;
import carom.sim.field.Count;
import carom.sim.field.Countdown;
import carom.sim.field.Field;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import java.util.List;

/** Ragdolls that hover upright and throw punches. A hard blow to the head costs health. */
final class RagdollBrawl implements Game {
  static final Count HEALTH = Field.count("health", 0, 100).startsAt(100);
  static final Countdown TIRED = Field.countdown("tired");

  static final String LEVEL =
      """
      {"name": "Ring", "game": "ragdollBrawl", "gravity": [0, -10],
       "bounds": {"min": [-20, -5], "max": [20, 20]},
       "spawns": [{"at": [-6, 2]}, {"at": [6, 2]}],
       "statics": [
         {"at": [0, -1], "shape": {"type": "box", "width": 40, "height": 2}},
         {"at": [0, 12], "shape": {"type": "box", "width": 40, "height": 2}},
         {"at": [-12, 5], "shape": {"type": "box", "width": 1, "height": 16}, "repeat": {"columns": 2, "step": [24, 0]}}],
       "bodies": [{"at": [-2, 0.5], "shape": {"type": "box", "width": 0.8, "height": 0.8},
         "repeat": {"columns": 4, "step": [1.4, 0]}}]}
      """;

  private Assembly fighter;
  private EventKind blow;

  @Override
  public String name() {
    return "ragdollBrawl";
  }

  @Override
  public String defaultLevel() {
    return "ring";
  }

  @Override
  public List<Field<?>> fields() {
    return List.of(HEALTH, TIRED);
  }

  @Override
  public void setUp(SetUp s) {
    Material flesh = new Material(1, 0.6f, 0.1f);
    AssemblyDef def =
        new AssemblyDef("fighter")
            .body("torso", limb("torso", 0.6f, 0.17f, flesh), 0, 0)
            .body("head", new ArchetypeDef("head").shape(new Circle(0.17f), flesh), 0, 0.36f)
            .joint("neck", "torso", "head", (a, b) -> hinge(a, b, 0, 0.2f, 0.5f));
    for (int side = -1; side <= 1; side += 2) {
      String name = side < 0 ? "left " : "right ";
      float x = 0.1f * side;
      def.body(name + "arm", limb("arm", 0.5f, 0.07f, flesh), 2.2f * x, 0)
          .body(name + "leg", limb("leg", 0.6f, 0.09f, flesh), x, -0.7f)
          .joint(name + "shoulder", "torso", name + "arm", (a, b) -> hinge(a, b, 2.2f * x, 0, 2.5f))
          .joint(name + "hip", "torso", name + "leg", (a, b) -> hinge(a, b, x, -0.7f, 1));
    }
    fighter = s.assembly(def);
    blow = s.event("blow", 0xef476f, 1, "hit");
  }

  private static ArchetypeDef limb(String name, float length, float radius, Material flesh) {
    return new ArchetypeDef(name)
        .shape(new Capsule(0, 0, 0, -length, radius), flesh)
        .angularDamping(1);
  }

  private static JointDef<Object> hinge(
      Body<Object> a, Body<Object> b, float x, float y, float most) {
    return JointDef.revolute(a, b, x, y).limits(-most, most);
  }

  @Override
  public void join(Match s, Player p) {
    List<Level.Spawn> spots = s.level().spawns("player");
    Level.Spawn spot = spots.get(p.id() % spots.size());
    s.spawn(fighter, spot.x(), spot.y(), 0, p);
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    Entity torso = p.entity();
    torso.applyForce(in.moveX() * 60, 18 + in.moveY() * 40);
    torso.applyTorque(-8 * torso.angle() - torso.angularVelocity());
    Entity arm = p.entity().part(in.moveX() < 0 ? "left arm" : "right arm");
    if (in.held(Input.ACTION) && p.get(TIRED) == 0 && arm != null) {
      p.set(TIRED, s.ticks(0.6f));
      arm.applyAngularImpulse(in.moveX() < 0 ? -0.5f : 0.5f);
    }
  }

  @Override
  public void hit(Simulation s, Contact c) {
    Entity a = c.self();
    Entity b = c.other();
    Entity head = a.archetype().name().equals("head") ? a : b;
    Player owner = head.owner();
    if (head.archetype().name().equals("head") && owner != null && c.impulse() > 1) {
      owner.add(HEALTH, -Math.round(c.impulse()));
      s.emit(blow).at(head.x(), head.y());
    }
  }
}
