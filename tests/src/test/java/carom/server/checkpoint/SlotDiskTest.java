package carom.server.checkpoint;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class SlotDiskTest {
  private static void fail(Error error) {
    throw error;
  }

  @Test
  void noErrorKeepsTheNextCheckpointFromTheDisk() throws Exception {
    try (SlotDisk disk = new SlotDisk(1_000)) {
      disk.start();
      CountDownLatch done = new CountDownLatch(2);
      disk.write(() -> fail(new OutOfMemoryError("on purpose")));
      disk.sync(() -> fail(new NoClassDefFoundError("on purpose")));
      disk.write(done::countDown);
      disk.sync(done::countDown);
      assertTrue(done.await(30, TimeUnit.SECONDS));
      assertTrue(disk.flush());
    }
  }
}
