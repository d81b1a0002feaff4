package carom.lab.broadphase;

import carom.lab.measure.BenchJob;
import carom.lab.measure.BenchRow;
import carom.lab.measure.Entrant;
import carom.lab.measure.Measurement;
import carom.lab.measure.Stopwatch;
import carom.physics.broadphase.KdTree;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * The job that compares ways to rebuild a KD-tree: with a sort of all boxes per level, with two
 * sorts in all, or with none. Only the building is timed; the boxes move in between.
 *
 * @param name like {@code rebuild_10k}
 * @param boxes how many, in uniform distribution
 */
public record RebuildJob(String name, int boxes) implements BenchJob {
  private static final int TIMED = 100;

  /** The ways to build the tree. */
  enum Way {
    /** The engine's way: medians by selection, without sorting. */
    KD_NO_SORT,
    /** The way of two sorts, by x and by y, and a division in linear time on each level. */
    KD_TWO_SORTS,
    /** The textbook way: each level sorts its parts again. */
    KD_SORT_PER_LEVEL;

    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /** Returns all jobs of this kind in the order of the table. */
  public static List<BenchJob> all() {
    return List.of(new RebuildJob("rebuild_10k", 10_000), new RebuildJob("rebuild_100k", 100_000));
  }

  @Override
  public List<Entrant> entrants(Choice wanted) {
    List<Entrant> all = new ArrayList<>();
    for (Way way : Way.values()) {
      all.add(Entrant.of(way.toString()));
    }
    return all;
  }

  @Override
  public BenchRow run(Entrant entrant, Measurement measurement) {
    BroadphaseScene scene = new BroadphaseScene(boxes, false);
    KdTree tree = new KdTree(scene.boxes());
    SortedKd sorted = new SortedKd(scene.boxes());
    Runnable build = () -> tree.rebuild(scene.boxes(), scene.ids(), boxes);
    if (entrant.engine().equals(Way.KD_TWO_SORTS.toString())) {
      build = () -> sorted.buildWithTwoSorts(boxes);
    } else if (entrant.engine().equals(Way.KD_SORT_PER_LEVEL.toString())) {
      build = () -> sorted.buildWithSortPerLevel(boxes);
    }
    double begin = Stopwatch.cpuSeconds();
    while (Stopwatch.cpuSeconds() - begin < measurement.warmUpSeconds()) {
      scene.step();
      build.run();
    }
    Stopwatch watch = new Stopwatch(measurement.quick() ? TIMED / 4 : TIMED, false);
    measurement.time(watch, scene::step, build);
    return BenchRow.of(name, entrant, boxes, watch.times());
  }
}
