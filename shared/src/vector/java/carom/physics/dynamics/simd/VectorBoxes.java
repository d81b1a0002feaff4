package carom.physics.dynamics.simd;

import static jdk.incubator.vector.VectorOperators.EQ;
import static jdk.incubator.vector.VectorOperators.GE;
import static jdk.incubator.vector.VectorOperators.GT;
import static jdk.incubator.vector.VectorOperators.LE;
import static jdk.incubator.vector.VectorOperators.LT;

import carom.physics.collision.Collider;
import carom.physics.dynamics.contact.KeptManifolds;
import carom.physics.dynamics.narrow.BoxLanes;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorSpecies;

/**
 * Finds the manifolds of pairs of boxes with the Vector API: the operations of {@code BoxCollider},
 * at the rounded relative pose, and of {@link KeptManifolds#follow}, in the same order, hence the
 * same bits.
 *
 * <p>Where these choose, both are worked out and blended. Small methods that pass each other
 * arrays, never vectors: these would be boxed.
 */
public final class VectorBoxes extends BoxLanes {
  private static final VectorSpecies<Float> LANE =
      LANES == 16 ? FloatVector.SPECIES_512 : FloatVector.SPECIES_256;

  /** Pose of B in A's frame. */
  private static final int X = OWN;

  private static final int Y = X + LANES;
  private static final int COS = Y + LANES;
  private static final int SIN = COS + LANES;

  /** Rounded pose of B in A's frame. */
  private static final int CELL_X = SIN + LANES;

  private static final int CELL_Y = CELL_X + LANES;
  private static final int UNIT_COS = CELL_Y + LANES;
  private static final int UNIT_SIN = UNIT_COS + LANES;

  /** Offset from the centre of A's box to that of B's in A's axes, and back in B's. */
  private static final int DX = UNIT_SIN + LANES;

  private static final int DY = DX + LANES;
  private static final int EX = DY + LANES;
  private static final int EY = EX + LANES;

  /** The largest gap along the axes of A and of B. */
  private static final int GAP_AX = EY + LANES;

  private static final int GAP_AY = GAP_AX + LANES;
  private static final int GAP_BX = GAP_AY + LANES;
  private static final int GAP_BY = GAP_BX + LANES;

  /** 1 if the reference box is A's, -1 if it is B's, and the gap along its best axis. */
  private static final int SIGN = GAP_BY + LANES;

  private static final int SEPARATION = SIGN + LANES;

  /** Outward normal of the reference face in its box's axes. */
  private static final int EDGE_X = SEPARATION + LANES;

  private static final int EDGE_Y = EDGE_X + LANES;

  /** Half sizes of the reference box, away from its centre to the face and along it. */
  private static final int UP = EDGE_Y + LANES;

  private static final int ALONG = UP + LANES;

  /** The reference box in A's frame: centre and x axis. */
  private static final int CENTER_X = ALONG + LANES;

  private static final int CENTER_Y = CENTER_X + LANES;
  private static final int AXIS_X = CENTER_Y + LANES;
  private static final int AXIS_Y = AXIS_X + LANES;

  /** Place of the second box in the frame of the reference box. */
  private static final int OTHER_X = AXIS_Y + LANES;

  private static final int OTHER_Y = OTHER_X + LANES;
  private static final int TURN = OTHER_Y + LANES;
  private static final int OTHER_HALF_X = TURN + LANES;
  private static final int OTHER_HALF_Y = OTHER_HALF_X + LANES;

  /** Outward normal of the facing edge in its box's axes, and along n and t. */
  private static final int FACING_X = OTHER_HALF_Y + LANES;

  private static final int FACING_Y = FACING_X + LANES;
  private static final int FACING_N = FACING_Y + LANES;
  private static final int FACING_T = FACING_N + LANES;

  /** The facing edge: half its length, its ends along t and above the reference face. */
  private static final int HALF = FACING_T + LANES;

  private static final int LOW = HALF + LANES;
  private static final int HIGH = LOW + LANES;
  private static final int HEIGHT_LOW = HIGH + LANES;
  private static final int HEIGHT_HIGH = HEIGHT_LOW + LANES;

