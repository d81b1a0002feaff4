package carom.sim;

import carom.physics.Body;
import carom.physics.BodyDef;
import carom.physics.World;
import carom.physics.WorldDef;

/** Two bodies of a world of their own, which stand for those that a definition of a joint means. */
final class JointEnds {
  private static final World<Object> WORLD = new World<>(new WorldDef());
  static final Body<Object> FIRST = WORLD.createBody(new BodyDef(), "A");
  static final Body<Object> SECOND = WORLD.createBody(new BodyDef(), "B");

  private JointEnds() {}
}
