package carom.client;

import carom.game.Games;
import carom.net.codec.Sequence;
import carom.net.field.Declarations;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.InputDatagram;
import carom.net.protocol.PackedLevel;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.snapshot.InputFeedback;
import carom.net.snapshot.SnapshotEncoder;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import carom.net.transport.ServerTransport;
import carom.physics.Body;
import carom.server.prediction.OwnCapture;
import carom.server.prediction.PredictedSet;
import carom.sim.Role;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.level.Level;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The smallest authority a client can play on, driven tick by tick. Tests read its state and make
 * it misbehave. The real server has its own scenarios; this one shows that the client needs nothing
 * but the protocol.
 */
final class ScriptedServer {
  static final long TICK_NS = 1_000_000_000L / 60;

  final class Guest implements LinkHandler {
    final Link link;
    HostPlayer player;
    SnapshotEncoder encoder;
    boolean ready;
    boolean closed;
    ClientMessage.Hello hello;
    int levelRequests;
    final InputDatagram datagram = new InputDatagram();
    final InputFeedback feedback = new InputFeedback();
    final long[] inputs = new long[256];
    final int[] inputTick = new int[256];
    int newestInput = -1;
    long newestNs;
    long last;
    int missing;
    final OwnState own = new OwnState(capture.words());
    PredictedSet near;
    int disagreedTick = -1;

    Guest(Link link) {
      this.link = link;
      Arrays.fill(inputTick, -1);
    }

    @Override
    public void message(Link from, Object message) {
      if (message instanceof ClientMessage.Hello h) {
        hello = h;
        if (script.hello(this)) {
          welcome();
        }
      } else if (message instanceof ClientMessage.LevelRequest request) {
        levelRequests++;
        script.level(this, request.offset());
      } else if (message instanceof ClientMessage.Ready) {
        ready = true;
        player = simulation.join(hello.name());
        encoder = new SnapshotEncoder(ring, EPOCH, 60);
        near = capture.predictedSet(player, encoder, e -> true);
      } else if (message instanceof ClientMessage.Leave) {
        closed = true;
      }
    }

    ScriptedServer server() {
      return ScriptedServer.this;
    }

    void welcome() {
      byte[] bytes = level.source();
      link.send(
          new ServerMessage.Welcome(
              77,
              EPOCH,
              guests.indexOf(this),
              60,
              "1",
              1,
              0,
              EPOCH,
              simulation.tick(),
              simulation.tick(),
              1,
              level.gameName(),
              "test.json",
              level.contentHash(),
              bytes.length,
              PackedLevel.pack(bytes).length,
              Declarations.of(simulation.schema(), simulation.messageKinds()).digest()
                  + (fields.isEmpty() ? 0 : 1),
              ClientMessage.Ready.ANY_CODE,
              false,
              fields));
    }

    void sendLevel(int offset) {
      byte[] bytes = PackedLevel.pack(level.source());
      int to = Math.min(bytes.length, offset + ProtocolLimits.MAX_LEVEL_CHUNK_BYTES);
      link.send(new ServerMessage.LevelChunk(offset, Arrays.copyOfRange(bytes, offset, to)));
    }

    @Override
    public void datagram(Link from, byte[] bytes, int length) {
      if (!datagram.decode(bytes, 0, length) || datagram.epoch != EPOCH || !ready) {
        return;
      }
      if (datagram.hasAck) {
        encoder.receiveAck(datagram.ackSequence, datagram.ackBits);
      }
      feedback.present = true;
      feedback.sequence = datagram.sequence;
      if (datagram.disagrees) {
        disagreedTick = Sequence.expand(datagram.disagreedTick, simulation.tick());
      }
      newestNs = nowNs;
      for (int i = 0; i < datagram.count; i++) {
        int tick = datagram.newestTick - i;
        if (tick > simulation.tick() && tick < simulation.tick() + 200) {
          inputs[tick & 255] = datagram.inputs[i];
          inputTick[tick & 255] = tick;
        }
      }
      newestInput = Math.max(newestInput, datagram.newestTick);
    }

    @Override
    public void closed(Link from, String reason) {
      closed = true;
    }

    void applyInput(int tick) {
      if (inputTick[tick & 255] == tick) {
        last = inputs[tick & 255];
      } else if (newestInput >= 0) {
        missing++;
      }
      player.input().unpack(last);
    }

    void snapshot() {
      capture.capture(player, e -> true, own);
      if (datagram.near != InputDatagram.NEAR_NONE) {
        near.capture(player, false, disagreedTick, Integer.MAX_VALUE, own);
      }
      feedback.margin = Math.max(-32, Math.min(31, newestInput - simulation.tick()));
      feedback.holdMs = (int) Math.min(255, (nowNs - newestNs) / 1_000_000);
      script.own(this);
      encoder.begin(feedback, own, 4_000);
      for (int n; (n = encoder.next(buffer)) > 0; ) {
        script.datagram(buffer, n);
        link.sendDatagram(buffer, 0, n);
      }
      near.sent();
    }
  }

  /** What a test may do differently. */
  static class Script {
    /** Says hello back; true = welcome. */
    boolean hello(Guest guest) {
      return true;
    }

    void level(Guest guest, int offset) {
      guest.sendLevel(offset);
    }

    /** May change the exact state that the client is about to get. */
    void own(Guest guest) {}

    /** May change a datagram that the client is about to get. */
    void datagram(byte[] bytes, int length) {}
  }

  static final int EPOCH = 5;

  private final ServerTransport transport;
  private final FrameRing ring = new FrameRing(512);
  private final OwnCapture capture;
  private final byte[] buffer = new byte[SnapshotEncoder.MAX_DATAGRAM_BYTES];
  final Level level;
  final SimulationHost simulation;

  /** Declarations that the server says its game has; none if it has those of the client. */
  List<String> fields = List.of();

  final List<Guest> guests = new ArrayList<>();
  Script script = new Script();
  long nowNs;
  boolean silent;

  ScriptedServer(ServerTransport transport, Level level) {
    this.transport = transport;
    this.level = level;
    simulation = new SimulationHost(Games.create(level.gameName()), level, 1, 60, Role.AUTHORITY);
    capture = new OwnCapture(simulation);
    ring.gravity(level.gravityX(), level.gravityY()); // or clients take datagrams for damaged
  }

  /** Takes in what arrived. */
  void poll(long nowNs) {
    this.nowNs = nowNs;
    for (Link link; (link = transport.accept()) != null; ) {
      guests.add(new Guest(link));
    }
    for (Guest g : guests) {
      g.link.poll(g, 10_000);
    }
  }

  void tick(long nowNs) {
    poll(nowNs);
    int next = simulation.tick() + 1;
    for (Guest g : guests) {
      if (g.ready && !g.closed) {
        g.applyInput(next);
      }
    }
    simulation.step();
    FrameState frame = ring.begin(simulation.tick());
    for (int id = 0; id < simulation.entityCapacity(); id++) {
      HostEntity e = simulation.entity(id);
      if (e != null) {
        Body<HostEntity> b = e.body();
        frame.put(
            id,
            e.generation(),
            e.archetype().index(),
            e.ownerId(),
            b.x(),
            b.y(),
            b.angle(),
            b.velocityX(),
            b.velocityY(),
            b.angularVelocity());
      }
    }
    for (Guest g : guests) {
      if (g.player != null) {
        frame.putInput(g.player.id(), g.player.input().pack());
      }
    }
    ring.end();
    for (Guest g : guests) {
      if (g.ready && !g.closed && !silent) {
        g.snapshot();
      }
    }
  }
}
