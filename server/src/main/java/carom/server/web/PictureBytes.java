package carom.server.web;

import carom.server.room.Picture;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * A picture's numbers as the page reads them: 32-bit integers and floats, little endian.
 *
 * <pre>
 *   8 integers   tick, counts of bodies, joints, cells, contacts, priorities, player bodies, pools
 *   bodies       slot (bit 31: awake), x, y, angle
 *   joints       type, slots, anchors      cells     edges, depth
 *   contacts     place, normal, impulse    priorities one of each body, or none
 *   player bodies  player, slot        pools     colour, spacing, count, places
 * </pre>
 */
final class PictureBytes {
  private static final int HEAD = 8;
  private static final int BODY = 4;
  private static final int POOL = 3;
  private static final int AWAKE = 1 << 31;
  private static final float[] NOTHING = {};

  private PictureBytes() {}

  /**
   * Encodes a picture.
   *
   * @param priorityOf id of the player whose priorities are wanted, or -1
   */
  static ByteBuffer of(Picture picture, boolean cells, boolean contacts, int priorityOf) {
    float[] trees = cells ? picture.cells() : NOTHING;
    float[] points = contacts ? picture.contacts() : NOTHING;
    float[] priorities = picture.priorities().getOrDefault(priorityOf, NOTHING);
    int bodies = picture.bodies().size();
    int words =
        HEAD
            + picture.particles().stream().mapToInt(pool -> POOL + pool.xy().length).sum()
            + BODY * bodies
            + picture.joints().length
            + trees.length
            + points.length
            + priorities.length
            + picture.playerBodies().length;
    ByteBuffer out = ByteBuffer.allocate(Integer.BYTES * words).order(ByteOrder.LITTLE_ENDIAN);
    out.putInt(picture.tick())
        .putInt(bodies)
        .putInt(picture.joints().length / Picture.JOINT)
        .putInt(trees.length / Picture.CELL)
        .putInt(points.length / Picture.CONTACT)
        .putInt(priorities.length)
        .putInt(picture.playerBodies().length / 2)
        .putInt(picture.particles().size());
    for (int i = 0; i < bodies; i++) {
      out.putInt(picture.bodies().get(i).slot() | (picture.awake()[i] ? AWAKE : 0));
      for (int k = 0; k < Picture.POSE; k++) {
        out.putFloat(picture.poses()[Picture.POSE * i + k]);
      }
    }
    put(out, picture.joints());
    put(out, trees);
    put(out, points);
    put(out, priorities);
    for (int value : picture.playerBodies()) {
      out.putInt(value);
    }
    for (Picture.Pool pool : picture.particles()) {
      out.putInt(pool.rgb()).putFloat(pool.spacing()).putInt(pool.xy().length / 2);
      put(out, pool.xy());
    }
    return out.flip();
  }

  private static void put(ByteBuffer out, float[] values) {
    for (float value : values) {
      out.putFloat(value);
    }
  }
}