  /** The points along t and above the reference face. */
  private static final int POSITION1 = HEIGHT_HIGH + LANES;

  private static final int POSITION2 = POSITION1 + LANES;
  private static final int GAP1ST = POSITION2 + LANES;
  private static final int GAP2ND = GAP1ST + LANES;

  /** Normal and points in A's frame, of the rounded pose. */
  private static final int FACE_NX = GAP2ND + LANES;

  private static final int FACE_NY = FACE_NX + LANES;
  private static final int PX0 = FACE_NY + LANES;
  private static final int PY0 = PX0 + LANES;
  private static final int PX1 = PY0 + LANES;
  private static final int PY1 = PX1 + LANES;

  /** The turn from the rounded pose to the true one: (1 + TURN_COS, TURN_SIN). */
  private static final int TURN_COS = PY1 + LANES;

  private static final int TURN_SIN = TURN_COS + LANES;

  private static final int SCRATCH = TURN_SIN + LANES + APART;

  /** Creates the kernels; called by name, see {@link BoxLanes#FOUND}. */
  public VectorBoxes() {
    if (FloatVector.SPECIES_PREFERRED.length() < LANES) {
      throw new UnsupportedOperationException("vectors have fewer than " + LANES + " lanes");
    }
  }

  @Override
  public int scratchSize() {
    return SCRATCH;
  }

  @Override
  protected int warmUpSize() {
    return SCRATCH;
  }

  /**
   * {@inheritDoc}
   *
   * <p>Not by {@link #collide}: were that compiled before its kernels, it would take so many of
   * them in that the compiler gave up within, and boxed vectors for good.
   */
  @Override
  protected void warmUp(float[] s) {
    place(s);
    gaps(s);
    choose(s);
    frame(s);
    face(s);
    clip(s);
    keep(s, 1);
    corners(s);
    points(s);
    ids(s);
    order(s, 1);
    turn(s);
    follow(s, PX0, GAP0, X0);
    limit(s, 1);
  }

  @Override
  public void collide(float[] s, float speculative) {
    place(s);
    gaps(s);
    choose(s);
    frame(s);
    face(s);
    clip(s);
    keep(s, speculative);
    corners(s);
    points(s);
    ids(s);
    order(s, speculative);
    turn(s);
    follow(s, PX0, GAP0, X0);
    follow(s, PX1, GAP1, X1);
    limit(s, speculative);
  }

  /** Finds the pose of B in A's frame, and the rounded one. */
  private static void place(float[] s) {
    FloatVector wayX = FloatVector.fromArray(LANE, s, WAY_X);
    FloatVector wayY = FloatVector.fromArray(LANE, s, WAY_Y);
    FloatVector cosA = FloatVector.fromArray(LANE, s, COS_A);
    FloatVector sinA = FloatVector.fromArray(LANE, s, SIN_A);
    FloatVector cosB = FloatVector.fromArray(LANE, s, COS_B);
    FloatVector sinB = FloatVector.fromArray(LANE, s, SIN_B);
    FloatVector x = cosA.mul(wayX).add(sinA.mul(wayY));
    FloatVector y = cosA.mul(wayY).sub(sinA.mul(wayX));
    FloatVector cos = cosA.mul(cosB).add(sinA.mul(sinB));
    FloatVector sin = cosA.mul(sinB).sub(sinA.mul(cosB));
    x.intoArray(s, X);
    y.intoArray(s, Y);
    cos.intoArray(s, COS);
    sin.intoArray(s, SIN);
    x.add(KeptManifolds.ROUNDING).sub(KeptManifolds.ROUNDING).intoArray(s, CELL_X);
    y.add(KeptManifolds.ROUNDING).sub(KeptManifolds.ROUNDING).intoArray(s, CELL_Y);
    cos = cos.add(KeptManifolds.ROUNDING).sub(KeptManifolds.ROUNDING);
    sin = sin.add(KeptManifolds.ROUNDING).sub(KeptManifolds.ROUNDING);
    FloatVector unit = FloatVector.broadcast(LANE, 1).div(cos.mul(cos).add(sin.mul(sin)).sqrt());
    cos.mul(unit).intoArray(s, UNIT_COS);
    sin.mul(unit).intoArray(s, UNIT_SIN);
  }

