package carom.physics.dynamics.solver;

import static carom.physics.dynamics.solver.SolverBodies.COS;
import static carom.physics.dynamics.solver.SolverBodies.DX;
import static carom.physics.dynamics.solver.SolverBodies.DY;
import static carom.physics.dynamics.solver.SolverBodies.SIN;
import static carom.physics.dynamics.solver.SolverBodies.VX;
import static carom.physics.dynamics.solver.SolverBodies.VY;
import static carom.physics.dynamics.solver.SolverBodies.W;

import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.parallel.DomainPhases;
import carom.physics.dynamics.parallel.ParallelFor;
import carom.physics.simd.VectorModule;
import java.util.Arrays;

/**
 * The contacts of a step as the solver visits them: coloured, in blocks of {@link #LANES}.
 *
 * <p><b>Colours.</b> Sequential impulses need an order. Contacts are given colours, greedily in the
 * order of their keys: the first colour that neither body has yet. Contacts of one colour share no
 * body that can be moved, so the order within a colour changes no bit of the result, and they can
 * be solved in lanes, or by several threads. Contacts between bodies that move come first and those
 * with the static world last, which thus has the last word: what rests on the ground doesn't sink
 * into it. A body with more than {@value #LAST_COLOUR} contacts spills into a last colour that is
 * solved one by one. The colouring depends on the touching contacts of this step alone, so there is
 * no history to save or to hash; while these stay the same so do colours and lanes ({@link
 * ColourMemo}).
 *
 * <p><b>Layout.</b> Contacts are packed in blocks, a colour of a {@linkplain Domains domain}
 * beginning a new block. Each quantity of a block lies side by side for all its contacts; all
 * quantities of a block follow each other ({@code data[block * RECORD + quantity + lane]}). So a
 * pass is one stream through memory, and a block's quantity is one vector register.
 *
 * <p><b>Domains.</b> A contact belongs to the domain of its first body that can be moved, those
 * without a colour among moving bodies to the first domain. It is at the border if one of its
 * bodies is touched from another domain. Contacts at the border lie behind the others of their
 * group: blocks without any are the inner part of a phase (see {@link DomainPhases}).
 */
public final class ContactBlocks {
  /** Contacts in a block. */
  public static final int LANES = VectorModule.LANES;

  /** The last colour among moving bodies, and with static ones; it takes what found no other. */
  static final int LAST_COLOUR = 63;

  /** Blocks with fewer contacts are solved one by one. */
  private static final int FEWEST = 1 + LANES / 4;

  /** Steps with fewer blocks don't use vectors. */
  private static final int FEWEST_BLOCKS = 512 / LANES;

  /** Colours of a domain. */
  private static final int COLOURS = 2 * (LAST_COLOUR + 1);

  /** Instead of a colour: all of them, one after the other. */
  private static final int ALL = -1;

  /** Every colour has a group of contacts with one point, and one of those with two. */
  private static final int GROUPS = 2 * COLOURS;

  // Offsets of the quantities of a block in data: of the contact,
  public static final int NX = 0;
  public static final int NY = NX + LANES;
  public static final int FRICTION = NY + LANES;
  public static final int MASS_A = FRICTION + LANES;
  public static final int MASS_B = MASS_A + LANES;
  public static final int INERTIA_A = MASS_B + LANES;
  public static final int INERTIA_B = INERTIA_A + LANES;

  /** What an impulse at one point does to the other's speed along the normal, 1/kg. */
  public static final int CROSS = INERTIA_B + LANES;

  // of each of its two points, relative to FIRST or SECOND: lever arms of impulses along the
  // normal, r x n, and along the tangent, r x t = r . n, of both bodies, m,
  public static final int NORMAL_ARM_A = 0;
  public static final int NORMAL_ARM_B = NORMAL_ARM_A + LANES;
  public static final int TANGENT_ARM_A = NORMAL_ARM_B + LANES;
  public static final int TANGENT_ARM_B = TANGENT_ARM_A + LANES;

