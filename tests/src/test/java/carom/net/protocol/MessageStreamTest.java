package carom.net.protocol;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * Goal: over links that break at any moment, each message is heard once and in order, or known to
 * be lost. Method: random offers, deliveries and breaks between two ends.
 */
final class MessageStreamTest {
  @Test
  void messagesAreHeardOnceAndInOrderOverLinksThatBreakAtRandom() {
    for (long seed = 1; seed <= 200; seed++) {
      Random random = new Random(seed);
      MessageStream sender = new MessageStream();
      MessageStream receiver = new MessageStream();
      List<Integer> onTheWay = new ArrayList<>();
      List<Integer> heard = new ArrayList<>();
      int offered = 0;
      for (int i = 0; i < 500; i++) {
        if (random.nextInt(3) == 0 && sender.offer(new byte[] {(byte) offered})) {
          offered++;
        }
        if (random.nextInt(20) == 0) {
          sender.unlink();
          onTheWay.clear(); // lost with the link
        }
        if (random.nextInt(8) == 0 && onTheWay.isEmpty()) {
          sender.begin(receiver.lastHeard());
        }
        sender.flush((number, bytes) -> onTheWay.add(number));
        if (!onTheWay.isEmpty() && random.nextBoolean()) {
          int number = onTheWay.remove(0);
          int lost = receiver.hear(number);
          assertTrue(lost <= 0, "seed=" + seed + " lost=" + lost);
          if (lost == 0) {
            heard.add(number);
          }
        }
      }
      onTheWay.clear();
      sender.begin(receiver.lastHeard());
      sender.flush((number, bytes) -> assertEquals(0, receiver.hear(number)));
      assertEquals(offered, receiver.lastHeard(), "seed=" + seed);
      for (int i = 1; i < heard.size(); i++) {
        assertEquals(heard.get(i - 1) + 1, heard.get(i), "seed=" + seed);
      }
    }
  }

  @Test
  void whatIsNoLongerKeptIsKnownToBeLost() {
    MessageStream sender = new MessageStream();
    sender.begin(0);
    for (int i = 0; i < 100; i++) {
      assertTrue(sender.offer(new byte[] {1}));
      sender.flush((number, bytes) -> {}); // into a link that is broken already
    }
    sender.begin(0);
    MessageStream receiver = new MessageStream();
    List<Integer> lost = new ArrayList<>();
    sender.flush((number, bytes) -> lost.add(receiver.hear(number)));
    assertEquals(MessageStream.KEPT, lost.size());
    assertEquals(100 - MessageStream.KEPT, lost.get(0));
    assertEquals(100, receiver.lastHeard());
  }

  @Test
  void onlySoManyWaitForALink() {
    MessageStream sender = new MessageStream();
    for (int i = 0; i < MessageStream.KEPT; i++) {
      assertTrue(sender.offer(new byte[] {1}));
    }
    assertFalse(sender.offer(new byte[] {1}));
    sender.begin(Integer.MAX_VALUE); // a lie; nothing was sent, so all is due
    List<Integer> sent = new ArrayList<>();
    sender.flush((number, bytes) -> sent.add(number));
    assertEquals(MessageStream.KEPT, sent.size());
    assertTrue(sender.offer(new byte[] {1}));
  }

  @Test
  void aDatagramIsHeardOnceAndNotAfterANewerOne() {
    MessageDatagram sender = new MessageDatagram();
    MessageDatagram receiver = new MessageDatagram();
    sender.begin(5);
    receiver.begin(5);
    List<byte[]> datagrams = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      assertTrue(sender.add(new byte[] {(byte) i}));
      assertTrue(sender.add(new byte[300]));
      sender.complete();
      datagrams.add(java.util.Arrays.copyOf(sender.bytes(), sender.length()));
      sender.clear();
    }
    byte[] first = datagrams.get(0);
    assertTrue(receiver.isOne(first, first.length));
    assertTrue(receiver.decode(first, first.length));
    assertArrayEquals(new byte[] {0}, receiver.next());
    assertEquals(300, receiver.next().length);
    assertNull(receiver.next());
    assertFalse(receiver.decode(first, first.length), "twice");
    byte[] third = datagrams.get(2);
    assertTrue(receiver.decode(third, third.length));
    byte[] second = datagrams.get(1);
    assertFalse(receiver.decode(second, second.length), "too late");
    assertFalse(receiver.isOne(new byte[] {1, 2, 3}, 3));
    assertFalse(receiver.isOne(first, 2));
  }

  @Test
  void whateverADatagramHoldsReadingItEnds() {
    Random random = new Random(5);
    for (int i = 0; i < 20_000; i++) {
      MessageDatagram receiver = new MessageDatagram();
      receiver.begin(1);
      byte[] bytes = new byte[3 + random.nextInt(60)];
      random.nextBytes(bytes);
      assertTrue(receiver.decode(bytes, bytes.length));
      int read = 0;
      for (byte[] next; (next = receiver.next()) != null; ) {
        read += 2 + next.length;
      }
      assertTrue(read <= bytes.length - 3, "read=" + read);
    }
  }
}
