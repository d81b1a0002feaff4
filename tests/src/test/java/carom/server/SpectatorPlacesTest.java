package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.Protocol;
import carom.net.protocol.RefusalReason;
import carom.server.metrics.Counter;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Goal: no network takes all places of spectators, and none of players. */
final class SpectatorPlacesTest {
  private static final int PLACES = 256;

  private final Rig rig = new Rig();
  private final List<FakeClient> spectators = new ArrayList<>();

  @BeforeEach
  void allow() throws IOException {
    rig.server.allowSpectators(2);
  }

  @AfterEach
  void close() {
    rig.close();
  }

  private FakeClient watch(String address) {
    FakeClient client = rig.connectFrom(address);
    client.link.send(new ClientMessage.Watch(Protocol.VERSION, Protocol.physicsDigest(), 1));
    rig.steps(2);
    return client;
  }

  private long gone() {
    return spectators.stream().filter(each -> each.goodbye != null).count();
  }

  @Test
  void ofANetworkThatHoldsMostTheNewestGivesWayToAnother() {
    for (int i = 0; i < PLACES; i++) {
      spectators.add(watch("198.51.100." + i % 250));
    }
    assertEquals(PLACES, rig.count(Counter.SPECTATORS));
    FakeClient same = watch("198.51.100.251");
    assertEquals(RefusalReason.SERVER_FULL, same.refused.reason());
    assertEquals(0, gone());
    FakeClient other = watch("203.0.113.7");
    assertNull(other.refused);
    assertEquals(1, gone());
    assertEquals(GoodbyeReason.CROWDED, spectators.get(PLACES - 1).goodbye.reason());
    assertEquals(PLACES, rig.count(Counter.SPECTATORS));
    rig.joinFrom("198.51.100.252", "Ann"); // players have places of their own
  }

  @Test
  void networksWithinTheirShareKeepTheirPlaces() {
    for (int i = 0; i < PLACES; i++) {
      spectators.add(watch("198.51." + i % 16 + ".7"));
    }
    FakeClient other = watch("203.0.113.7");
    assertEquals(RefusalReason.SERVER_FULL, other.refused.reason());
    assertTrue(other.refused.text().startsWith(PLACES + " people"), other.refused.text());
    assertEquals(0, gone());
  }
}
