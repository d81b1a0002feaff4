package carom.server;

import carom.fixtures.Levels;
import carom.game.Games;
import carom.net.field.FieldTables;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.InputDatagram;
import carom.net.protocol.PackedLevel;
import carom.net.protocol.Protocol;
import carom.net.protocol.ProtocolLimits;
import carom.net.protocol.ServerMessage;
import carom.net.snapshot.DecodeStatus;
import carom.net.snapshot.SnapshotDecoder;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.frame.EventRecord;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.table.TableInbox;
import carom.net.snapshot.table.TableLayout;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import carom.sim.Game;
import carom.sim.SimulationHost;
import carom.sim.entity.Input;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/**
 * The smallest client that can play: it joins, loads, acks, sends inputs and keeps what it
 * receives.
 */
final class FakeClient implements LinkHandler {
  private static final int REDUNDANCY = 4;

  final Link link;
  final List<ServerMessage> messages = new ArrayList<>();
  final OwnState own = new OwnState(4);
  final Input input = new Input();
  ServerMessage.Welcome welcome;
  ServerMessage.Refused refused;
  ServerMessage.Goodbye goodbye;
  ServerMessage.Roster roster;
  ServerMessage.Roster lastRoster;
  byte[] level;
  SnapshotDecoder decoder;
  boolean ready;
  boolean closed;
  boolean loads = true;
  boolean sends = true;
  boolean acks = true;
  int leadTicks = 2;
  int near = InputDatagram.NEAR_NONE;
  int sequence;
  int inputTick;
  long datagrams;
  long bytes;
  long undecodable;
  final long[] statuses = new long[DecodeStatus.values().length];
  Runnable onDecoded = () -> {};

  /** Whose doing the events were that came. */
  final List<Integer> eventsBy = new ArrayList<>();

  private final InputDatagram datagram = new InputDatagram();
  private final byte[] buffer = new byte[InputDatagram.MAX_BYTES];
  private final Deque<Long> sent = new ArrayDeque<>();
  private int loaded;

  /** The game that the server plays, if it is neither installed nor {@link TestGame}. */
  Game game;

  FakeClient(Link link) {
    this.link = link;
  }

  FakeClient hello(String name) {
    return hello(name, 0);
  }

  FakeClient hello(String name, long resumeSecret) {
    link.send(
        new ClientMessage.Hello(Protocol.VERSION, Protocol.physicsDigest(), name, resumeSecret));
    return this;
  }

  /** Polls, and sends one input datagram for the tick {@code leadTicks} after the server's. */
  void step(int serverTick) {
    while (link.poll(this, 1_000) > 0) {}
    if (ready && sends && !closed) {
      sendInput(serverTick + leadTicks);
    }
  }

  void sendInput(int tick) {
    datagram.epoch = welcome.epoch();
    datagram.sequence = sequence = sequence + 1 & 0xffff;
    datagram.hasAck = acks && decoder.hasAck();
    datagram.ackSequence = datagram.hasAck ? decoder.ackSequence() : 0;
    datagram.ackBits = datagram.hasAck ? decoder.ackBits() : 0;
    if (tick != inputTick) {
      sent.addFirst(input.pack());
      inputTick = tick;
    }
    while (sent.size() > REDUNDANCY) {
      sent.removeLast();
    }
    datagram.newestTick = tick;
    datagram.near = near;
    datagram.count = 0;
    for (long packed : sent) {
      datagram.inputs[datagram.count++] = packed;
    }
    link.sendDatagram(buffer, 0, datagram.encode(buffer, 0));
  }

  /** The fields of the game that the server plays. */
  private Schema schema() {
    Level without = Levels.emptyArena(); // triggers, which no level of these tests has
    if (game != null) {
      return SimulationHost.schemaOf(game, without);
    }
    boolean isTest = welcome.game().equals("test");
    return SimulationHost.schemaOf(
        isTest ? new TestGame(0) : Games.create(welcome.game()), without);
  }

  @Override
  public void message(Link from, Object message) {
    messages.add((ServerMessage) message);
    if (message instanceof ServerMessage.Welcome w) {
      welcome = w;
      level = new byte[w.packedSize()];
      loaded = 0;
      FieldTables layouts =
          new FieldTables(schema(), ProtocolLimits.MAX_PLAYERS, ProtocolLimits.MAX_ENTITIES);
      decoder =
          new SnapshotDecoder(
              ProtocolLimits.MAX_ENTITIES,
              w.epoch(),
              w.tick(),
              w.tickRate(),
              schema().toldWords(Scope.PLAYER),
              new TableInbox(layouts.layouts().toArray(new TableLayout[0])));
      if (loads) {
        link.send(new ClientMessage.LevelRequest(welcome.epoch(), 0));
      }
    } else if (message instanceof ServerMessage.LevelChunk chunk) {
      System.arraycopy(chunk.bytes(), 0, level, chunk.offset(), chunk.bytes().length);
      loaded = chunk.offset() + chunk.bytes().length;
      if (loaded < level.length) {
        link.send(new ClientMessage.LevelRequest(welcome.epoch(), loaded));
      } else {
        level = PackedLevel.unpack(level, welcome.levelSize());
        start(level);
        link.send(new ClientMessage.Ready(welcome.epoch(), welcome.declarationsDigest()));
        ready = true;
      }
    } else if (message instanceof ServerMessage.Refused r) {
      refused = r;
    } else if (message instanceof ServerMessage.Goodbye g) {
      goodbye = g;
    } else if (message instanceof ServerMessage.Roster r) {
      List<ServerMessage.RosterEntry> players = new ArrayList<>();
      if (roster != null) {
        players.addAll(roster.entries());
      }
      r.applyTo(players);
      lastRoster = r;
      roster = new ServerMessage.Roster(players);
    }
  }

  private void start(byte[] json) {
    try {
      Level parsed = Level.parse("level", json);
      decoder.gravity(parsed.gravityX(), parsed.gravityY());
      decoder.level(
          FrameState.of(ProtocolLimits.MAX_ENTITIES, frame -> parsed.forEachBody(frame::put)));
    } catch (LevelException e) {
      throw new AssertionError(e);
    }
  }

  @Override
  public void datagram(Link from, byte[] content, int length) {
    datagrams++;
    bytes += length;
    DecodeStatus status = decoder.decode(content, 0, length);
    statuses[status.ordinal()]++;
    if (status == DecodeStatus.OK) {
      if (decoder.hasOwn()) {
        own.set(decoder.own());
      }
      for (EventRecord e; (e = decoder.events().poll()) != null; ) {
        eventsBy.add(e.player);
      }
      onDecoded.run();
    } else {
      undecodable++;
    }
  }

  @Override
  public void closed(Link from, String reason) {
    closed = true;
  }

  List<String> notices() {
    List<String> texts = new ArrayList<>();
    for (ServerMessage message : messages) {
      if (message instanceof ServerMessage.Notice notice) {
        texts.add(notice.text());
      }
    }
    return texts;
  }
}