  /** Computes the four gaps. */
  private static void gaps(float[] s) {
    FloatVector cos = FloatVector.fromArray(LANE, s, UNIT_COS);
    FloatVector sin = FloatVector.fromArray(LANE, s, UNIT_SIN);
    FloatVector bx = FloatVector.fromArray(LANE, s, CENTER_X_B);
    FloatVector by = FloatVector.fromArray(LANE, s, CENTER_Y_B);
    FloatVector dx =
        FloatVector.fromArray(LANE, s, CELL_X)
            .add(cos.mul(bx))
            .sub(sin.mul(by))
            .sub(FloatVector.fromArray(LANE, s, CENTER_X_A));
    FloatVector dy =
        FloatVector.fromArray(LANE, s, CELL_Y)
            .add(sin.mul(bx))
            .add(cos.mul(by))
            .sub(FloatVector.fromArray(LANE, s, CENTER_Y_A));
    FloatVector ex = cos.mul(dx).add(sin.mul(dy)).neg();
    FloatVector ey = sin.mul(dx).sub(cos.mul(dy));
    dx.intoArray(s, DX);
    dy.intoArray(s, DY);
    ex.intoArray(s, EX);
    ey.intoArray(s, EY);
    FloatVector c = cos.abs();
    FloatVector n = sin.abs();
    FloatVector aw = FloatVector.fromArray(LANE, s, HALF_WIDTH_A);
    FloatVector ah = FloatVector.fromArray(LANE, s, HALF_HEIGHT_A);
    FloatVector bw = FloatVector.fromArray(LANE, s, HALF_WIDTH_B);
    FloatVector bh = FloatVector.fromArray(LANE, s, HALF_HEIGHT_B);
    dx.abs().sub(aw).sub(c.mul(bw).add(n.mul(bh))).intoArray(s, GAP_AX);
    dy.abs().sub(ah).sub(n.mul(bw).add(c.mul(bh))).intoArray(s, GAP_AY);
    ex.abs().sub(bw).sub(c.mul(aw).add(n.mul(ah))).intoArray(s, GAP_BX);
    ey.abs().sub(bh).sub(n.mul(aw).add(c.mul(ah))).intoArray(s, GAP_BY);
  }

  /** Chooses the reference box, and its reference face. */
  private static void choose(float[] s) {
    FloatVector gapAx = FloatVector.fromArray(LANE, s, GAP_AX);
    FloatVector gapAy = FloatVector.fromArray(LANE, s, GAP_AY);
    FloatVector gapBx = FloatVector.fromArray(LANE, s, GAP_BX);
    FloatVector gapBy = FloatVector.fromArray(LANE, s, GAP_BY);
    FloatVector gapA = gapAx.max(gapAy);
    FloatVector gapB = gapBx.max(gapBy);
    FloatVector aw = FloatVector.fromArray(LANE, s, HALF_WIDTH_A);
    FloatVector bw = FloatVector.fromArray(LANE, s, HALF_WIDTH_B);
    FloatVector bias =
        aw.add(FloatVector.fromArray(LANE, s, HALF_HEIGHT_A))
            .add(bw)
            .add(FloatVector.fromArray(LANE, s, HALF_HEIGHT_B))
            .mul(Collider.BOX_ROUNDING);
    FloatVector faceBias =
        aw.min(bw).mul(2).mul(Collider.RELATIVE_FACE_BIAS).min(Collider.FACE_BIAS);
    bias = bias.blend(bias.add(faceBias), gapB.compare(LE, Collider.TOUCHING));
    VectorMask<Float> ofB = gapB.compare(GT, gapA.add(bias));
    gapA.blend(gapB, ofB).intoArray(s, SEPARATION);
    FloatVector one = FloatVector.broadcast(LANE, 1);
    FloatVector minus = FloatVector.broadcast(LANE, -1);
    one.blend(minus, ofB).intoArray(s, SIGN);
    FloatVector gapX = gapAx.blend(gapBx, ofB);
    FloatVector gapY = gapAy.blend(gapBy, ofB);
    FloatVector x =
        FloatVector.fromArray(LANE, s, DX).blend(FloatVector.fromArray(LANE, s, EX), ofB);
    FloatVector y =
        FloatVector.fromArray(LANE, s, DY).blend(FloatVector.fromArray(LANE, s, EY), ofB);
    x.intoArray(s, OTHER_X);
    y.intoArray(s, OTHER_Y);
    // Of equally good faces the right one goes before the upper one, that before the left one.
    VectorMask<Float> right = gapX.compare(EQ, gapY).and(y.compare(GT, 0)).and(x.compare(GE, 0));
    VectorMask<Float> sideways = gapY.compare(LT, gapX).or(right);
    FloatVector zero = FloatVector.zero(LANE);
    zero.blend(one.blend(minus, x.compare(LT, 0)), sideways).intoArray(s, EDGE_X);
    minus.blend(one, y.compare(GT, 0)).blend(zero, sideways).intoArray(s, EDGE_Y);
  }

