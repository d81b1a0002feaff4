package carom.net.transport;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class ServerTransportsTest {

  private static final class Door implements ServerTransport {
    final ArrayDeque<Link> waiting = new ArrayDeque<>();
    final int port;
    final boolean tells;
    Throwable error;
    Runnable wake;
    int most;
    boolean closed;

    Door(int port, boolean tells) {
      this.port = port;
      this.tells = tells;
    }

    @Override
    public Link accept() {
      return waiting.poll();
    }

    @Override
    public boolean onOpened(Runnable newWake) {
      wake = newWake;
      return tells;
    }

    @Override
    public void limitLinks(int newMost, int mostPerAddress) {
      most = newMost;
    }

    @Override
    public int tcpPort() {
      return port;
    }

    @Override
    public int udpPort() {
      return port + 1;
    }

    @Override
    public String troubles() {
      return error == null ? "" : "trouble at " + port;
    }

    @Override
    public List<NetworkCounter> networkCounters() {
      return List.of(new NetworkCounter("door" + port, "Counts nothing.", () -> port));
    }

    @Override
    public Throwable nextError() {
      Throwable next = error;
      error = null;
      return next;
    }

    @Override
    public void close() {
      closed = true;
      if (port == 10) {
        throw new IllegalStateException("can't close");
      }
    }
  }

  private final Door own = new Door(10, true);
  private final Door plain = new Door(20, true);
  private final ServerTransport both = ServerTransports.of(own, List.of(plain));

  private static Link link() {
    InProcessNetwork network = new InProcessNetwork(new TextCodec());
    network.client().connect("anywhere", 1, 2);
    return network.server().accept();
  }

  @Test
  void aCrowdAtOneDoorKeepsNobodyWaitingAtTheOther() {
    List<Link> crowd = new ArrayList<>();
    for (int i = 0; i < 5; i++) {
      crowd.add(link());
    }
    own.waiting.addAll(crowd);
    Link alone = link();
    plain.waiting.add(alone);
    List<Link> accepted = new ArrayList<>();
    for (Link next; (next = both.accept()) != null; ) {
      accepted.add(next);
    }
    assertEquals(6, accepted.size());
    assertTrue(accepted.indexOf(alone) <= 1, "in turn");
    accepted.remove(alone);
    assertEquals(crowd, accepted, "in order");
  }

  @Test
  void portsAreThoseOfTheFirstAndTheRestIsOfAll() {
    assertEquals(10, both.tcpPort());
    assertEquals(11, both.udpPort());
    both.limitLinks(7, 3);
    assertEquals(7, own.most);
    assertEquals(7, plain.most);
    assertEquals(
        List.of("door10", "door20"),
        both.networkCounters().stream().map(NetworkCounter::name).toList());
    assertEquals("", both.troubles());
    assertNull(both.nextError());
    Throwable error = new IllegalStateException("bug");
    plain.error = error;
    assertEquals("trouble at 20", both.troubles());
    assertSame(error, both.nextError());
    assertNull(both.nextError());
  }

  @Test
  void theServerLooksIfOneOfThemDoesNotTell() {
    Runnable wake = () -> {};
    assertTrue(both.onOpened(wake));
    assertSame(wake, own.wake);
    assertSame(wake, plain.wake);
    Door silent = new Door(30, false);
    assertFalse(ServerTransports.of(silent, List.of(plain)).onOpened(wake));
  }

  @Test
  void allCloseAlthoughOneFails() {
    try {
      both.close();
    } catch (IllegalStateException e) {
      assertEquals("can't close", e.getMessage());
    }
    assertTrue(plain.closed);
    assertSame(own, ServerTransports.of(own, List.of()), "nothing to combine");
  }
}
