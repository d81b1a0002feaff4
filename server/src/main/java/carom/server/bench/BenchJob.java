package carom.server.bench;

import carom.sim.level.Suggestion;
import carom.sim.scene.Scenes;
import java.util.ArrayList;
import java.util.List;

/** Something to measure: one {@code scene} of the table, done by several entrants. */
interface BenchJob {
  /** The name in flags and tables, small letters, digits and underscores. */
  String name();

  /**
   * Who can do it; the first one's time is what the others' are compared with.
   *
   * @param wanted what the flags ask for
   */
  List<Entrant> entrants(Choice wanted);

  /** Whether an entrant must end with the very hash of the first one. */
  default boolean mustAgree(Entrant entrant) {
    return entrant.isCarom();
  }

  /**
   * Measures it in this process.
   *
   * @param entrant one of {@link #entrants}
   * @param measurement how long
   * @throws UnsupportedOperationException if the engine lacks something
   */
  BenchRow run(Entrant entrant, Measurement measurement);

  /**
   * What the flags ask for.
   *
   * @param kernels of the solver: {@code vector}, {@code scalar}
   * @param threads numbers of threads, ascending
   * @param peers other engines by name
   */
  record Choice(List<String> kernels, List<Integer> threads, List<String> peers) {
    /** Carom with each kernel and number of threads, one thread first. */
    List<Entrant> carom() {
      List<Entrant> all = new ArrayList<>();
      for (String kernel : kernels) {
        for (int count : threads) {
          all.add(new Entrant(CaromEngine.NAME, kernel, count));
        }
      }
      return all;
    }
  }

  /** All jobs that run unless flags say otherwise, in the order of the table. */
  static List<BenchJob> all() {
    List<BenchJob> jobs = new ArrayList<>();
    BenchScene.ALL.forEach(scene -> jobs.add(new SceneJob(scene)));
    jobs.addAll(StateJob.all());
    jobs.add(new StartupJob());
    jobs.addAll(BroadphaseJob.all());
    jobs.addAll(RebuildJob.all());
    return jobs;
  }

  /** Groups of jobs by name, for {@code --scenes}. */
  static List<BenchJob> group(String name) {
    return switch (name) {
      case "scenes" -> BenchScene.ALL.stream().<BenchJob>map(SceneJob::new).toList();
      case "state" -> StateJob.all();
      case "bp" -> BroadphaseJob.all();
      case "rebuild" -> RebuildJob.all();
      default -> List.of();
    };
  }

  /**
   * The jobs of the names.
   *
   * @param names of jobs, groups, or any scene of the library
   * @throws IllegalArgumentException if there is none of a name, naming the nearest
   */
  static List<BenchJob> of(List<String> names) {
    List<BenchJob> jobs = new ArrayList<>();
    for (String name : names) {
      List<BenchJob> group = group(name);
      if (group.isEmpty()) {
        jobs.add(of(name));
      } else {
        jobs.addAll(group);
      }
    }
    return jobs;
  }

  /**
   * The job of a name.
   *
   * @throws IllegalArgumentException if there is none, naming the nearest
   */
  static BenchJob of(String name) {
    List<String> known = new ArrayList<>(Scenes.names());
    for (BenchJob job : all()) {
      if (job.name().equals(name)) {
        return job;
      }
      known.add(job.name());
    }
    if (!Scenes.names().contains(name)) {
      throw new IllegalArgumentException(
          "unknown scene=" + name + Suggestion.didYouMean(name, known));
    }
    return new SceneJob(BenchScene.of(name));
  }
}
