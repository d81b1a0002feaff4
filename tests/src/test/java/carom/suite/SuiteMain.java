package carom.suite;

import carom.suite.TestClass.Part;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import picocli.CommandLine;
import picocli.CommandLine.Option;

/**
 * Runs the tests. As many processes as there are cores run what computes, and leave the processor
 * to as many others for what {@link Needs} more than that; each takes the longest class of its kind
 * that is left, first of those that are {@link Optimized}. When all that is done, those that are
 * {@link Alone} run one after another. A class that ends its process or hangs is a failure with its
 * name, and costs no other class its results.
 *
 * <p>Prints each failure as it happens; lines that begin with {@code |} tell how far it is. Exits
 * with 0 if all passed, 1 if tests failed.
 */
@CommandLine.Command(name = "suite", mixinStandardHelpOptions = true)
final class SuiteMain implements Runnable {
  private static final int TRACE_LINES = 30;
  private static final int PROGRESS_SECONDS = 30;

  @Option(names = "--classes", required = true, description = "folder of the compiled tests")
  private Path classes;

  @Option(names = "--results", required = true, description = "folder for JUnit's XML files")
  private Path results;

  @Option(names = "--slow", required = true, description = "seconds of the slowest classes")
  private Path slow;

  @Option(names = "--seconds", required = true, description = "file for the seconds of this run")
  private Path secondsFile;

  @Option(names = "--only", description = "a class or method to run; * stands for anything")
  private List<String> only = new ArrayList<>();

  @Option(names = "--quick", description = "only what computes and isn't in the table")
  private boolean quick;

  @Option(names = "--processes", description = "processes of each kind; 0: one for each core")
  private int processes;

  @Option(
      names = "--limit",
      defaultValue = "600",
      description = "seconds after which a class has hung")
  private int limitSeconds;

  private final List<ClassReport> reports = new ArrayList<>();

  /** Flags of the JVM by which processes start faster. */
  private List<String> faster = List.of();

  private int total;
  private long lastProgress = System.nanoTime();

  /** Runs the tests. */
  public static void main(String[] args) {
    SuiteMain suite = new SuiteMain();
    int status = new CommandLine(suite).execute(args);
    System.exit(status == 0 && suite.failed() > 0 ? 1 : status);
  }

  @Override
  public void run() {
    try {
      Map<String, Double> known = read(slow);
      List<TestClass> all = new ArrayList<>(TestClass.find(classes, only));
      if (quick) {
        all.removeIf(test -> test.part() != Part.COMPUTING || known.containsKey(test.name()));
      }
      all.sort(
          Comparator.comparing(TestClass::optimized)
              .reversed()
              .thenComparingDouble(test -> -known.getOrDefault(test.name(), 0.)));
      total = all.size();
      Files.createDirectories(results);
      if (only.isEmpty() && !quick) { // a few classes start fewer programs than it costs
        faster = ClassArchive.make(Files.createDirectories(results.resolve("classes")));
      }
      int cores = processes > 0 ? processes : Runtime.getRuntime().availableProcessors();
      List<Thread> beside = new ArrayList<>(begin(all, Part.NEEDING, cores));
      beside.addAll(begin(all, Part.COMPUTING, cores));
      for (Thread thread : beside) {
        thread.join();
      }
      for (Thread thread : begin(all, Part.ALONE, 1)) {
        thread.join();
      }
      writeSeconds();
      if (reports.size() < total) {
        throw new IllegalStateException((total - reports.size()) + " classes weren't run");
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Starts the threads that run all classes of a kind, in a process each. */
  private List<Thread> begin(List<TestClass> all, Part part, int count) {
    Deque<TestClass> left =
        new ArrayDeque<>(all.stream().filter(test -> test.part() == part).toList());
    String name = part.name().toLowerCase(Locale.ROOT);
    List<Thread> threads = new ArrayList<>();
    for (int i = 1; i <= Math.min(count, left.size()); i++) {
      Path output = results.resolve(name + "-" + i + ".txt");
      Runnable work = () -> work(left, output, part == Part.COMPUTING);
      threads.add(new Thread(work, "suite-" + name + "-" + i));
    }
    threads.forEach(Thread::start);
    return threads;
  }

  private void work(Deque<TestClass> left, Path output, boolean yields) {
    WorkerProcess worker = null;
    boolean optimized = false;
    try {
      for (TestClass next = next(left); next != null; next = next(left)) {
        if (worker != null && next.optimized() != optimized) {
          worker.close();
          worker = null;
        }
        if (worker == null) {
          optimized = next.optimized();
          worker = new WorkerProcess(output, yields, optimized, faster);
        }
        ClassReport report = worker.run(next, limitSeconds, this::told);
        report.write(results);
        add(report);
        if (!worker.usable()) {
          worker.close();
          worker = null;
        }
      }
      if (worker != null) {
        worker.close();
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static TestClass next(Deque<TestClass> left) {
    synchronized (left) {
      return left.poll();
    }
  }

  private synchronized void told(ClassReport report, TestEvent event) {
    if (event.kind() == TestEvent.Kind.FAILED) {
      System.out.printf("FAILED %s, %s%n", report.name(), event.test());
      event.text().lines().limit(TRACE_LINES).forEach(line -> System.out.println("    " + line));
    }
  }

  private synchronized void add(ClassReport report) {
    reports.add(report);
    long now = System.nanoTime();
    if (now - lastProgress > PROGRESS_SECONDS * 1_000_000_000L) {
      lastProgress = now;
      int tests = reports.stream().mapToInt(ClassReport::tests).sum();
      System.out.printf(
          Locale.ROOT,
          "| %d of %d classes, %,d tests, %d failed%n",
          reports.size(),
          total,
          tests,
          failed());
    }
  }

  private synchronized int failed() {
    return reports.stream().mapToInt(report -> report.count(TestEvent.Kind.FAILED)).sum();
  }

  /** Reads a table of seconds and classes. */
  private static Map<String, Double> read(Path table) throws IOException {
    Map<String, Double> seconds = new HashMap<>();
    for (String line : Files.readAllLines(table)) {
      if (!line.isBlank() && !line.startsWith("#")) {
        String[] words = line.strip().split("\\s+", 2);
        seconds.put(words[1], Double.parseDouble(words[0]));
      }
    }
    return seconds;
  }

  /** Writes what each class took, the slowest first. */
  private synchronized void writeSeconds() throws IOException {
    StringBuilder text = new StringBuilder("# seconds, of them computed, tests, class\n");
    reports.sort(Comparator.comparingDouble(ClassReport::seconds).reversed());
    for (ClassReport report : reports) {
      text.append(
          String.format(
              Locale.ROOT,
              "%7.1f %7.1f %5d  %s%n",
              report.seconds(),
              report.cpuSeconds(),
              report.tests(),
              report.name()));
    }
    Files.writeString(secondsFile, text);
  }
}
