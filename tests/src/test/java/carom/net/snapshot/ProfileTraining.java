package carom.net.snapshot;

import carom.net.codec.BitCoder;
import carom.net.codec.Quantizer;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.frame.QuantizedPose;
import carom.physics.Body;
import carom.physics.BodyType;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneRun;
import carom.sim.scene.Scenes;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/**
 * Makes the files of {@link Profiles}: run its {@code main} with their folder. Runs scenes, takes
 * down the deltas that clients with older baselines would get, and sorts the ticks into as many
 * kinds as there are profiles, so that each kind's own shares and table say its deltas with least
 * surprise (k-means, with the surprise as distance). Shares are those with the least sum of
 * absolute errors, by least squares weighed anew in each round. Also tells what a delta takes in
 * each scene: with one profile for all, with the best of each tick; without slot.
 */
public final class ProfileTraining {

  private static final List<String> SCENES =
      List.of(
          "plough",
          "plough_above",
          "churn",
          "mixer",
          "bridge",
          "shapes",
          "wind",
          "orbits",
          "gas_1k",
          "pile_2k");
  private static final List<String> UNSEEN = List.of("wrecking_ball", "dominoes");

  /** Baselines: age, poses, stride. Those of fewer poses are taken of every eighth slot. */
  private static final int[][] BASELINES = {
    {2, 3, 3},
    {3, 3, 3},
    {5, 3, 3},
    {6, 3, 3},
    {7, 3, 3},
    {8, 3, 4},
    {8, 3, 2},
    {12, 3, 3},
    {20, 3, 4},
    {3, 2, 3},
    {7, 2, 3},
    {3, 1, 0},
    {8, 1, 0},
  };

  private static final int TICKS = 600;
  private static final int TICKS_APART = 8;
  private static final int OLDEST = 28;
  private static final int FEWER_POSES_APART = 8;
  private static final int ROUNDS = 8;

  /** Distance of the deltas by which a tick's best profile is found. */
  private static final int SAMPLED = 3;

  /** A profile begins as if it had seen the common table's bits so often. */
  private static final double STRENGTH = 20;

  /** The same for shares: as if a body had gone straight on so many steps. */
  private static final double STRAIGHT_STEPS = 50;

  /** Numbers of a delta: its baseline, three poses and the pose after it, with their stills. */
  private static final int NUMBERS = 17;

  private static final int BASELINE_BITS = 16;

  private final List<Group> groups = new ArrayList<>();
  private final Track track = new Track();
  private final QuantizedPose predicted = new QuantizedPose();
  private final QuantizedPose actual = new QuantizedPose();
  private final QuantizedPose residual = new QuantizedPose();

  private ProfileTraining() {}

  /** The deltas of one scene and tick. */
  private static final class Group {
    final String scene;
    final boolean unseen;
    final Predictor predictor;
    int[] numbers = new int[64 * NUMBERS];
    int records;
    int rested;

    Group(String scene, boolean unseen, Predictor predictor) {
      this.scene = scene;
      this.unseen = unseen;
      this.predictor = predictor;
    }

    void add(int baseline, int rested, Track t, QuantizedPose actual) {
      if ((records + 1) * NUMBERS > numbers.length) {
        numbers = Arrays.copyOf(numbers, 2 * numbers.length);
      }
      int at = records++ * NUMBERS;
      numbers[at] = baseline | rested << BASELINE_BITS;
      for (int i = 0; i < 4; i++) {
        QuantizedPose pose = i == 3 ? actual : t.pose(i);
        numbers[at + 1 + 4 * i] = pose.x;
        numbers[at + 2 + 4 * i] = pose.y;
        numbers[at + 3 + 4 * i] = pose.angle;
        numbers[at + 4 + 4 * i] = pose.still ? 1 : 0;
      }
    }

    void get(int record, Track t, QuantizedPose actual) {
      int at = record * NUMBERS;
      for (int i = 0; i < 4; i++) {
        QuantizedPose pose = i == 3 ? actual : t.pose(i);
        int from = at + 1 + 4 * i;
        pose.set(numbers[from], numbers[from + 1], numbers[from + 2], numbers[from + 3] != 0);
      }
      rested = numbers[at] >>> BASELINE_BITS;
      int baseline = numbers[at] & (1 << BASELINE_BITS) - 1;
      predictor.study(t, baseline);
    }
  }

  /** A candidate: its shares and the probabilities of its nodes, and what they are counted from. */
  private static final class Candidate {
    final short[] shares = new short[Predictor.SHARES];
    final double[][] sums = new double[Predictor.SHARES / 2][5];
    final double[] seen = new double[2 * DeltaCodec.NODES];
    double[] probability = new double[DeltaCodec.NODES];
    final double[] cost = new double[2 * DeltaCodec.NODES];

    Candidate() {
      straightOn();
    }

    void straightOn() {
      for (int i = 0; i < shares.length; i++) {
        shares[i] = (short) (i % 2 == 0 ? Predictor.WHOLE : 0);
      }
    }

