package carom.scenario;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.link.ConnectionPhase;
import carom.fixtures.Levels;
import carom.fixtures.Stranger;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.DatagramMark;
import carom.net.protocol.InputDatagram;
import carom.net.protocol.Protocol;
import carom.net.protocol.ProtocolLimits;
import carom.net.transport.Impairment;
import carom.net.transport.Link;
import carom.server.config.ServerConfig;
import carom.server.metrics.Counter;
import carom.testkit.Scripts;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Goal: whatever a hostile peer sends, the other clients notice nothing. Method: the same game with
 * and without the offender; the others' numbers are equal, or equally good.
 */
class HostileScenarioTest {
  /** What an honest player got out of a game. */
  private record Result(long hash, long snapshots, double gapP99Ms, long corrections) {}

  /** A peer that talks as it likes. */
  private static final class Offender extends Stranger {
    final Link link;
    final long fields;
    final Random random;
    boolean saidReady;

    Offender(Link link, long fields, long seed) {
      this.link = link;
      this.fields = fields;
      this.random = new Random(seed);
    }

    void hello() {
      link.send(new ClientMessage.Hello(Protocol.VERSION, Protocol.physicsDigest(), "evil", 0));
    }

    /** The epoch of the last Welcome, or 0. */
    int epoch() {
      return welcome() == null ? 0 : welcome().epoch();
    }

    void poll() {
      link.poll(this, 100);
    }

    /** Random bytes; half of them with the right mark. */
    void garbageDatagram() {
      byte[] bytes = new byte[1 + random.nextInt(1_200)];
      random.nextBytes(bytes);
      if (welcome() != null && random.nextBoolean() && bytes.length > 4) {
        int mark = DatagramMark.ofState(welcome().epoch());
        bytes[0] = (byte) (bytes[0] & -1 << DatagramMark.BITS | mark);
      }
      link.sendDatagram(bytes, 0, bytes.length);
    }

    /** Well-formed, of the right epoch, and absurd: any tick, any ack, any input. */
    void absurdInput() {
      InputDatagram datagram = new InputDatagram();
      datagram.epoch = welcome().epoch();
      datagram.sequence = random.nextInt(1 << 16);
      datagram.hasAck = true;
      datagram.ackSequence = random.nextInt(1 << 16);
      datagram.ackBits = random.nextLong();
      datagram.newestTick = random.nextBoolean() ? random.nextInt() : random.nextInt(2_000);
      datagram.count = 16;
      for (int i = 0; i < datagram.count; i++) {
        datagram.inputs[i] = random.nextLong() & (1L << 48) - 1;
      }
      byte[] bytes = new byte[InputDatagram.MAX_BYTES];
      link.sendDatagram(bytes, 0, datagram.encode(bytes, 0));
    }

    void randomMessage() {
      switch (random.nextInt(5)) {
        case 0 -> hello();
        case 1 ->
            link.send(
                new ClientMessage.LevelRequest(
                    epoch(), random.nextInt(ProtocolLimits.MAX_LEVEL_BYTES)));
        case 2 -> link.send(new ClientMessage.Ready(epoch(), fields));
        case 3 -> link.send(new ClientMessage.Hello(random.nextInt(), random.nextLong(), "x", 7));
        default -> link.send(new ClientMessage.Leave());
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"arena", "platformer"})
  void strangersWhoNeverGetInChangeNothingForThosePlaying(String game) {
    // Goal: bit for bit the same game. Method: strangers send random datagrams and messages that
    // make no sense where they stand; frames and numbers equal those of the quiet run.
    Result quiet = play(game, 0);
    Result noisy = play(game, 12);
    assertEquals(quiet, noisy, "seed=" + Stepper.SEED);
  }

  private static Result play(String game, int strangers) {
    try (Stepper stepper = Stepper.of(game)) {
      SimulatedClient player =
          stepper.join("p", Impairment.NONE.withLatency(40, 5), Scripts.wander(Stepper.SEED));
      List<Offender> offenders = new ArrayList<>();
      for (int i = 0; i < strangers; i++) {
        offenders.add(offender(stepper, i));
      }
      for (int slice = 0; slice < 3_000; slice++) {
        for (int i = 0; i < strangers; i++) {
          Offender o = offenders.get(i);
          o.poll();
          if (o.closed()) {
            offenders.set(i, offender(stepper, i + slice));
          } else if (o.random.nextInt(40) == 0) {
            // Never the one sentence that lets one in.
            o.link.send(
                o.random.nextBoolean()
                    ? new ClientMessage.Ready(o.epoch(), o.fields)
                    : new ClientMessage.Hello(o.random.nextInt(), o.random.nextLong(), "", 7));
          } else {
            o.garbageDatagram();
          }
        }
        stepper.step();
      }
      assertEquals(1, stepper.count(Counter.JOINS));
      return new Result(
          stepper.hash(),
          player.stats().snapshots(),
          player.stats().gapP99Ms(),
          player.stats().corrections());
    }
  }

