package carom.lab.peers;

import carom.lab.bench.PeerEngine;
import carom.physics.Body;
import carom.physics.Joint;
import carom.physics.JointType;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.collision.shapes.Shape;
import org.jbox2d.common.Vec2;
import org.jbox2d.dynamics.BodyDef;
import org.jbox2d.dynamics.BodyType;
import org.jbox2d.dynamics.FixtureDef;
import org.jbox2d.dynamics.World;
import org.jbox2d.dynamics.joints.RevoluteJointDef;

/** Runs JBox2D, the port of Box2D 2.2. */
public final class Jbox2dEngine extends PeerEngine<org.jbox2d.dynamics.Body> {
  private World world;

  /** Creates the engine, for the service loader. */
  public Jbox2dEngine() {}

  @Override
  public String name() {
    return "jbox2d";
  }

  @Override
  protected void open(carom.physics.World<?> start) {
    world = new World(new Vec2(start.gravityX(), start.gravityY()));
    world.setAllowSleep(start.def().sleeping());
    world.setContinuousPhysics(false);
    world.setWarmStarting(true);
  }

  @Override
  protected org.jbox2d.dynamics.Body add(Body<?> body) {
    BodyDef def = new BodyDef();
    def.type =
        switch (body.type()) {
          case STATIC -> BodyType.STATIC;
          case KINEMATIC -> BodyType.KINEMATIC;
          case DYNAMIC -> BodyType.DYNAMIC;
        };
    def.position.set(body.x(), body.y());
    def.angle = (float) Math.atan2(body.sin(), body.cos());
    def.linearVelocity.set(body.velocityX(), body.velocityY());
    def.angularVelocity = body.angularVelocity();
    def.gravityScale = body.gravityScale();
    def.awake = body.awake();
    org.jbox2d.dynamics.Body peer = world.createBody(def);
    for (int i = 0; i < body.shapeCount(); i++) {
      for (Convex part : body.shape(i).parts()) {
        FixtureDef fixture = new FixtureDef();
        fixture.shape = shape(part);
        fixture.density = body.material(i).density();
        fixture.friction = body.material(i).friction();
        fixture.restitution = body.material(i).restitution();
        fixture.filter.groupIndex = body.filter(i).group();
        peer.createFixture(fixture);
      }
    }
    return peer;
  }

  private static Shape shape(Convex part) {
    if (part instanceof Circle circle) {
      CircleShape peer = new CircleShape();
      peer.m_radius = circle.radius();
      peer.m_p.set(circle.centerX(), circle.centerY());
      return peer;
    }
    if (part.radius() > 0 || part.vertexCount() < 3) {
      throw new UnsupportedOperationException("shape " + part);
    }
    Vec2[] vertices = new Vec2[part.vertexCount()];
    for (int i = 0; i < vertices.length; i++) {
      vertices[i] = new Vec2(part.vertexX(i), part.vertexY(i));
    }
    PolygonShape peer = new PolygonShape();
    peer.set(vertices, vertices.length);
    return peer;
  }

  @Override
  protected void join(Joint<?> joint, org.jbox2d.dynamics.Body a, org.jbox2d.dynamics.Body b) {
    if (joint.type() != JointType.REVOLUTE) {
      throw new UnsupportedOperationException("joint " + joint.type());
    }
    RevoluteJointDef def = new RevoluteJointDef();
    def.initialize(a, b, new Vec2(joint.anchorAX(), joint.anchorAY()));
    world.createJoint(def);
  }

  @Override
  protected void step(float dtSeconds) {
    world.step(dtSeconds, VELOCITY_ITERATIONS, POSITION_ITERATIONS);
  }

  @Override
  protected boolean awake(org.jbox2d.dynamics.Body peer) {
    return peer.getType() != BodyType.STATIC && peer.isAwake();
  }

  @Override
  protected void read(org.jbox2d.dynamics.Body from, Body<?> into) {
    Vec2 at = from.getPosition();
    into.setPose(at.x, at.y, (float) Math.cos(from.getAngle()), (float) Math.sin(from.getAngle()));
    into.setVelocity(from.getLinearVelocity().x, from.getLinearVelocity().y);
    into.setAngularVelocity(from.getAngularVelocity());
  }
}
