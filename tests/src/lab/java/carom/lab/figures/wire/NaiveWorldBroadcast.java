package carom.lab.figures.wire;

import carom.physics.Body;
import com.esotericsoftware.kryo.Kryo;
import com.esotericsoftware.kryo.io.Output;
import java.util.ArrayList;
import java.util.List;

/**
 * The naive way to replicate a world: in each tick Kryo serialises the whole world as a graph of
 * objects, and the server sends it to all clients. Only a baseline for comparisons.
 */
final class NaiveWorldBroadcast {
  /** A point or a vector. */
  static final class Vector {
    float x;
    float y;

    /** Creates the vector (0, 0), for Kryo. */
    Vector() {}

    Vector(float x, float y) {
      this.x = x;
      this.y = y;
    }
  }

  /** A body. */
  static final class BodyObject {
    int id;
    Vector position;
    Vector velocity;
    float angle;
    float angularVelocity;
  }

  /** The world. */
  static final class WorldObject {
    int tick;
    List<BodyObject> bodies = new ArrayList<>();
  }

  private final Kryo kryo = new Kryo();
  private final Output output = new Output(1 << 12, -1);

  NaiveWorldBroadcast() {
    // The best that a naive sender can do: classes are registered and references are off.
    kryo.register(Vector.class);
    kryo.register(BodyObject.class);
    kryo.register(WorldObject.class);
    kryo.register(ArrayList.class);
    kryo.setReferences(false);
  }

  /** Returns the bytes of one message without framing. */
  int bytes(int tick, List<Body<String>> bodies) {
    WorldObject world = new WorldObject();
    world.tick = tick;
    for (int i = 0; i < bodies.size(); i++) {
      Body<String> body = bodies.get(i);
      BodyObject object = new BodyObject();
      object.id = i;
      object.position = new Vector(body.x(), body.y());
      object.velocity = new Vector(body.velocityX(), body.velocityY());
      object.angle = body.angle();
      object.angularVelocity = body.angularVelocity();
      world.bodies.add(object);
    }
    output.reset();
    kryo.writeObject(output, world);
    return output.position();
  }
}
