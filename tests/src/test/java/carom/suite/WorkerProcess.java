package carom.suite;

import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.lang.management.ManagementFactory;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;

/** A process of {@link SuiteWorker} with the flags of this one. Used by one thread. */
final class WorkerProcess implements AutoCloseable {
  private static final Path NICE = Path.of("/usr/bin/nice");
  private static final int START_MS = 120_000;
  private static final int DUMP_SECONDS = 30;
  private static final int STACK_LINES = 40;

  /** A process that yields may take so many times as long: others run before it. */
  private static final int PATIENCE = 3;

  private final boolean yields;
  private final Process process;
  private final Socket socket;
  private final ObjectInputStream in;
  private final DataOutputStream out;
  private boolean usable = true;

  /**
   * Starts a process.
   *
   * @param output the file that gets what the process prints
   * @param yields whether it leaves the processor to others that want it, where {@code nice} is
   * @param optimized whether both compilers of the JVM work, or only the quick one
   * @param flags more flags of the JVM, which programs that tests start have, too
   */
  WorkerProcess(Path output, boolean yields, boolean optimized, List<String> flags)
      throws IOException {
    this.yields = yields;
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      server.setSoTimeout(START_MS);
      List<String> command = new ArrayList<>();
      if (yields && Files.isExecutable(NICE)) {
        command.addAll(List.of(NICE.toString(), "-n", "10"));
      }
      command.add(tool("java"));
      command.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments());
      if (!optimized) { // the kernels of the vector module would be interpreted
        command.removeIf(flag -> flag.contains("jdk.incubator.vector"));
        command.add("-XX:TieredStopAtLevel=1");
      }
      command.addAll(flags);
      command.add("-cp");
      command.add(System.getProperty("java.class.path"));
      command.add(SuiteWorker.class.getName());
      command.add(Integer.toString(server.getLocalPort()));
      process =
          new ProcessBuilder(command)
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.appendTo(output.toFile()))
              .start();
      process.getOutputStream().close();
      try {
        socket = server.accept();
      } catch (SocketTimeoutException e) {
        process.destroyForcibly();
        throw new IOException("a test process didn't start; it printed to file=" + output, e);
      }
    }
    in = new ObjectInputStream(socket.getInputStream());
    out = new DataOutputStream(socket.getOutputStream());
  }

  /** Returns whether it can run another class. */
  boolean usable() {
    return usable;
  }

  /**
   * Runs a class. A process that dies of it, or takes longer than allowed, fails the class, tells
   * in which test it was, and isn't usable any more.
   *
   * @param told hears of each test as it happens
   */
  ClassReport run(TestClass testClass, int limitSeconds, BiConsumer<ClassReport, TestEvent> told)
      throws IOException {
    ClassReport report = new ClassReport(testClass);
    long began = System.nanoTime();
    int seconds = yields ? PATIENCE * limitSeconds : limitSeconds;
    try {
      out.writeUTF(testClass.name());
      out.writeUTF(testClass.methods());
      out.writeUTF(testClass.part().name());
      out.flush();
      while (true) {
        long left = seconds * 1000L - (System.nanoTime() - began) / 1_000_000;
        socket.setSoTimeout((int) Math.max(1, left));
        TestEvent event = (TestEvent) in.readObject();
        report.add(event);
        told.accept(report, event);
        if (event.kind() == TestEvent.Kind.CLASS_DONE) {
          return report;
        }
      }
    } catch (SocketTimeoutException e) {
      String reason = "still ran after " + seconds + " s and was ended; it was at\n" + dump();
      end(report, reason, began, told);
    } catch (EOFException | SocketException e) {
      end(report, "the process ended in it, with exit value " + exitValue(), began, told);
    } catch (ClassNotFoundException e) {
      throw new IllegalStateException(e);
    }
    return report;
  }

  private void end(
      ClassReport report, String reason, long began, BiConsumer<ClassReport, TestEvent> told) {
    usable = false;
    told.accept(report, report.broken(reason, (System.nanoTime() - began) / 1e9));
  }

  private String exitValue() {
    try {
      return process.waitFor(DUMP_SECONDS, TimeUnit.SECONDS)
          ? Integer.toString(process.exitValue())
          : "none: it only hung up";
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return "unknown";
    }
  }

  /** Returns where the thread of the tests is. */
  private String dump() throws IOException {
    Path file = Files.createTempFile("carom-suite", ".txt");
    try {
      Process jcmd =
          new ProcessBuilder(tool("jcmd"), Long.toString(process.pid()), "Thread.print")
              .redirectErrorStream(true)
              .redirectOutput(file.toFile())
              .start();
      if (!jcmd.waitFor(DUMP_SECONDS, TimeUnit.SECONDS)) {
        jcmd.destroyForcibly();
      }
      List<String> lines = Files.readAllLines(file);
      int main = 0;
      while (main < lines.size() && !lines.get(main).startsWith("\"main\"")) {
        main++;
      }
      return String.join("\n", lines.stream().skip(main).limit(STACK_LINES).toList());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return "unknown: interrupted";
    } finally {
      Files.delete(file);
    }
  }

  private static String tool(String name) {
    return Path.of(System.getProperty("java.home"), "bin", name).toString();
  }

  /** Ends the process, and those that its tests left. */
  @Override
  public void close() throws IOException {
    process.descendants().forEach(ProcessHandle::destroyForcibly);
    process.destroyForcibly();
    socket.close();
  }
}
