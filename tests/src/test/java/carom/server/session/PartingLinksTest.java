package carom.server.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.kryo.KryoMessageCodec;
import carom.net.transport.InProcessNetwork;
import carom.net.transport.Link;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Goal: a goodbye arrives, and those who are told it use up no more than their share. Method: links
 * in this process, in virtual time.
 */
final class PartingLinksTest {
  private static final int CAPACITY = 64;

  private final InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
  private final PartingLinks partings = new PartingLinks(CAPACITY);
  private final List<Link> clients = new ArrayList<>();
  private final List<Link> servers = new ArrayList<>();

  @Test
  void oneMoreThanTheCapacityClosesTheOldestAtOnce() {
    for (int i = 0; i < CAPACITY + 10; i++) {
      part(1_000);
    }
    for (int i = 0; i < servers.size(); i++) {
      assertEquals(i >= 10, isOpen(servers.get(i)), "i=" + i);
    }
    assertEquals(0, partings.doWork(999));
    assertEquals(CAPACITY, partings.doWork(1_000));
    assertTrue(partings.isEmpty());
    assertTrue(servers.stream().noneMatch(PartingLinksTest::isOpen));
  }

  @Test
  void aLinkGoesWhenItsTimeIsOverOrItsPeerHasGone() {
    part(100);
    part(300);
    part(200);
    assertEquals(0, partings.doWork(99));
    clients.get(1).close("gone");
    assertEquals(1, partings.doWork(99), "the peer has gone");
    assertEquals(1, partings.doWork(100));
    assertTrue(isOpen(servers.get(2)));
    assertFalse(partings.isEmpty());
    partings.closeAll();
    assertTrue(partings.isEmpty());
    assertFalse(isOpen(servers.get(2)));
  }

  /** Lets one more link part, until {@code deadlineNs}. */
  private void part(long deadlineNs) {
    clients.add(network.client().connect("anywhere", 1, 2));
    Link server = network.server().accept();
    servers.add(server);
    partings.add(server, "told goodbye", deadlineNs);
  }

  private static boolean isOpen(Link link) {
    return link.state() != Link.State.CLOSED;
  }
}
