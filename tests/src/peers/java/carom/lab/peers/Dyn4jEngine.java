package carom.lab.peers;

import carom.lab.bench.PeerEngine;
import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.Joint;
import carom.physics.JointType;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import org.dyn4j.collision.CategoryFilter;
import org.dyn4j.dynamics.BodyFixture;
import org.dyn4j.dynamics.ContinuousDetectionMode;
import org.dyn4j.dynamics.joint.RevoluteJoint;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.MassType;
import org.dyn4j.geometry.Vector2;
import org.dyn4j.world.World;

/** Runs dyn4j, in double precision, with the iterations of its defaults' order. */
public final class Dyn4jEngine extends PeerEngine<org.dyn4j.dynamics.Body> {
  private World<org.dyn4j.dynamics.Body> world;

  /** Creates the engine, for the service loader. */
  public Dyn4jEngine() {}

  @Override
  public String name() {
    return "dyn4j";
  }

  @Override
  protected void open(carom.physics.World<?> start) {
    world = new World<>();
    world.setGravity(new Vector2(start.gravityX(), start.gravityY()));
    world.getSettings().setAtRestDetectionEnabled(start.def().sleeping());
    world.getSettings().setContinuousDetectionMode(ContinuousDetectionMode.NONE);
    world.getSettings().setVelocityConstraintSolverIterations(VELOCITY_ITERATIONS);
    world.getSettings().setPositionConstraintSolverIterations(POSITION_ITERATIONS);
  }

  @Override
  protected org.dyn4j.dynamics.Body add(Body<?> body) {
    org.dyn4j.dynamics.Body peer = new org.dyn4j.dynamics.Body();
    for (int i = 0; i < body.shapeCount(); i++) {
      for (Convex part : body.shape(i).parts()) {
        BodyFixture fixture = peer.addFixture(shape(part));
        fixture.setDensity(body.material(i).density());
        fixture.setFriction(body.material(i).friction());
        fixture.setRestitution(body.material(i).restitution());
        if (body.filter(i).group() < 0) {
          fixture.setFilter(new CategoryFilter(1, 2));
        }
      }
    }
    peer.setMass(body.type() == BodyType.DYNAMIC ? MassType.NORMAL : MassType.INFINITE);
    peer.rotate(Math.atan2(body.sin(), body.cos()));
    peer.translate(body.x(), body.y());
    peer.setLinearVelocity(body.velocityX(), body.velocityY());
    peer.setAngularVelocity(body.angularVelocity());
    peer.setGravityScale(body.gravityScale());
    peer.setAtRest(!body.awake());
    world.addBody(peer);
    return peer;
  }

  private static org.dyn4j.geometry.Convex shape(Convex part) {
    if (part instanceof Circle circle) {
      org.dyn4j.geometry.Circle peer = Geometry.createCircle(circle.radius());
      peer.translate(circle.centerX(), circle.centerY());
      return peer;
    }
    if (part.radius() > 0 || part.vertexCount() < 3) {
      throw new UnsupportedOperationException("shape " + part);
    }
    Vector2[] vertices = new Vector2[part.vertexCount()];
    for (int i = 0; i < vertices.length; i++) {
      vertices[i] = new Vector2(part.vertexX(i), part.vertexY(i));
    }
    return Geometry.createPolygon(vertices);
  }

  @Override
  protected void join(Joint<?> joint, org.dyn4j.dynamics.Body a, org.dyn4j.dynamics.Body b) {
    if (joint.type() != JointType.REVOLUTE) {
      throw new UnsupportedOperationException("joint " + joint.type());
    }
    world.addJoint(new RevoluteJoint<>(a, b, new Vector2(joint.anchorAX(), joint.anchorAY())));
  }

  @Override
  protected void step(float dtSeconds) {
    world.getSettings().setStepFrequency(dtSeconds);
    world.step(1);
  }

  @Override
  protected boolean awake(org.dyn4j.dynamics.Body peer) {
    return !peer.isStatic() && !peer.isAtRest();
  }

  @Override
  protected void read(org.dyn4j.dynamics.Body from, Body<?> into) {
    double angle = from.getTransform().getRotationAngle();
    into.setPose(
        (float) from.getTransform().getTranslationX(),
        (float) from.getTransform().getTranslationY(),
        (float) Math.cos(angle),
        (float) Math.sin(angle));
    into.setVelocity((float) from.getLinearVelocity().x, (float) from.getLinearVelocity().y);
    into.setAngularVelocity((float) from.getAngularVelocity());
  }
}