    /** Takes an error of a prediction in: what the way and the bend predict, and the truth. */
    void learn(int shareClass, double way, double bend, double truth, double error) {
      double weight = 1 / (1 + Math.abs(error));
      double[] s = sums[shareClass];
      s[0] += weight * way * way;
      s[1] += weight * way * bend;
      s[2] += weight * bend * bend;
      s[3] += weight * way * truth;
      s[4] += weight * bend * truth;
    }

    void takeShares() {
      for (int i = 0; i < sums.length; i++) {
        double[] s = sums[i];
        double a = s[0] + STRAIGHT_STEPS;
        double d = s[2] + STRAIGHT_STEPS;
        double p = s[3] + STRAIGHT_STEPS;
        double determinant = a * d - s[1] * s[1];
        shares[2 * i] = share((p * d - s[4] * s[1]) / determinant);
        shares[2 * i + 1] = share((a * s[4] - s[1] * p) / determinant);
        Arrays.fill(s, 0);
      }
    }

    private static short share(double value) {
      return (short) Math.max(-512, Math.min(512, Math.round(value * Predictor.WHOLE)));
    }

    /** Turns counts into probabilities, those that the file can say. */
    void takeTable(double[] common) {
      double strength = common == null ? 0.8 : STRENGTH;
      for (int node = 0; node < probability.length; node++) {
        double before = strength * (common == null ? 0.5 : common[node]);
        double all = seen[2 * node] + seen[2 * node + 1] + strength;
        probability[node] = (seen[2 * node + 1] + before) / all;
        char letter = Profiles.letter(probability[node]);
        double p = Profiles.probability(letter) / (double) BitCoder.ONE;
        cost[2 * node] = -Math.log(1 - p) / Math.log(2);
        cost[2 * node + 1] = -Math.log(p) / Math.log(2);
      }
      Arrays.fill(seen, 0);
    }
  }

  /** Counts the nodes or sums up their costs instead of coding. */
  private static final class Counting extends DeltaCodec {
    Candidate candidate;
    boolean learns;
    double bits;

    @Override
    int head(BitCoder c, int head, int symbol) {
      headSteps(head, symbol, this::step);
      return symbol;
    }

    @Override
    int symbol(BitCoder c, int tree, int symbol) {
      numberSteps(tree, symbol, this::step);
      return symbol;
    }

    @Override
    int restSymbol(BitCoder c, int symbol, int most) {
      restSteps(symbol, this::step);
      return symbol;
    }

    private void step(int node, int bit) {
      bits += candidate.cost[2 * node + bit];
      if (learns) {
        candidate.seen[2 * node + bit]++;
      }
    }

    @Override
    int plain(BitCoder c, int value, int count) {
      bits += count;
      return value & (1 << count) - 1;
    }
  }

  private final Counting counting = new Counting();

  /** Writes the files. */
  public static void main(String[] args) throws IOException {
    ProfileTraining training = new ProfileTraining();
    for (String name : SCENES) {
      training.run(name, false);
    }
    for (String name : UNSEEN) {
      training.run(name, true);
    }
    training.train(Path.of(args[0]));
  }

  private void train(Path folder) throws IOException {
    Candidate common = new Candidate();
    Candidate[] one = {common};
    for (int round = 0; round < 3; round++) {
      for (Group group : groups) {
        learn(group, common);
      }
      common.takeShares();
    }
    for (Group group : groups) {
      count(group, common);
    }
    common.takeTable(null);
    print("one profile", one);
    Candidate[] all = new Candidate[Profiles.COUNT];
    Arrays.setAll(all, i -> new Candidate());
    Integer[] order = new Integer[groups.size()];
    Arrays.setAll(order, i -> i);
    Arrays.sort(
        order,
        Comparator.comparingDouble(i -> bits(groups.get(i), common) / groups.get(i).records));
    int[] kind = new int[groups.size()];
    for (int rank = 0; rank < order.length; rank++) {
      kind[order[rank]] = rank * Profiles.COUNT / order.length;
    }
    for (int round = 0; round < ROUNDS; round++) {
      for (int g = 0; g < kind.length; g++) {
        learn(groups.get(g), all[kind[g]]);
      }
      for (Candidate candidate : all) {
        candidate.takeShares();
      }
      for (int g = 0; g < kind.length; g++) {
        count(groups.get(g), all[kind[g]]);
      }
      for (Candidate candidate : all) {
        candidate.takeTable(common.probability);
      }
      for (int g = 0; g < kind.length && round < ROUNDS - 1; g++) {
        kind[g] = best(groups.get(g), all);
      }
    }
    print("profiles", all);
    StringBuilder text = new StringBuilder();
    StringBuilder shares = new StringBuilder();
    for (Candidate candidate : all) {
      for (double p : candidate.probability) {
        text.append(Profiles.letter(p));
      }
      text.append('\n');
      for (int i = 0; i < Predictor.SHARES; i++) {
        shares.append(i == 0 ? "" : " ").append(candidate.shares[i]);
      }
      shares.append('\n');
    }
    Files.writeString(folder.resolve("profiles.txt"), text);
    Files.writeString(folder.resolve("shares.txt"), shares);
  }