  /** gap when the step began, and now, m, */
  public static final int SEPARATION = TANGENT_ARM_B + LANES;

  public static final int GAP = SEPARATION + LANES;

  /** what an impulse does to the point's speed along the normal, 1/kg, */
  public static final int YIELD = GAP + LANES;

  /** its inverse along the tangent, kg, */
  public static final int TANGENT_MASS = YIELD + LANES;

  /** impulses along normal and tangent, of the substep and of the whole step. */
  public static final int NORMAL = TANGENT_MASS + LANES;

  public static final int TANGENT = NORMAL + LANES;
  public static final int TOTAL = TANGENT + LANES;
  public static final int SLIDE = TOTAL + LANES;
  static final int POINT = SLIDE + LANES;

  public static final int FIRST = CROSS + LANES;
  public static final int SECOND = FIRST + POINT;
  public static final int RECORD = SECOND + POINT;

  // What few contacts need, relative to the block in extra; each part is only valid if the block
  // has the trait. Speed of moving surfaces, m/s:
  public static final int SURFACE = 0;

  /** Radii of the parts' rounding, m. */
  public static final int ROUND_A = SURFACE + LANES;

  public static final int ROUND_B = ROUND_A + LANES;
  static final int ROLLING = ROUND_B + LANES;
  static final int ROLL_MASS = ROLLING + LANES;
  static final int ROLL = ROLL_MASS + LANES;

  /** Acceleration with which gravity and forces press the bodies together, m/s^2. */
  static final int PULL = ROLL + LANES;

  /** Approach speed of each point to answer with a bounce, m/s, 0 if there is none to answer. */
  static final int BOUNCE_FIRST = PULL + LANES;

  static final int BOUNCE_SECOND = BOUNCE_FIRST + LANES;

  /** How much further the bounce's impulse along the normal, and that of its friction, are. */
  static final int BOUNCED = 2 * LANES;

  static final int RUBBED = BOUNCED + 2 * LANES;
  public static final int EXTRA = BOUNCE_FIRST + RUBBED + 2 * LANES;

  // Traits of blocks.
  /** Its contacts have two points. */
  public static final int TWO = 1;

  /** They are with bodies that can't be moved: several touch the same, none writes to it. */
  public static final int FIXED = 2;

  /** Some contact has a moving surface, a round part, rolling resistance, a bounce to come. */
  public static final int MOVING_SURFACE = 4;

  public static final int ROUND = 8;
  static final int ROLLS = 16;
  static final int BOUNCES = 32;

  /** Solved by vectors. */
  static final int WIDE = 64;

  /** The traits that softness depends on. */
  static final int SOFTNESS = TWO | FIXED;

  /** Number of contacts, and of blocks. */
  private int contacts;

  private int count;

  /** Groups of all domains. */
  private int groups = GROUPS;

  /** The touching rows and their groups, in the order of the keys. */
  private int[] touching = new int[0];

  private int[] groupOf = new int[0];

  /** Colours each active body has, among moving bodies and with static ones. */
  private long[] taken = new long[0];

  private long[] takenFixed = new long[0];

  /**
   * Per group, all those of a domain one after the other: its contacts; the lane of the next one
   * that isn't at the border, and the one behind the next that is; its first block, and that of its
   * border. Behind the last group, its end.
   */
  private int[] size = new int[0];

  private int[] next = new int[0];
  private int[] last = new int[0];
  private int[] start = new int[1];
  private int[] startOfBorder = new int[0];

  /** Colours that any domain has contacts of. */
  private final int[] colour = new int[COLOURS];

  private int colours;

  private final ColourMemo memo = new ColourMemo();

  /** Per block: contacts in it, and its traits. */
  byte[] used = new byte[0];

  public byte[] traits = new byte[0];

  /** Per lane: row of the contact table; offsets of the two bodies in the solver's state. */
  int[] row = new int[0];

  public int[] bodyA = new int[0];
  public int[] bodyB = new int[0];

  public float[] data = new float[0];
  public float[] extra = new float[0];

  /** {@link SolverBodies#state}, which the offsets are of. */
  float[] v;

