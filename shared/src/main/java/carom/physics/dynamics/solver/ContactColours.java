package carom.physics.dynamics.solver;

import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.domain.Domains;
import carom.physics.dynamics.jointtree.JointTrees;
import java.util.Arrays;

/**
 * The colours of a step's contacts. Contacts of one colour share no body that can be moved, so
 * their order changes no bit of the result: they can be solved in lanes, or by several threads.
 *
 * <p>Contacts are coloured greedily in the order of their keys: each takes the first colour that
 * neither body has yet.
 *
 * <pre>
 *   three bodies A, B, C on the ground G; contacts are named by their bodies
 *
 *       C           contact, in the order    colours that its   colour
 *      / \          of the keys              bodies have
 *     A---B         AB                       none              moving 0
 *     |   |         AC                       A: 0              moving 1
 *   --G---G--       BC                       B: 0, C: 1        moving 2
 *                   AG                       A: no fixed one   fixed 0
 *                   BG                       B: no fixed one   fixed 0
 *
 *   solved in this order:  moving 0, 1, 2, ... 63   then   fixed 0, 1, ... 63
 * </pre>
 *
 * <p>Contacts between bodies that move come first and those with the static world last, which thus
 * has the last word: what rests on the ground doesn't sink into it. A body with more than {@value
 * #LAST_COLOUR} contacts spills into a last colour that is solved one by one. Contacts with bodies
 * of {@linkplain JointTrees joint trees} are a kind of their own.
 *
 * <p>Every colour of a domain has two <i>groups</i>, of contacts with one point and with two. The
 * colours depend on the touching contacts of this step alone, so there is no history to save or to
 * hash. One thread; allocates only when there are more contacts or bodies than ever before.
 */
final class ContactColours {
  /** The last colour among moving bodies, and with static ones; it takes what found no other. */
  public static final int LAST_COLOUR = 63;

  /**
   * First of the two last colours of a domain: contacts with bodies of joint trees, among moving
   * bodies and with static ones. They are no colours, and belong to the first domain.
   */
  public static final int TREES = 2 * (LAST_COLOUR + 1);

  /** Colours of a domain: those among moving bodies, those with static ones, those of trees. */
  public static final int COLOURS = TREES + 2;

  /** Groups of a domain: every colour has one of contacts with one point, and one with two. */
  public static final int GROUPS = 2 * COLOURS;

  /** Rows of the contacts to solve, in the order of their keys. */
  public int[] row = new int[0];

  /** Groups of these contacts. */
  public int[] group = new int[0];

  /** Per group, those of a domain one after the other: how many contacts it has. */
  public int[] size = new int[0];

  private int contacts;
  private int groups = GROUPS;

  /** Per active body: a bit for each colour that it has among moving bodies. */
  private long[] taken = new long[0];

  /** Per active body: a bit for each colour that it has with static ones. */
  private long[] takenFixed = new long[0];

  /** Returns the number of contacts to solve. */
  public int contacts() {
    return contacts;
  }

  /** Returns the number of groups of all domains. */
  public int groups() {
    return groups;
  }

  /**
   * Finds the contacts to solve, touching and not vetoed, and gives each its group. Tells domains
   * which bodies are at their borders.
   */
  public void assign(
      ContactTable t, BodyStore b, ActiveBodies active, Domains domains, JointTrees trees) {
    boolean anyTrees = trees.edition() != 0;
    ensure(t.capacity(), active.list.length, domains.count());
    boolean divided = domains.count() > 1;
    if (divided) {
      domains.forgetBorders();
    }
    Arrays.fill(taken, 0, active.count, 0);
    Arrays.fill(takenFixed, 0, active.count, 0);
    Arrays.fill(size, 0, domains.count() * GROUPS, 0);
    int found = listTouching(t);
    contacts = 0;
    for (int k = 0; k < found; k++) {
      int r = row[k];
      if ((t.flags[r] & ContactTable.VETOED) != 0) {
        t.forget(r);
        continue;
      }
      int mover = ContactKey.bodyA(t.key[r]);
      int other = ContactKey.bodyB(t.key[r]);
      int c;
      if (b.invMass[mover] == 0) {
        int swap = mover;
        mover = other;
        other = swap;
      }
      int at = active.index[mover];
      if (anyTrees
          && (trees.answersWhole(mover, other, b) || trees.answersWhole(other, mover, b))) {
        c = b.invMass[other] == 0 ? TREES + 1 : TREES;
      } else if (b.invMass[other] == 0) {
        c = Math.min(Long.numberOfTrailingZeros(~takenFixed[at]), LAST_COLOUR);
        takenFixed[at] |= 1L << c;
        c += LAST_COLOUR + 1;
      } else {
        int otherAt = active.index[other];
        c = Math.min(Long.numberOfTrailingZeros(~(taken[at] | taken[otherAt])), LAST_COLOUR);
        long bit = 1L << c;
        taken[at] |= bit;
        taken[otherAt] |= bit;
      }
      int g = 2 * c + t.points[r] - 1;
      if (divided) {
        int domain = c == LAST_COLOUR || c >= TREES ? 0 : domains.of[mover];
        g += domain * GROUPS;
        domains.touch(domain, mover);
        if (active.contains(other)) {
          domains.touch(domain, other);
        }
      }
      size[g]++;
      group[contacts] = g;
      row[contacts++] = r;
    }
  }

  /**
   * Lists the rows that touch and aren't dormant, and returns how many. It doesn't branch, because
   * a processor could not predict which rows do.
   */
  private int listTouching(ContactTable t) {
    int n = 0;
    for (int r = 0; r < t.count(); r++) {
      row[n] = r;
      n += -t.points[r] >>> Integer.SIZE - 1 & ~(t.flags[r] >> Byte.SIZE - 1);
    }
    return n;
  }

  private void ensure(int rows, int bodies, int domains) {
    if (row.length < rows) {
      row = new int[rows];
      group = new int[rows];
    }
    if (taken.length < bodies) {
      taken = new long[bodies];
      takenFixed = new long[bodies];
    }
    groups = domains * GROUPS;
    if (size.length < groups) {
      size = new int[groups];
    }
  }

  /** Returns whether the contacts of a group share no body that can be moved. */
  public static boolean isColour(int group) {
    int c = (group >> 1) % COLOURS;
    return c < TREES && (c & LAST_COLOUR) != LAST_COLOUR;
  }

  /** Returns whether one body of each contact of a group can't be moved. */
  public static boolean isFixed(int group) {
    int c = (group >> 1) % COLOURS;
    return c > LAST_COLOUR && c != TREES;
  }
}
