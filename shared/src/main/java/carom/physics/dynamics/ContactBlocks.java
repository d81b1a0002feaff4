package carom.physics.dynamics;

import static carom.physics.dynamics.SolverBodies.COS;
import static carom.physics.dynamics.SolverBodies.DX;
import static carom.physics.dynamics.SolverBodies.DY;
import static carom.physics.dynamics.SolverBodies.SIN;
import static carom.physics.dynamics.SolverBodies.VX;
import static carom.physics.dynamics.SolverBodies.VY;
import static carom.physics.dynamics.SolverBodies.W;

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
 * <p><b>Layout.</b> Contacts are packed in blocks, a colour beginning a new block. Each quantity of
 * a block lies side by side for all its contacts; all quantities of a block follow each other
 * ({@code data[block * RECORD + quantity + lane]}). So a pass is one stream through memory, and a
 * block's quantity is one vector register.
 */
final class ContactBlocks {
  /** Contacts in a block. */
  static final int LANES = VectorModule.LANES;

  /** The last colour among moving bodies, and with static ones; it takes what found no other. */
  static final int LAST_COLOUR = 63;

  /** Blocks with fewer contacts are solved one by one. */
  private static final int FEWEST = 1 + LANES / 4;

  /** Steps with fewer blocks don't use vectors. */
  private static final int FEWEST_BLOCKS = 512 / LANES;

  /** Blocks that make a piece of work for a worker. */
  private static final int GRAIN = 64 / LANES;

  /** Every colour has a group of contacts with one point, and one of those with two. */
  private static final int GROUPS = 2 * 2 * (LAST_COLOUR + 1);

  // Offsets of the quantities of a block in data: of the contact,
  static final int NX = 0;
  static final int NY = NX + LANES;
  static final int FRICTION = NY + LANES;
  static final int MASS_A = FRICTION + LANES;
  static final int MASS_B = MASS_A + LANES;
  static final int INERTIA_A = MASS_B + LANES;
  static final int INERTIA_B = INERTIA_A + LANES;

  /** What an impulse at one point does to the other's speed along the normal, 1/kg. */
  static final int CROSS = INERTIA_B + LANES;

  // of each of its two points, relative to FIRST or SECOND: lever arms of impulses along the
  // normal, r x n, and along the tangent, r x t = r . n, of both bodies, m,
  static final int NORMAL_ARM_A = 0;
  static final int NORMAL_ARM_B = NORMAL_ARM_A + LANES;
  static final int TANGENT_ARM_A = NORMAL_ARM_B + LANES;
  static final int TANGENT_ARM_B = TANGENT_ARM_A + LANES;

  /** gap when the step began, and now, m, */
  static final int SEPARATION = TANGENT_ARM_B + LANES;

  static final int GAP = SEPARATION + LANES;

  /** what an impulse does to the point's speed along the normal, 1/kg, */
  static final int YIELD = GAP + LANES;

  /** its inverse along the tangent, kg, */
  static final int TANGENT_MASS = YIELD + LANES;

  /** impulses along normal and tangent, of the substep and of the whole step. */
  static final int NORMAL = TANGENT_MASS + LANES;

  static final int TANGENT = NORMAL + LANES;
  static final int TOTAL = TANGENT + LANES;
  static final int SLIDE = TOTAL + LANES;
  static final int POINT = SLIDE + LANES;

  static final int FIRST = CROSS + LANES;
  static final int SECOND = FIRST + POINT;
  static final int RECORD = SECOND + POINT;

  // What few contacts need, relative to the block in extra; each part is only valid if the block
  // has the trait. Speed of moving surfaces, m/s:
  static final int SURFACE = 0;

  /** Radii of the parts' rounding, m. */
  static final int ROUND_A = SURFACE + LANES;

  static final int ROUND_B = ROUND_A + LANES;
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
  static final int EXTRA = BOUNCE_FIRST + RUBBED + 2 * LANES;

  // Traits of blocks.
  /** Its contacts have two points. */
  static final int TWO = 1;

