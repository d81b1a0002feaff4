package carom.client.link;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.kryo.KryoMessageCodec;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.ServerMessage;
import carom.net.transport.InProcessNetwork;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Goal: a client of a fleet goes to the owner of its room, and believes no earlier one. */
final class FleetRouteTest {
  private static final ServerAddress A = ServerAddress.parse("a.example.org:1");
  private static final ServerAddress B = ServerAddress.parse("b.example.org:2");
  private static final long SECOND = 1_000_000_000L;

  private final InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
  private final FleetRoute route = new FleetRoute(network.client());
  private final List<Object> heard = new ArrayList<>();

  private static ServerMessage.Welcome welcome(String room, long claim) {
    return new ServerMessage.Welcome(
        1, 0, 0, 60, room, 1, claim, 0, 0, 0, 0, "g", "l", 0, 0, 0, 0, 0, false, List.of());
  }

  private final LinkHandler server =
      new LinkHandler() {
        @Override
        public void message(Link link, Object message) {
          heard.add(message);
        }

        @Override
        public void datagram(Link link, byte[] bytes, int length) {}

        @Override
        public void closed(Link link, String reason) {
          heard.add("closed");
        }
      };

  @Test
  void aServerThatOwnedTheRoomBeforeIsStaleAndAnotherRoomIsAnother() {
    route.note(welcome("cup", 7));
    assertTrue(route.isStale(welcome("cup", 6)));
    assertFalse(route.isStale(welcome("cup", 7)));
    assertFalse(route.isStale(welcome("cup", 8)));
    assertFalse(route.isStale(welcome("jump", 1)));
    route.note(welcome("cup", 3));
    assertTrue(route.isStale(welcome("cup", 6)), "the highest claim counts");
    route.forget();
    assertFalse(route.isStale(welcome("cup", 0)), "a server outside of the fleet has no claims");
  }

  @Test
  void theServersAreTriedInTurnAndOutsideAFleetTheSameOne() {
    assertEquals(A, route.after(A));
    route.told(new ServerMessage.Fleet(List.of("b.example.org:2", "no address at all,"), ""), A);
    assertEquals(2, route.count());
    assertEquals(B, route.after(A));
    assertEquals(A, route.after(B));
    route.told(new ServerMessage.Fleet(List.of(), ""), B);
    assertEquals(B, route.after(B));
  }

  @Test
  void theFollowerSpeaksFirstAndARefusalIsTriedAgain() {
    route.told(new ServerMessage.Fleet(List.of("b.example.org:2"), "b.example.org:2"), A);
    assertFalse(route.poll(0, 5, "cup"));
    assertFalse(route.poll(1, 5, "cup"));
    Link there = network.server().accept();
    there.poll(server, 9);
    assertEquals(5, ((ClientMessage.Standby) heard.get(0)).secret());
    there.send(new ServerMessage.Refused(RefusalReason.ROOM_UNKNOWN, ""));
    assertFalse(route.poll(2, 5, "cup"));
    assertFalse(route.hasStandby());
    assertFalse(route.poll(SECOND, 5, "cup"), "not at once");
    assertEquals(null, network.server().accept());
    route.poll(3 * SECOND, 5, "cup");
    route.poll(3 * SECOND, 5, "cup");
    assertTrue(route.hasStandby());
    Link again = network.server().accept();
    again.send(welcome("cup", 9));
    again.send(new ServerMessage.Notice("after it"));
    assertTrue(route.poll(4 * SECOND, 5, "cup"));
    assertEquals(9, route.takeWelcome().claim());
    List<Object> rest = new ArrayList<>();
    route
        .takeLink()
        .poll(
            new LinkHandler() {
              @Override
              public void message(Link link, Object message) {
                rest.add(message);
              }

              @Override
              public void datagram(Link link, byte[] bytes, int length) {}

              @Override
              public void closed(Link link, String reason) {}
            },
            9);
    assertEquals(1, rest.size(), "what follows Welcome is left to the connection");
  }
}
