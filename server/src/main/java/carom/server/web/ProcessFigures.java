package carom.server.web;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * The figures of this process at one moment, by the system and the JVM. Immutable.
 *
 * @param cpuNs time that processors have worked for the process, ns; 0 if the JVM can't tell
 * @param heapBytes the used part of the Java heap, with what the collector has yet to free
 * @param residentBytes memory of the machine that the process takes, the heap included; NaN where
 *     the system has no {@code /proc}
 */
record ProcessFigures(long cpuNs, long heapBytes, double residentBytes) {
  private static final Path STATUS = Path.of("/proc/self/status");
  private static final String RESIDENT = "VmRSS:";
  private static final String UNIT = " kB";
  private static final double BYTES_PER_KB = 1_024;

  /** Reads the figures. Any thread; takes about 50 us. */
  public static ProcessFigures now() {
    Runtime runtime = Runtime.getRuntime();
    long cpuNs =
        ManagementFactory.getOperatingSystemMXBean() instanceof OperatingSystemMXBean system
            ? system.getProcessCpuTime()
            : 0;
    return new ProcessFigures(cpuNs, runtime.totalMemory() - runtime.freeMemory(), resident());
  }

  /** Returns the memory of the machine that the process takes, bytes; NaN if unknown. */
  public static double resident() {
    try {
      return resident(Files.readString(STATUS, StandardCharsets.ISO_8859_1));
    } catch (IOException e) {
      return Double.NaN;
    }
  }

  /** Reads a line such as {@code VmRSS: 107520 kB}. */
  static double resident(String status) {
    int line = status.startsWith(RESIDENT) ? 0 : status.indexOf("\n" + RESIDENT) + 1;
    int end = status.indexOf(UNIT + "\n", line);
    if (!status.startsWith(RESIDENT, line) || end < line + RESIDENT.length()) {
      return Double.NaN;
    }
    try {
      return BYTES_PER_KB * Long.parseLong(status.substring(line + RESIDENT.length(), end).strip());
    } catch (NumberFormatException e) {
      return Double.NaN;
    }
  }
}
