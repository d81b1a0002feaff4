package carom.physics.dynamics.solver;

import static carom.physics.dynamics.solver.ContactColours.COLOURS;
import static carom.physics.dynamics.solver.ContactColours.GROUPS;
import static carom.physics.dynamics.solver.ContactColours.TREES;

import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.contact.ContactKey;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.domain.DomainPhases;
import carom.physics.dynamics.domain.Domains;
import carom.physics.dynamics.domain.SolverBodies;
import carom.physics.dynamics.jointtree.JointTrees;
import carom.physics.dynamics.store.ParallelFor;
import carom.physics.simd.VectorModule;
import java.util.Arrays;

/**
 * The contacts of a step as the solver visits them: {@linkplain ContactColours coloured}, and
 * packed in blocks of {@link #LANES} contacts.
 *
 * <p><b>Blocks.</b> The contacts of a group (a colour of a {@linkplain Domains domain}, with one or
 * with two points) fill whole blocks; the last one may have empty lanes. A quantity lies side by
 * side for all contacts of a block, so it is one vector register. All quantities of a block follow
 * each other, so a pass is one stream through memory.
 *
 * <pre>
 *   data    | block 0                                      | block 1                   | ...
 *           | NX       | NY       | ... | FIRST | SECOND   | NX ...
 *           | 01234567 | 01234567 |     |       |          |          lanes
 *                                       /        \
 *                 NORMAL_ARM_A | NORMAL_ARM_B | ... | TOTAL_TANGENT   of one contact point
 *
 *   a number:   data[block * RECORD + quantity + lane]
 *               data[block * RECORD + FIRST + quantity of the point + lane]
 *   bodies:     bodyA[block * LANES + lane], an offset in SolverBodies.state
 *   extra:      as data, with EXTRA for RECORD: what few contacts need
 * </pre>
 *
 * <p><b>Domains.</b> A contact belongs to the domain of its first body that can be moved; contacts
 * without a colour among moving bodies belong to the first domain. A contact is at the border if
 * another domain touches one of its bodies. Contacts at the border lie behind the others of their
 * group. Blocks without any are the inner part of a phase (see {@link DomainPhases}).
 *
 * <pre>
 *   blocks of a group   | start   ...   | startOfBorder   ...   | start of the next group
 *                       | inner, inner  | mixed, border, border | inner ...
 * </pre>
 *
 * <p>While contacts, domains and masses stay the same, so do colours and lanes ({@link
 * ColourMemo}).
 */
public final class ContactBlocks {
  /** Contacts in a block. */
  public static final int LANES = VectorModule.LANES;

  /** Blocks with fewer contacts are solved one by one. */
  private static final int FEWEST = 1 + LANES / 4;

  /** Steps with fewer blocks don't use vectors. */
  private static final int FEWEST_BLOCKS = 512 / LANES;

  /** Number that stands for all colours, one after the other. */
  private static final int ALL = -1;

  /** Number that stands for all but the contacts of trees. */
  private static final int COLOURED = -2;

  // Quantities of a contact: offsets in its block of data.

  /** Unit normal from A to B, world axes. */
  public static final int NX = 0;

  /** The y part of the normal. */
  public static final int NY = NX + LANES;

  /** Coefficient of friction of the pair. */
  public static final int FRICTION = NY + LANES;

  /** Inverse mass of A, 1/kg, 0 if it cannot be moved. */
  public static final int MASS_A = FRICTION + LANES;

  /** Inverse mass of B, 1/kg. */
  public static final int MASS_B = MASS_A + LANES;

  /** Inverse moment of inertia of A, 1/(kg m^2). */
  public static final int INERTIA_A = MASS_B + LANES;

  /** Inverse moment of inertia of B, 1/(kg m^2). */
  public static final int INERTIA_B = INERTIA_A + LANES;

  /**
   * Inverse effective mass between the two points: what an impulse at one does to the normal speed
   * of the other, 1/kg.
   */
  public static final int CROSS = INERTIA_B + LANES;

