package carom.net.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.Random;
import org.junit.jupiter.api.Test;

/**
 * Goal: both ends of a link agree within seconds how datagrams travel, and over TCP none waits
 * behind a stall. Method: two ends in virtual time, with a UDP that can be cut in each direction
 * and a TCP that keeps everything, in order, and can stand still.
 */
class DatagramPathTest {
  private static final long MS = 1_000_000L;

  /** What is under way over TCP: a head, when it arrives, and which datagram it is. */
  @SuppressWarnings("ArrayRecordComponent") // never compared
  private record Frame(byte[] head, int number, long due) {}

  /** What a datagram by UDP is: a payload, a client's keep-alive, or the server's echo of one. */
  private enum Kind {
    PAYLOAD,
    KEEP_ALIVE,
    ECHO
  }

  /** What is under way by UDP. */
  private record Udp(Kind kind, long due) {}

  /** One end, which sends a datagram each 16 ms. */
  private static final class End {
    final DatagramPath path = new DatagramPath();
    final ArrayDeque<Frame> toOther = new ArrayDeque<>();
    final ArrayDeque<Udp> byUdp = new ArrayDeque<>();
    boolean udpWorks = true;
    boolean stands;
    int sent;
    int newest;
    int mostUnderWay;
    End other;

    private void frame(int number, long now, long delay) {
      byte[] head = new byte[3];
      path.write(head, number > 0, now);
      toOther.add(new Frame(head, number, now + delay));
      mostUnderWay = Math.max(mostUnderWay, toOther.size());
    }

    void udp(Kind kind, long due) {
      if (udpWorks) {
        byUdp.add(new Udp(kind, due));
      }
    }

    void send(long now, long delay) {
      sent++;
      if (!path.isOverTcp(now)) {
        udp(Kind.PAYLOAD, now + delay);
      } else if (path.isFree(now)) {
        frame(sent, now, delay);
      }
      if (path.mustSpeak(now)) {
        frame(0, now, delay);
      }
    }

    void deliver(long now, long delay) {
      while (!byUdp.isEmpty() && byUdp.peek().due <= now) {
        Kind kind = byUdp.remove().kind;
        other.path.heardByUdp(kind != Kind.KEEP_ALIVE, now);
        if (kind == Kind.KEEP_ALIVE) {
          other.udp(Kind.ECHO, now + delay);
        }
      }
      while (!stands && !toOther.isEmpty() && toOther.peek().due <= now) {
        Frame frame = toOther.remove();
        int count = (frame.head[1] & 0xff) << 8 | frame.head[2] & 0xff;
        assertTrue(other.path.read(frame.head[0] != 0, count, frame.number > 0, now));
        other.newest = Math.max(other.newest, frame.number);
      }
    }
  }

  private final End client = new End();
  private final End server = new End();
  private long now = 1_000 * MS;
  private long delay = 20 * MS;

  private void run(long millis) {
    client.other = server;
    server.other = client;
    for (long end = now + millis * MS; now < end; now += 16 * MS) {
      if (client.path.isQuiet(now)) {
        client.udp(Kind.KEEP_ALIVE, now + delay);
      }
      for (End each : new End[] {client, server}) {
        each.send(now, delay);
        each.deliver(now, delay);
      }
    }
  }

  private void assertOverTcp(boolean expected) {
    assertEquals(expected, client.path.isOverTcp(now), "client");
    assertEquals(expected, server.path.isOverTcp(now), "server");
  }

  private void begin(long oneWay) {
    delay = oneWay;
    client.path.roundTrip(2 * oneWay);
    server.path.roundTrip(2 * oneWay);
    client.path.heardByUdp(true, now);
    server.path.heardByUdp(true, now);
  }

  @Test
  void aDeadDirectionMovesBothEndsToTcpAndALivingOneMovesThemBack() {
    for (boolean up : new boolean[] {true, false}) {
      begin(20 * MS);
      run(2_000);
      assertOverTcp(false);
      End dead = up ? client : server;
      dead.udpWorks = false;
      run(4_000);
      assertOverTcp(true);
      int before = server.newest;
      run(1_000);
      assertTrue(server.newest > before + 50, "inputs=" + (server.newest - before));
      dead.udpWorks = true;
      run(2_000);
      assertOverTcp(false);
    }
  }

  @Test
  void aLineOfThreeSecondsIsNoSilence() {
    begin(1_500 * MS);
    for (int i = 0; i < 100; i++) {
      run(100);
      assertOverTcp(false);
    }
  }

  @Test
  void behindAStallTheNewestWinsAndNothingQueues() {
    begin(20 * MS);
    client.udpWorks = false;
    server.udpWorks = false;
    run(10_000);
    server.stands = true;
    run(1_000);
    int queued = server.toOther.size();
    assertTrue(queued < 40, "queued=" + queued);
    int acknowledgements = 60; // two a second, for the other direction
    run(30_000);
    assertTrue(server.toOther.size() < queued + acknowledgements + 4, "" + server.toOther.size());
    server.stands = false;
    run(100);
    assertTrue(server.sent - client.newest < 5, "late=" + (server.sent - client.newest));
  }

  @Test
  void aSlowLineKeepsNoMoreThanAQuarterOfASecond() {
    Random random = new Random(7);
    begin(20 * MS);
    client.udpWorks = false;
    server.udpWorks = false;
    run(6_000);
    for (int i = 0; i < 200; i++) {
      server.stands = random.nextInt(4) > 0; // a quarter of the time, it moves
      run(16);
    }
    long late = server.toOther.isEmpty() ? 0 : now - server.toOther.peek().due;
    assertTrue(late < 400 * MS, "late=" + late / MS + " ms");
  }

  @Test
  void aPeerThatAcknowledgesWhatWasNeverSentIsFound() {
    DatagramPath path = new DatagramPath();
    assertTrue(path.read(true, 0, false, now));
    assertFalse(path.read(true, 1, false, now));
    path.write(new byte[3], true, now);
    assertTrue(path.read(true, 1, false, now));
    assertFalse(path.read(true, 0, false, now), "counts never go back");
  }

  @Test
  void countsGoOnBeyondSixteenBits() {
    DatagramPath path = new DatagramPath();
    for (int i = 1; i < 200_000; i++) {
      assertTrue(path.isFree(now), "datagram " + i);
      path.write(new byte[3], true, now);
      assertTrue(path.read(false, i & 0xffff, true, now));
    }
  }
}
