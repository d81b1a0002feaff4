package carom.net.snapshot.record;

import carom.net.codec.BitCoder;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.frame.Motion;
import carom.net.snapshot.frame.Predictor;
import carom.physics.Body;
import carom.physics.BodyType;
import carom.sim.scene.Scene;
import carom.sim.scene.SceneRun;
import carom.sim.scene.catalog.Scenes;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/**
 * Makes the file of {@link Profiles}: run its {@code main} with the file's name. Runs scenes, takes
 * down the deltas that clients with older baselines would get, and sorts the ticks into as many
 * kinds as there are profiles, so that each kind's own table says its bits with least surprise
 * (k-means, with the surprise as distance). Also tells what a delta takes in each scene: with one
 * table for all, with the best profile of each tick; without slot and kind.
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
          "gas_1k");
  private static final List<String> UNSEEN = List.of("wrecking_ball", "dominoes");
  private static final int[] AGES = {2, 3, 4, 6, 8, 12};
  private static final int TICKS = 600;
  private static final int TICKS_APART = 4;
  private static final int ROUNDS = 12;

  /** A profile begins as if it had seen the common table's bits so often. */
  private static final double STRENGTH = 20;

  private final List<Group> groups = new ArrayList<>();

  private ProfileTraining() {}

  /** The deltas of one scene and tick: how often each node had which bit. */
  private static final class Group {
    final String scene;
    final boolean unseen;
    long records;
    long plain;
    int[] steps = new int[2 * DeltaCodec.NODES];
    int[] counts;

    Group(String scene, boolean unseen) {
      this.scene = scene;
      this.unseen = unseen;
    }

    /** Keeps only what occurred. */
    void pack() {
      int[] all = steps;
      steps = IntStream.range(0, all.length).filter(i -> all[i] > 0).toArray();
      counts = Arrays.stream(steps).map(i -> all[i]).toArray();
    }

    double bits(double[] cost) {
      double sum = plain;
      for (int i = 0; i < steps.length; i++) {
        sum += cost[steps[i]] * counts[i];
      }
      return sum;
    }
  }

  /** Counts instead of coding. */
  private static final class Counting extends DeltaCodec {
    Group group;

    Counting(int tickRate) {
      super(tickRate);
    }

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

    private void step(int node, int bit) {
      group.steps[2 * node + bit]++;
    }

    @Override
    int plain(BitCoder c, int value, int count) {
      group.plain += count;
      return value;
    }
  }

  /** Writes the file. */
  public static void main(String[] args) throws IOException {
    ProfileTraining training = new ProfileTraining();
    for (String name : SCENES) {
      training.run(name, false);
    }
    for (String name : UNSEEN) {
      training.run(name, true);
    }
    Files.writeString(Path.of(args[0]), training.train());
  }

  private String train() {
    double[] common = probabilities(null, null, -1);
    print("one table", new double[][] {cost(common)});
    int[] kind = new int[groups.size()];
    double[] commonCost = cost(common);
    Integer[] order = new Integer[groups.size()];
    Arrays.setAll(order, i -> i);
    Arrays.sort(
        order,
        Comparator.comparingDouble(i -> groups.get(i).bits(commonCost) / groups.get(i).records));
    for (int rank = 0; rank < order.length; rank++) {
      kind[order[rank]] = rank * Profiles.COUNT / order.length;
    }
    double[][] tables = new double[Profiles.COUNT][];
    double[][] costs = new double[Profiles.COUNT][];
    for (int round = 0; round < ROUNDS; round++) {
      for (int k = 0; k < Profiles.COUNT; k++) {
        tables[k] = probabilities(common, kind, k);
        costs[k] = cost(tables[k]);
      }
      for (int g = 0; g < kind.length; g++) {
        kind[g] = best(groups.get(g), costs);
      }
    }
    print("profiles", costs);
    StringBuilder text = new StringBuilder();
    for (double[] table : tables) {
      for (double p : table) {
        text.append(Profiles.letter(p));
      }
      text.append('\n');
    }
    return text.toString();
  }

  private static int best(Group group, double[][] costs) {
    int best = 0;
    for (int k = 1; k < costs.length; k++) {
      best = group.bits(costs[k]) < group.bits(costs[best]) ? k : best;
    }
    return best;
  }

  /** Of all groups, or those of a kind. */
  private double[] probabilities(double[] common, int[] kind, int wanted) {
    double[] seen = new double[2 * DeltaCodec.NODES];
    for (int g = 0; g < groups.size(); g++) {
      Group group = groups.get(g);
      if (!group.unseen && (kind == null || kind[g] == wanted)) {
        for (int i = 0; i < group.steps.length; i++) {
          seen[group.steps[i]] += group.counts[i];
        }
      }
    }
    double[] p = new double[DeltaCodec.NODES];
    double strength = common == null ? 0.8 : STRENGTH;
    for (int node = 0; node < p.length; node++) {
      double before = strength * (common == null ? 0.5 : common[node]);
      p[node] = (seen[2 * node + 1] + before) / (seen[2 * node] + seen[2 * node + 1] + strength);
    }
    return p;
  }

  /** Bits by node and bit, with the probabilities that the file can say. */
  private static double[] cost(double[] probabilities) {
    double[] cost = new double[2 * probabilities.length];
    for (int node = 0; node < probabilities.length; node++) {
      double p = Profiles.probability(Profiles.letter(probabilities[node])) / (double) BitCoder.ONE;
      cost[2 * node] = -Math.log(1 - p) / Math.log(2);
      cost[2 * node + 1] = -Math.log(p) / Math.log(2);
    }
    return cost;
  }

  private void print(String what, double[][] costs) {
    System.out.println(what);
    List<String> all = new ArrayList<>(SCENES);
    all.addAll(UNSEEN);
    for (String scene : all) {
      double bits = 0;
      long records = 0;
      for (Group group : groups) {
        if (group.scene.equals(scene)) {
          bits += group.bits(costs[best(group, costs)]);
          records += group.records;
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
    Counting counting = new Counting(scene.tickRate());
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
      if (tick > AGES[AGES.length - 1] && tick % TICKS_APART == 0) {
        counting.group = new Group(name, unseen);
        for (int age : AGES) {
          count(ring, predictor, counting, age);
        }
        if (counting.group.records > 0) {
          counting.group.pack();
          groups.add(counting.group);
        }
      }
    }
  }

  private static void count(FrameRing ring, Predictor predictor, Counting counting, int age) {
    FrameState frame = ring.newest();
    FrameState baseline = ring.at(frame.tick() - age);
    Motion old = new Motion();
    Motion actual = new Motion();
    Motion residual = new Motion();
    for (int slot = 0; slot < frame.slotLimit(); slot++) {
      if (ring.changedTick(slot) > baseline.tick()) {
        baseline.motion(slot, old);
        frame.motion(slot, actual);
        int way = predictor.way(old, actual, age);
        residual.setResidual(predictor, old, actual, way, age);
        counting.code(BitCoder.known(), age, old, way, residual);
        counting.group.records++;
      }
    }
  }
}
