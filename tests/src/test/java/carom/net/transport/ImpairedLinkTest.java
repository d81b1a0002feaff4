package carom.net.transport;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ProtocolLimits;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.BrokenBarrierException;
import java.util.concurrent.CyclicBarrier;
import org.junit.jupiter.api.Test;

/**
 * Goal: an impaired link is as bad as configured, and the same for the same seed. Method: counts
 * over thousands of datagrams.
 */
class ImpairedLinkTest {

  private static final long MS = 1_000_000;

  private long now =
      Long.MAX_VALUE - 500 * MS; // the clock's origin is arbitrary, and it may overflow
  private final InProcessNetwork network = new InProcessNetwork(new TextCodec());
  private final Link client = network.client().connect("anywhere", 1, 2);
  private final Link server = network.server().accept();
  private final Recorder atServer = new Recorder();
  private final Recorder atClient = new Recorder();

  private ImpairedLink impaired(Impairment impairment) {
    return new ImpairedLink(client, impairment, () -> now);
  }

  private static byte[] numbered(int i) {
    return new byte[] {(byte) i, (byte) (i >> 8), (byte) (i >> 16)};
  }

  private static int number(byte[] b) {
    return (b[0] & 0xff) | (b[1] & 0xff) << 8 | (b[2] & 0xff) << 16;
  }

  /** One datagram a millisecond through the network; returns their numbers in order of arrival. */
  private List<Integer> send(ImpairedLink link, int count) {
    for (int i = 0; i < count; i++) {
      link.sendDatagram(numbered(i), 0, 3);
      tick(link, 1);
    }
    tick(link, 1_000);
    List<Integer> numbers = new ArrayList<>();
    for (byte[] datagram : atServer.datagrams) {
      numbers.add(number(datagram));
    }
    return numbers;
  }

  private void tick(ImpairedLink link, int ms) {
    now += ms * MS;
    link.poll(atClient, 1_000);
    server.poll(atServer, 1_000);
  }

  private static int inversions(List<Integer> numbers) {
    int count = 0;
    for (int i = 1; i < numbers.size(); i++) {
      if (numbers.get(i) < numbers.get(i - 1)) {
        count++;
      }
    }
    return count;
  }

  @Test
  void aPerfectNetworkChangesNothing() {
    ImpairedLink link = impaired(Impairment.NONE);
    List<Integer> numbers = send(link, 500);
    assertEquals(500, numbers.size());
    assertEquals(0, inversions(numbers));
    assertEquals(0, link.counters().datagramsDropped.get());
  }

  @Test
  void losesTheShareThatWasAskedFor() {
    ImpairedLink link = impaired(Impairment.NONE.withLoss(20).withSeed(3));
    int arrived = send(link, 10_000).size();
    assertEquals(8_000, arrived, 200);
    assertEquals(10_000 - arrived, link.counters().datagramsDropped.get());
  }

  @Test
  void burstsHaveTheMeanLengthThatWasAskedFor() {
    List<Integer> numbers = send(impaired(Impairment.NONE.withBursts(10, 5).withSeed(4)), 50_000);
    assertEquals(45_000, numbers.size(), 1_000);
    int gaps = 0;
    for (int i = 1; i < numbers.size(); i++) {
      if (numbers.get(i) != numbers.get(i - 1) + 1) {
        gaps++;
      }
    }
    assertEquals(5.0, (50_000.0 - numbers.size()) / gaps, 0.5);
  }

  @Test
  void delaysByTheLatency() {
    ImpairedLink link = impaired(Impairment.NONE.withLatency(100, 0));
    link.sendDatagram(numbered(1), 0, 3);
    server.sendDatagram(numbered(2), 0, 3);
    tick(link, 0);
    tick(link, 99);
    assertEquals(0, atServer.datagrams.size() + atClient.datagrams.size());
    tick(link, 1);
    assertEquals(1, atServer.datagrams.size());
    assertEquals(1, atClient.datagrams.size());
  }

  @Test
  void jitterReordersUnlessToldNotTo() {
    Impairment jitter = Impairment.NONE.withLatency(50, 20).withSeed(5);
    List<Integer> numbers = send(impaired(jitter), 2_000);
    assertEquals(2_000, numbers.size());
    assertTrue(inversions(numbers) > 300, "inversions=" + inversions(numbers));
    atServer.datagrams.clear();
    numbers = send(impaired(jitter.withJitterReorders(false)), 2_000);
    assertEquals(2_000, numbers.size());
    assertEquals(0, inversions(numbers));
  }

