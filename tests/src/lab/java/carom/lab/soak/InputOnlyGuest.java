package carom.lab.soak;

import carom.net.protocol.ClientMessage;
import carom.net.protocol.InputDatagram;
import carom.net.protocol.MessageStream;
import carom.net.protocol.Protocol;
import carom.net.protocol.ServerMessage;
import carom.net.snapshot.SnapshotHeads;
import carom.net.transport.ClientTransport;
import carom.net.transport.ImpairedLink;
import carom.net.transport.Impairment;
import carom.net.transport.Link;
import carom.net.transport.LinkHandler;
import carom.physics.math.SimRandom;
import carom.sim.entity.Input;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.Emote;
import carom.sim.message.Message;
import carom.sim.message.MessageKind.Direction;
import carom.sim.message.MessageKinds;
import carom.sim.message.MessageRates;
import carom.testkit.OutageTransport;
import java.util.List;
import java.util.function.LongSupplier;

/**
 * A client that joins, plays, talks and comes back as a real one does, but decodes no snapshot and
 * simulates nothing: it sends inputs and acknowledges every datagram. For the server it is as much
 * work as any client, and for the soak hardly any.
 */
final class InputOnlyGuest implements Guest, LinkHandler {
  private static final long RETRY_NS = 500_000_000L;
  private static final int MOST_ARRIVALS = 1_000;

  /** Silence after which the link is given up, as a real client does. */
  private static final long SILENCE_NS = 6_000_000_000L;

  /** Inputs that each datagram repeats. */
  private static final int REPEATED = 6;

  private static final int RING = 16;
  private static final int MIN_MARGIN = 1;
  private static final int MAX_MARGIN = 4;

  private final String name;
  private final OutageTransport line;
  private final LongSupplier clock;
  private final SimRandom random;
  private final int near;
  private final MessageKinds kinds = new MessageKinds();
  private final MessageRates rates = MessageRates.ofClient(kinds);
  private final InputDatagram datagram = new InputDatagram();
  private final byte[] buffer = new byte[InputDatagram.MAX_BYTES];
  private final long[] inputs = new long[RING];
  private final Input held = new Input();
  private Impairment network;
  private ImpairedLink link;
  private long retryNs = Long.MIN_VALUE;
  private long blackoutEndNs;
  private boolean greeted;
  private long lastHeardNs;
  private boolean frozen;
  private boolean gone;
  private ServerMessage.Welcome welcome;
  private MessageStream stream = new MessageStream();
  private SnapshotHeads heads;
  private boolean heardAny;
  private long tickNs;
  private long heardNs;
  private int lead = MIN_MARGIN;
  private int lastTick;
  private int sampled;

  InputOnlyGuest(
      String name,
      ClientTransport transport,
      LongSupplier clock,
      Impairment network,
      boolean predicts,
      long seed) {
    this.name = name;
    line = new OutageTransport(transport);
    this.clock = clock;
    this.network = network.withSeed(seed);
    near = predicts ? InputDatagram.NEAR_ISLAND : InputDatagram.NEAR_NONE;
    random = new SimRandom(seed);
  }

  @Override
  public void update(long nowNs) {
    if (line.isDead() && nowNs - blackoutEndNs >= 0) {
      line.dead(false);
    }
    if (gone || frozen) {
      return;
    }
    if (link == null) {
      if (retryNs == Long.MIN_VALUE || nowNs - retryNs >= 0) {
        connect();
      }
      return;
    }
    greet();
    link.poll(this, MOST_ARRIVALS);
    if (link != null && nowNs - lastHeardNs > SILENCE_NS) {
      drop("nothing was heard");
    }
    if (link != null && heads != null) {
      sendInputs(nowNs);
      stream.flush((number, bytes) -> link.send(new ClientMessage.GameMessage(number, bytes)));
    }
  }

  private void connect() {
    link = new ImpairedLink(line.connect("localhost", 0, 0), network, clock);
    greeted = false;
    lastHeardNs = clock.getAsLong();
  }

  private void greet() {
    if (greeted || link.state() != Link.State.OPEN) {
      return;
    }
    greeted = true;
    long secret = welcome == null ? 0 : welcome.sessionSecret();
    link.send(new ClientMessage.Hello(Protocol.VERSION, Protocol.physicsDigest(), name, secret));
  }

  private void sendInputs(long nowNs) {
    int target = heads.newestTick() + (int) ((nowNs - heardNs) / tickNs) + lead;
    if (target <= lastTick) {
      return;
    }
    lastTick = Math.max(lastTick, target - RING);
    while (lastTick < target) {
      lastTick++;
      sampled = Math.min(RING, sampled + 1);
      inputs[lastTick & RING - 1] = sample();
    }
    InputDatagram d = datagram;
    d.epoch = welcome.epoch();
    d.sequence = d.sequence + 1 & 0xffff;
    heads.acknowledge(d);
    d.near = near;
    d.newestTick = lastTick;
    d.count = Math.min(REPEATED, sampled);
    for (int i = 0; i < d.count; i++) {
      d.inputs[i] = inputs[lastTick - i & RING - 1];
    }
    link.sendDatagram(buffer, 0, d.encode(buffer, 0));
  }

