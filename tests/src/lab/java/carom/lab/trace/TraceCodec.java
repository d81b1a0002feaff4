package carom.lab.trace;

import carom.net.codec.BitCoder;
import carom.net.codec.Quantizer;
import carom.net.codec.RangeDecoder;
import carom.net.codec.RangeEncoder;
import java.util.Arrays;

/**
 * Codes snapshots of many moving bodies as few bytes, without a world: arrays in, bytes out. Each
 * snapshot is coded against what the receiver has acknowledged: all snapshots up to the one {@code
 * lag} before, and what can be learnt from them. The receiver runs the same class over the same
 * bytes. One object either encodes or decodes.
 *
 * <p>How: bodies go in order of their speed, each followed by those that it may have touched. A bit
 * says whether a body is as it was. If not, a linear prediction is made from its past and from how
 * its neighbours, already coded, were surprised; it fits its own weights to the acknowledged past,
 * for bodies in free flight apart from those in contact. What is left is coded bit by bit with
 * probabilities mixed from several contexts ({@link NumberModel}). After that snapshot is
 * acknowledged the same walk over it teaches regressions and contexts. While coding nothing is
 * learnt, so that a lost snapshot leaves no trace.
 *
 * <p>One thread. Nothing is allocated after the first snapshot. Cost: grows with the bodies that
 * move; bodies at rest far from all others cost some nanoseconds and next to no bits.
 *
 * <p>One class of 750 lines, as encoder, decoder and what they learn are one walk over one state.
 */
public final class TraceCodec {

  /** Fields of a pose: x, y, angle. */
  public static final int POSE = 3;

  /** Fields of a full state: x, y, angle, vx, vy, omega. */
  public static final int FULL = 6;

  /** Most bodies of a codec. */
  public static final int MAX_BODIES = 65_535;

  /** Longest lag in snapshots. */
  public static final int MAX_LAG = 64;

  private static final int ANGLE = 2;
  private static final int[] POSE_ORDER = {0, 1, 2};
  private static final int[] FULL_ORDER = {3, 4, 5, 0, 1, 2};

  // What a prediction is made of: how far the body came over the last snapshots...
  private static final int[] SPANS = {1, 2, 4, 8, 16, 32};
  private static final int HISTORY = 32;
  // ... a constant, for gravity ...
  private static final int CONSTANT = 6;
  // ... and what is known of this snapshot: surprises of neighbours and of the fields before.
  private static final int AROUND = 7;
  private static final int PUSH = 8;
  private static final int CROSS = 9;
  private static final int AROUND_X = 10;
  private static final int AROUND_Y = 11;
  private static final int POSE_INPUTS = 12;
  // With velocities: the way at the old velocity, and at the mean of old and new.
  private static final int OLD_VELOCITY = 12;
  private static final int MEAN_VELOCITY = 13;
  private static final int FULL_INPUTS = 14;

  private static final int PHASES = 10;
  private static final int TOUCHES = 3;
  private static final int CLASSES = TOUCHES * (1 + PHASES);
  private static final int SOLVE_EVERY = 4;

  /** A second difference off its trend by more than this, in 1/16 steps, is more than rounding. */
  private static final int JOLT = 40;

  private static final int MAX_STEP = Quantizer.MAX_POSITION;
  private static final int FAR = 1_000_000_000;
  private static final int REFIT = 32;
  private static final int NUMBER_CONTEXTS = 7;
  private static final int SAME_CONTEXTS = 6;
  private static final int SAME_VALUES = 1_024;
  private static final int ALONE_CONTEXTS = 4;
  private static final int ALONE_VALUES = 1_024;

  private final int bodies;
  private final int lag;
  private final int fields;
  private final int[] order;
  private final double velocityWay;
  private final double omegaWay;
  private final int[][][] ring;
  private int count;

  // What acknowledged snapshots taught about each body: up to the newest of them, up to each of the
  // last, and up to the baseline of the walk.
  private final BodyRecord latest;
  private final BodyRecord[] records;
  private BodyRecord record;
  private final int[] spacing;
  private final int[] reach;
  private int moving;