  /** Finds the reference box, and the other one in its frame. */
  private static void frame(float[] s) {
    VectorMask<Float> ofB = FloatVector.fromArray(LANE, s, SIGN).compare(LT, 0);
    VectorMask<Float> upright = FloatVector.fromArray(LANE, s, EDGE_X).compare(EQ, 0);
    FloatVector cos = FloatVector.fromArray(LANE, s, UNIT_COS);
    FloatVector sin = FloatVector.fromArray(LANE, s, UNIT_SIN);
    FloatVector aw = FloatVector.fromArray(LANE, s, HALF_WIDTH_A);
    FloatVector ah = FloatVector.fromArray(LANE, s, HALF_HEIGHT_A);
    FloatVector bw = FloatVector.fromArray(LANE, s, HALF_WIDTH_B);
    FloatVector bh = FloatVector.fromArray(LANE, s, HALF_HEIGHT_B);
    FloatVector halfX = aw.blend(bw, ofB);
    FloatVector halfY = ah.blend(bh, ofB);
    halfX.blend(halfY, upright).intoArray(s, UP);
    halfY.blend(halfX, upright).intoArray(s, ALONG);
    bw.blend(aw, ofB).intoArray(s, OTHER_HALF_X);
    bh.blend(ah, ofB).intoArray(s, OTHER_HALF_Y);
    sin.blend(sin.neg(), ofB).intoArray(s, TURN);
    FloatVector.broadcast(LANE, 1).blend(cos, ofB).intoArray(s, AXIS_X);
    FloatVector.zero(LANE).blend(sin, ofB).intoArray(s, AXIS_Y);
    FloatVector x = FloatVector.fromArray(LANE, s, CENTER_X_A);
    FloatVector y = FloatVector.fromArray(LANE, s, CENTER_Y_A);
    x.blend(x.add(FloatVector.fromArray(LANE, s, DX)), ofB).intoArray(s, CENTER_X);
    y.blend(y.add(FloatVector.fromArray(LANE, s, DY)), ofB).intoArray(s, CENTER_Y);
  }