  /** Plays as {@code Scripts.wander} does. */
  private long sample() {
    if (random.nextInt(12) == 0) {
      held.move(2 * random.nextFloat() - 1, 2 * random.nextFloat() - 1);
      held.hold(Input.ACTION, random.nextInt(3) == 0);
      held.hold(Input.JUMP, random.nextInt(3) == 0);
    }
    return held.pack();
  }

  // ---- what the server says

  @Override
  public void message(Link from, Object message) {
    lastHeardNs = clock.getAsLong();
    if (message instanceof ServerMessage.Welcome w) {
      begin(w);
    } else if (message instanceof ServerMessage.Heard heard) {
      stream.begin(heard.number());
      from.send(new ClientMessage.Heard(stream.lastHeard()));
    } else if (message instanceof ServerMessage.GameMessage m) {
      stream.hear(m.number());
    } else if (message instanceof ServerMessage.Refused) {
      drop("refused");
    }
  }

  private void begin(ServerMessage.Welcome w) {
    if (welcome == null
        || w.sessionSecret() != welcome.sessionSecret()
        || !w.room().equals(welcome.room())
        || w.match() != welcome.match()
        || w.incarnation() != welcome.incarnation()) {
      stream = new MessageStream();
    }
    stream.unlink();
    welcome = w;
    tickNs = 1_000_000_000L / w.tickRate();
    heads = new SnapshotHeads(w.epoch(), w.tick());
    heardNs = clock.getAsLong();
    heardAny = false;
    lastTick = w.tick();
    sampled = 0;
    // It needs no level, as it shows nothing.
    link.send(new ClientMessage.Ready(w.epoch(), w.declarationsDigest()));
  }

  @Override
  public void datagram(Link from, byte[] bytes, int length) {
    if (heads == null) {
      return;
    }
    int before = heads.newestTick();
    if (!heads.take(bytes, length)) {
      return;
    }
    heardAny = true;
    lastHeardNs = clock.getAsLong();
    if (heads.newestTick() > before) {
      heardNs = clock.getAsLong();
      int margin = heads.margin();
      lead = Math.max(1, Math.min(RING, margin < MIN_MARGIN ? lead + 1 : lead));
      lead = margin > MAX_MARGIN ? lead - 1 : lead;
    }
  }

  @Override
  public void closed(Link from, String reason) {
    if (from == link) {
      drop(reason);
    }
  }

  private void drop(String reason) {
    link.close(reason);
    link = null;
    heads = null;
    stream.unlink();
    retryNs = clock.getAsLong() + RETRY_NS;
  }

  // ---- what happens to it

  @Override
  public boolean isConnected() {
    return link != null && !gone;
  }

  @Override
  public boolean isPlaying() {
    return isConnected() && heardAny;
  }

  @Override
  public String name() {
    return name;
  }

  @Override
  public String room() {
    return welcome == null ? "" : welcome.room();
  }

  @Override
  public int playerId() {
    return welcome == null ? -1 : welcome.playerId();
  }

  @Override
  public void cut() {
    link.close("the line was cut");
  }

  @Override
  public void blackout(double seconds) {
    blackoutEndNs = clock.getAsLong() + (long) (seconds * 1e9);
    line.dead(true);
  }

  @Override
  public void freeze(boolean stopped) {
    frozen = stopped;
  }

  @Override
  public void impair(Impairment next) {
    network = next;
    if (link != null) {
      link.impair(next, next);
    }
  }

  @Override
  public void say(String text) {
    offer(BuiltInKinds.SAY.of(false, text));
  }

  @Override
  public void show(Emote emote) {
    offer(BuiltInKinds.EMOTE.of(emote));
  }

  private void offer(Message message) {
    if (rates.take(message.kind(), clock.getAsLong() * 1e-9)
        && stream.waiting() < MessageStream.KEPT) {
      stream.offer(kinds.encode(message, Direction.FROM_CLIENT));
    }
  }

  @Override
  public void changeRoom(String to) {
    link.send(new ClientMessage.ChangeRoom(to));
  }

  @Override
  public void end(boolean dies) {
    gone = true;
    if (link != null) {
      if (!dies) {
        link.send(new ClientMessage.Leave());
      }
      link.close(dies ? "the process died" : "the player left");
    }
  }

  @Override
  public List<Object> roots() {
    return link == null ? List.of(stream) : List.of(stream, link);
  }

  @Override
  public long compared() {
    return 0;
  }

  @Override
  public String toString() {
    return name;
  }
}