  // What it taught about all of them.
  private final Regression[][] regressions;
  private final Mixture same;
  private final Mixture sameFar;
  private final NumberModel[] numbers;
  private final NumberModel alone;

  // One walk over a snapshot.
  private BitCoder coder;
  private boolean learning;
  private int[][] target;
  private int[][] base;
  private final int[][][] past = new int[SPANS.length][][];
  private final Grid grid;
  private final int[] found;
  private final int[] queue;
  private int queued;
  private final int[] speed;
  private final int[] speedCount = new int[LEVELS + 1];
  private final boolean[] coded;
  private final boolean[] alerted;
  private final double[][] expected;
  private final double[][] surprises;
  private final double[] pushX;
  private final double[] pushY;
  private final int[] neighbours;
  private final int[] movedNeighbours;
  private final double[] input;
  private final double[] surprise;

  private final RangeEncoder encoder = new RangeEncoder();
  private final RangeDecoder decoder = new RangeDecoder();

  /**
   * Creates one end of a stream. Both ends must be given the same numbers.
   *
   * @param bodies 1..{@link #MAX_BODIES}
   * @param lag how many snapshots the newest acknowledged one is behind, 1..{@link #MAX_LAG}
   * @param rate snapshots per second
   * @param fields {@link #POSE} or {@link #FULL}
   */
  public TraceCodec(int bodies, int lag, int rate, int fields) {
    check("bodies", bodies, 1, MAX_BODIES);
    check("lag", lag, 1, MAX_LAG);
    check("rate", rate, 1, 1_000);
    if (fields != POSE && fields != FULL) {
      throw new IllegalArgumentException("fields=" + fields + " is neither POSE nor FULL");
    }
    this.bodies = bodies;
    this.lag = lag;
    this.fields = fields;
    order = fields == FULL ? FULL_ORDER : POSE_ORDER;
    double seconds = (double) lag / rate;
    velocityWay = seconds * Quantizer.POSITION_STEPS / Trace.VELOCITY_STEPS;
    omegaWay = seconds * Quantizer.ANGLE_STEPS / (Trace.OMEGA_STEPS * 2 * Math.PI);
    ring = new int[2 * lag + HISTORY + 1][fields][bodies];
    latest = new BodyRecord(bodies, fields, HISTORY);
    records = new BodyRecord[lag + 1];
    for (int i = 0; i < records.length; i++) {
      records[i] = new BodyRecord(bodies, fields, HISTORY);
    }
    spacing = new int[bodies];
    Arrays.fill(spacing, FAR);
    reach = new int[bodies];
    regressions = new Regression[fields][CLASSES];
    numbers = new NumberModel[fields];
    int inputs = fields == FULL ? FULL_INPUTS : POSE_INPUTS;
    for (int f = 0; f < fields; f++) {
      int guessed = fields == FULL && f < POSE ? MEAN_VELOCITY : 1;
      for (int c = 0; c < CLASSES; c++) {
        regressions[f][c] = new Regression(inputs, c < TOUCHES ? -1 : guessed);
      }
      numbers[f] = new NumberModel(NUMBER_CONTEXTS, 512, PHASES);
    }
    same = new Mixture(SAME_CONTEXTS, SAME_CONTEXTS * SAME_VALUES, 64, 255);
    sameFar = new Mixture(1, LEVELS, 1, 1_000);
    alone = new NumberModel(ALONE_CONTEXTS, ALONE_VALUES, 1);
    grid = new Grid(bodies);
    found = new int[bodies];
    queue = new int[bodies];
    speed = new int[bodies];
    coded = new boolean[bodies];
    alerted = new boolean[bodies];
    expected = new double[fields][bodies];
    surprises = new double[fields][bodies];
    pushX = new double[bodies];
    pushY = new double[bodies];
    neighbours = new int[bodies];
    movedNeighbours = new int[bodies];
    input = new double[inputs];
    surprise = new double[fields];
  }

