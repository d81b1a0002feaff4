package carom.lab.soak;

import carom.lab.fleet.FleetSoak;
import carom.testkit.Folders;
import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/**
 * Runs a soak. A seed reproduces it; of a soak that fails, the shortest script that still fails is
 * looked for and named.
 */
@Command(
    name = "soak",
    mixinStandardHelpOptions = true,
    subcommands = FleetSoak.class,
    description = "Lets a server and its clients live through whatever a seed does to them.")
public final class SoakMain implements Callable<Integer> {
  @Option(
      names = "--minutes",
      paramLabel = "N",
      description = "length in minutes of virtual time, default ${DEFAULT-VALUE}")
  private double minutes = 5;

  @Option(
      names = "--clients",
      paramLabel = "N",
      description = "most clients at a time, default ${DEFAULT-VALUE}")
  private int clients = 16;

  @Option(names = "--predict", description = "clients predict, instead of interpolating")
  private boolean predict;

  @Option(
      names = "--input-only",
      description = "clients send inputs and acknowledge snapshots, but don't decode them")
  private boolean inputOnly;

  @Option(names = "--no-recordings", description = "records nothing, and replays nothing")
  private boolean noRecordings;

  @Option(names = "--seed", paramLabel = "N", description = "seed; default: another every time")
  private long seed = System.nanoTime();

  @Option(
      names = "--incidents",
      paramLabel = "N",
      description = "only the first N incidents of the seed")
  private int incidents = Integer.MAX_VALUE;

  private SoakMain() {}

  /** Runs the command. */
  public static void main(String[] args) {
    System.exit(new CommandLine(new SoakMain()).execute(args));
  }

  @Override
  public Integer call() throws Exception {
    List<Incident> script = Incident.script(seed, minutes * 60, clients);
    script = script.subList(0, Math.min(incidents, script.size()));
    System.out.printf(
        "soak: seed=%d minutes=%.1f clients=%d play=%s incidents=%d%n",
        seed, minutes, clients, play(), script.size());
    long start = System.nanoTime();
    double startCpuS = cpuS();
    Outcome outcome = attempt(script, minutes * 60);
    System.out.println(outcome.soak.summary());
    double took = (System.nanoTime() - start) * 1e-9;
    String speed =
        String.format(
            Locale.ROOT,
            "seed=%d play=%s, %.0f s of virtual time in %.0f s, %.0f s of processors: %.1f times"
                + " real time, %.1f times processor time",
            seed,
            play(),
            outcome.seconds(),
            took,
            cpuS() - startCpuS,
            outcome.seconds() / took,
            outcome.seconds() / (cpuS() - startCpuS));
    if (outcome.failure == null) {
      List<String> unseen = outcome.soak.unseenQueues();
      System.out.printf(
          "soak %s: %s, %s%n",
          unseen.isEmpty() ? "passed" : "FAILED, no queue of these bounds was seen: " + unseen,
          outcome.soak.counts(),
          speed);
      return unseen.isEmpty() ? 0 : 1;
    }
    outcome.failure.printStackTrace(System.out);
    int fewest = shortest(script, outcome.seconds());
    System.out.printf(
        "the shortest script that fails: --seed %d --minutes %.3f --clients %d%s --incidents %d%n",
        seed, outcome.seconds() / 60 + 0.01, clients, flag(), fewest);
    script.subList(Math.max(0, fewest - 10), fewest).forEach(System.out::println);
    System.out.printf(
        "soak FAILED after %.2f s: %s; %s%n",
        outcome.seconds(), outcome.failure.getMessage(), speed);
    return 1;
  }

  private Soak.Play play() {
    return predict
        ? Soak.Play.PREDICTING
        : inputOnly ? Soak.Play.INPUT_ONLY : Soak.Play.INTERPOLATING;
  }

  private String flag() {
    return predict ? " --predict" : inputOnly ? " --input-only" : "";
  }

  /**
   * Returns what this process has used of processors so far, s; all threads, the compiler's too.
   */
  private static double cpuS() {
    return ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class).getProcessCpuTime()
        * 1e-9;
  }

  /** The result of a soak. */
  private record Outcome(Soak soak, Throwable failure) {
    double seconds() {
      return soak.elapsedS();
    }
  }

  private Outcome attempt(List<Incident> script, double seconds) throws IOException {
    Path folder = Files.createTempDirectory("carom-soak");
    Soak soak = new Soak(new Soak.Settings(seed, seconds, clients, play(), folder, !noRecordings));
    Throwable failure = null;
    try {
      soak.run(script);
    } catch (AssertionError | RuntimeException | IOException e) {
      failure = e;
    } finally {
      Folders.delete(folder);
    }
    return new Outcome(soak, failure);
  }

  /** Returns the smallest number of incidents with which the soak fails up to the same moment. */
  private int shortest(List<Incident> script, double seconds) throws IOException {
    int passes = -1;
    int fails = script.size();
    for (int i = 0; i < script.size(); i++) {
      if (script.get(i).atS() > seconds) {
        fails = i;
        break;
      }
    }
    while (fails - passes > 1) {
      int middle = (passes + fails) / 2;
      if (attempt(script.subList(0, middle), seconds + 1).failure == null) {
        passes = middle;
      } else {
        fails = middle;
      }
    }
    return fails;
  }
}
