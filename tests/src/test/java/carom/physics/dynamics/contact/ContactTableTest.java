package carom.physics.dynamics.contact;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.physics.collision.Manifold;
import org.junit.jupiter.api.Test;

/** Which impulses contact points inherit. An id names a corner of A, then one of B. */
final class ContactTableTest {
  private final ContactTable table = new ContactTable();
  private final Manifold manifold = new Manifold();
  private final int row = table.append();

  private void touch(int id, int otherId) {
    manifold.count = 1;
    manifold.id0 = id;
    manifold.otherId0 = otherId;
    table.update(row, manifold);
  }

  private void touch(int id0, int otherId0, int id1, int otherId1) {
    manifold.count = 2;
    manifold.id0 = id0;
    manifold.otherId0 = otherId0;
    manifold.id1 = id1;
    manifold.otherId1 = otherId1;
    table.update(row, manifold);
  }

  private void load(float first, float second) {
    int at = row * ContactTable.CONTACT;
    table.contact[at + ContactTable.NORMAL0] = first;
    table.contact[at + ContactTable.TANGENT0] = first / 2;
    table.contact[at + ContactTable.NORMAL1] = second;
    table.contact[at + ContactTable.TANGENT1] = second / 2;
  }

  private void assertLoad(float first, float second) {
    int at = row * ContactTable.CONTACT;
    assertEquals(first, table.contact[at + ContactTable.NORMAL0]);
    assertEquals(first / 2, table.contact[at + ContactTable.TANGENT0]);
    assertEquals(second, table.contact[at + ContactTable.NORMAL1]);
    assertEquals(second / 2, table.contact[at + ContactTable.TANGENT1]);
  }

  @Test
  void aSinglePointKeepsItsLoadUnderEitherId() {
    touch(0x200, 0x300);
    load(5, 0);
    touch(0x300, 0x200);
    assertLoad(5, 0);
    touch(0x301, 0x201); // another corner
    assertLoad(0, 0);
  }

  @Test
  void itKeepsItWhenAnotherPointComesOrGoes() {
    touch(0x103, 0x003);
    load(5, 0);
    touch(0x102, 0x002, 0x003, 0x103);
    assertLoad(0, 5);
    load(3, 5);
    touch(0x103, 0x003);
    assertLoad(5, 0);
  }

  @Test
  void itKeepsItWhenAnObtuseCornerRollsOn() {
    touch(0x102, 0x202, 0x201, 0x101);
    load(3, 5);
    touch(0x103, 0x203, 0x202, 0x102); // corner 2 was the first point, and is the second
    assertLoad(0, 3);
  }

  @Test
  void ownIdsGoFirst() {
    touch(0x102, 0x102, 0x201, 0x201);
    load(3, 5);
    touch(0x201, 0x102);
    assertLoad(5, 0);
  }
}