  private static void check(String name, int value, int min, int max) {
    if (value < min || value > max) {
      throw new IllegalArgumentException(name + "=" + value + " is outside " + min + ".." + max);
    }
  }

  /**
   * Encodes the next snapshot.
   *
   * @param state by field, then by body, in the steps of {@link Quantizer}; angles 0..1,023; copied
   * @param out where to; {@link #maxBytes} are enough
   * @return length in bytes
   * @throws IllegalArgumentException if a number is out of the quantiser's range
   */
  public int encode(int[][] state, byte[] out) {
    for (int f = 0; f < fields; f++) {
      for (int i = 0; i < bodies; i++) {
        if (!inRange(f, state[f][i])) {
          throw new IllegalArgumentException(
              "body=" + i + " field=" + f + " value=" + state[f][i] + " is out of range");
        }
      }
    }
    learnAcknowledged();
    int[][] snapshot = at(count);
    for (int f = 0; f < fields; f++) {
      System.arraycopy(state[f], 0, snapshot[f], 0, bodies);
    }
    encoder.reset(out, 0, out.length);
    walk(encoder);
    int length = encoder.finish();
    if (encoder.overflow()) {
      throw new IllegalArgumentException(
          "out.length=" + out.length + " is too short; " + maxBytes() + " bytes are enough");
    }
    count++;
    return length;
  }

  /** Returns the number of bytes that any snapshot fits in. */
  public int maxBytes() {
    // No bit costs more than 16 of them, no number has more than 56 in its tree.
    return 16 + 2 * bodies * (1 + 56 * fields);
  }

  /**
   * Decodes the next snapshot.
   *
   * @param bytes any
   * @param length of the snapshot in them, from 0 on
   * @param state receives what {@link #encode} was given
   * @return false if no encoder wrote these bytes as its next snapshot; then nothing can be decoded
   *     any more
   */
  public boolean decode(byte[] bytes, int length, int[][] state) {
    if (decoder.failed()) {
      return false;
    }
    learnAcknowledged();
    decoder.reset(bytes, 0, length);
    walk(decoder);
    if (!decoder.finished()) {
      decoder.fail();
      return false;
    }
    int[][] snapshot = at(count);
    for (int f = 0; f < fields; f++) {
      System.arraycopy(snapshot[f], 0, state[f], 0, bodies);
    }
    for (int i = 0; i < bodies; i++) {
      state[ANGLE][i] &= Quantizer.ANGLE_STEPS - 1;
    }
    count++;
    return true;
  }

  private static boolean inRange(int field, int value) {
    return switch (field) {
      case 0, 1 -> Math.abs(value) <= Quantizer.MAX_POSITION;
      case ANGLE -> value >= 0 && value < Quantizer.ANGLE_STEPS;
      case 3, 4 -> Math.abs(value) <= Trace.MAX_VELOCITY;
      default -> Math.abs(value) <= Trace.MAX_OMEGA;
    };
  }

  /** Returns a snapshot of the ring. Angles are unwrapped there: they go on past a turn. */
  private int[][] at(int snapshot) {
    return ring[Math.max(snapshot, 0) % ring.length];
  }

  private void walk(BitCoder with) {
    coder = with;
    learning = false;
    if (count < lag) {
      walkAlone();
    } else {
      walk(count - lag, count);
    }
  }

  // ---------------------------------------------------------------- without a baseline

  /**
   * Codes a snapshot without a baseline: each body against the body before, in contexts of the
   * steps before. The codec forgets what it learnt at the end of the snapshot.
   */
  private void walkAlone() {
    alone.reset();
    int[][] now = at(count);
    int[] lastField = null;
    for (int f : order) {
      int before = 0;
      int step1 = 0;
      int step2 = 0;
      for (int i = 0; i < bodies; i++) {
        int lastStep = lastField != null && i > 0 ? lastField[i] - lastField[i - 1] : 0;
        alone.context(0, hash(f, 0, 0));
        alone.context(1, hash(f, step1, 1));
        alone.context(2, hash(f, step1 * 31 + step2, 2));
        alone.context(3, hash(f, level(Math.abs(step1)) * 8_191 + lastStep, 3));
        int step = alone.code(coder, now[f][i] - before, true);
        int value = before + step;
        if (!inRange(f, value)) {
          decoder.fail();
          return;
        }
        now[f][i] = value;
        before = value;
        step2 = step1;
        step1 = step;
      }
      lastField = now[f];
    }
  }

