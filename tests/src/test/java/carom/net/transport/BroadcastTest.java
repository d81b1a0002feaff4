package carom.net.transport;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class BroadcastTest {
  /** Text, and how often it was encoded. */
  private static final class CountingCodec implements MessageCodec {
    int encoded;

    @Override
    public byte[] encode(Object message) {
      encoded++;
      return message.toString().getBytes(StandardCharsets.UTF_8);
    }

    @Override
    public Object decode(byte[] bytes, int offset, int length) {
      return new String(bytes, offset, length, StandardCharsets.UTF_8);
    }
  }

  @Test
  void aMessageToManyLinksIsEncodedOnceAndArrivesAtEach() {
    CountingCodec codec = new CountingCodec();
    InProcessNetwork network = new InProcessNetwork(codec);
    List<Link> clients = new ArrayList<>();
    Broadcast broadcast = new Broadcast("hello");
    for (int i = 0; i < 20; i++) {
      clients.add(network.client().connect("", 0, 0));
      network.server().accept().send(broadcast);
    }
    assertEquals(1, codec.encoded);
    List<Object> received = new ArrayList<>();
    LinkHandler ears =
        new LinkHandler() {
          @Override
          public void message(Link link, Object message) {
            received.add(message);
          }

          @Override
          public void datagram(Link link, byte[] bytes, int length) {}

          @Override
          public void closed(Link link, String reason) {}
        };
    clients.forEach(client -> client.poll(ears, 10));
    assertEquals(20, received.size());
    assertEquals("hello", received.get(19));
  }

  @Test
  void anotherCodecEncodesAgain() {
    CountingCodec one = new CountingCodec();
    CountingCodec two = new CountingCodec();
    Broadcast broadcast = new Broadcast(7);
    byte[] first = Broadcast.encode(one, broadcast);
    assertArrayEquals(first, Broadcast.encode(two, broadcast));
    assertArrayEquals(first, Broadcast.encode(two, 7));
    assertEquals(1, one.encoded);
    assertEquals(2, two.encoded);
  }
}