  /** Finds the edge of the other box that faces the reference face. */
  private static void face(float[] s) {
    FloatVector edgeX = FloatVector.fromArray(LANE, s, EDGE_X);
    FloatVector edgeY = FloatVector.fromArray(LANE, s, EDGE_Y);
    FloatVector cos = FloatVector.fromArray(LANE, s, UNIT_COS);
    FloatVector turn = FloatVector.fromArray(LANE, s, TURN);
    FloatVector turnedCos = edgeX.mul(cos).add(edgeY.mul(turn));
    FloatVector turnedSin = edgeX.mul(turn).sub(edgeY.mul(cos));
    // Opposite to the edge, less the quarters by which the box is turned; no negative zeros.
    VectorMask<Float> across = cos.abs().compare(LT, turn.abs());
    FloatVector quarterX = edgeY.blend(edgeY.neg(), turn.compare(GT, 0));
    FloatVector quarterY = edgeX.neg().blend(edgeX, turn.compare(GT, 0));
    VectorMask<Float> straight = cos.compare(GT, 0);
    FloatVector facingX = edgeX.blend(edgeX.neg(), straight).blend(quarterX, across).add(0f);
    FloatVector facingY = edgeY.blend(edgeY.neg(), straight).blend(quarterY, across).add(0f);
    facingX.intoArray(s, FACING_X);
    facingY.intoArray(s, FACING_Y);
    turnedCos.mul(facingX).sub(turnedSin.mul(facingY)).intoArray(s, FACING_N);
    turnedSin.mul(facingX).add(turnedCos.mul(facingY)).intoArray(s, FACING_T);
  }

  /** Finds the ends of that edge, and of its part above the reference face. */
  private static void clip(float[] s) {
    FloatVector edgeX = FloatVector.fromArray(LANE, s, EDGE_X);
    FloatVector edgeY = FloatVector.fromArray(LANE, s, EDGE_Y);
    FloatVector facingN = FloatVector.fromArray(LANE, s, FACING_N);
    FloatVector facingT = FloatVector.fromArray(LANE, s, FACING_T);
    FloatVector x = FloatVector.fromArray(LANE, s, OTHER_X);
    FloatVector y = FloatVector.fromArray(LANE, s, OTHER_Y);
    FloatVector halfX = FloatVector.fromArray(LANE, s, OTHER_HALF_X);
    FloatVector halfY = FloatVector.fromArray(LANE, s, OTHER_HALF_Y);
    VectorMask<Float> upright = FloatVector.fromArray(LANE, s, FACING_X).compare(EQ, 0);
    FloatVector outward = halfX.blend(halfY, upright);
    FloatVector half = halfY.blend(halfX, upright);
    half.intoArray(s, HALF);
    FloatVector middleN =
        edgeX
            .mul(x)
            .add(edgeY.mul(y))
            .add(facingN.mul(outward))
            .sub(FloatVector.fromArray(LANE, s, UP));
    FloatVector middleT = edgeX.mul(y).sub(edgeY.mul(x)).add(facingT.mul(outward));
    FloatVector low = middleT.add(facingN.mul(half));
    FloatVector high = middleT.sub(facingN.mul(half));
    FloatVector heightLow = middleN.sub(facingT.mul(half));
    FloatVector heightHigh = middleN.add(facingT.mul(half));
    low.intoArray(s, LOW);
    high.intoArray(s, HIGH);
    heightLow.intoArray(s, HEIGHT_LOW);
    heightHigh.intoArray(s, HEIGHT_HIGH);
    FloatVector slope = facingT.neg().div(facingN);
    FloatVector along = FloatVector.fromArray(LANE, s, ALONG);
    FloatVector position1 = low.max(along.neg());
    FloatVector position2 = high.min(along);
    position1.intoArray(s, POSITION1);
    position2.intoArray(s, POSITION2);
    heightLow.add(slope.mul(position1.sub(low))).intoArray(s, GAP1ST);
    heightHigh.add(slope.mul(position2.sub(high))).intoArray(s, GAP2ND);
  }

  /** Counts the points. */
  private static void keep(float[] s, float speculative) {
    FloatVector none = FloatVector.zero(LANE);
    FloatVector one = FloatVector.broadcast(LANE, 1);
    FloatVector first =
        none.blend(one, FloatVector.fromArray(LANE, s, GAP1ST).compare(LE, speculative));
    FloatVector second =
        none.blend(one, FloatVector.fromArray(LANE, s, GAP2ND).compare(LE, speculative));
    first.add(second).intoArray(s, COUNT);
  }

