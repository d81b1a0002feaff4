package carom.physics.dynamics;

import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.store.IntList;
import java.util.Arrays;

/**
 * The bodies that had a contact in the last step which a call has ended since, such as that which
 * destroys the other body. They may have been pushed by what no longer shows. No part of the state;
 * one world's.
 */
final class EndedContacts {
  private final ContactTable contacts;
  private final IntList bodies = new IntList();
  private boolean[] contained = new boolean[64]; // by slot

  EndedContacts(ContactTable contacts) {
    this.contacts = contacts;
  }

  /** Forgets all: a step begins. */
  void clear() {
    for (int i = 0; i < bodies.count; i++) {
      contained[bodies.values[i]] = false;
    }
    bodies.count = 0;
  }

  /** Adds both bodies of a contact that is about to end. */
  void add(int row) {
    addBody(contacts.bodyA(row));
    addBody(contacts.bodyB(row));
  }

  private void addBody(int body) {
    if (body >= contained.length) {
      contained = Arrays.copyOf(contained, 2 * body);
    }
    if (!contained[body]) {
      contained[body] = true;
      bodies.add(body);
    }
  }

  /** Returns whether a body is one of them. */
  boolean has(int body) {
    return body < contained.length && contained[body];
  }
}
