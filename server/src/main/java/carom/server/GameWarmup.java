package carom.server;

import carom.net.field.FieldTables;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.InputDatagram;
import carom.net.protocol.Protocol;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.snapshot.table.TableInbox;
import carom.net.snapshot.table.TableLayout;
import carom.net.transport.InProcessNetwork;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import carom.net.transport.MessageCodec;
import carom.server.checkpoint.SlotDisk;
import carom.server.checkpoint.SlotLink;
import carom.server.checkpoint.SlotMirror;
import carom.server.config.ServerConfig;
import carom.server.room.Room;
import carom.server.session.Ownership;
import carom.sim.Game;
import carom.sim.SimulationHost;
import carom.sim.entity.Input;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import carom.sim.level.Level;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Warms up a server before it opens. It plays the game for a moment in virtual time, with a few
 * clients inside this process, so that the JVM has loaded and compiled what a tick and a join need.
 * Without it, the first player of a fresh server on a busy machine waits up to several hundred
 * milliseconds. A server of a fleet also follows its own room and goes on with it a few times, so
 * that players needn't wait for that when another server dies.
 *
 * <p>It covers the whole server but vector kernels, which take seconds: {@link
 * carom.server.KernelWarmupThread} warms those up while the rooms run.
 */
final class GameWarmup {
  private static final int CLIENTS = 4;
  private static final int MIN_TICKS = 120;
  private static final int MAX_TICKS = 600;
  private static final long MAX_NS = 400_000_000L;

  /**
   * True if a server that is alone opens after one tick, as where a program starts many servers
   * that nobody plays on for long; its first players may wait.
   */
  private static final boolean COLD = Boolean.getBoolean("carom.cold");

  /** Ticks and time in a fleet, where a server must be fast at once when another one dies. */
  private static final int MAX_FLEET_TICKS = 6_000;

  private static final long MAX_FLEET_NS = 3_000_000_000L;

  /** Rooms that are taken over: the first takes 80 ms of a processor, the 60th 9. */
  private static final int TAKEOVERS = 60;

  /** Time after which no further one is, so that a slow machine starts, too. */
  private static final long MAX_TAKEOVERS_NS = 4_000_000_000L;

  private static final Logger LOG = LoggerFactory.getLogger(GameWarmup.class);

  private long virtualNs;

  private final Runnable step;

  private GameWarmup(Runnable step) {
    this.step = step;
  }

  /**
   * Plays until enough ticks or 0.4 s have passed, 3 s in a fleet. Writes log lines, which the
   * caller may mute.
   *
   * @param games gives an instance, which is thrown away afterwards
   * @param followed folder for the journal of a room, or null if the server is alone
   * @param step told whenever it gets on
   */
  static void play(
      ServerConfig config,
      Supplier<Game> games,
      Level level,
      MessageCodec codec,
      Path followed,
      Runnable step) {
    new GameWarmup(step)
        .run(
            config.with(ServerConfig.ROOMS, 1).with(ServerConfig.STATUS_INTERVAL, 0),
            games,
            level,
            codec,
            followed);
  }

  private void run(
      ServerConfig config, Supplier<Game> games, Level level, MessageCodec codec, Path followed) {
    long beginNs = System.nanoTime();
    int mostTicks = followed != null ? MAX_FLEET_TICKS : COLD ? 1 : MAX_TICKS;
    int leastTicks = Math.min(MIN_TICKS, mostTicks);
    long mostNs = followed == null ? MAX_NS : MAX_FLEET_NS;
    Schema schema = SimulationHost.schemaOf(games.get(), level);
    InProcessNetwork network = new InProcessNetwork(codec);
    try (Server server = new Server(config, games, level, network.server(), () -> virtualNs)) {
      Extra[] extras = new Extra[Math.min(CLIENTS, config.get(ServerConfig.MAX_PLAYERS))];
      for (int i = 0; i < extras.length; i++) {
        extras[i] = new Extra(network.client().connect("", 0, 0), i, level, schema);
      }
      Practice practice = followed == null ? null : follow(server.rooms().get(0), followed);
      for (int i = 0;
          i < leastTicks || (i < mostTicks && System.nanoTime() - beginNs < mostNs);
          i++) {
        virtualNs += config.tickNs() + 1;
        for (Extra extra : extras) {
          extra.turn(server.rooms().get(0).tick());
        }
        server.tick(virtualNs);
        step.run();
      }
      for (Extra extra : extras) {
        extra.link.send(new ClientMessage.Leave());
      }
      for (int i = 0; i < 3; i++) {
        virtualNs += config.tickNs() + 1;
        server.tick(virtualNs);
      }
      if (practice != null) {
        takeOver(server, practice);
      }
    }
  }