  /** Marks lanes in which corners face each other. */
  private static void corners(float[] s) {
    FloatVector low = FloatVector.fromArray(LANE, s, LOW);
    FloatVector high = FloatVector.fromArray(LANE, s, HIGH);
    FloatVector along = FloatVector.fromArray(LANE, s, ALONG);
    FloatVector heightLow = FloatVector.fromArray(LANE, s, HEIGHT_LOW);
    FloatVector heightHigh = FloatVector.fromArray(LANE, s, HEIGHT_HIGH);
    VectorMask<Float> past = low.compare(GE, along).or(high.compare(LE, along.neg()));
    FloatVector nearest = high.blend(low, heightLow.compare(LE, heightHigh));
    FloatVector end = along.blend(along.neg(), nearest.compare(LT, 0));
    FloatVector inner =
        FloatVector.fromArray(LANE, s, FACING_T)
            .mul(heightHigh)
            .add(FloatVector.fromArray(LANE, s, FACING_N).mul(end.sub(high)));
    FloatVector length = FloatVector.fromArray(LANE, s, HALF).mul(2);
    VectorMask<Float> beyond =
        FloatVector.fromArray(LANE, s, SEPARATION)
            .compare(GT, Collider.TOUCHING)
            .and(nearest.abs().compare(GT, along))
            .and(inner.compare(LE, 0).or(inner.compare(GE, length)));
    FloatVector.fromArray(LANE, s, COUNT)
        .blend(FloatVector.broadcast(LANE, CORNERS), past.or(beyond))
        .intoArray(s, COUNT);
  }

  /** Finds normal and points in A's frame. */
  private static void points(float[] s) {
    FloatVector edgeX = FloatVector.fromArray(LANE, s, EDGE_X);
    FloatVector edgeY = FloatVector.fromArray(LANE, s, EDGE_Y);
    FloatVector axisX = FloatVector.fromArray(LANE, s, AXIS_X);
    FloatVector axisY = FloatVector.fromArray(LANE, s, AXIS_Y);
    FloatVector nx = edgeX.mul(axisX).sub(edgeY.mul(axisY));
    FloatVector ny = edgeX.mul(axisY).add(edgeY.mul(axisX));
    FloatVector up = FloatVector.fromArray(LANE, s, UP);
    FloatVector centerX = FloatVector.fromArray(LANE, s, CENTER_X);
    FloatVector centerY = FloatVector.fromArray(LANE, s, CENTER_Y);
    FloatVector t1 = FloatVector.fromArray(LANE, s, POSITION1);
    FloatVector t2 = FloatVector.fromArray(LANE, s, POSITION2);
    FloatVector up1 = up.add(FloatVector.fromArray(LANE, s, GAP1ST).mul(0.5f));
    FloatVector up2 = up.add(FloatVector.fromArray(LANE, s, GAP2ND).mul(0.5f));
    centerX.add(nx.mul(up1)).sub(ny.mul(t1)).intoArray(s, PX0);
    centerY.add(ny.mul(up1)).add(nx.mul(t1)).intoArray(s, PY0);
    centerX.add(nx.mul(up2)).sub(ny.mul(t2)).intoArray(s, PX1);
    centerY.add(ny.mul(up2)).add(nx.mul(t2)).intoArray(s, PY1);
    FloatVector sign = FloatVector.fromArray(LANE, s, SIGN);
    nx.mul(sign).intoArray(s, FACE_NX);
    ny.mul(sign).intoArray(s, FACE_NY);
  }