  /** The number of blocks. */
  int count() {
    return count;
  }

  /**
   * Finds the contacts to solve, touching and not vetoed, colours them and gives each a lane, and
   * active bodies their slots. What it holds of contacts is to be filled in.
   *
   * @param lanes kernels that take whole blocks, null for none
   */
  void lay(ContactTable table, BodyStore bodies, SolverBodies solverBodies, ContactLanes lanes) {
    Domains domains = solverBodies.domains;
    if (memo.holds(table, bodies, domains.edition())) {
      layOut(lanes, table.count(), solverBodies);
    } else {
      paint(table, bodies, solverBodies.active, domains);
      solverBodies.assignSlots();
      memo.note(table, bodies, domains.edition());
      findGroups();
      giveLanes(table, domains);
      layOut(lanes, table.count(), solverBodies);
    }
    v = solverBodies.state;
  }

  /** Finds the contacts to solve and gives each its colour. */
  private void paint(ContactTable t, BodyStore b, ActiveBodies active, Domains domains) {
    ensure(t.count(), active.count, domains.count());
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
      int r = touching[k];
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
      if (b.invMass[other] == 0) {
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
      int group = 2 * c + t.points[r] - 1;
      if (divided) {
        int domain = c == LAST_COLOUR ? 0 : domains.of[mover];
        group += domain * GROUPS;
        domains.touch(domain, mover);
        if (active.contains(other)) {
          domains.touch(domain, other);
        }
      }
      size[group]++;
      groupOf[contacts] = group;
      touching[contacts++] = r;
    }
  }

  /**
   * Lists the rows that touch and aren't dormant; answers how many. Without a branch, as it is not
   * to be foreseen which do.
   */
  private int listTouching(ContactTable t) {
    int n = 0;
    for (int r = 0; r < t.count(); r++) {
      touching[n] = r;
      n += -t.points[r] >>> Integer.SIZE - 1 & ~(t.flags[r] >> Byte.SIZE - 1);
    }
    return n;
  }

  private void ensure(int rows, int bodies, int domains) {
    if (touching.length < rows) {
      int capacity = rows + rows / 2;
      touching = new int[capacity];
      groupOf = new int[capacity];
    }
    if (taken.length < bodies) {
      int capacity = Math.max(bodies, taken.length * 2);
      taken = new long[capacity];
      takenFixed = new long[capacity];
    }
    if (size.length < domains * GROUPS) {
      size = new int[domains * GROUPS];
      next = new int[domains * GROUPS];
      last = new int[domains * GROUPS];
      start = new int[domains * GROUPS + 1];
      startOfBorder = new int[domains * GROUPS];
    }
    groups = domains * GROUPS;
  }

  /** Gives each group its blocks, and finds out which colours there are. */
  private void findGroups() {
    int block = 0;
    for (int g = 0; g < groups; g++) {
      start[g] = block;
      next[g] = block * LANES;
      last[g] = next[g] + size[g];
      block += (size[g] + LANES - 1) / LANES;
    }
    start[groups] = block;
    count = block;
    colours = 0;
    for (int c = 0; c < COLOURS; c++) {
      int sum = 0;
      for (int g = 2 * c; g < groups; g += GROUPS) {
        sum += size[g] + size[g + 1];
      }
      if (sum > 0) {
        colour[colours++] = c;
      }
    }
    if (row.length < count * LANES) {
      int capacity = count + count / 2; // room at once: crowds go on meeting after their first step
      used = new byte[capacity];
      traits = new byte[capacity];
      row = new int[capacity * LANES];
      bodyA = new int[capacity * LANES];
      bodyB = new int[capacity * LANES];
      data = new float[capacity * RECORD];
      extra = new float[capacity * EXTRA];
    }
  }

