package carom.server.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.room.RoomPictures;
import carom.suite.Needs;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: ten people who watch cost the room's thread what one costs, and nobody costs nothing.
 * Method: pages over WebSockets; the pictures that the room makes and those that arrive are
 * counted. What that is in milliseconds, {@code carom.lab.figures.PageViewers} measures.
 */
@Needs("sockets")
@Timeout(120)
final class ViewerCostTest {
  private static final int VIEWERS = 10;
  private static final String LOOK = "{\"do\":\"look\",\"room\":\"1\",\"contacts\":true}";

  @TempDir private Path folder;

  private final HttpClient client = HttpClient.newHttpClient();

  /** A page that counts the pictures that it gets. */
  private static final class Page implements WebSocket.Listener {
    final AtomicInteger pictures = new AtomicInteger();

    @Override
    public CompletionStage<?> onBinary(WebSocket from, ByteBuffer data, boolean last) {
      pictures.addAndGet(last ? 1 : 0);
      from.request(1);
      return null;
    }
  }

  private WebSocket open(PageRig rig, Page page) {
    URI address = URI.create(rig.web.url().replace("http:", "ws:") + "/live");
    WebSocket socket =
        client
            .newWebSocketBuilder()
            .header("Origin", rig.web.url())
            .buildAsync(address, page)
            .join();
    return socket.sendText(LOOK, true).join();
  }

  private static void until(BooleanSupplier condition) throws InterruptedException {
    while (!condition.getAsBoolean()) {
      Thread.sleep(10);
    }
  }

  @Test
  void tenPagesShareThePicturesOfARoomAndNoPageCostsNone() throws Exception {
    try (PageRig rig = new PageRig(folder, true)) {
      RoomPictures pictures = rig.stepper.room().pictures();
      assertEquals(0, pictures.count(), "pictures for nobody");
      List<Page> pages = new ArrayList<>();
      List<WebSocket> sockets = new ArrayList<>();
      for (int i = 0; i < VIEWERS; i++) {
        Page page = new Page();
        pages.add(page);
        sockets.add(open(rig, page));
      }
      until(() -> pages.stream().allMatch(page -> page.pictures.get() > 0));
      long madeBefore = pictures.count();
      int sentBefore = pages.stream().mapToInt(page -> page.pictures.get()).sum();
      until(() -> pages.stream().allMatch(page -> page.pictures.get() > 20));
      long made = pictures.count() - madeBefore;
      int sent = pages.stream().mapToInt(page -> page.pictures.get()).sum() - sentBefore;
      // A page that is still sent the last picture is left out; pictures of its own would be 1 to
      // 1.
      assertTrue(sent > 2 * made, "sent=" + sent + " made=" + made + " pages=" + VIEWERS);
      assertTrue(
          made <= rig.stepper.room().tick(), "made=" + made + ", more than one for each tick");

      sockets.forEach(WebSocket::abort);
      until(() -> isStill(pictures));
    }
  }

  /** Returns whether the room has made no picture for ten times the interval between two. */
  private static boolean isStill(RoomPictures pictures) {
    long before = pictures.count();
    try {
      Thread.sleep(660);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    return pictures.count() == before;
  }
}