  @Test
  void doublesAndReordersTheShareThatWasAskedFor() {
    List<Integer> numbers = send(impaired(Impairment.NONE.withReorder(0, 15).withSeed(6)), 10_000);
    assertEquals(11_500, numbers.size(), 150);
    atServer.datagrams.clear();
    numbers = send(impaired(Impairment.NONE.withReorder(5, 0).withSeed(6)), 10_000);
    assertEquals(10_000, numbers.size());
    assertEquals(500, inversions(numbers), 80);
  }

  @Test
  void messagesAreLateButNeverLostOrReordered() {
    ImpairedLink link = impaired(Impairment.NONE.withLoss(50).withLatency(40, 40).withSeed(7));
    for (int i = 0; i < 300; i++) {
      link.send("up" + i);
      server.send("down" + i);
      tick(link, 1);
    }
    assertTrue(atServer.messages.size() < 300, "some are on their way");
    tick(link, 1_000);
    for (int i = 0; i < 300; i++) {
      assertEquals("up" + i, atServer.messages.get(i));
      assertEquals("down" + i, atClient.messages.get(i));
    }
  }

  @Test
  void theSameSeedGivesTheSameFate() {
    Impairment bad =
        Impairment.NONE.withBursts(10, 3).withLatency(30, 25).withReorder(5, 5).withSeed(8);
    List<Integer> first = send(impaired(bad), 1_000);
    atServer.datagrams.clear();
    List<Integer> second = send(impaired(bad), 1_000);
    assertEquals(first, second);
    atServer.datagrams.clear();
    assertNotEquals(first, send(impaired(bad.withSeed(9)), 1_000));
  }

  @Test
  void closingSendsWhatWasReliable() {
    ImpairedLink link = impaired(Impairment.NONE.withLatency(100, 0));
    link.send("goodbye");
    link.sendDatagram(numbered(1), 0, 3);
    link.close("leaving");
    server.poll(atServer, 10);
    assertEquals(List.of("goodbye"), atServer.order);
    assertEquals(1, atServer.closed);
    assertFalse(link.send("more"));
    assertEquals("leaving", link.closeReason());
  }

  @Test
  void theOtherSidesCloseComesAfterItsLastMessage() {
    ImpairedLink link = impaired(Impairment.NONE.withLatency(100, 0));
    server.send("goodbye");
    server.close("kicked");
    tick(link, 0);
    tick(link, 50);
    assertEquals(0, atClient.closed);
    assertEquals(Link.State.OPEN, link.state(), "the end is still on its way");
    assertEquals("", link.closeReason());
    tick(link, 50);
    assertEquals(List.of("goodbye"), atClient.order);
    assertEquals(1, atClient.closed);
    assertEquals(Link.State.CLOSED, link.state());
    tick(link, 50);
    assertEquals(1, atClient.closed);
  }

  @Test
  void conditionsCanChangeOnTheWay() {
    ImpairedLink link = impaired(Impairment.NONE);
    link.impair(Impairment.NONE.withLoss(100), Impairment.NONE);
    send(link, 100);
    assertEquals(0, atServer.datagrams.size());
    link.impair(Impairment.NONE, Impairment.NONE);
    assertEquals(100, send(link, 100).size());
  }

  @Test
  void impossibleConditionsAreRefused() {
    assertThrows(IllegalArgumentException.class, () -> Impairment.NONE.withLoss(101));
    assertThrows(IllegalArgumentException.class, () -> Impairment.NONE.withBursts(5, 0.5));
    assertThrows(IllegalArgumentException.class, () -> Impairment.NONE.withLatency(-1, 0));
    assertThrows(IllegalArgumentException.class, () -> Impairment.NONE.withReorder(0, Double.NaN));
  }

