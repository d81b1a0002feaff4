package carom.physics.dynamics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.physics.collision.Manifold;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Which impulses a contact point inherits. An id names a corner of A, then a corner of B. */
final class ContactTableTest {
  private final ContactTable table = new ContactTable();
  private final Manifold manifold = new Manifold();

  private void touch(int row, int id, float x, float angle) {
    manifold.count = 1;
    manifold.id0 = id;
    manifold.x0 = x;
    manifold.normalX = (float) Math.sin(angle);
    manifold.normalY = (float) Math.cos(angle);
    table.update(row, manifold);
  }

  /**
   * A corner that stands on a face at 45 degrees is paired with one or the other end of that face,
   * as rounding has it. It is the same point, and what rests on it must not drop.
   */
  @ParameterizedTest
  @CsvSource({
    "0x200, 0x200, 0, 0, 5", // the same point
    "0x200, 0x300, 0, 0, 5", // a corner of B, with the other end of A's face
    "0x103, 0x100, 0, 0, 5", // a corner of A, with the other end of B's face
    "0x200, 0x300, 0.01, 0.1, 5", // it rolls a little
    "0x200, 0x300, 0.03, 0, 0", // another corner, with the same end of the face
    "0x200, 0x300, 0, 0.4, 0", // another side pushes
    "0x200, 0x301, 0, 0, 0" // another corner on another end
  })
  void aCornerKeepsItsLoad(String before, String after, float x, float angle, float load) {
    int row = table.append();
    touch(row, Integer.decode(before), 0, 0);
    table.contact[row * ContactTable.CONTACT + ContactTable.NORMAL0] = 5;
    table.contact[row * ContactTable.CONTACT + ContactTable.TANGENT0] = 2;
    touch(row, Integer.decode(after), x, angle);
    assertEquals(load, table.contact[row * ContactTable.CONTACT + ContactTable.NORMAL0]);
    assertEquals(0.4f * load, table.contact[row * ContactTable.CONTACT + ContactTable.TANGENT0]);
  }
}
