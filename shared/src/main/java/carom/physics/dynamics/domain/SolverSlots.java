package carom.physics.dynamics.domain;

import carom.physics.dynamics.body.ActiveBodies;
import java.util.Arrays;

/**
 * Says which slot of the solver's state each active body has. All other bodies have slot 0.
 *
 * <pre>
 *   slot  0       1-4      5     6 ...     ...          ...
 *        static  unused  idle  inner      border      unused  idle  inner      border     unused
 *                              |---- domain 0 -----|                |---- domain 1 -----|
 * </pre>
 *
 * <p>Before its first slot a domain has an <i>idle</i> one that belongs to no body: lanes without a
 * contact write there. The unused slots keep two domains a pair of cache lines apart, so threads
 * share lines only where bodies are at borders. No bit of a result depends on slots. One thread at
 * a time.
 */
final class SolverSlots {
  /**
   * Unused slots between what different threads write to: two cache lines, as they come in pairs.
   */
  private static final int APART = 4;

  private final ActiveBodies active;
  private final Domains domains;

  /** Per body: its slot. */
  public int[] slotOf = new int[0];

  /** Per slot: its body. */
  public int[] body = new int[1];

  private int count = 1;

  /** Per domain: its first slot. */
  private int[] first = new int[1];

  /** Per domain: its first slot of a body at the border. */
  private int[] firstAtBorder = new int[1];

  /** Per domain: the slot behind its last one. */
  private int[] end = new int[1];

  /** {@link Domains#edition} that the slots are of. */
  private int edition = -1;

  /** Makes slots for these bodies, by these domains. */
  public SolverSlots(ActiveBodies active, Domains domains) {
    this.active = active;
    this.domains = domains;
  }

  /** Returns how many slots there are, the static one and unused ones included. */
  public int count() {
    return count;
  }

  /** Returns how many slots there is room for, at least {@link #count}. */
  public int capacity() {
    return body.length;
  }

  /** Returns the first slot of a part of a domain. */
  public int from(int domain, boolean border) {
    return border ? firstAtBorder[domain] : first[domain];
  }

  /** Returns the slot behind the last one of a part of a domain. */
  public int to(int domain, boolean border) {
    return border ? end[domain] : firstAtBorder[domain];
  }

  /** Returns the slot of a domain that no body has. */
  public int idle(int domain) {
    return first[domain] - 1;
  }

  /**
   * Gives every active body a slot and the others none, by domains and borders. While domains stay
   * the same only bodies change places that came to a border or left it.
   */
  public void assign() {
    if (edition == domains.edition()) {
      for (int i = 0; i < domains.beforeCount; i++) {
        leaveBorder(domains.before[i]);
      }
      for (int i = 0; i < domains.borderCount; i++) {
        comeToBorder(domains.atBorder[i]);
      }
      return;
    }
    edition = domains.edition();
    if (slotOf.length < active.index.length) { // bodies may come that don't move
      slotOf = Arrays.copyOf(slotOf, active.index.length);
    }
    for (int i = 1; i < count; i++) {
      slotOf[body[i]] =
          0; // or that of the body that was in an unused slot once: all get theirs below
    }
    int n = domains.count();
    if (firstAtBorder.length < n) {
      first = new int[n];
      firstAtBorder = new int[n];
      end = new int[n];
    }
    Arrays.fill(end, 0, n, 0);
    for (int i = 0; i < active.count; i++) {
      end[domains.of[active.list[i]]]++;
    }
    count = 1;
    for (int domain = 0; domain < n; domain++) {
      first[domain] = count + APART + 1;
      firstAtBorder[domain] = first[domain];
      end[domain] += first[domain];
      count = end[domain];
    }
    count += APART;
    if (body.length < count) {
      body = new int[count + active.list.length - active.count];
    }
    for (int i = 0; i < active.count; i++) {
      int one = active.list[i];
      put(one, firstAtBorder[domains.of[one]]++);
    }
    for (int i = 0; i < domains.borderCount; i++) {
      comeToBorder(domains.atBorder[i]);
    }
  }

  private void leaveBorder(int one) {
    int domain = domains.of[one];
    if (!domains.isAtBorder(one)) {
      swap(one, firstAtBorder[domain]++);
    }
  }

  private void comeToBorder(int one) {
    int domain = domains.of[one];
    if (slotOf[one] < firstAtBorder[domain]) {
      swap(one, --firstAtBorder[domain]);
    }
  }

  private void swap(int one, int slot) {
    put(body[slot], slotOf[one]);
    put(one, slot);
  }

  private void put(int one, int slot) {
    body[slot] = one;
    slotOf[one] = slot;
  }
}