  @Test
  void aSlowLineCarriesItsBandwidthAndLosesWhatWouldWaitTooLong() {
    // 64 kbit/s = 8 bytes a millisecond; datagrams of 45 + 55 bytes take 12.5 ms each.
    ImpairedLink link = impaired(Impairment.NONE.withBandwidth(64));
    int sent = 1_000;
    for (int i = 0; i < sent; i++) {
      link.sendDatagram(new byte[45], 0, 45);
      tick(link, 5);
    }
    int after5Seconds = atServer.datagrams.size();
    assertEquals(5_000 / 12.5, after5Seconds, 1);
    tick(link, 1_000);
    int waiting = atServer.datagrams.size() - after5Seconds;
    assertEquals(ImpairedDirection.MAX_QUEUE_MS / 12.5, waiting, 2);
    assertEquals(sent - atServer.datagrams.size(), link.counters().datagramsDropped.get());
  }

  @Test
  void messagesWaitForASlowLineAndAreNeverLost() {
    ImpairedLink link =
        new ImpairedLink(
            client,
            Impairment.NONE.withBandwidth(8),
            Impairment.NONE,
            () -> now,
            message -> 1_000 - ProtocolLimits.DATAGRAM_OVERHEAD_BYTES);
    for (int i = 0; i < 4; i++) {
      link.send("message " + i); // a second each
    }
    tick(link, 999);
    assertEquals(0, atServer.messages.size());
    tick(link, 1);
    assertEquals(1, atServer.messages.size());
    tick(link, 3_000);
    assertEquals(4, atServer.messages.size());
    assertEquals("message 3", atServer.messages.get(3));
  }

  @Test
  void whoIsHandedADatagramKnowsHowLongItWaitedForThePoll() {
    ImpairedLink link = impaired(Impairment.NONE.withLatency(20, 0));
    server.sendDatagram(new byte[1], 0, 1);
    tick(link, 0);
    now += 27 * MS;
    long[] waited = {-1};
    link.poll(
        new LinkHandler() {
          @Override
          public void message(Link from, Object message) {}

          @Override
          public void datagram(Link from, byte[] bytes, int length) {
            waited[0] = from.waitedNs();
          }

          @Override
          public void closed(Link from, String reason) {}
        },
        1);
    assertEquals(7 * MS, waited[0]);
  }

  @Test
  void aServersTransportImpairsEachLinkWithASeedOfItsOwn() {
    InProcessNetwork inner = new InProcessNetwork(new TextCodec());
    ServerTransport bad =
        new ImpairedServerTransport(
            inner.server(), Impairment.NONE.withLoss(50), new TextCodec(), () -> now);
    List<List<Integer>> fates = new ArrayList<>();
    for (int n = 0; n < 2; n++) {
      Link peer = inner.client().connect("anywhere", 1, 2);
      Link accepted = bad.accept();
      Recorder recorder = new Recorder();
      for (int i = 0; i < 200; i++) {
        accepted.sendDatagram(numbered(i), 0, 3);
        peer.poll(recorder, 10);
      }
      fates.add(recorder.datagrams.stream().map(ImpairedLinkTest::number).toList());
      assertEquals(100, recorder.datagrams.size(), 30);
    }
    assertNotEquals(fates.get(0), fates.get(1));
    assertEquals(null, bad.accept());
  }

  @Test
  void linksOpenedByTwoThreadsAtOnceHaveSeedsOfTheirOwn() throws Exception {
    int each = 20_000; // so many that a counter not made for threads is caught
    LinkImpairer impairer =
        new LinkImpairer(Impairment.NONE.withLoss(50), new TextCodec(), () -> now);
    ImpairedLink[] links = new ImpairedLink[2 * each];
    CyclicBarrier start = new CyclicBarrier(2);
    Thread[] openers = new Thread[2];
    for (int t = 0; t < 2; t++) {
      int first = t * each;
      openers[t] =
          new Thread(
              () -> {
                try {
                  start.await();
                } catch (InterruptedException | BrokenBarrierException x) {
                  throw new IllegalStateException(x);
                }
                for (int i = first; i < first + each; i++) {
                  links[i] = impairer.impair(client);
                }
              });
      openers[t].start();
    }
    for (Thread opener : openers) {
      opener.join();
    }
    Set<Long> fates = new HashSet<>();
    for (ImpairedLink link : links) {
      long fate = 0;
      for (int i = 0; i < 64; i++) {
        long dropped = link.counters().datagramsDropped.get();
        link.sendDatagram(numbered(i), 0, 3);
        fate = fate << 1 | (link.counters().datagramsDropped.get() - dropped);
      }
      server.poll(atServer, 64);
      atServer.datagrams.clear();
      fates.add(fate);
    }
    assertEquals(links.length, fates.size());
  }
}
