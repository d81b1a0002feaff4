package carom.server.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Goal: the page and the metrics tell what the process takes, also where it isn't known. */
@Timeout(60)
final class ProcessFiguresTest {
  @Test
  void residentMemoryIsReadFromTheSystemsStatus() {
    assertEquals(
        107_520 * 1_024.0,
        ProcessFigures.resident("Name:\tjava\nVmHWM:\t  200000 kB\nVmRSS:\t  107520 kB\n"));
    for (String unknown : new String[] {"", "VmRSS: many kB\n", "VmRSS:\t12\n", "Name:\tVmRSS:"}) {
      assertTrue(Double.isNaN(ProcessFigures.resident(unknown)), unknown);
    }
  }

  @Test
  void workAndObjectsShowInTheFigures() {
    ProcessFigures before = ProcessFigures.now();
    byte[][] held = new byte[64][1 << 20];
    ProcessFigures after = ProcessFigures.now();
    assertTrue(after.heapBytes() >= 64L << 20, after + " " + held.length);
    while (ProcessFigures.now().cpuNs() <= before.cpuNs()) {
      Thread.onSpinWait(); // work, which the system counts in steps
    }
  }
}
