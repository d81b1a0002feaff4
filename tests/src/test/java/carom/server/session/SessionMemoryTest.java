package carom.server.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;

class SessionMemoryTest {
  @Test
  void aFewPlacesAreNotWorthIt() {
    assertEquals(0, SessionMemory.touch(64));
  }

  @Test
  void memoryOfManyPlacesIsTouchedWithinTheHeapAndFreedAgain() {
    long touched = SessionMemory.touch(100);
    assertTrue(touched >= 0 && touched <= 100 * 166_000, "touched " + touched);
    long committed = ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getCommitted();
    assertTrue(SessionMemory.touch(Integer.MAX_VALUE) < committed);
  }
}