  // Quantities of a contact point: offsets from FIRST or SECOND.

  /** Lever arm of A along the normal, r x n, m. */
  public static final int NORMAL_ARM_A = 0;

  /** Lever arm of B along the normal, m. */
  public static final int NORMAL_ARM_B = NORMAL_ARM_A + LANES;

  /** Lever arm of A along the tangent, r x t = r . n, m. */
  public static final int TANGENT_ARM_A = NORMAL_ARM_B + LANES;

  /** Lever arm of B along the tangent, m. */
  public static final int TANGENT_ARM_B = TANGENT_ARM_A + LANES;

  /** Gap when the step began, m; negative if the shapes overlap. */
  public static final int SEPARATION = TANGENT_ARM_B + LANES;

  /** Gap when it was last measured, m. */
  public static final int GAP = SEPARATION + LANES;

  /** Inverse effective mass along the normal: what an impulse does to the normal speed, 1/kg. */
  public static final int INVERSE_NORMAL_MASS = GAP + LANES;

  /** Effective mass along the tangent, kg. */
  public static final int TANGENT_MASS = INVERSE_NORMAL_MASS + LANES;

  /** Impulse along the normal in the substep, N s, not negative. */
  public static final int NORMAL_IMPULSE = TANGENT_MASS + LANES;

  /** Impulse of friction in the substep, N s. */
  public static final int TANGENT_IMPULSE = NORMAL_IMPULSE + LANES;

  /** Impulse along the normal in the whole step, N s. */
  public static final int TOTAL_NORMAL = TANGENT_IMPULSE + LANES;

  /** Impulse of friction in the whole step, N s. */
  public static final int TOTAL_TANGENT = TOTAL_NORMAL + LANES;

  /** Floats of a point. */
  static final int POINT = TOTAL_TANGENT + LANES;

  // The parts of a block in data.

  /** Offset of the first contact point. */
  public static final int FIRST = CROSS + LANES;

  /** Offset of the second contact point. */
  public static final int SECOND = FIRST + POINT;

  /** Floats of a block in data. */
  public static final int RECORD = SECOND + POINT;

  // Quantities that few contacts need: offsets in extra. Each is valid if the block has its trait.

  /** Speed of moving surfaces, m/s. */
  public static final int SURFACE = 0;

  /** Radius of the rounding of A's shape, m. */
  public static final int RADIUS_A = SURFACE + LANES;

  /** Radius of the rounding of B's shape, m. */
  public static final int RADIUS_B = RADIUS_A + LANES;

  /** Rolling resistance: most angular impulse per normal impulse, m. */
  static final int ROLLING = RADIUS_B + LANES;

  /** Effective mass of rolling, kg m^2. */
  static final int ROLL_MASS = ROLLING + LANES;

  /** Angular impulse against rolling in the substep, N m s. */
  static final int ROLL = ROLL_MASS + LANES;

  /** Acceleration with which gravity and forces press the bodies together, m/s^2. */
  static final int CLOSING_ACCELERATION = ROLL + LANES;

  /** Coefficient of restitution. */
  static final int COEFFICIENT = CLOSING_ACCELERATION + LANES;

  /** Not 0 if the surfaces meet or part faster than the threshold when the step begins. */
  static final int FAST = COEFFICIENT + LANES;

  /** Normal impulses of impacts so far, N s: of the first point, then of the second. */
  static final int IMPACT_NORMAL = FAST + LANES;

  /** Friction impulses of impacts so far, N s: of the first point, then of the second. */
  static final int IMPACT_TANGENT = IMPACT_NORMAL + 2 * LANES;

  /** Floats of a block in extra. */
  public static final int EXTRA = IMPACT_TANGENT + 2 * LANES;

  // Traits of blocks, added up.

  /** Trait: the contacts have two points. */
  public static final int TWO = 1;

  /**
   * Trait: one body of each contact cannot be moved. Several contacts touch the same one, and none
   * writes to it.
   */
  public static final int FIXED = 2;