  /**
   * Gives each contact a lane: from the front of its group, or from its end if it is at the border.
   * What found no colour keeps the order of the keys, and all of it counts as border.
   */
  private void giveLanes(ContactTable t, Domains domains) {
    boolean divided = domains.count() > 1;
    for (int k = 0; k < contacts; k++) {
      int r = touching[k];
      int g = groupOf[k];
      boolean border =
          divided
              && isColour(g)
              && (domains.isAtBorder(ContactKey.bodyA(t.key[r]))
                  || domains.isAtBorder(ContactKey.bodyB(t.key[r])));
      row[border ? --last[g] : next[g]++] = r;
    }
    for (int g = 0; g < groups; g++) {
      int inner = next[g] - start[g] * LANES;
      if (divided && !isColour(g)) {
        inner = 0;
      }
      startOfBorder[g] = inner == size[g] ? start[g + 1] : start[g] + inner / LANES;
    }
  }

  /** Whether contacts of a group share no body that can be moved. */
  private static boolean isColour(int group) {
    return (group >> 1 & LAST_COLOUR) != LAST_COLOUR;
  }

  /** Says what is in each block. */
  private void layOut(ContactLanes lanes, int rows, SolverBodies solverBodies) {
    int widest = 0;
    if (lanes != null && count >= FEWEST_BLOCKS) {
      widest = lanes.grant(count, rows);
    }
    for (int g = 0; g < groups; g++) {
      int kind = ((g & 1) != 0 ? TWO : 0) | ((g >> 1) % COLOURS > LAST_COLOUR ? FIXED : 0);
      int left = size[g];
      for (int block = start[g]; left > 0; block++, left -= LANES) {
        used[block] = (byte) Math.min(left, LANES);
        boolean wide = block < widest && left >= FEWEST && isColour(g);
        traits[block] = (byte) (kind | (wide ? WIDE : 0));
        if (left < LANES) {
          clear(block, solverBodies.idle(g / GROUPS));
        }
      }
    }
  }

  /**
   * Adds a stage in which no block has anything to do with another; whatever other domains did
   * before in their border parts is done then.
   */
  void addAll(DomainPhases phases, DomainPhases.Phase stage) {
    phases.add(stage, ALL);
  }

  /** Adds a stage colour by colour. */
  void addColours(DomainPhases phases, DomainPhases.Phase stage) {
    if (groups == GROUPS) {
      phases.add(stage, ALL);
      return;
    }
    for (int i = 0; i < colours; i++) {
      phases.add(stage, colour[i]);
    }
  }

  /** Makes a phase of a stage that takes blocks from one to another. */
  DomainPhases.Phase phase(ParallelFor.Range stage) {
    return new DomainPhases.Phase() {
      @Override
      public void run(int number, int domain, boolean border, int worker) {
        visit(number, domain, border, worker, stage);
      }

      @Override
      public boolean hasBorder(int number, int domain) {
        return number == ALL || touchesBorder(domain * GROUPS + 2 * number);
      }
    };
  }

  /** Whether a colour of a domain has contacts at the border. */
  private boolean touchesBorder(int group) {
    return startOfBorder[group] < start[group + 1] || startOfBorder[group + 1] < start[group + 2];
  }

  private void visit(int number, int domain, boolean border, int worker, ParallelFor.Range stage) {
    if (number == ALL) {
      if (border) {
        stage.run(start[domain * GROUPS], start[(domain + 1) * GROUPS], worker);
      }
      return;
    }
    int g = domain * GROUPS + 2 * number;
    if (border) {
      visit(startOfBorder[g], start[g + 1], worker, stage);
      visit(startOfBorder[g + 1], start[g + 2], worker, stage);
    } else {
      visit(start[g], startOfBorder[g], worker, stage);
      visit(start[g + 1], startOfBorder[g + 1], worker, stage);
    }
  }

  private static void visit(int from, int to, int worker, ParallelFor.Range stage) {
    if (from < to) {
      stage.run(from, to, worker);
    }
  }

