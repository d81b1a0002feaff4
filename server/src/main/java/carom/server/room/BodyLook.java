package carom.server.room;

import carom.physics.Body;
import carom.physics.BodyType;
import carom.physics.geometry.Shape;
import carom.sim.entity.HostEntity;
import java.util.ArrayList;
import java.util.List;

/**
 * The properties of a body that seldom change. Pictures hold the same object until it does.
 * Immutable.
 *
 * @param slot the body's slot in the world; another body gets it when this one is gone
 * @param entity id of its entity, {@link HostEntity#LEVEL} for bodies of the level that are no
 *     entities
 * @param owner id of the player that owns it, or {@link HostEntity#NO_OWNER}
 * @param kind name of its archetype
 * @param type whether and how it moves
 * @param rgb colour, 0xRRGGBB
 * @param sensor whether all its shapes are sensors
 * @param shapes shapes in the body's frame
 */
public record BodyLook(
    int slot,
    int entity,
    int owner,
    String kind,
    BodyType type,
    int rgb,
    boolean sensor,
    List<Shape> shapes) {
  /** Describes a body. The room's thread. */
  static BodyLook of(Body<HostEntity> body) {
    HostEntity e = body.user();
    boolean sensor = body.shapeCount() > 0;
    List<Shape> shapes = new ArrayList<>(body.shapeCount());
    for (int i = 0; i < body.shapeCount(); i++) {
      shapes.add(body.shape(i));
      sensor &= body.sensor(i);
    }
    return new BodyLook(
        body.index(),
        e == null ? HostEntity.LEVEL : e.id(),
        e == null ? HostEntity.NO_OWNER : e.ownerId(),
        kindOf(e),
        body.type(),
        rgbOf(e),
        sensor,
        List.copyOf(shapes));
  }

  private static String kindOf(HostEntity e) {
    return e == null ? "" : e.archetype().name();
  }

  private static int rgbOf(HostEntity e) {
    return e == null ? 0 : e.archetype().appearance().rgb();
  }

  /** Returns whether the body is still of this kind and colour, and moves and is shaped alike. */
  boolean isOf(Body<HostEntity> body) {
    if (type != body.type()
        || shapes.size() != body.shapeCount()
        || rgb != rgbOf(body.user())
        || !kind.equals(kindOf(body.user()))) {
      return false;
    }
    boolean sensors = !shapes.isEmpty();
    for (int i = 0; i < shapes.size(); i++) {
      if (shapes.get(i) != body.shape(i)) {
        return false;
      }
      sensors &= body.sensor(i);
    }
    return sensor == sensors;
  }
}
