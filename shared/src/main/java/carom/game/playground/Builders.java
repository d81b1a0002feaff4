package carom.game.playground;

import static carom.game.playground.PlaygroundFields.AT_X;
import static carom.game.playground.PlaygroundFields.AT_Y;
import static carom.game.playground.PlaygroundFields.HELD;
import static carom.game.playground.PlaygroundFields.LINKS;
import static carom.game.playground.PlaygroundFields.LINK_A;
import static carom.game.playground.PlaygroundFields.LINK_B;
import static carom.game.playground.PlaygroundFields.MAX_LINKS;
import static carom.game.playground.PlaygroundFields.MAX_MOTORS;
import static carom.game.playground.PlaygroundFields.MOTOR;
import static carom.game.playground.PlaygroundFields.MOTORS;

import carom.physics.Body;
import carom.physics.JointDef;
import carom.physics.math.Trig;
import carom.sim.Match;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityFilter;
import carom.sim.entity.EntityHit;
import carom.sim.entity.EntityJoint;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import java.util.function.BiFunction;

/**
 * Joints that players make and cut; the server's. A joint is made at the point where the beam holds
 * a thing, with the nearest other thing there; a rope flies along the aim, and sticks to what it
 * hits. A player has {@value PlaygroundFields#MAX_LINKS} joints: the oldest one goes first.
 */
final class Builders {
  private static final float TOUCH = 0.7f; // between the held point and the other thing, m
  private static final float ROPE = 9; // m

  private final Yard yard;
  private final EntityHit hit = new EntityHit();
  private final EntityFilter others = this::isOther;
  private final EntityFilter ends;
  private Entity held; // scratch

  Builders(Yard yard) {
    this.yard = yard;
    ends = e -> e != held && !yard.isRobot(e);
  }

  private boolean isOther(Entity e) {
    return e != held && yard.isLoose(e) && e.archetype() != yard.star;
  }

  /** Makes and cuts the joints that players ask for in this tick. */
  void beforeStep(Match m) {
    for (Player p : m.players()) {
      held = p.get(HELD);
      Input in = m.input(p);
      if (p.isAlive() && held != null && held.archetype() != yard.star) {
        build(m, p, in);
      }
    }
    held = null;
  }

  private void build(Match m, Player p, Input in) {
    float x = held.worldPointX(p.get(AT_X), p.get(AT_Y));
    float y = held.worldPointY(p.get(AT_X), p.get(AT_Y));
    if (in.pressed(PlaygroundGame.CUT)) {
      held.forEachJoint(EntityJoint::destroy);
      m.emit(yard.cut).at(x, y).of(held).by(p);
    } else if (in.pressed(PlaygroundGame.WELD)) {
      join(m, p, x, y, (a, b) -> JointDef.weld(a, b, x, y));
    } else if (in.pressed(PlaygroundGame.HINGE)) {
      join(m, p, x, y, (a, b) -> JointDef.revolute(a, b, x, y));
    } else if (in.pressed(PlaygroundGame.MOTOR)) {
      if (join(m, p, x, y, (a, b) -> JointDef.revolute(a, b, x, y).motor(0, Hands.TORQUE))) {
        p.set(MOTOR, p.get(MOTORS), held);
        p.set(MOTORS, (p.get(MOTORS) + 1) % MAX_MOTORS);
      }
    } else if (in.pressed(PlaygroundGame.ROPE)) {
      float wayX = ROPE * Trig.cos(in.aim());
      float wayY = ROPE * Trig.sin(in.aim());
      if (m.queries().rayClosest(x, y, wayX, wayY, ends, hit)) {
        float endX = hit.x();
        float endY = hit.y();
        float length = Math.max(0.3f, hit.distance());
        Entity end = hit.entity().isLevel() ? null : hit.entity();
        link(m, p, end, x, y, (a, b) -> JointDef.rope(a, b, endX, endY, x, y, length));
      }
    }
  }

  private boolean join(
      Match m,
      Player p,
      float x,
      float y,
      BiFunction<Body<Object>, Body<Object>, JointDef<Object>> how) {
    boolean found = m.queries().nearest(x, y, TOUCH, others, hit);
    if (found) {
      link(m, p, hit.entity(), x, y, how);
    }
    return found;
  }

  private void link(
      Match m,
      Player p,
      Entity to,
      float x,
      float y,
      BiFunction<Body<Object>, Body<Object>, JointDef<Object>> how) {
    int at = p.get(LINKS);
    forget(p.get(LINK_A, at), p.get(LINK_B, at));
    m.connect(to, held, how);
    p.set(LINK_A, at, to);
    p.set(LINK_B, at, held);
    p.set(LINKS, (at + 1) % MAX_LINKS);
    m.emit(yard.joined).at(x, y).of(held).by(p);
  }

  /** Destroys a joint of b with a; null for the world, or for what is gone. */
  private static void forget(Entity a, Entity b) {
    if (b != null) {
      b.forEachJoint(
          joint -> {
            if (joint.b() == b && joint.a() == a) {
              joint.destroy();
            }
          });
    }
  }
}