  /** Trait: some contact has a moving surface. */
  public static final int MOVING_SURFACE = 4;

  /** Trait: some contact has a rounded shape. */
  public static final int ROUNDED = 8;

  /** Trait: some contact has rolling resistance. */
  static final int ROLLS = 16;

  /** Trait: some contact bounces, if it approaches fast enough. */
  static final int RESTITUTION = 32;

  /** Trait: vector kernels solve the block. */
  static final int WIDE = 64;

  /** Trait: impacts alone answer some contact in this substep. */
  public static final int FREE = 128;

  /** Traits that softness depends on. */
  static final int SOFTNESS = TWO | FIXED;

  /** Number of blocks. */
  private int count;

  private final ContactColours colouring = new ContactColours();

  /** Per group: the lane of its next contact that isn't at the border. */
  private int[] next = new int[0];

  /** Per group: the lane behind the next contact at the border. They are given from the end. */
  private int[] last = new int[0];

  /** Per group: its first block. Behind the last group, the end of all blocks. */
  private int[] start = new int[1];

  /** Per group: its first block that holds a contact at the border. */
  private int[] startOfBorder = new int[0];

  /** Colours that any domain has contacts of; {@link #colours} of them. */
  private final int[] colour = new int[COLOURS];

  private int colours;

  private final ColourMemo memo = new ColourMemo();

  /** Per block: how many contacts it has. */
  byte[] used = new byte[0];

  /** Per block: its traits. */
  public byte[] traits = new byte[0];

  /** Per lane: row of the contact table. */
  int[] row = new int[0];

  /** Per lane: offset of body A in the solver's state. */
  public int[] bodyA = new int[0];

  /** Per lane: offset of body B in the solver's state. */
  public int[] bodyB = new int[0];

  /** Quantities of all contacts. */
  public float[] data = new float[0];

  /** Quantities that few contacts need. */
  public float[] extra = new float[0];

  /** Returns the number of blocks. */
  int count() {
    return count;
  }

  /**
   * Finds the contacts to solve, touching and not vetoed, colours them, and gives each a lane and
   * each active body its slot. {@link ContactPacker} then fills the lanes.
   *
   * @param lanes kernels that take whole blocks, null for none
   */
  void build(
      ContactTable table,
      BodyStore bodies,
      SolverBodies solverBodies,
      JointTrees trees,
      ContactLanes lanes) {
    Domains domains = solverBodies.domains;
    if (memo.holds(table, bodies, domains.edition(), trees.edition())) {
      layOutBlocks(lanes, table.count(), solverBodies);
    } else {
      colouring.assign(table, bodies, solverBodies.active, domains, trees);
      solverBodies.assignSlots();
      memo.note(table, bodies, domains.edition(), trees.edition());
      findGroups(table.capacity() / LANES);
      giveLanes(table, domains);
      layOutBlocks(lanes, table.count(), solverBodies);
    }
  }

  /**
   * Gives each group its blocks, and finds out which colours there are.
   *
   * @param most blocks that will hardly ever be exceeded: there is room for them at once, as crowds
   *     go on meeting after their first step
   */
  private void findGroups(int most) {
    int groups = colouring.groups();
    int[] size = colouring.size;
    if (next.length < groups) {
      next = new int[groups];
      last = new int[groups];
      start = new int[groups + 1];
      startOfBorder = new int[groups];
    }
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
      int capacity = Math.max(count + count / 2, most);
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
    for (int k = 0; k < colouring.contacts(); k++) {
      int r = colouring.row[k];
      int g = colouring.group[k];
      boolean border =
          divided
              && ContactColours.isColour(g)
              && (domains.isAtBorder(ContactKey.bodyA(t.key[r]))
                  || domains.isAtBorder(ContactKey.bodyB(t.key[r])));
      row[border ? --last[g] : next[g]++] = r;
    }
    for (int g = 0; g < colouring.groups(); g++) {
      int inner = next[g] - start[g] * LANES;
      if (divided && !ContactColours.isColour(g)) {
        inner = 0;
      }
      startOfBorder[g] = inner == colouring.size[g] ? start[g + 1] : start[g] + inner / LANES;
    }
  }

