package carom.lab.peers;

import carom.lab.bench.PeerEngine;
import carom.physics.Joint;
import carom.physics.JointType;
import carom.physics.geometry.Circle;
import carom.physics.geometry.Convex;
import com.badlogic.gdx.math.Vector2;
import com.badlogic.gdx.physics.box2d.Body;
import com.badlogic.gdx.physics.box2d.BodyDef;
import com.badlogic.gdx.physics.box2d.BodyDef.BodyType;
import com.badlogic.gdx.physics.box2d.Box2D;
import com.badlogic.gdx.physics.box2d.CircleShape;
import com.badlogic.gdx.physics.box2d.FixtureDef;
import com.badlogic.gdx.physics.box2d.PolygonShape;
import com.badlogic.gdx.physics.box2d.Shape;
import com.badlogic.gdx.physics.box2d.Transform;
import com.badlogic.gdx.physics.box2d.World;
import com.badlogic.gdx.physics.box2d.joints.RevoluteJointDef;
import com.badlogic.gdx.utils.GdxNativesLoader;

/**
 * Runs libGDX's Box2D 2.3, native code behind JNI. Its natives load without a window. What it
 * allocates natively isn't in the row; that it calls back into Java for every contact is in its
 * times.
 */
public final class GdxBox2dEngine extends PeerEngine<Body> {
  private World world;

  /** Creates the engine, for the service loader. */
  public GdxBox2dEngine() {}

  @Override
  public String name() {
    return "gdx-box2d";
  }

  @Override
  protected void open(carom.physics.World<?> start) {
    GdxNativesLoader.load(); // buffers, which its bodies use; a window would have loaded them
    Box2D.init();
    close();
    world = new World(new Vector2(start.gravityX(), start.gravityY()), start.def().sleeping());
    world.setContinuousPhysics(false);
    world.setWarmStarting(true);
  }

  @Override
  protected Body add(carom.physics.Body<?> body) {
    BodyDef def = new BodyDef();
    def.type =
        switch (body.type()) {
          case STATIC -> BodyType.StaticBody;
          case KINEMATIC -> BodyType.KinematicBody;
          case DYNAMIC -> BodyType.DynamicBody;
        };
    def.position.set(body.x(), body.y());
    def.angle = (float) Math.atan2(body.sin(), body.cos());
    def.linearVelocity.set(body.velocityX(), body.velocityY());
    def.angularVelocity = body.angularVelocity();
    def.gravityScale = body.gravityScale();
    def.awake = body.awake();
    Body peer = world.createBody(def);
    for (int i = 0; i < body.shapeCount(); i++) {
      for (Convex part : body.shape(i).parts()) {
        FixtureDef fixture = new FixtureDef();
        fixture.shape = shape(part);
        fixture.density = body.material(i).density();
        fixture.friction = body.material(i).friction();
        fixture.restitution = body.material(i).restitution();
        fixture.filter.groupIndex = (short) body.filter(i).group();
        peer.createFixture(fixture);
        fixture.shape.dispose(); // the fixture has a copy
      }
    }
    return peer;
  }

  private static Shape shape(Convex part) {
    if (part instanceof Circle circle) {
      CircleShape peer = new CircleShape();
      peer.setRadius(circle.radius());
      peer.setPosition(new Vector2(circle.centerX(), circle.centerY()));
      return peer;
    }
    if (part.radius() > 0 || part.vertexCount() < 3) {
      throw new UnsupportedOperationException("shape " + part);
    }
    float[] vertices = new float[2 * part.vertexCount()];
    for (int i = 0; i < part.vertexCount(); i++) {
      vertices[2 * i] = part.vertexX(i);
      vertices[2 * i + 1] = part.vertexY(i);
    }
    PolygonShape peer = new PolygonShape();
    peer.set(vertices);
    return peer;
  }

  @Override
  protected void join(Joint<?> joint, Body a, Body b) {
    if (joint.type() != JointType.REVOLUTE) {
      throw new UnsupportedOperationException("joint " + joint.type());
    }
    RevoluteJointDef def = new RevoluteJointDef();
    def.initialize(a, b, new Vector2(joint.anchorAX(), joint.anchorAY()));
    world.createJoint(def);
  }

  @Override
  protected void step(float dtSeconds) {
    world.step(dtSeconds, VELOCITY_ITERATIONS, POSITION_ITERATIONS);
  }

  @Override
  protected boolean awake(Body peer) {
    return peer.getType() != BodyType.StaticBody && peer.isAwake();
  }

  @Override
  public void close() {
    super.close();
    if (world != null) {
      world.dispose(); // native memory, which no collector frees
      world = null;
    }
  }

  @Override
  protected void read(Body from, carom.physics.Body<?> into) {
    float[] pose = from.getTransform().vals;
    into.setPose(
        pose[Transform.POS_X], pose[Transform.POS_Y], pose[Transform.COS], pose[Transform.SIN]);
    into.setVelocity(from.getLinearVelocity().x, from.getLinearVelocity().y);
    into.setAngularVelocity(from.getAngularVelocity());
  }
}
