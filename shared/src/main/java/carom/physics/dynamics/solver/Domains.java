package carom.physics.dynamics.solver;

import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.pairs.PairFinder;
import java.util.Arrays;

/**
 * Which domain of the world each active body belongs to: one where a thread steps alone, else one
 * per thread, all with about as much to solve. Bodies of a domain are near each other, so that few
 * touch those of another.
 *
 * <p>Domains are cut from the list of active bodies as it is, while neighbours in it are neighbours
 * in the world: then each thread finds the rows of its contacts where it left them after the narrow
 * phase, which goes by the same order. When bodies have mixed, domains are cut from the tree in
 * which pairs are searched.
 *
 * <p>Domains decide who does what when, and no bit of a result. They stay the same for {@value
 * #LASTING} steps while the same bodies are active. One thread at a time.
 */
public final class Domains {
  /** So many steps domains stay the same while the same bodies are active. */
  private static final int LASTING = 32;

  /** Active bodies that a domain is worth having for. */
  private static final int LEAST_BODIES = 250;

  /** What it takes to solve a body without contacts, and what each of its contacts adds. */
  private static final int BODY_COST = 2;

  private static final int CONTACT_COST = 3;

  /** Bodies have mixed when more than one contact in so many is between domains. */
  private static final int MIXED_SHARE = 32;

  private final ActiveBodies active;
  private final PairFinder pairs;

  /** Per body: its domain, from 0; means something for active ones. */
  int[] of = new int[0];

  /** Per body: whether a contact touches it that belongs to another domain. */
  private boolean[] border = new boolean[0];

  /** Those bodies, and those of the step before. */
  int[] atBorder = new int[0];

  int borderCount;
  int[] before = new int[0];
  int beforeCount;

  private int count = 1;

  /** What the domains are of, and for how many more steps. */
  private int version = -1;

  private int most;
  private int left;

  /** Changes with the domains. */
  private int edition;

  /** Scratch: bodies in the order of the tree, with one entry per part; what each costs. */
  private int[] listed = new int[0];

  private int[] cost = new int[0];

  /** Finds domains by the tree of these pairs. */
  Domains(ActiveBodies active, PairFinder pairs) {
    this.active = active;
    this.pairs = pairs;
  }

  /** How many there are. */
  public int count() {
    return count;
  }

  /** Changes whenever a body may have come to another domain, or become active or inactive. */
  int edition() {
    return edition;
  }

  /**
   * Gives every active body a domain.
   *
   * @param threads how many threads share the step
   * @param contacts tells what bodies cost
   */
  void find(int threads, ContactTable contacts) {
    left--;
    if (version == active.version() && most == threads && (left >= 0 || threads == 1)) {
      return;
    }
    version = active.version();
    most = threads;
    left = LASTING;
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

  /** Finds what each active body costs; answers the sum. */
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

  /** Has no body touch another domain. */
  void forgetBorders() {
    for (int i = 0; i < borderCount; i++) {
      border[atBorder[i]] = false;
    }
    int[] swap = before;
    before = atBorder;
    atBorder = swap;
    beforeCount = borderCount;
    borderCount = 0;
  }

  /** Takes note of a contact that belongs to a domain and touches this active body. */
  void touch(int domain, int body) {
    if (of[body] == domain || border[body]) {
      return;
    }
    border[body] = true;
    atBorder[borderCount++] = body;
  }

  /** Whether a contact touches a body that belongs to another domain. */
  boolean isAtBorder(int body) {
    return border[body];
  }
}