  /** They are with bodies that can't be moved: several touch the same, none writes to it. */
  static final int FIXED = 2;

  /** Some contact has a moving surface, a round part, rolling resistance, a bounce to come. */
  static final int MOVING_SURFACE = 4;

  static final int ROUND = 8;
  static final int ROLLS = 16;
  static final int BOUNCES = 32;

  /** Solved by vectors. */
  static final int WIDE = 64;

  /** The traits that softness depends on. */
  static final int SOFTNESS = TWO | FIXED;

  /** Number of contacts, and of blocks. */
  private int contacts;

  private int count;

  /** The touching rows and their places, group and zone, in the order of the keys. */
  private int[] touching = new int[0];

  private int[] place = new int[0];

  /** Colours each slot of {@link SolverBodies} has, among moving bodies and with static ones. */
  private long[] taken = new long[0];

  private long[] takenFixed = new long[0];

  /** Per group: its contacts. */
  private final int[] size = new int[GROUPS];

  /** Per zone of each group: its contacts; and, while they are given lanes, the next one. */
  private final int[] next = new int[GROUPS * SolverSlots.MOST_ZONES];

  /** The contacts of a group lie by the zones of their bodies; so many there are. */
  private int zones;

  private final ColourMemo memo = new ColourMemo();

  /** Per block: contacts in it, and its traits. */
  byte[] used = new byte[0];

  byte[] traits = new byte[0];

  /** Per lane: row of the contact table; offsets of the two bodies in the solver's state. */
  int[] row = new int[0];

  int[] bodyA = new int[0];
  int[] bodyB = new int[0];

  float[] data = new float[0];
  float[] extra = new float[0];

  /** {@link SolverBodies#state}, which the offsets are of. */
  float[] v;

  /** First block of each colour. */
  private final int[] colourStart = new int[2 * (LAST_COLOUR + 1) + 1];

  private final Crew crew;

  /** Pieces of all colours: from and to of each. */
  private int[] piece = new int[0];

  private int pieces;

  /** Per colour: its first piece; and all pieces by the workers that get them. */
  private final int[] firstPiece = new int[2 * (LAST_COLOUR + 1) + 1];

  private int[] byWorkers = new int[0];

  /** What is done piece by piece. */
  private Crew.Range visit;

  private final Crew.Range visiting = this::visitPieces;
  private final Crew.Range visitingAll = this::visitAllPieces;

  /** Makes room for nothing yet; the crew does colours. */
  ContactBlocks(Crew crew) {
    this.crew = crew;
  }

  /** The number of blocks. */
  int count() {
    return count;
  }

  /**
   * Finds the contacts to solve, touching and not vetoed, colours them and gives each a lane. What
   * it holds of them is to be filled in.
   *
   * @param lanes kernels that take whole blocks, null for none
   */
  void lay(ContactTable table, BodyStore bodies, SolverBodies solverBodies, ContactLanes lanes) {
    v = solverBodies.state;
    if (memo.holds(table, bodies, solverBodies.slotOf())) {
      layOut(lanes);
      return;
    }
    paint(table, bodies, solverBodies);
    memo.note(table, bodies, solverBodies.slotOf());
    layOut(lanes);
    layZones();
    for (int k = 0; k < contacts; k++) {
      row[next[place[k]]++] = touching[k];
    }
  }

