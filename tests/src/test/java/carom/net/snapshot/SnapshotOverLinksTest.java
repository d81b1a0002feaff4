package carom.net.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.kryo.KryoMessageCodec;
import carom.net.protocol.InputDatagram;
import carom.net.transport.ImpairedLink;
import carom.net.transport.Impairment;
import carom.net.transport.InProcessNetwork;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import org.junit.jupiter.api.Test;

/**
 * Goal: snapshots down and input datagrams with acks up agree over real links, whatever the
 * conditions. Method: in-process network, impaired client link, virtual time, the scene as oracle.
 */
class SnapshotOverLinksTest {

  private static final int EPOCH = 4;
  private static final long TICK_NS = 1_000_000_000L / Scene.TICK_RATE;

  private final Scene scene = new Scene(80, 500, 5);
  private final SnapshotEncoder encoder = new SnapshotEncoder(scene.ring, EPOCH, Scene.TICK_RATE);
  private final SnapshotDecoder decoder =
      new SnapshotDecoder(scene.slots, EPOCH, scene.firstTick, Scene.TICK_RATE);
  private final InputDatagram up = new InputDatagram();
  private final InputDatagram received = new InputDatagram();
  private final InputFeedback feedback = new InputFeedback();
  private final byte[] buffer = new byte[SnapshotEncoder.MAX_DATAGRAM_BYTES];
  private long nowNs;
  private int decoded;

  private final LinkHandler atServer =
      new LinkHandler() {
        @Override
        public void message(Link link, Object message) {
          throw new AssertionError("no messages here: " + message);
        }

        @Override
        public void datagram(Link link, byte[] bytes, int length) {
          assertTrue(received.decode(bytes, 0, length));
          assertEquals(EPOCH, received.epoch);
          if (received.hasAck) {
            encoder.receiveAck(received.ackSequence, received.ackBits);
          }
        }

        @Override
        public void closed(Link link, String reason) {
          throw new AssertionError(reason);
        }
      };

  private final LinkHandler atClient =
      new LinkHandler() {
        @Override
        public void message(Link link, Object message) {
          throw new AssertionError("no messages here: " + message);
        }

        @Override
        public void datagram(Link link, byte[] bytes, int length) {
          DecodeStatus status = decoder.decode(bytes, 0, length);
          assertTrue(
              status == DecodeStatus.OK
                  || status == DecodeStatus.DUPLICATE
                  || status == DecodeStatus.STALE,
              status.name());
          decoded += status == DecodeStatus.OK ? 1 : 0;
        }

        @Override
        public void closed(Link link, String reason) {
          throw new AssertionError(reason);
        }
      };

  private void run(Impairment impairment, int ticks) {
    InProcessNetwork network = new InProcessNetwork(new KryoMessageCodec());
    ImpairedLink client =
        new ImpairedLink(network.client().connect("here", 1, 2), impairment, () -> nowNs);
    Link server = network.server().accept();
    for (int i = 0; i < ticks; i++) {
      if (i < ticks - 300) {
        scene.step();
      } else {
        scene.tick++;
        scene.capture();
      }
      encoder.begin(feedback, null, 4_000);
      for (int n; (n = encoder.next(buffer)) > 0; ) {
        server.sendDatagram(buffer, 0, n);
      }
      nowNs += TICK_NS;
      client.poll(atClient, 1_000);
      up.epoch = EPOCH;
      up.sequence = (up.sequence + 1) & 0xffff;
      up.hasAck = decoder.hasAck();
      up.ackSequence = decoder.ackSequence();
      up.ackBits = decoder.ackBits();
      client.sendDatagram(buffer, 0, up.encode(buffer, 0));
      server.poll(atServer, 1_000);
    }
    Channel oracle = new Channel(scene, impairment.seed());
    oracle.decoder = decoder;
    oracle.checkHistories();
    oracle.checkConverged();
  }

  @Test
  void agreesOnAGoodLine() {
    run(Impairment.NONE.withLatency(15, 2), 900);
    assertTrue(decoded >= 880, "decoded=" + decoded);
  }

  @Test
  void agreesOnABadLine() {
    run(
        Impairment.NONE.withBursts(10, 3).withLatency(100, 50).withReorder(3, 3).withSeed(42),
        1_500);
    assertTrue(decoded >= 1_200, "decoded=" + decoded);
  }

  @Test
  void agreesOnATerribleLine() {
    run(Impairment.NONE.withBursts(50, 8).withLatency(250, 100).withSeed(43), 2_000);
    assertTrue(decoded >= 700, "decoded=" + decoded);
  }
}