  /**
   * Makes the empty lanes of a block contacts of nothing with nothing. Kernels write back what they
   * read, so that must be the domain's own: the static body's slot, all read.
   */
  private void clear(int block, int idle) {
    int at = block * RECORD;
    Arrays.fill(data, at, at + RECORD, 0);
    Arrays.fill(data, at + FIRST + YIELD, at + FIRST + YIELD + LANES, 1);
    Arrays.fill(data, at + SECOND + YIELD, at + SECOND + YIELD + LANES, 1);
    Arrays.fill(bodyA, block * LANES, (block + 1) * LANES, idle);
    Arrays.fill(bodyB, block * LANES, (block + 1) * LANES, idle);
  }

  /** Gives a block a trait; its part of extra is zero for those lanes that don't have it. */
  void has(int block, int trait, int from, int to) {
    if ((traits[block] & trait) == 0) {
      traits[block] |= (byte) trait;
      Arrays.fill(extra, block * EXTRA + from, block * EXTRA + to, 0);
    }
  }

  /** Speed at which a point parts along the normal, m/s. */
  float normalSpeed(int lane, int point) {
    float[] d = data;
    int at = lane / LANES * RECORD + lane % LANES;
    int a = bodyA[lane];
    int b = bodyB[lane];
    float dvx = v[b + VX] - v[a + VX];
    float dvy = v[b + VY] - v[a + VY];
    float linear = dvx * d[at + NX] + dvy * d[at + NY];
    float armA = d[at + point + NORMAL_ARM_A];
    float armB = d[at + point + NORMAL_ARM_B];
    return linear + (v[b + W] * armB - v[a + W] * armA);
  }

  /**
   * Gives B impulses along normal and tangent, and A their opposites; the angular velocities are
   * already the new ones. Writes nothing to what can't be moved: other workers may be reading it.
   */
  void give(int lane, int at, float normal, float tangent, float wa, float wb) {
    float[] d = data;
    float nx = d[at + NX];
    float ny = d[at + NY];
    float px = normal * nx - tangent * ny;
    float py = normal * ny + tangent * nx;
    float massA = d[at + MASS_A];
    float massB = d[at + MASS_B];
    if (massA != 0) {
      int a = bodyA[lane];
      v[a + VX] -= massA * px;
      v[a + VY] -= massA * py;
      v[a + W] = wa;
    }
    if (massB != 0) {
      int b = bodyB[lane];
      v[b + VX] += massB * px;
      v[b + VY] += massB * py;
      v[b + W] = wb;
    }
  }

  /**
   * How far B moved away from A along the normal since the step began, rotation of lever arms not
   * counted. Rounding doesn't turn: the lowest point of a rolling disc is always another one. So
   * the anchor of a round part is a radius inside, {@code r - R n}, which makes a difference of
   * {@code R (cos - 1)}. Without it a fast disc would seem to lift off while it turns, and sink in.
   */
  float moved(int block, int i) {
    float[] d = data;
    int at = block * RECORD + i;
    int a = bodyA[block * LANES + i];
    int b = bodyB[block * LANES + i];
    float movedX = v[b + DX] - v[a + DX];
    float movedY = v[b + DY] - v[a + DY];
    float moved = movedX * d[at + NX] + movedY * d[at + NY];
    if ((traits[block] & ROUND) != 0) {
      int more = block * EXTRA + i;
      moved += extra[more + ROUND_A] * (v[a + COS] - 1) + extra[more + ROUND_B] * (v[b + COS] - 1);
    }
    return moved;
  }

  /**
   * The gap at a point now: that of the start, plus how far the two anchors moved and turned apart.
   * A lever arm r that turned by R moves along the normal by {@code (R r - r) . n = (cos - 1) (r .
   * n) + sin (r x n)}.
   */
  float gap(int p, float moved, int a, int b) {
    float[] d = data;
    float ca = v[a + COS] - 1;
    float sa = v[a + SIN];
    float cb = v[b + COS] - 1;
    float sb = v[b + SIN];
    float turnedA = ca * d[p + TANGENT_ARM_A] + sa * d[p + NORMAL_ARM_A];
    float turnedB = cb * d[p + TANGENT_ARM_B] + sb * d[p + NORMAL_ARM_B];
    return d[p + SEPARATION] + (moved + (turnedB - turnedA));
  }
}