  private static int hash(int a, int b, int c) {
    int h = a * 0x9e3779b1 + b * 0x85ebca77 + c * 0xc2b2ae3d;
    h = (h ^ h >>> 15) * 0x2c1b3c6d;
    return h >>> 22;
  }

  // ---------------------------------------------------------------- learning

  /** Takes in the snapshot that has just become acknowledged. */
  private void learnAcknowledged() {
    int k = count - lag;
    if (k < 0) {
      return;
    }
    unwrap(at(k)[ANGLE], at(k - 1)[ANGLE]);
    if (k >= lag) {
      coder = BitCoder.known();
      learning = true;
      walk(k - lag, k);
      for (int f = 0; f < fields; f++) {
        for (int c = k % SOLVE_EVERY; c < CLASSES; c += SOLVE_EVERY) {
          regressions[f][c].solve();
        }
      }
    }
    if (k > 0) {
      observe(at(k), at(k - 1), at(k - 2));
    }
    records[k % records.length].set(latest);
    if (k % REFIT == 0) {
      grid.fit(at(k)[0], at(k)[1]);
      if (k == 0) {
        Arrays.fill(reach, 400);
      }
    }
  }

  private void unwrap(int[] angle, int[] before) {
    for (int i = 0; i < bodies; i++) {
      angle[i] = before[i] + Quantizer.wrapAngle(angle[i] - before[i]);
    }
  }

  /** Updates the features of each body that need no prediction. */
  private void observe(int[][] now, int[][] before, int[][] older) {
    moving = 0;
    for (int i = 0; i < bodies; i++) {
      if (isSame(now, before, i)) {
        latest.still[i] = Math.min(255, latest.still[i] + 1);
        if (latest.still[i] >= HISTORY) {
          continue;
        }
      } else {
        latest.still[i] = 0;
        moving++;
      }
      boolean jolt = false;
      for (int f = 0; f < fields; f++) {
        int bend = 16 * (now[f][i] - 2 * before[f][i] + older[f][i]) - latest.trend[f][i];
        jolt |= Math.abs(bend) > JOLT;
        latest.trend[f][i] += bend / 4;
      }
      latest.sinceJolt[i] = jolt ? 0 : Math.min(255, latest.sinceJolt[i] + 1);
    }
  }

  private boolean isSame(int[][] a, int[][] b, int i) {
    for (int f = 0; f < fields; f++) {
      if (a[f][i] != b[f][i]) {
        return false;
      }
    }
    return true;
  }

  // ---------------------------------------------------------------- with a baseline

  private void walk(int baseline, int snapshot) {
    target = at(snapshot);
    base = at(baseline);
    record = records[baseline % records.length];
    for (int s = 0; s < SPANS.length; s++) {
      past[s] = at(baseline - SPANS[s]);
    }
    grid.fill(base[0], base[1]);
    Arrays.fill(coded, false);
    Arrays.fill(alerted, false);
    Arrays.fill(pushX, 0);
    Arrays.fill(pushY, 0);
    Arrays.fill(neighbours, 0);
    Arrays.fill(movedNeighbours, 0);
    for (int f = 0; f < fields; f++) {
      Arrays.fill(surprises[f], 0);
    }
    queueMoving();
    // The queue grows by bodies at rest that a moving one may have touched.
    int done = 0;
    for (int i = 0; i < bodies; i++) {
      for (; done < queued; done++) {
        if (!coded[queue[done]]) {
          body(queue[done], true);
        }
      }
      if (!coded[i]) {
        body(i, false);
      }
    }
    for (; done < queued; done++) {
      if (!coded[queue[done]]) {
        body(queue[done], true);
      }
    }
  }

