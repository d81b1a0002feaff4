package carom.server.directory;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Map;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

/** Goal: the directory in memory keeps what {@link DirectoryContract} asks for, in virtual time. */
final class MemoryDirectoryTest extends DirectoryContract {
  private final AtomicLong clockNs = new AtomicLong();
  private final MemoryDirectory directory = new MemoryDirectory(clockNs::get);

  @Override
  Directory open() {
    return directory.door();
  }

  @Override
  void pass(int ms) {
    clockNs.addAndGet(ms * 1_000_000L);
    directory.tick();
  }

  @Test
  void aDoorThatIsAwayHearsLater() throws Exception {
    MemoryDirectory.Door away = directory.door();
    Directory other = door();
    Heard heard = new Heard();
    long one = other.create(key("a"), "1", 0);
    away.watch(root(), heard);
    away.away(true);
    assertThrows(DirectoryException.class, () -> away.get(key("a")));
    other.delete(key("a"), one);
    other.create(key("b"), "2", 0);
    assertEquals(Map.of(key("a"), "1"), heard.values());
    away.away(false);
    assertEquals(Map.of(key("b"), "2"), heard.values());
    assertEquals(2, heard.completes());
    heard.check();
  }
}
