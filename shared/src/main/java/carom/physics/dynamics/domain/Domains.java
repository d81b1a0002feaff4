package carom.physics.dynamics.domain;

import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.pairs.PairFinder;
import java.util.Arrays;

/**
 * Divides the active bodies into domains of the world: one where a thread steps alone, else one per
 * thread, all with about as much to solve. Bodies of a domain are near each other, so that few
 * touch those of another.
 *
 * <p>Domains are cut from the list of active bodies as it is, while neighbours in it are neighbours
 * in the world: then each thread finds the rows of its contacts where it left them after the narrow
 * phase, which goes by the same order. When bodies have mixed, domains are cut from the tree in
 * which pairs are searched.
 *
 * <p>Domains decide which thread does what, and no bit of a result. They stay the same for {@value
 * #LASTING} steps while the same bodies are active. One thread at a time.
 */
public final class Domains {
  /** Number of steps that domains stay the same while the same bodies are active. */
  private static final int LASTING = 32;

  /** Fewest active bodies per domain: fewer aren't worth a thread. */
  private static final int LEAST_BODIES = 250;

  /** Cost of solving a body without contacts, in units of its own. */
  private static final int BODY_COST = 2;

  /** Cost that each contact adds to its two bodies, in the same units. */
  private static final int CONTACT_COST = 3;

  /** Bodies have mixed when more than one contact in so many is between domains. */
  private static final int MIXED_SHARE = 32;

  private final ActiveBodies active;
  private final PairFinder pairs;

  /** Per body: its domain, from 0. Holds for active bodies only. */
  public int[] of = new int[0];

  /** Per body: whether a contact touches it that belongs to another domain. */
  private boolean[] border = new boolean[0];

  /** Bodies at a border, {@link #borderCount} of them. */
  int[] atBorder = new int[0];

  int borderCount;

  /** Bodies that were at a border in the step before, {@link #beforeCount} of them. */
  int[] before = new int[0];

  int beforeCount;

  private int count = 1;

  /** {@link ActiveBodies#version} that the domains are of. */
  private int version = -1;

  /** Number of threads that the domains are for. */
  private int threads;

  /** Number of further steps for which the domains stay. */
  private int stepsLeft;

  private int edition;

  /** Scratch: bodies in the order of the tree, with one entry per part. */
  private int[] listed = new int[0];

  /** Scratch: what each body costs. */
  private int[] cost = new int[0];

  /**
   * Makes domains of these bodies.
   *
   * @param pairs has the tree that tells which bodies are near each other; null where no step is
   *     shared
   */
  public Domains(ActiveBodies active, PairFinder pairs) {
    this.active = active;
    this.pairs = pairs;
  }

  /** Returns how many domains there are. */
  public int count() {
    return count;
  }

  /**
   * Returns a number that changes whenever a body may have come to another domain, or become active
   * or inactive.
   */
  public int edition() {
    return edition;
  }

  /**
   * Gives every active body a domain, unless the ones of the last step still serve.
   *
   * @param threads how many threads share the step
   * @param contacts tells what bodies cost
   */
  public void find(int threads, ContactTable contacts) {
    stepsLeft--;
    if (version == active.version()
        && this.threads == threads
        && (stepsLeft >= 0 || threads == 1)) {
      return;
    }
    version = active.version();
    this.threads = threads;
    stepsLeft = LASTING;
    edition++;
    count = Math.max(1, Math.min(threads, active.count / LEAST_BODIES));
    if (of.length < active.index.length) {
      of = new int[active.index.length];
      border = Arrays.copyOf(border, active.index.length);
      atBorder = Arrays.copyOf(atBorder, of.length); // at once, as worlds go on mixing for long
      before = Arrays.copyOf(before, of.length);
      cost = new int[active.index.length];
    }
    forgetBorders();
    beforeCount = 0;
    if (count == 1) {
      for (int i = 0; i < active.count; i++) {
        of[active.list[i]] = 0;
      }
      return;
    }
    long sum = weigh(contacts);
    cut(active.list, active.count, sum);
    if (areMixed(contacts)) {
      if (listed.length < pairs.movingParts()) {
        listed = new int[2 * pairs.movingParts()];
      }
      cut(listed, pairs.listBodies(listed), sum);
    }
  }

  /** Finds what each active body costs, and returns the sum. */
  private long weigh(ContactTable t) {
    for (int i = 0; i < active.count; i++) {
      cost[active.list[i]] = BODY_COST;
    }
    for (int row = 0; row < t.count(); row++) {
      if (t.points[row] > 0) {
        cost[ContactKey.bodyA(t.key[row])] += CONTACT_COST;
        cost[ContactKey.bodyB(t.key[row])] += CONTACT_COST;
      }
    }
    long sum = 0;
    for (int i = 0; i < active.count; i++) {
      sum += cost[active.list[i]];
    }
    return sum;
  }

  /** Goes along a list of bodies, and begins the next domain whenever one has its share. */
  private void cut(int[] list, int n, long sum) {
    for (int i = 0; i < active.count; i++) {
      of[active.list[i]] = -1;
    }
    long seen = 0;
    for (int i = 0; i < n; i++) {
      int one = list[i];
      if (active.contains(one) && of[one] < 0) {
        of[one] = (int) (seen * count / sum);
        seen += cost[one];
      }
    }
    for (int i = 0; i < active.count; i++) { // what has no parts is in no tree
      int one = active.list[i];
      of[one] = Math.max(of[one], 0);
    }
  }

  private boolean areMixed(ContactTable t) {
    int all = 0;
    int between = 0;
    for (int row = 0; row < t.count(); row++) {
      int a = ContactKey.bodyA(t.key[row]);
      int b = ContactKey.bodyB(t.key[row]);
      if (t.points[row] > 0 && active.contains(a) && active.contains(b)) {
        all++;
        between += of[a] != of[b] ? 1 : 0;
      }
    }
    return between > all / MIXED_SHARE;
  }

  /** Forgets which bodies are at a border; the step then tells again by {@link #touch}. */
  public void forgetBorders() {
    for (int i = 0; i < borderCount; i++) {
      border[atBorder[i]] = false;
    }
    int[] swap = before;
    before = atBorder;
    atBorder = swap;
    beforeCount = borderCount;
    borderCount = 0;
  }

  /** Notes a contact that belongs to a domain and touches this active body. */
  public void touch(int domain, int body) {
    if (of[body] == domain || border[body]) {
      return;
    }
    border[body] = true;
    atBorder[borderCount++] = body;
  }

  /** Returns whether a contact of another domain touches this body. */
  public boolean isAtBorder(int body) {
    return border[body];
  }
}