  /** Sets how many contacts each block has, and its traits. */
  private void layOutBlocks(ContactLanes lanes, int rows, SolverBodies solverBodies) {
    int widest = 0;
    if (lanes != null && count >= FEWEST_BLOCKS) {
      widest = lanes.grant(count, rows);
    }
    for (int g = 0; g < colouring.groups(); g++) {
      int kind = ((g & 1) != 0 ? TWO : 0) | (ContactColours.isFixed(g) ? FIXED : 0);
      int left = colouring.size[g];
      for (int block = start[g]; left > 0; block++, left -= LANES) {
        used[block] = (byte) Math.min(left, LANES);
        boolean wide = block < widest && left >= FEWEST && ContactColours.isColour(g);
        traits[block] = (byte) (kind | (wide ? WIDE : 0));
        if (left < LANES) {
          clear(block, solverBodies.idle(g / GROUPS));
        }
      }
    }
  }

  /**
   * Adds a stage in which no block has anything to do with another. By then all domains have done
   * the border parts of earlier stages.
   */
  void addAll(DomainPhases phases, DomainPhases.Phase stage) {
    phases.add(stage, ALL);
  }

  /**
   * Adds a stage colour by colour.
   *
   * @param trees whether contacts with bodies of trees come, too, last
   */
  void addColours(DomainPhases phases, DomainPhases.Phase stage, boolean trees) {
    if (colouring.groups() == GROUPS) {
      phases.add(stage, trees ? ALL : COLOURED);
      return;
    }
    for (int i = 0; i < colours; i++) {
      if (trees || colour[i] < TREES) {
        phases.add(stage, colour[i]);
      }
    }
  }

  /** Returns the first block of contacts with bodies of trees. */
  int startOfTrees() {
    return start[2 * TREES];
  }

  /** Returns the end of the blocks of contacts with bodies of trees. */
  int endOfTrees() {
    return start[GROUPS];
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
        return number < 0 || touchesBorder(domain * GROUPS + 2 * number);
      }
    };
  }

  /** Returns whether a colour of a domain has contacts at the border. */
  private boolean touchesBorder(int group) {
    return startOfBorder[group] < start[group + 1] || startOfBorder[group + 1] < start[group + 2];
  }

  private void visit(int number, int domain, boolean border, int worker, ParallelFor.Range stage) {
    if (number < 0) {
      if (border) {
        int end = number == ALL ? GROUPS : 2 * TREES;
        stage.run(start[domain * GROUPS], start[domain * GROUPS + end], worker);
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
   * Makes the empty lanes of a block contacts of nothing with nothing. Their bodies are the
   * domain's idle slot, because kernels write back what they read, and all threads read the static
   * body.
   */
  private void clear(int block, int idle) {
    int at = block * RECORD;
    Arrays.fill(data, at, at + RECORD, 0);
    Arrays.fill(
        data, at + FIRST + INVERSE_NORMAL_MASS, at + FIRST + INVERSE_NORMAL_MASS + LANES, 1);
    Arrays.fill(
        data, at + SECOND + INVERSE_NORMAL_MASS, at + SECOND + INVERSE_NORMAL_MASS + LANES, 1);
    Arrays.fill(bodyA, block * LANES, (block + 1) * LANES, idle);
    Arrays.fill(bodyB, block * LANES, (block + 1) * LANES, idle);
  }

  /** Gives a block a trait. Clears that part of extra, which stays zero for lanes without it. */
  void addTrait(int block, int trait, int from, int to) {
    if ((traits[block] & trait) == 0) {
      traits[block] |= (byte) trait;
      Arrays.fill(extra, block * EXTRA + from, block * EXTRA + to, 0);
    }
  }
}