  /** Finds the contacts to solve and gives each its colour. */
  private void paint(ContactTable t, BodyStore b, SolverBodies solverBodies) {
    int[] slotOf = solverBodies.slotOf();
    int slots = solverBodies.count();
    int zoneShift = solverBodies.zoneShift();
    zones = ((slots - 1) >> zoneShift) + 1;
    if (touching.length < t.count()) {
      int capacity = t.count() + t.count() / 2;
      touching = new int[capacity];
      place = new int[capacity];
    }
    if (taken.length < slots) {
      int capacity = Math.max(slots, taken.length * 2);
      taken = new long[capacity];
      takenFixed = new long[capacity];
    }
    Arrays.fill(taken, 0, slots, 0);
    Arrays.fill(takenFixed, 0, slots, 0);
    Arrays.fill(size, 0);
    Arrays.fill(next, 0, GROUPS * zones, 0);
    contacts = 0;
    for (int r = 0; r < t.count(); r++) {
      if (t.points[r] == 0 || (t.flags[r] & ContactTable.DORMANT) != 0) {
        continue;
      }
      if ((t.flags[r] & ContactTable.VETOED) != 0) {
        t.forget(r);
        continue;
      }
      int a = ContactKey.bodyA(t.key[r]);
      int o = ContactKey.bodyB(t.key[r]);
      int c;
      int slotA = slotOf[a];
      int slotB = slotOf[o];
      if (b.invMass[a] == 0) {
        slotA = slotB;
        c = LAST_COLOUR + 1 + paint(takenFixed, slotB);
      } else if (b.invMass[o] == 0) {
        c = LAST_COLOUR + 1 + paint(takenFixed, slotA);
      } else {
        c = Math.min(Long.numberOfTrailingZeros(~(taken[slotA] | taken[slotB])), LAST_COLOUR);
        long bit = 1L << c;
        taken[slotA] |= bit;
        taken[slotB] |= bit;
      }
      int zone = (c & LAST_COLOUR) == LAST_COLOUR ? 0 : slotA >> zoneShift;
      int group = 2 * c + t.points[r] - 1;
      size[group]++;
      place[contacts] = group * zones + zone;
      next[place[contacts]]++;
      touching[contacts++] = r;
    }
  }

  /** Gives each zone of a group its lanes. */
  private void layZones() {
    int block = 0;
    for (int g = 0; g < GROUPS; g++) {
      int lane = block * LANES;
      for (int i = g * zones; i < (g + 1) * zones; i++) {
        int n = next[i];
        next[i] = lane;
        lane += n;
      }
      block += (size[g] + LANES - 1) / LANES;
    }
  }

  private static int paint(long[] masks, int slot) {
    int c = Math.min(Long.numberOfTrailingZeros(~masks[slot]), LAST_COLOUR);
    masks[slot] |= 1L << c;
    return c;
  }

  /** Gives each group its count. */
  private void layOut(ContactLanes lanes) {
    count = 0;
    for (int g = 0; g < GROUPS; g++) {
      count += (size[g] + LANES - 1) / LANES;
    }
    if (used.length < count) {
      int capacity = count + count / 2; // room at once: crowds go on meeting after their first step
      used = new byte[capacity];
      traits = new byte[capacity];
      row = new int[capacity * LANES];
      bodyA = new int[capacity * LANES];
      bodyB = new int[capacity * LANES];
      data = new float[capacity * RECORD];
      extra = new float[capacity * EXTRA];
    }
    int widest = lanes == null || count < FEWEST_BLOCKS ? 0 : lanes.trusted(count);
    int block = 0;
    for (int g = 0; g < GROUPS; g++) {
      int colour = g >> 1;
      if ((g & 1) == 0) {
        colourStart[colour] = block;
      }
      int kind = ((g & 1) != 0 ? TWO : 0) | (colour > LAST_COLOUR ? FIXED : 0);
      int left = size[g];
      for (; left > 0; left -= LANES) {
        used[block] = (byte) Math.min(left, LANES);
        boolean wide = block < widest && left >= FEWEST && (colour & LAST_COLOUR) != LAST_COLOUR;
        traits[block] = (byte) (kind | (wide ? WIDE : 0));
        if (left < LANES) {
          clear(block);
        }
        block++;
      }
    }
    colourStart[GROUPS >> 1] = count;
    cut();
  }

