package carom.suite;

import static java.util.concurrent.TimeUnit.SECONDS;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;

import com.sun.management.OperatingSystemMXBean;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.ObjectOutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.regex.Pattern;
import org.junit.platform.engine.FilterResult;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.Launcher;
import org.junit.platform.launcher.PostDiscoveryFilter;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.TestPlan;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;

/**
 * Runs the test classes that {@link SuiteMain} names, one after another, and tells it about each
 * test as it happens. So what was found is known even if the process dies. Ends with the process
 * that started it.
 */
final class SuiteWorker {
  private static final int NO_PARENT = 3;
  private static final int ENDING_SECONDS = 5;

  /** Unit of the times in /proc, which is the same on every Linux that runs Java. */
  private static final double LINUX_CLOCK_HZ = 100;

  private final ObjectOutputStream out;

  private SuiteWorker(ObjectOutputStream out) {
    this.out = out;
  }

  /** Runs what comes over the loopback connection to the port {@code args[0]}. */
  public static void main(String[] args) throws IOException, InterruptedException {
    int port = Integer.parseInt(args[0]);
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), port)) {
      socket.setTcpNoDelay(true);
      ObjectOutputStream out = new ObjectOutputStream(socket.getOutputStream());
      out.flush();
      SuiteWorker worker = new SuiteWorker(out);
      BlockingQueue<TestClass> orders = new LinkedBlockingQueue<>();
      DataInputStream in = new DataInputStream(socket.getInputStream());
      Thread reader = new Thread(() -> read(in, orders), "suite-orders");
      reader.setDaemon(true);
      reader.start();
      Launcher launcher = LauncherFactory.create();
      while (true) {
        worker.run(launcher, orders.take());
      }
    }
  }

  private static void read(DataInputStream in, BlockingQueue<TestClass> orders) {
    try {
      while (true) {
        String name = in.readUTF();
        String methods = in.readUTF();
        orders.add(new TestClass(name, methods, TestClass.Part.valueOf(in.readUTF()), false));
      }
    } catch (IOException e) { // nobody listens any more: neither this nor what tests began goes on
      ProcessHandle.current().descendants().forEach(ProcessHandle::destroyForcibly);
      Runtime.getRuntime().halt(NO_PARENT);
    }
  }

  private void run(Launcher launcher, TestClass testClass) {
    System.out.println("--- " + testClass.name());
    long began = System.nanoTime();
    double cpu = cpuSeconds();
    Pattern named = Pattern.compile(testClass.methods().isEmpty() ? ".*" : testClass.methods());
    PostDiscoveryFilter asked =
        test ->
            FilterResult.includedIf(
                !(test.getSource().orElse(null) instanceof MethodSource source)
                    || named.matcher(source.getMethodName()).matches()
                        && testClass.has(source.getJavaMethod()));
    LauncherDiscoveryRequestBuilder request =
        LauncherDiscoveryRequestBuilder.request()
            .selectors(selectClass(testClass.name()))
            .filters(asked);
    launcher.execute(request.build(), new Teller());
    awaitEndingProcesses();
    System.out.flush();
    send(
        new TestEvent(
            TestEvent.Kind.CLASS_DONE,
            testClass.name(),
            secondsSince(began),
            cpuSeconds() - cpu,
            ""));
  }

  /** Waits for processes that the class has just ended: what they computed counts for it. */
  private static void awaitEndingProcesses() {
    CompletableFuture<?>[] ends =
        ProcessHandle.current()
            .children()
            .map(ProcessHandle::onExit)
            .toArray(CompletableFuture<?>[]::new);
    CompletableFuture.allOf(ends).completeOnTimeout(null, ENDING_SECONDS, SECONDS).join();
  }

  private synchronized void send(TestEvent event) {
    try {
      out.writeObject(event);
      out.reset();
      out.flush();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static double secondsSince(long nanos) {
    return (System.nanoTime() - nanos) / 1e9;
  }

  /** Returns the processor time of this process, and on Linux of those that it started. */
  private static double cpuSeconds() {
    double own =
        ManagementFactory.getOperatingSystemMXBean() instanceof OperatingSystemMXBean system
            ? system.getProcessCpuTime() / 1e9
            : 0;
    try {
      String stat = Files.readString(Path.of("/proc/self/stat"));
      String[] fields = stat.substring(stat.lastIndexOf(')') + 2).split(" ");
      return own + (Long.parseLong(fields[13]) + Long.parseLong(fields[14])) / LINUX_CLOCK_HZ;
    } catch (IOException e) { // another system
      return own;
    }
  }

  private final class Teller implements TestExecutionListener {
    private final Map<String, Long> began = new ConcurrentHashMap<>();
    private TestPlan plan;

    @Override
    public void testPlanExecutionStarted(TestPlan testPlan) {
      plan = testPlan;
    }

    @Override
    public void executionStarted(TestIdentifier test) {
      began.put(test.getUniqueId(), System.nanoTime());
      if (test.isTest()) {
        send(new TestEvent(TestEvent.Kind.STARTED, name(test), 0, 0, ""));
      }
    }

    @Override
    public void executionSkipped(TestIdentifier test, String reason) {
      skipped(test, reason);
    }

    @Override
    public void executionFinished(TestIdentifier test, TestExecutionResult result) {
      TestExecutionResult.Status status = result.getStatus();
      if (status == TestExecutionResult.Status.FAILED) { // a container, too: its tests didn't run
        tell(TestEvent.Kind.FAILED, test, trace(result));
      } else if (status == TestExecutionResult.Status.ABORTED) {
        skipped(test, result.getThrowable().map(Throwable::getMessage).orElse(""));
      } else if (test.isTest()) {
        tell(TestEvent.Kind.PASSED, test, "");
      }
    }

    private void skipped(TestIdentifier test, String reason) {
      if (test.isTest()) {
        tell(TestEvent.Kind.SKIPPED, test, String.valueOf(reason));
      } else {
        plan.getChildren(test).forEach(child -> skipped(child, reason));
      }
    }

    private void tell(TestEvent.Kind kind, TestIdentifier test, String text) {
      Long start = began.get(test.getUniqueId());
      double seconds = start == null ? 0 : secondsSince(start);
      send(new TestEvent(kind, name(test), seconds, 0, text));
    }

    /** The method, and what tells its invocations apart. */
    private static String name(TestIdentifier test) {
      if (!(test.getSource().orElse(null) instanceof MethodSource source)) {
        return test.getDisplayName();
      }
      String shown = test.getDisplayName();
      String method = source.getMethodName();
      return shown.startsWith(method + "(") ? method : method + " " + shown;
    }

    private static String trace(TestExecutionResult result) {
      StringWriter text = new StringWriter();
      result.getThrowable().ifPresent(e -> e.printStackTrace(new PrintWriter(text)));
      return text.toString();
    }
  }
}