  /** Finds the ids of both points: the number of A's corner, times 256, plus that of B's. */
  private static void ids(float[] s) {
    FloatVector edgeX = FloatVector.fromArray(LANE, s, EDGE_X);
    FloatVector edgeY = FloatVector.fromArray(LANE, s, EDGE_Y);
    FloatVector facingX = FloatVector.fromArray(LANE, s, FACING_X);
    FloatVector facingY = FloatVector.fromArray(LANE, s, FACING_Y);
    FloatVector two = FloatVector.broadcast(LANE, 2);
    FloatVector zero = FloatVector.zero(LANE);
    FloatVector edge = two.sub(edgeX).blend(edgeY.add(1), edgeX.compare(EQ, 0));
    FloatVector facing = two.sub(facingX).blend(facingY.add(1), facingX.compare(EQ, 0));
    FloatVector edge2 = edge.add(1).blend(zero, edge.compare(EQ, 3));
    FloatVector facing2 = facing.add(1).blend(zero, facing.compare(EQ, 3));
    VectorMask<Float> ofB = FloatVector.fromArray(LANE, s, SIGN).compare(LT, 0);
    edge.blend(facing2, ofB).mul(256).add(facing2.blend(edge, ofB)).add(INTEGER).intoArray(s, ID0);
    edge2.blend(facing, ofB).mul(256).add(facing.blend(edge2, ofB)).add(INTEGER).intoArray(s, ID1);
    FloatVector highId = edge2.blend(facing2, ofB).mul(256).add(facing2.blend(edge2, ofB));
    FloatVector lowId = edge.blend(facing, ofB).mul(256).add(facing.blend(edge, ofB));
    FloatVector along = FloatVector.fromArray(LANE, s, ALONG);
    VectorMask<Float> beyond1 = FloatVector.fromArray(LANE, s, LOW).compare(LT, along.neg());
    VectorMask<Float> beyond2 = FloatVector.fromArray(LANE, s, HIGH).compare(GT, along);
    highId.blend(lowId, beyond1).add(INTEGER).intoArray(s, OTHER_ID0);
    lowId.blend(highId, beyond2).add(INTEGER).intoArray(s, OTHER_ID1);
  }

  /** Makes the second point the first one where there is no other. */
  private static void order(float[] s, float speculative) {
    FloatVector gap1 = FloatVector.fromArray(LANE, s, GAP1ST);
    FloatVector gap2 = FloatVector.fromArray(LANE, s, GAP2ND);
    VectorMask<Float> later = gap1.compare(GT, speculative);
    gap1.blend(gap2, later).intoArray(s, GAP0);
    gap2.intoArray(s, GAP1);
    FloatVector.fromArray(LANE, s, PX0)
        .blend(FloatVector.fromArray(LANE, s, PX1), later)
        .intoArray(s, PX0);
    FloatVector.fromArray(LANE, s, PY0)
        .blend(FloatVector.fromArray(LANE, s, PY1), later)
        .intoArray(s, PY0);
    FloatVector.fromArray(LANE, s, ID0)
        .blend(FloatVector.fromArray(LANE, s, ID1), later)
        .intoArray(s, ID0);
    FloatVector.fromArray(LANE, s, OTHER_ID0)
        .blend(FloatVector.fromArray(LANE, s, OTHER_ID1), later)
        .intoArray(s, OTHER_ID0);
    FloatVector apart =
        FloatVector.fromArray(LANE, s, GAP_AX).max(FloatVector.fromArray(LANE, s, GAP_AY));
    apart = apart.max(FloatVector.fromArray(LANE, s, GAP_BX));
    apart = apart.max(FloatVector.fromArray(LANE, s, GAP_BY));
    FloatVector.fromArray(LANE, s, COUNT)
        .blend(0, apart.compare(GT, speculative))
        .intoArray(s, COUNT);
  }

  /** Finds the turn from the rounded to the true pose, and the normal there. */
  private static void turn(float[] s) {
    FloatVector cos = FloatVector.fromArray(LANE, s, COS);
    FloatVector sin = FloatVector.fromArray(LANE, s, SIN);
    FloatVector unitCos = FloatVector.fromArray(LANE, s, UNIT_COS);
    FloatVector unitSin = FloatVector.fromArray(LANE, s, UNIT_SIN);
    FloatVector c = cos.mul(unitCos).add(sin.mul(unitSin)).sub(1);
    FloatVector n = sin.mul(unitCos).sub(cos.mul(unitSin));
    c.intoArray(s, TURN_COS);
    n.intoArray(s, TURN_SIN);
    VectorMask<Float> ofB = FloatVector.fromArray(LANE, s, SIGN).compare(LT, 0);
    FloatVector zero = FloatVector.zero(LANE);
    FloatVector x = FloatVector.fromArray(LANE, s, FACE_NX);
    FloatVector y = FloatVector.fromArray(LANE, s, FACE_NY);
    // To the axes of A's frame, which the collider takes for the world: tells on signs of zeros.
    FloatVector nx = x.sub(zero.mul(y));
    FloatVector ny = zero.mul(x).add(y);
    FloatVector turnedX = nx.add(c.mul(nx).sub(n.mul(ny)));
    FloatVector turnedY = ny.add(n.mul(nx).add(c.mul(ny)));
    nx = nx.blend(turnedX, ofB);
    ny = ny.blend(turnedY, ofB);
    nx.intoArray(s, FACE_NX);
    ny.intoArray(s, FACE_NY);
    FloatVector cosA = FloatVector.fromArray(LANE, s, COS_A);
    FloatVector sinA = FloatVector.fromArray(LANE, s, SIN_A);
    cosA.mul(nx).sub(sinA.mul(ny)).intoArray(s, NX);
    sinA.mul(nx).add(cosA.mul(ny)).intoArray(s, NY);
  }

