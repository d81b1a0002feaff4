package carom.physics.dynamics;

import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.pairs.PairFinder;

/** Decides anew which parts may touch, at the next step after types, filters or joints changed. */
final class Refilter {
  private final ContactTable contacts;
  private final PairFinder pairs;
  private final LostLoads lost;
  private boolean stale;

  Refilter(ContactTable contacts, PairFinder pairs, LostLoads lost) {
    this.lost = lost;
    this.contacts = contacts;
    this.pairs = pairs;
  }

  /** Notes that types, filters or joints changed. */
  void markStale() {
    stale = true;
  }

  /** Decides for each row whether its parts still may touch, and requests a search of all pairs. */
  void run() {
    if (!stale) {
      return;
    }
    stale = false;
    pairs.searchAll();
    for (int row = 0; row < contacts.count(); row++) {
      boolean ends = !pairs.mayStay(contacts, row);
      contacts.ignore(row, ends);
      if (ends) {
        lost.losesContact(row);
      }
    }
    lost.settle();
  }
}