  /** Expects all bodies where their past leads them, and queues those that move, fastest first. */
  private void queueMoving() {
    Arrays.fill(speedCount, 0);
    queued = 0;
    for (int i = 0; i < bodies; i++) {
      if (record.still[i] >= HISTORY) {
        for (int f = 0; f < fields; f++) {
          expected[f][i] = base[f][i];
        }
        continue;
      }
      double way = 0;
      for (int f : order) {
        past(f, i);
        double step = regressions[f][group(f, i)].predict(input);
        expected[f][i] = base[f][i] + step;
        way += Math.abs(step);
      }
      speed[i] = LEVELS - 1 - level(way);
      speedCount[speed[i] + 1]++;
      queued++;
    }
    for (int level = 0; level < LEVELS; level++) {
      speedCount[level + 1] += speedCount[level];
    }
    for (int i = 0; i < bodies; i++) {
      if (record.still[i] < HISTORY) {
        queue[speedCount[speed[i]]++] = i;
      }
    }
  }

  /** Sets the inputs of a prediction that depend on the past alone. */
  private void past(int f, int i) {
    int now = base[f][i];
    for (int s = 0; s < SPANS.length; s++) {
      input[s] = (now - past[s][f][i]) * ((double) lag / SPANS[s]);
    }
    input[CONSTANT] = 8;
    for (int n = AROUND; n < input.length; n++) {
      input[n] = 0;
    }
    if (fields == FULL) {
      if (f >= POSE) {
        input[OLD_VELOCITY] = now;
      } else {
        double way = base[f + POSE][i] * (f == ANGLE ? omegaWay : velocityWay);
        input[OLD_VELOCITY] = way;
        input[MEAN_VELOCITY] = way;
      }
    }
  }

  /** Sets the inputs of a prediction that depend on this snapshot. */
  private void present(int f, int i) {
    double share = 1.0 / Math.max(1, neighbours[i]);
    input[AROUND] = surprises[f][i] * share;
    int kind = f < POSE ? f : f - POSE;
    int x = f - kind;
    switch (kind) {
      case 0 -> input[PUSH] = pushX[i];
      case 1 -> {
        input[PUSH] = pushY[i];
        input[CROSS] = surprise[x];
      }
      default -> {
        input[PUSH] = surprise[x + 1];
        input[CROSS] = surprise[x];
        input[AROUND_X] = surprises[x][i] * share;
        input[AROUND_Y] = surprises[x + 1][i] * share;
      }
    }
    if (fields == FULL && f < POSE) {
      double mean = 0.5 * (base[f + POSE][i] + target[f + POSE][i]);
      input[MEAN_VELOCITY] = mean * (f == ANGLE ? omegaWay : velocityWay);
    }
  }

  /**
   * Returns which of the regressions serves a body: by what touches it and how long it flew freely.
   */
  private int group(int f, int i) {
    int touch = neighbours[i] == 0 ? 0 : pushX[i] == 0 && pushY[i] == 0 ? 1 : 2;
    return touch + TOUCHES * (record.still[i] >= HISTORY ? 0 : 1 + phase(f, i));
  }

  private int phase(int f, int i) {
    int since = record.sinceJolt[i];
    if (since < 4) {
      return since > 0 ? 1 + since : record.error[f][i] < 64 ? 0 : 1;
    }
    return since < 6 ? 5 : since < 9 ? 6 : since < 16 ? 7 : since < 32 ? 8 : 9;
  }

  private void body(int i, boolean near) {
    coded[i] = true;
    int bit = changed(i) ? 0 : 1;
    bit = near ? sameNear(i, bit) : sameFar(bit);
    if (learning) {
      latest.sameBefore[i] = latest.sameBefore[i] << 1 | bit;
    }
    if (bit == 0) {
      numbers(i);
      scatter(i, true);
      return;
    }
    for (int f = 0; f < fields; f++) {
      target[f][i] = base[f][i];
      surprise[f] = base[f][i] - expected[f][i];
      if (learning) {
        latest.error[f][i] -= latest.error[f][i] + 3 >> 2;
        latest.lastResidual[f][i] = 0;
      }
    }
    if (near) {
      scatter(i, false);
    }
  }

