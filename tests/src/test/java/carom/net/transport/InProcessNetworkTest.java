package carom.net.transport;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.suite.Needs;
import java.util.List;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;

@Needs("sockets")
class InProcessNetworkTest {

  private final InProcessNetwork network = new InProcessNetwork(new TextCodec());
  private final Recorder atServer = new Recorder();
  private final Recorder atClient = new Recorder();

  @Test
  void bytesGoBothWaysInOrder() {
    Link client = network.client().connect("anywhere", 1, 2);
    Link server = network.server().accept();
    assertNotNull(server);
    assertNull(network.server().accept());
    byte[] datagram = {9, 8, 7};
    assertTrue(client.send("one"));
    assertTrue(client.sendDatagram(datagram, 1, 2));
    datagram[1] = 0;
    assertTrue(client.send("two"));
    assertEquals(1, server.poll(atServer, 1), "no more than asked for");
    assertEquals(2, server.poll(atServer, 100));
    assertEquals(List.of("one", "datagram 8", "two"), atServer.order);
    assertArrayEquals(new byte[] {8, 7}, atServer.datagrams.get(0));
    assertTrue(server.send("back"));
    client.poll(atClient, 10);
    assertEquals(List.of("back"), atClient.messages);
    assertEquals(2, client.counters().messagesOut.get());
    assertEquals(6, server.counters().messageBytesIn.get());
    assertEquals(2, server.counters().datagramBytesIn.get());
  }

  @Test
  void closingDeliversWhatWasSentThenTellsOnce() {
    Link client = network.client().connect("anywhere", 1, 2);
    Link server = network.server().accept();
    client.send("last words");
    client.close("enough");
    client.close("twice");
    assertFalse(client.send("too late"));
    assertFalse(client.sendDatagram(new byte[1], 0, 1));
    assertEquals(0, server.poll(atServer, 0));
    assertEquals(0, atServer.closed, "not before the inbox is empty");
    server.poll(atServer, 10);
    server.poll(atServer, 10);
    assertEquals(List.of("last words"), atServer.messages);
    assertEquals(1, atServer.closed);
    assertEquals("the connection was closed by the other side", atServer.reason);
    client.poll(atClient, 10);
    assertEquals("enough", atClient.reason);
    assertEquals(Link.State.CLOSED, server.state());
  }

  @Test
  void aFullInboxDropsDatagramsAndClosesOnMessages() {
    Link client = network.client().connect("anywhere", 1, 2);
    Link server = network.server().accept();
    for (int i = 0; i < InProcessLink.MAX_DATAGRAMS + 10; i++) {
      assertTrue(client.sendDatagram(new byte[] {1}, 0, 1));
    }
    assertEquals(10, server.counters().datagramsDropped.get());
    assertEquals(InProcessLink.MAX_DATAGRAMS, server.poll(atServer, 10_000));
    String big = "x".repeat(64 * 1024);
    int sent = 0;
    while (client.send(big)) {
      sent++;
    }
    assertEquals(InProcessLink.MAX_MESSAGE_BYTES / big.length(), sent);
    assertEquals(Link.State.CLOSED, client.state());
    assertTrue(client.closeReason().contains("doesn't take its messages"), client.closeReason());
    assertEquals(sent, server.poll(atServer, 10_000));
    assertEquals(1, atServer.closed);
  }

  @Test
  void damagedMessagesCloseTheLink() {
    Link client = network.client().connect("anywhere", 1, 2);
    Link server = network.server().accept();
    client.send("?");
    server.poll(atServer, 10);
    assertEquals(1, server.counters().malformed.get());
    assertEquals(1, atServer.closed);
    assertEquals(List.of(), atServer.messages);
  }

  @Test
  void wrongSizesAndTypesAreTheCallersBug() {
    Link client = network.client().connect("anywhere", 1, 2);
    assertThrows(IllegalArgumentException.class, () -> client.send(42));
    assertThrows(
        IllegalArgumentException.class, () -> client.sendDatagram(new byte[1201], 0, 1201));
    assertThrows(IllegalArgumentException.class, () -> client.sendDatagram(new byte[1], 0, 0));
  }

  @Test
  void aClosedServerRefusesAndClosesItsLinks() {
    Link before = network.client().connect("anywhere", 1, 2);
    network.server().close();
    assertEquals(Link.State.CLOSED, before.state());
    Link after = network.client().connect("anywhere", 1, 2);
    assertEquals(Link.State.CLOSED, after.state());
    assertEquals("the server is not running", after.closeReason());
    assertNull(network.server().accept());
  }

  @Test
  void tooManyWaitingLinksAreRefused() {
    for (int i = 0; i < InProcessNetwork.MAX_WAITING_LINKS; i++) {
      assertEquals(Link.State.OPEN, network.client().connect("anywhere", 1, 2).state());
    }
    assertEquals(Link.State.CLOSED, network.client().connect("anywhere", 1, 2).state());
    assertNotNull(network.server().accept());
    assertEquals(Link.State.OPEN, network.client().connect("anywhere", 1, 2).state());
  }

  @Test
  void twoThreadsLoseNothing() throws InterruptedException {
    Link client = network.client().connect("anywhere", 1, 2);
    Link server = network.server().accept();
    int count = 20_000;
    AtomicReference<Throwable> failure = new AtomicReference<>();
    Thread sender =
        new Thread(
            () -> {
              for (int i = 0; i < count; i++) {
                client.send("m" + i);
              }
              client.close("done");
            });
    sender.setUncaughtExceptionHandler((thread, error) -> failure.set(error));
    sender.start();
    while (atServer.closed == 0) {
      if (server.poll(atServer, 100) == 0) {
        Thread.sleep(1);
      }
    }
    sender.join();
    assertNull(failure.get());
    assertEquals(count, atServer.messages.size());
    assertEquals("m" + (count - 1), atServer.messages.get(count - 1));
  }
}