  private int best(Group group, Candidate[] candidates) {
    int best = 0;
    double least = Double.MAX_VALUE;
    for (int k = 0; k < candidates.length; k++) {
      double bits = bits(group, candidates[k]);
      best = bits < least ? k : best;
      least = Math.min(bits, least);
    }
    return best;
  }

  /** Learns the shares that would have predicted a group's poses. */
  private void learn(Group group, Candidate candidate) {
    for (int i = 0; i < group.records && !group.unseen; i++) {
      group.get(i, track, actual);
      int baseline = track.baseline;
      if (Baseline.poses(baseline) < Baseline.MOST_POSES) {
        continue;
      }
      double stride = Baseline.stride(baseline);
      double straight = Baseline.age(baseline) / stride;
      double bent = straight * (Baseline.age(baseline) + stride) / (2 * stride);
      Predictor.predict(track, candidate.shares, 0, predicted);
      residual.setResidual(predicted, actual);
      QuantizedPose from = track.newest;
      if (!track.falls) {
        long bend = Math.abs((long) track.bendX) + Math.abs((long) track.bendY);
        int place = Predictor.level(bend, Predictor.BEND_SHARES - 1);
        candidate.learn(
            place, track.dx * straight, track.bendX * bent, actual.x - from.x, residual.x);
        candidate.learn(
            place, track.dy * straight, track.bendY * bent, actual.y - from.y, residual.y);
      }
      int spin = Predictor.level(Math.abs(track.bendTurn), Predictor.BEND_SHARES - 1);
      double turned = residual.angle + Quantizer.wrapAngle(predicted.angle - from.angle);
      candidate.learn(
          Predictor.BEND_SHARES + spin,
          track.turn * straight,
          track.bendTurn * bent,
          turned,
          residual.angle);
    }
  }

  private void count(Group group, Candidate candidate) {
    counting.candidate = candidate;
    counting.learns = true;
    for (int i = 0; i < group.records && !group.unseen; i++) {
      code(group, i, candidate);
    }
  }

  private double bits(Group group, Candidate candidate) {
    counting.candidate = candidate;
    counting.learns = false;
    counting.bits = 0;
    for (int i = 0; i < group.records; i += SAMPLED) {
      code(group, i, candidate);
    }
    return counting.bits;
  }

  private void code(Group group, int record, Candidate candidate) {
    group.get(record, track, actual);
    Predictor.predict(track, candidate.shares, 0, predicted);
    residual.setResidual(predicted, actual);
    counting.code(BitCoder.known(), track, residual, group.rested);
  }

  private void print(String what, Candidate[] candidates) {
    System.out.println(what);
    List<String> all = new ArrayList<>(SCENES);
    all.addAll(UNSEEN);
    for (String scene : all) {
      double bits = 0;
      long records = 0;
      for (Group group : groups) {
        if (group.scene.equals(scene)) {
          bits += bits(group, candidates[best(group, candidates)]);
          records += (group.records + SAMPLED - 1) / SAMPLED;
        }
      }
      System.out.printf(
          Locale.ROOT, "  %-14s deltas=%d bits/delta=%.2f%n", scene, records, bits / records);
    }
  }

  private void run(String name, boolean unseen) {
    Scene scene = Scenes.get(name);
    SceneRun run = scene.start();
    List<Body<String>> bodies = new ArrayList<>();
    run.world()
        .forEachBody(
            body -> {
              if (body.type() != BodyType.STATIC) {
                bodies.add(body);
              }
            });
    FrameRing ring = new FrameRing(bodies.size());
    Predictor predictor = new Predictor(scene.tickRate());
    predictor.gravity(run.world().gravityX(), run.world().gravityY());
    for (int tick = 1; tick <= TICKS; tick++) {
      run.step();
      FrameState frame = ring.begin(tick);
      for (int i = 0; i < bodies.size(); i++) {
        Body<String> b = bodies.get(i);
        frame.put(
            i,
            1,
            1,
            -1,
            b.x(),
            b.y(),
            b.angle(),
            b.velocityX(),
            b.velocityY(),
            b.angularVelocity());
      }
      ring.end();
      if (tick > OLDEST && tick % TICKS_APART == 0) {
        Group group = new Group(name, unseen, predictor);
        for (int[] baseline : BASELINES) {
          take(ring, group, baseline[0], baseline[1], baseline[2]);
        }
        if (group.records > 0) {
          groups.add(group);
        }
      }
    }
  }

  private void take(FrameRing ring, Group group, int age, int poses, int stride) {
    FrameState now = ring.newest();
    int apart = poses == Baseline.MOST_POSES ? 1 : FEWER_POSES_APART;
    for (int slot = 0; slot < now.slotLimit(); slot += apart) {
      if (ring.changedTick(slot) > now.tick() - age) {
        int held = now.tick() - age;
        for (int i = 0; i < poses; i++) {
          ring.at(held - i * stride).pose(slot, track.pose(i));
        }
        int rested = track.newest.still ? ring.lastLike(slot, held).tick() - held : 0;
        now.pose(slot, actual);
        group.add(Baseline.of(age, poses, stride), rested, track, actual);
      }
    }
  }
}