  /**
   * Cuts all colours into pieces, those of a colour in the order of the workers that get them: the
   * first worker the first part of each of its groups, and so on. Within a group contacts lie by
   * the zones of their bodies, or by their keys, so every worker stays with the same bodies; who
   * packs and stores them finds blocks in its core's cache.
   */
  private void cut() {
    pieces = 0;
    if (!crew.shares(count, GRAIN)) {
      return;
    }
    int workers = crew.count();
    int most = count / GRAIN + 2 * GROUPS * workers;
    if (piece.length < 2 * most) {
      piece = new int[3 * most];
      byWorkers = new int[piece.length / 2];
    }
    for (int c = 0; c < GROUPS >> 1; c++) {
      firstPiece[c] = pieces;
      int start = colourStart[c];
      int middle = start + (size[2 * c] + LANES - 1) / LANES;
      int end = colourStart[c + 1];
      int shares = isShared(c) ? workers : 1;
      for (int i = 0; i < shares; i++) {
        cut(part(start, middle, i, shares), part(start, middle, i + 1, shares));
        cut(part(middle, end, i, shares), part(middle, end, i + 1, shares));
      }
    }
    firstPiece[GROUPS >> 1] = pieces;
    int n = 0;
    for (int worker = 0; worker < workers; worker++) {
      for (int c = 0; c < GROUPS >> 1; c++) {
        int shares = isShared(c) ? workers : 1;
        int from = part(firstPiece[c], firstPiece[c + 1], Math.min(worker, shares), shares);
        int to = part(firstPiece[c], firstPiece[c + 1], Math.min(worker + 1, shares), shares);
        for (int k = from; k < to; k++) {
          byWorkers[n++] = k;
        }
      }
    }
  }

  /** Where the part of a number begins, of so many equal parts of a range. */
  private static int part(int from, int to, int number, int parts) {
    return from + (to - from) * number / parts;
  }

  private void cut(int from, int to) {
    for (int at = from; at < to; at += GRAIN) {
      piece[2 * pieces] = at;
      piece[2 * pieces + 1] = Math.min(at + GRAIN, to);
      pieces++;
    }
  }

  /** Whether a colour is shared by the workers: not what found no colour, nor too few blocks. */
  private boolean isShared(int c) {
    return (c & LAST_COLOUR) != LAST_COLOUR
        && crew.shares(colourStart[c + 1] - colourStart[c], GRAIN);
  }

  /** Does a stage in which no block has anything to do with another. */
  void inAnyOrder(Crew.Range stage) {
    if (pieces == 0) {
      stage.run(0, count, 0);
      return;
    }
    visit = stage;
    crew.run(0, pieces, 1, visitingAll);
    visit = null;
  }

  private void visitPieces(int from, int to, int worker) {
    for (int k = from; k < to; k++) {
      visit.run(piece[2 * k], piece[2 * k + 1], worker);
    }
  }

  private void visitAllPieces(int from, int to, int worker) {
    for (int i = from; i < to; i++) {
      int k = byWorkers[i];
      visit.run(piece[2 * k], piece[2 * k + 1], worker);
    }
  }

  /** Makes the empty lanes of a block contacts of nothing with nothing. */
  private void clear(int block) {
    int at = block * RECORD;
    Arrays.fill(data, at, at + RECORD, 0);
    Arrays.fill(data, at + FIRST + YIELD, at + FIRST + YIELD + LANES, 1);
    Arrays.fill(data, at + SECOND + YIELD, at + SECOND + YIELD + LANES, 1);
    Arrays.fill(bodyA, block * LANES, (block + 1) * LANES, 0);
    Arrays.fill(bodyB, block * LANES, (block + 1) * LANES, 0);
  }

  /**
   * Does a stage colour by colour. Colours with too little to share, and what found no colour, are
   * done by the caller alone, neighbours in one go.
   */
  void byColours(Crew.Range stage) {
    int from = 0;
    for (int c = 0; c < GROUPS >> 1; c++) {
      int start = colourStart[c];
      int end = colourStart[c + 1];
      if (isShared(c)) {
        if (from < start) {
          stage.run(from, start, 0);
        }
        visit = stage;
        crew.run(firstPiece[c], firstPiece[c + 1], 1, visiting);
        from = end;
      }
    }
    if (from < count) {
      stage.run(from, count, 0);
    }
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