  private boolean changed(int i) {
    for (int f = 0; f < fields; f++) {
      int difference = target[f][i] - base[f][i];
      if (f == ANGLE ? Quantizer.wrapAngle(difference) != 0 : difference != 0) {
        return true;
      }
    }
    return false;
  }

  private int sameFar(int bit) {
    sameFar.select(0, level(moving));
    return sameFar.code(coder, bit, learning);
  }

  private int sameNear(int i, int bit) {
    int rest = Math.min(7, level(record.still[i]));
    int moved = Math.min(3, movedNeighbours[i]);
    int unmoved = Math.min(3, neighbours[i] - movedNeighbours[i]);
    int push = Math.min(11, level(2 * (Math.abs(pushX[i]) + Math.abs(pushY[i]))));
    double way = 0;
    double around = 0;
    int errors = 0;
    for (int f = 0; f < POSE; f++) {
      way += Math.abs(expected[f][i] - base[f][i]);
      around += f < ANGLE ? Math.abs(surprises[f][i]) : 0;
      errors += record.error[f][i];
    }
    int ways = Math.min(11, level(2 * way));
    int arounds = Math.min(11, level(2 * around / Math.max(1, neighbours[i])));
    select(0, (rest * 4 + moved) * 4 + unmoved);
    select(1, push * 12 + ways);
    select(2, arounds * 8 + rest);
    select(3, (record.sameBefore[i] & 63) * 4 + moved);
    select(4, Math.min(11, level(errors)) * 12 + ways);
    select(5, push * 32 + rest * 4 + moved);
    same.weights(rest * 4 + moved);
    return same.code(coder, bit, learning);
  }

  private void select(int context, int value) {
    same.select(context, context * SAME_VALUES + value);
  }

  private void numbers(int i) {
    double share = 1.0 / Math.max(1, neighbours[i]);
    int around = 0;
    if (neighbours[i] > 0) {
      around =
          1
              + Math.min(
                  11, level(2 * share * (Math.abs(surprises[0][i]) + Math.abs(surprises[1][i]))));
    }
    int push = Math.min(11, level(2 * (Math.abs(pushX[i]) + Math.abs(pushY[i]))));
    double before = 0;
    for (int f : order) {
      past(f, i);
      present(f, i);
      Regression regression = regressions[f][group(f, i)];
      double step = regression.predict(input);
      step = Math.max(-MAX_STEP, Math.min(MAX_STEP, step));
      int centre = base[f][i] + (int) Math.floor(step + 0.5);
      int residual = target[f][i] - centre;
      if (f == ANGLE) {
        residual = Quantizer.wrapAngle(residual);
      }
      NumberModel model = numbers[f];
      contexts(model, f, i, step, centre, around, push, Math.min(15, level(4 * before)));
      residual = model.code(coder, residual, learning);
      if (!learning) {
        int value = centre + residual;
        if (!inRange(f, f == ANGLE ? value & Quantizer.ANGLE_STEPS - 1 : value)) {
          decoder.fail();
          value = base[f][i];
        }
        target[f][i] = value;
      }
      surprise[f] = target[f][i] - expected[f][i];
      before += Math.abs(surprise[f]);
      if (learning) {
        double size = record.error[f][i] * (1 / 16.0);
        regression.learn(
            input,
            centre + residual - base[f][i],
            1 / (0.25 + size * size + (double) residual * residual));
        int magnitude = Math.min(1 << 12, Math.abs(residual));
        latest.error[f][i] += (16 * magnitude - latest.error[f][i]) / 3;
        latest.slowError[f][i] += (256 * magnitude - latest.slowError[f][i]) / 12;
        latest.lastResidual[f][i] = residual;
      }
    }
    if (!learning && !changed(i)) {
      decoder.fail();
    }
  }

