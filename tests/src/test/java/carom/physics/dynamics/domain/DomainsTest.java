package carom.physics.dynamics.domain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.dynamics.contact.ContactTable;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Domains weigh the same and keep their slots in order while bodies come, go and touch. */
final class DomainsTest {
  /** Two of them hold so many bodies' states; threads never come closer to each other's. */
  private static final int CACHE_LINES = 128 / (Float.BYTES * SolverBodies.STRIDE);

  private final ActiveBodies active = new ActiveBodies();
  private final Domains domains = new Domains(active, null); // nobody mixes here, so no tree
  private final SolverSlots slots = new SolverSlots(active, domains);

  private void activate(int bodies) {
    active.reserve(bodies);
    for (int body = 0; body < bodies; body++) {
      active.add(body);
    }
  }

  /** A row of touching bodies, each with the next one. */
  private static ContactTable chain(int from, int to) {
    ContactTable table = new ContactTable();
    for (int body = from; body + 1 < to; body++) {
      int row = table.append();
      table.key[row] = ContactKey.of(body, 0, body + 1, 0);
      table.points[row] = 2;
    }
    return table;
  }

  /** Looks at every slot. */
  private void check(String when) {
    int[] bodies = new int[slots.count()];
    int found = 0;
    int before = 1; // behind the static body's
    for (int domain = 0; domain < domains.count(); domain++) {
      assertTrue(slots.idle(domain) >= before + CACHE_LINES, when);
      int expected = slots.idle(domain) + 1;
      for (boolean border : new boolean[] {false, true}) {
        assertEquals(expected, slots.from(domain, border), when);
        for (int slot = expected; slot < slots.to(domain, border); slot++) {
          int body = slots.body[slot];
          assertEquals(slot, slots.slotOf[body], when);
          assertEquals(domain, domains.of[body], when);
          assertEquals(border, domains.isAtBorder(body), when);
          bodies[slot] = body;
          found++;
        }
        expected = slots.to(domain, border);
      }
      before = expected;
    }
    assertEquals(active.count, found, when);
    assertEquals(before + CACHE_LINES, slots.count(), when);
    for (int body = 0; body < active.index.length; body++) {
      int slot = slots.slotOf[body];
      assertEquals(active.contains(body), slot > 0, when);
      assertTrue(slot == 0 || bodies[slot] == body, when);
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void slotsFollowDomainsAndBorders(long seed) {
    Random random = new Random(seed);
    int all = 1000 + random.nextInt(1000);
    activate(all);
    ContactTable table = chain(0, all);
    for (int round = 0; round < 100; round++) {
      String when = "seed=" + seed + " round=" + round;
      if (random.nextInt(10) == 0) {
        int body = random.nextInt(all);
        if (active.contains(body)) {
          active.remove(body);
        } else {
          active.add(body);
        }
      }
      domains.find(seed > 1 ? 4 : 1 + round / 50, table);
      domains.forgetBorders();
      for (int i = random.nextInt(60); i > 0; i--) {
        int body = random.nextInt(all);
        if (active.contains(body)) {
          domains.touch(random.nextInt(domains.count()), body);
        }
      }
      slots.assign();
      check(when);
    }
  }

  @Test
  void aDomainHasAsMuchToSolveAsAnother() {
    activate(4000);
    domains.find(2, chain(3000, 4000)); // the others are free, and cost less
    int first = 0;
    for (int body = 0; body < 4000; body++) {
      first += domains.of[body] == 0 ? 1 : 0;
      assertTrue(body == 0 || domains.of[body] >= domains.of[body - 1], "body=" + body);
    }
    // 2 for a body, 3 for each side of a contact: 14,000 - 6 in all, 6,000 of them before 3,000
    assertEquals(3000 + 1000 / 8, first, 2);
  }

  @Test
  void fewBodiesAreOneDomain() {
    activate(499);
    domains.find(8, chain(0, 499));
    assertEquals(1, domains.count());
    active.reserve(500);
    active.add(499);
    domains.find(8, chain(0, 500));
    assertEquals(2, domains.count());
  }

  @Test
  void domainsStayWhileTheSameBodiesAreActive() {
    activate(1000);
    ContactTable table = chain(0, 1000);
    domains.find(2, table);
    int edition = domains.edition();
    for (int step = 0; step < 32; step++) {
      domains.find(2, table);
      assertEquals(edition, domains.edition());
    }
    domains.find(2, table);
    assertTrue(domains.edition() != edition, "costs may have changed");
    edition = domains.edition();
    active.remove(7);
    domains.find(2, table);
    assertTrue(domains.edition() != edition);
  }
}
