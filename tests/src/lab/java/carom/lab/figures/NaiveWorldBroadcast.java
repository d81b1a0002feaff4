package carom.lab.figures;

import carom.physics.Body;
import com.esotericsoftware.kryo.Kryo;
import com.esotericsoftware.kryo.io.Output;
import java.util.ArrayList;
import java.util.List;

/**
 * What one writes first: in each tick the whole world as a graph of objects, serialised by Kryo and
 * sent to everybody. A baseline to compare with, used by nothing else.
 */
final class NaiveWorldBroadcast {
  /** A point or a vector. */
  static final class Vector {
    float x;
    float y;

    /** For Kryo. */
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
    // As kindly as a naive sender can be: names are known, and no object is looked for twice.
    kryo.register(Vector.class);
    kryo.register(BodyObject.class);
    kryo.register(WorldObject.class);
    kryo.register(ArrayList.class);
    kryo.setReferences(false);
  }

  /** Bytes of one message, without a frame around it. */
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