  private void contexts(
      NumberModel model, int f, int i, double step, int centre, int around, int push, int before) {
    int size = Math.min(15, level(record.error[f][i]));
    int fraction = (int) ((step + 0.5 - Math.floor(step + 0.5)) * 4) & 3;
    int way = Math.min(13, level(2 * Math.abs(step)));
    int phase = record.still[i] >= HISTORY ? 0 : 1 + phase(f, i);
    int stay = Math.max(-15, Math.min(15, base[f][i] - centre)) + 15;
    model.context(0, around * 16 + size);
    model.context(1, way * 16 + size);
    model.context(2, push * 16 + before);
    model.context(3, stay * 8 + size / 2);
    model.context(4, signed(2 * record.lastResidual[f][i]) * 16 + around);
    model.context(
        5, phase * 32 + fraction * 8 + Math.min(7, level(record.slowError[f][i] >> 3) / 2));
    model.context(6, phase * 32 + before * 2 + Math.min(1, around));
    model.situation(Math.min(PHASES - 1, phase));
  }

  /** Tells the neighbours of a body that aren't coded yet how it moved. */
  private void scatter(int j, boolean moved) {
    int x = base[0][j];
    int y = base[1][j];
    int n = grid.query(x, y, reach[j], found);
    long nearest = Long.MAX_VALUE;
    for (int k = 0; k < n; k++) {
      int i = found[k];
      if (i == j) {
        continue;
      }
      long dx = (long) base[0][i] - x;
      long dy = (long) base[1][i] - y;
      long squared = dx * dx + dy * dy;
      nearest = Math.min(nearest, squared);
      if (coded[i] || squared > (long) reach[j] * reach[j]) {
        continue;
      }
      neighbours[i]++;
      for (int f = 0; f < fields; f++) {
        surprises[f][i] += surprise[f];
      }
      if (moved) {
        movedNeighbours[i]++;
        push(i, j, Math.sqrt(squared));
        if (record.still[i] >= HISTORY && !alerted[i]) {
          alerted[i] = true;
          queue[queued++] = i;
        }
      }
    }
    if (learning) {
      if (nearest == Long.MAX_VALUE) {
        reach[j] = Math.min(reach[j] + (reach[j] >> 1), 8 << grid.shift());
      } else {
        spacing[j] = Math.min(spacing[j], (int) Math.sqrt(nearest));
        reach[j] = Math.min(spacing[j] * 8 / 5 + 1, 8 << grid.shift());
      }
    }
  }

  /**
   * Adds how far a body must give way to a moved neighbour: to stay at the least distance ever seen
   * of either, or at the old one if that was hardly more, as between corners of boxes.
   */
  private void push(int i, int j, double before) {
    int least = 0;
    if (spacing[i] != FAR) {
      least = spacing[i];
    }
    if (spacing[j] != FAR) {
      least = Math.max(least, spacing[j]);
    }
    double contact = before < 1.45 * least ? Math.max(least, before) : least;
    double dx = expected[0][i] - target[0][j];
    double dy = expected[1][i] - target[1][j];
    double distance = Math.sqrt(dx * dx + dy * dy);
    if (distance < contact && distance > 1) {
      pushX[i] += dx * ((contact - distance) / distance);
      pushY[i] += dy * ((contact - distance) / distance);
    }
  }

  // ---------------------------------------------------------------- levels

  private static final int LEVELS = 32;

  /** Returns a logarithmic scale in half octaves: 0 below 1, then 1, 2, 3, ... */
  private static int level(double value) {
    return level((int) Math.min(32_767, value));
  }

  private static int level(int value) {
    if (value <= 1) {
      return Math.max(0, value);
    }
    int width = 32 - Integer.numberOfLeadingZeros(Math.min(value, 32_767));
    return 2 * width - 1 + (value >> width - 2 & 1);
  }

  /** Returns the scale of octaves with a sign: 0..14, 7 in the middle. */
  private static int signed(int value) {
    int size = Math.min(7, 32 - Integer.numberOfLeadingZeros(Math.abs(value)));
    return value < 0 ? 7 - size : 7 + size;
  }
}