  /** The disk and the mirror by which a room is followed for practice. */
  private record Practice(SlotDisk disk, SlotMirror mirror) {}

  private static Practice follow(Room room, Path folder) {
    try {
      SlotMirror mirror = new SlotMirror(folder, 1);
      SlotDisk disk = SlotDisk.ofFollowers(room.tickRateHz());
      room.followedBy(disk, new MirrorLink(mirror), 1, false);
      return new Practice(disk, mirror);
    } catch (IOException e) {
      LOG.debug("no room is followed for practice: {}", e.toString());
      return null; // the first real one says why
    }
  }

  private void takeOver(Server server, Practice practice) {
    Room room = server.rooms().get(0);
    long beginNs = System.nanoTime();
    try {
      for (int i = 0; i < TAKEOVERS && System.nanoTime() - beginNs < MAX_TAKEOVERS_NS; i++) {
        server.forget(room);
        practice.disk.close(); // all is there, and nothing comes once the folder is gone
        room = server.prepare(room.settings(), practice.mirror.path(), Ownership.alone());
        server.takeOver(room, practice.mirror.path());
        step.run();
      }
      practice.mirror.delete();
    } catch (IOException | IllegalArgumentException e) {
      LOG.debug("no room is taken over for practice: {}", e.toString());
    }
  }

  /** Carries a journal to a mirror in this process. */
  private record MirrorLink(SlotMirror mirror) implements SlotLink {
    @Override
    public String title() {
      return "practice";
    }

    @Override
    public void send(Step step, int slot, byte[] bytes, int offset, int length) throws IOException {
      mirror.apply(step, slot, Arrays.copyOfRange(bytes, offset, offset + length));
    }

    @Override
    public void whenThere(Runnable then) {
      then.run();
    }

    @Override
    public void await() {
      // All that was sent is there.
    }
  }

  /** A client that walks about. */
  private static final class Extra implements LinkHandler {
    private static final int LEAD_TICKS = 2;

    private final Link link;
    private final int number;
    private final Level level;
    private final Schema schema;
    private final Input input = new Input();
    private final InputDatagram datagram = new InputDatagram();
    private final byte[] buffer = new byte[InputDatagram.MAX_BYTES];
    private SnapshotDecoder decoder;
    private long declarationsDigest;
    private boolean playing;

    Extra(Link link, int number, Level level, Schema schema) {
      this.link = link;
      this.number = number;
      this.level = level;
      this.schema = schema;
      link.send(
          new ClientMessage.Hello(Protocol.VERSION, Protocol.physicsDigest(), "extra" + number, 0));
    }

    void turn(int serverTick) {
      link.poll(this, Integer.MAX_VALUE);
      if (!playing) {
        return;
      }
      int tick = serverTick + LEAD_TICKS;
      boolean right = (tick / 40 + number) % 2 == 0;
      input.move(right ? 1 : -1, tick / 25 % 3 - 1).hold(Input.JUMP, tick % 30 < 5);
      datagram.sequence = datagram.sequence + 1 & 0xffff;
      datagram.hasAck = decoder.hasAck();
      datagram.ackSequence = decoder.hasAck() ? decoder.ackSequence() : 0;
      datagram.ackBits = decoder.hasAck() ? decoder.ackBits() : 0;
      datagram.newestTick = tick;
      datagram.count = 1;
      datagram.inputs[0] = input.pack();
      link.sendDatagram(buffer, 0, datagram.encode(buffer, 0));
    }

    @Override
    public void message(Link from, Object message) {
      if (message instanceof ServerMessage.Welcome welcome) {
        datagram.epoch = welcome.epoch();
        declarationsDigest = welcome.declarationsDigest();
        FieldTables tables =
            new FieldTables(schema, ProtocolLimits.MAX_PLAYERS, ProtocolLimits.MAX_ENTITIES);
        decoder =
            new SnapshotDecoder(
                ProtocolLimits.MAX_ENTITIES,
                welcome.epoch(),
                welcome.tick(),
                welcome.tickRate(),
                schema.toldWords(Scope.PLAYER),
                new TableInbox(tables.layouts().toArray(new TableLayout[0])));
        decoder.gravity(level.gravityX(), level.gravityY());
        link.send(new ClientMessage.LevelRequest(welcome.epoch(), 0));
      } else if (message instanceof ServerMessage.LevelChunk) {
        link.send(new ClientMessage.Ready(datagram.epoch, declarationsDigest));
        playing = true;
      }
    }

    @Override
    public void datagram(Link from, byte[] bytes, int length) {
      if (decoder != null) {
        decoder.decode(bytes, 0, length);
      }
    }

    @Override
    public void closed(Link from, String reason) {
      playing = false;
    }
  }
}