  /** Finds a point and its gap at the true pose. */
  private static void follow(float[] s, int point, int gap, int to) {
    FloatVector zero = FloatVector.zero(LANE);
    FloatVector x = FloatVector.fromArray(LANE, s, point);
    FloatVector y = FloatVector.fromArray(LANE, s, point + LANES);
    FloatVector px = x.sub(zero.mul(y));
    FloatVector py = zero.mul(x).add(y);
    FloatVector c = FloatVector.fromArray(LANE, s, TURN_COS);
    FloatVector n = FloatVector.fromArray(LANE, s, TURN_SIN);
    FloatVector cellX = FloatVector.fromArray(LANE, s, CELL_X);
    FloatVector cellY = FloatVector.fromArray(LANE, s, CELL_Y);
    FloatVector armX = px.sub(cellX);
    FloatVector armY = py.sub(cellY);
    FloatVector moveX =
        FloatVector.fromArray(LANE, s, X).sub(cellX).add(c.mul(armX).sub(n.mul(armY)));
    FloatVector moveY =
        FloatVector.fromArray(LANE, s, Y).sub(cellY).add(n.mul(armX).add(c.mul(armY)));
    FloatVector.fromArray(LANE, s, gap)
        .add(
            FloatVector.fromArray(LANE, s, FACE_NX)
                .mul(moveX)
                .add(FloatVector.fromArray(LANE, s, FACE_NY).mul(moveY)))
        .intoArray(s, gap);
    px = px.add(moveX.mul(0.5f));
    py = py.add(moveY.mul(0.5f));
    FloatVector cosA = FloatVector.fromArray(LANE, s, COS_A);
    FloatVector sinA = FloatVector.fromArray(LANE, s, SIN_A);
    cosA.mul(px).sub(sinA.mul(py)).intoArray(s, to);
    sinA.mul(px).add(cosA.mul(py)).intoArray(s, to + LANES);
  }

  /** Drops what is too far apart in the true pose, and tells the least gap. */
  private static void limit(float[] s, float speculative) {
    FloatVector count = FloatVector.fromArray(LANE, s, COUNT);
    FloatVector gap0 = FloatVector.fromArray(LANE, s, GAP0);
    FloatVector least =
        gap0.blend(gap0.min(FloatVector.fromArray(LANE, s, GAP1)), count.compare(EQ, 2));
    VectorMask<Float> face = count.compare(GT, 0).and(count.compare(LT, CORNERS));
    count = count.blend(0, face.and(least.compare(GT, speculative)));
    FloatVector slack = FloatVector.fromArray(LANE, s, REACH).add(1).mul(2 * KeptManifolds.CELL);
    FloatVector near = FloatVector.broadcast(LANE, speculative).sub(slack);
    face = count.compare(GT, 0).and(count.compare(LT, CORNERS));
    count = count.blend(count.add(LOOK), face.and(least.compare(GT, near)));
    count.add(INTEGER).intoArray(s, COUNT);
    FloatVector deepest = FloatVector.fromArray(LANE, s, LEAST);
    deepest.blend(deepest.min(least), face).intoArray(s, LEAST);
  }
}