  private static Offender offender(Stepper stepper, long seed) {
    return new Offender(
        stepper.transport().connect("localhost", 0, 0),
        stepper.room().match().declarations().digest(),
        Stepper.SEED * 7_919 + seed);
  }

  @Test
  void aPlayerWhoSendsGarbageHurtsOnlyItself() {
    // Goal: from inside the room, too. Method: an offender joins and sends garbage and absurd
    // inputs; two honest players alone in their corners keep rate, gaps and exactness.
    try (Stepper stepper = Stepper.of(Levels.emptyPlatformer(), ServerConfig.defaults())) {
      stepper.expectExpulsions();
      for (int i = 0; i < 2; i++) {
        stepper.join("p" + i, Impairment.NONE.withLatency(40, 0), Scripts.hold(i == 0 ? -1 : 1, 0));
      }
      stepper.run(2);
      final long[] corrections = corrections(stepper);
      final long[] snapshots = snapshots(stepper);
      Offender offender = offender(stepper, 1);
      for (int slice = 0; slice < 5_000; slice++) {
        offender.poll();
        if (offender.closed()) {
          offender = offender(stepper, slice);
        } else if (offender.welcome() == null) {
          if (slice % 50 == 0) {
            offender.hello();
          }
        } else {
          if (!offender.saidReady) {
            offender.saidReady = true;
            offender.link.send(new ClientMessage.Ready(offender.epoch(), offender.fields));
          }
          for (int i = 0; i < 5; i++) {
            offender.garbageDatagram();
            offender.absurdInput();
          }
          if (slice % 500 == 499) {
            offender.randomMessage();
          }
        }
        stepper.step();
      }
      assertTrue(stepper.count(Counter.JOINS) > 4, stepper.describe());
      assertTrue(stepper.count(Counter.DATAGRAMS_IN) > 5_000, stepper.describe());
      assertTrue(stepper.count(Counter.DATAGRAMS_REFUSED) > 1_000, stepper.describe());
      for (int i = 0; i < 2; i++) {
        SimulatedClient honest = stepper.clients().get(i);
        assertEquals(ConnectionPhase.PLAYING, honest.view().phase(), honest::toString);
        assertEquals(0, honest.stats().reconnects(), honest::toString);
        assertEquals(corrections[i], honest.stats().corrections(), honest::toString);
        assertTrue(honest.stats().gapP99Ms() < 105, "keep-alives at least, " + honest);
        assertTrue(honest.stats().snapshots() - snapshots[i] > 95, honest::toString);
      }
      assertEquals(0, stepper.count(Counter.TICKS_DROPPED));
    }
  }

  private static long[] corrections(Stepper stepper) {
    return stepper.clients().stream().mapToLong(c -> c.stats().corrections()).toArray();
  }

  private static long[] snapshots(Stepper stepper) {
    return stepper.clients().stream().mapToLong(c -> c.stats().snapshots()).toArray();
  }

  @Test
  void messagesThatMakeNoSenseGetTheirSenderExpelledAndNobodyElse() {
    // Goal: one wrong message ends one session. Method: random messages from many who got in.
    try (Stepper stepper = Stepper.of("arena")) {
      stepper.expectExpulsions();
      SimulatedClient honest =
          stepper.join("p", Impairment.NONE.withLatency(20, 0), Scripts.wander(1));
      List<Offender> offenders = new ArrayList<>();
      for (int i = 0; i < 20; i++) {
        Offender offender = offender(stepper, i);
        offender.hello();
        offenders.add(offender);
      }
      stepper.run(1);
      for (Offender offender : offenders) {
        offender.poll();
        offender.link.send(new ClientMessage.LevelRequest(offender.epoch(), 0));
        offender.link.send(new ClientMessage.Ready(offender.epoch(), offender.fields));
      }
      stepper.run(1);
      offenders.forEach(Offender::poll);
      assertEquals(21, stepper.count(Counter.PLAYERS));
      for (Offender offender : offenders) {
        for (int i = 0; i < 20; i++) {
          offender.randomMessage();
        }
      }
      stepper.run(2);
      assertEquals(1, stepper.count(Counter.PLAYERS), stepper.describe());
      assertEquals(ConnectionPhase.PLAYING, honest.view().phase());
      assertEquals(1, honest.view().players().size());
      assertEquals(0, honest.stats().reconnects());
    }
  }
}
