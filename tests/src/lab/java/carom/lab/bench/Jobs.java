package carom.lab.bench;

import carom.lab.broadphase.BroadphaseJob;
import carom.lab.broadphase.PairSearchJob;
import carom.lab.broadphase.RebuildJob;
import carom.lab.measure.BenchJob;
import carom.sim.scene.Scenes;
import carom.text.Suggestion;
import java.util.ArrayList;
import java.util.List;

/** Finds the jobs of the benchmark by name. */
final class Jobs {
  private Jobs() {}

  /** Returns the jobs that run by default, in the order of the table. */
  static List<BenchJob> all() {
    List<BenchJob> jobs = new ArrayList<>();
    BenchScene.ALL.forEach(scene -> jobs.add(new SceneJob(scene)));
    jobs.addAll(StateJob.all());
    jobs.add(new StartupJob());
    jobs.addAll(PairSearchJob.all());
    jobs.addAll(BroadphaseJob.all());
    jobs.addAll(RebuildJob.all());
    return jobs;
  }

  /** Groups of jobs by name, for {@code --scenes}. */
  static List<BenchJob> group(String name) {
    return switch (name) {
      case "scenes" -> BenchScene.ALL.stream().<BenchJob>map(SceneJob::new).toList();
      case "state" -> StateJob.all();
      case "pairs" -> PairSearchJob.all();
      case "bp" -> BroadphaseJob.all();
      case "rebuild" -> RebuildJob.all();
      default -> List.of();
    };
  }

  /**
   * Returns the jobs of the names.
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
   * Returns the job of a name.
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
