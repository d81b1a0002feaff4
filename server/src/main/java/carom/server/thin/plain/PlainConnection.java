package carom.server.thin.plain;

import carom.net.admission.AddressGroup;
import carom.net.admission.Entrance;
import carom.net.admission.TokenBucket;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.RefusalReason;
import carom.server.thin.GameClasses;
import carom.server.thin.ThinClientMessage;
import carom.server.thin.ThinNews;
import carom.server.thin.ThinServerMessage;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.SocketChannel;
import java.util.Arrays;
import java.util.List;

/**
 * A TCP connection at the door, from its first byte to its last, with the UDP address that belongs
 * to it. Bytes are read on the door's thread and datagrams on that of the UDP port; any thread may
 * send.
 */
final class PlainConnection implements Entrance.Guest {
  private static final long NANOS_PER_MS = 1_000_000L;
  private static final long SECOND_NANOS = 1_000_000_000L;
  private static final int LENGTH_BYTES = 4;

  /** Bytes given to the system at a time; it copies all that it is offered. */
  private static final int MAX_WRITE = 32 * 1_024;

  /** Time between two pings: KryoNet gives up after 12 s without a byte. */
  private static final long PING_NANOS = 2 * SECOND_NANOS;

  /** Time for the last words of a connection that closes, and for the client to hang up. */
  private static final long LEAVING_NANOS = 2 * SECOND_NANOS;

  private final PlainDoor door;
  private final SocketChannel channel;
  private final int id;
  private final InetAddress address;
  private final String remote;
  private final AddressGroup origin;
  private final PlainEncoder encoder = new PlainEncoder(); // with the output

  // Guarded by the output.
  private final KryoOutput out = new KryoOutput();
  private int sent;
  private long progressNs;
  private boolean saidLast;
  private boolean ended;

  // The door's thread only.
  private SelectionKey key;
  private byte[] partial = {};
  private final TokenBucket frames;
  private long secondNs;
  private int bytesOfSecond;
  private int unheardBytes;
  private final long acceptedNs;
  private long frameNs;
  private long leavingUntilNs;
  private boolean leaving;
  private boolean finished;
  private int pings;
  private long pingNs;
  private boolean pingWaits;

  // The UDP port's thread only.
  private final TokenBucket datagrams;

  private final Object udpLock = new Object();
  private InetSocketAddress udp; // guarded by its lock
  private volatile GameClasses classes; // that the client may send
  private volatile PlainLink link;
  private volatile boolean closed;
  private volatile String closeReason;

  PlainConnection(
      PlainDoor door, SocketChannel channel, InetSocketAddress from, int id, long nowNs) {
    this.door = door;
    this.channel = channel;
    this.id = id;
    address = from.getAddress();
    remote = AddressGroup.remote(address, from.getPort());
    origin = AddressGroup.of(address);
    acceptedNs = nowNs;
    frameNs = nowNs;
    progressNs = nowNs;
    secondNs = nowNs;
    pingNs = nowNs;
    PlainLimits limits = door.limits();
    frames = new TokenBucket(limits.framesPerSecond(), limits.framesPerSecond());
    datagrams = new TokenBucket(limits.datagramsPerSecond(), limits.datagramsPerSecond());
  }

  int id() {
    return id;
  }

  SocketChannel channel() {
    return channel;
  }

  @Override
  public AddressGroup origin() {
    return origin;
  }

  /** Returns that it waits until it has asked to join, and not after. */
  @Override
  public Entrance.Proof proof() {
    return link == null && !leaving && !closed ? Entrance.Proof.UNPROVEN : Entrance.Proof.IN;
  }

  /** Tells the client its number; the door's thread. */
  void begin(SelectionKey newKey) {
    key = newKey;
    synchronized (out) {
      PlainEncoder.registerTcp(out, id);
      flush();
    }
  }

  // Reading.

  /** Takes bytes that came by TCP; the door's thread. */
  void read(ByteBuffer buffer, PlainDecoder decoder, long nowNs) {
    int fresh = buffer.remaining();
    if (leaving) { // what it still says doesn't count, as long as it isn't much
      unheardBytes += fresh;
      if (unheardBytes > door.limits().bytesPerSecond()) {
        close("");
      }
      return;
    }
    if (nowNs - secondNs >= SECOND_NANOS) {
      secondNs = nowNs;
      bytesOfSecond = 0;
    }
    bytesOfSecond += fresh;
    if (bytesOfSecond > door.limits().bytesPerSecond()) {
      expel("bytesPerSecond=" + door.limits().bytesPerSecond() + " is the limit of a client");
      return;
    }
    byte[] bytes = new byte[partial.length + fresh];
    System.arraycopy(partial, 0, bytes, 0, partial.length);
    buffer.get(bytes, partial.length, fresh);
    int from = 0;
    while (!leaving && bytes.length - from >= LENGTH_BYTES) {
      int length = ByteBuffer.wrap(bytes).getInt(from);
      if (length <= 0 || length > PlainDecoder.MAX_BYTES) {
        expel("a message has length=" + length + ", outside 1.." + PlainDecoder.MAX_BYTES);
        return;
      }
      if (bytes.length - from - LENGTH_BYTES < length) {
        break;
      }
      from += LENGTH_BYTES;
      frame(decoder, bytes, from, from + length, nowNs);
      from += length;
    }
    partial = Arrays.copyOfRange(bytes, from, bytes.length);
  }

  private void frame(PlainDecoder decoder, byte[] bytes, int from, int to, long nowNs) {
    if (!frames.take(nowNs)) {
      expel("messagesPerSecond=" + door.limits().framesPerSecond() + " is the limit of a client");
      return;
    }
    Object message = decoder.decode(bytes, from, to, classes);
    PlainLink present = link;
    if (present != null) {
      present.counters().messageBytesIn.addAndGet(to - from);
    }
    if (message == null) {
      expel(
          "a message can't be read: "
              + decoder.problem()
              + "; register classes by Plain.register, with this server's carom-plain, and by what"
              + " carom plain writes for its game");
      return;
    }
    frameNs = nowNs;
    if (message instanceof PlainControl control) {
      control(control, nowNs);
    } else {
      message((ThinClientMessage) message);
    }
  }

  private void control(PlainControl control, long nowNs) {
    PlainLink to = link;
    if (to != null) {
      to.alive();
    }
    if (control instanceof PlainControl.Ping ping) {
      if (!ping.isReply()) {
        answer(ping.id());
      } else if (pingWaits && ping.id() == pings) {
        pingWaits = false;
        if (to != null) {
          to.measured((int) ((nowNs - pingNs) / NANOS_PER_MS));
        }
      }
    }
  }

  private void answer(int ping) {
    synchronized (out) {
      if (ended || isFull()) {
        return; // a client that doesn't read needs no answer
      }
      PlainEncoder.ping(out, ping, true);
      flush();
    }
  }

  private void message(ThinClientMessage message) {
    PlainLink to = link;
    if (to != null) {
      to.take(message);
      return;
    }
    if (!(message instanceof ThinClientMessage.Join)
        && !(message instanceof ThinClientMessage.ListRooms)) {
      expel(message.getClass().getSimpleName() + " came before Join");
      return;
    }
    synchronized (udpLock) { // from here on the UDP address stays what it is
      to = new PlainLink(this, remote, udp);
      if (door.network() != null) {
        to.simulate(door.network());
      }
      link = to;
    }
    to.take(message);
    door.joined(this, to);
  }

  /**
   * Notes from where the client's datagrams come; the UDP port's thread.
   *
   * @return false if the address isn't that of the TCP connection, or there is one already
   */
  boolean bind(InetSocketAddress from) {
    if (!from.getAddress().equals(address)) {
      return false;
    }
    synchronized (udpLock) {
      if (udp != null || link != null || closed) {
        return false;
      }
      udp = from;
    }
    return true;
  }

  /** Tells the client by TCP that its datagrams arrive; any thread. */
  void confirmUdp() {
    synchronized (out) {
      if (!ended) {
        PlainEncoder.registerUdp(out, id);
        flush();
      }
    }
  }

  InetSocketAddress udp() {
    synchronized (udpLock) {
      return udp;
    }
  }

  /** Takes a datagram; the UDP port's thread. Nothing in it closes the connection. */
  void datagram(PlainDecoder decoder, byte[] bytes, int length, long nowNs) {
    PlainLink to = link;
    if (!datagrams.take(nowNs)) {
      door.counters().excessDatagrams.incrementAndGet();
      return;
    }
    Object message = decoder.decode(bytes, 0, length, null);
    boolean repeated = message instanceof PlainControl.RegisterUdp;
    if (message instanceof PlainControl.Ping ping && !ping.isReply()) {
      answer(ping.id()); // by TCP, as KryoNet does
    }
    if (to == null) {
      return; // it hasn't joined
    }
    if (message instanceof PlainControl) {
      to.alive();
    } else if (message instanceof ThinClientMessage.Input
        || message instanceof ThinClientMessage.View
        || message instanceof ThinClientMessage.Alive) {
      to.counters().datagramsIn.incrementAndGet();
      to.counters().datagramBytesIn.addAndGet(length);
      to.take((ThinClientMessage) message);
    } else if (!repeated) {
      to.counters().malformed.incrementAndGet();
      door.counters().malformedDatagrams.incrementAndGet();
    }
  }

  // Sending.

  /**
   * Writes the game's messages by classes that the client has; null by name. What the client could
   * send before, it still can.
   */
  void use(GameClasses ofGame) {
    if (ofGame != null) {
      classes = ofGame;
    }
    synchronized (out) {
      encoder.use(ofGame);
    }
  }

  /**
   * Sends messages; any thread.
   *
   * @return their bytes, or -1 if too much waits; 0 if the connection has ended
   */
  int tell(List<ThinNews> news) {
    synchronized (out) {
      if (ended) {
        return 0;
      }
      int bytes = 0;
      for (int i = 0; i < news.size() && !saidLast; i++) {
        if (isFull()) {
          return -1;
        }
        int before = out.length();
        encoder.encode(out, news.get(i).message());
        saidLast = news.get(i).message().isLast();
        bytes += out.length() - before;
      }
      flush(); // once, as each call of the system costs more than a message
      return bytes;
    }
  }

  /** Returns the number of the newest match that was told, from 1; the thread that tells it. */
  int matches() {
    return encoder.matches();
  }

  /** Sends a message that is encoded already; any thread. */
  boolean send(byte[] bytes, int length) {
    synchronized (out) {
      if (ended || saidLast || isFull()) {
        return false;
      }
      out.fixed(length);
      out.write(bytes, 0, length);
      flush();
      return true;
    }
  }

  boolean sendDatagram(InetSocketAddress to, byte[] bytes, int length) {
    return !closed && door.sendDatagram(to, bytes, length);
  }

  /** Returns whether nothing waits on this side; any thread. */
  boolean hasSentAll() {
    synchronized (out) {
      return out.length() == 0;
    }
  }

  private boolean isFull() {
    return out.length() - sent > door.limits().unsentBytes();
  }

  /** Gives the system what it takes; the rest waits until it takes more. With the output's lock. */
  private void flush() {
    if (sent == 0) {
      progressNs = System.nanoTime();
    }
    try {
      while (sent < out.length()) {
        int offered = Math.min(MAX_WRITE, out.length() - sent);
        int taken = channel.write(ByteBuffer.wrap(out.bytes(), sent, offered));
        if (taken > 0) {
          sent += taken;
          progressNs = System.nanoTime();
        }
        if (taken < offered) {
          break;
        }
      }
      if (sent == out.length() || sent > 2 * MAX_WRITE) {
        out.drop(sent);
        sent = 0;
      }
      boolean waits = out.length() > 0;
      if (key.isValid() && waits != ((key.interestOps() & SelectionKey.OP_WRITE) != 0)) {
        key.interestOps(
            waits ? SelectionKey.OP_READ | SelectionKey.OP_WRITE : SelectionKey.OP_READ);
        if (waits) {
          door.wake();
        }
      }
    } catch (IOException e) {
      ended = true;
      requestClose("the connection broke");
    }
  }

  /** Sends what waited; the door's thread. */
  void writable() {
    synchronized (out) {
      if (!ended) {
        flush();
      }
    }
  }

  // The end.

  /** Closes soon, when what was sent before has gone out; any thread. */
  void requestClose(String reason) {
    if (closeReason == null) {
      closeReason = reason;
    }
    door.requestClose(this);
  }

  /** Tells a client that it may not come in, and closes; the door's thread. */
  void refuse(RefusalReason reason, String text) {
    synchronized (out) {
      if (!ended) {
        PlainEncoder.registerUdp(out, id); // without it KryoNet doesn't listen
        encoder.encode(out, new ThinServerMessage.Refused(reason.name(), text));
        saidLast = true;
        flush();
      }
    }
    leave(text, System.nanoTime());
  }

  /** Closes a connection that breaks the rules, and tells it why; the door's thread. */
  private void expel(String why) {
    door.counters().expelled.incrementAndGet();
    PlainLink to = link;
    if (to == null) {
      refuse(RefusalReason.BAD_REQUEST, why);
      return;
    }
    to.gone(why);
    tell(
        List.of(
            new ThinNews(new ThinServerMessage.Goodbye(GoodbyeReason.PROTOCOL_ERROR.name(), why))));
    leave(why, System.nanoTime());
  }

  /** Begins the end: what waits still goes out; the door's thread. */
  void leave(String reason, long nowNs) {
    if (leaving || closed) {
      return;
    }
    leaving = true;
    leavingUntilNs = nowNs + LEAVING_NANOS;
    if (closeReason == null) {
      closeReason = reason;
    }
    door.left(this);
    finish();
  }

  /** Says that nothing more comes as soon as all has gone out. */
  private void finish() {
    synchronized (out) {
      if (finished || (!ended && out.length() > 0)) {
        return;
      }
      ended = true;
      finished = true;
      try {
        channel.shutdownOutput(); // a close would drop what the client hasn't read yet
      } catch (IOException e) {
        leavingUntilNs = System.nanoTime();
      }
    }
  }

  /** Looks at deadlines; the door's thread, several times a second. */
  void sweep(long nowNs) {
    PlainLimits limits = door.limits();
    if (leaving) {
      finish();
      if (nowNs - leavingUntilNs >= 0) {
        close("");
      }
      return;
    }
    if (link == null && nowNs - acceptedNs > limits.joinMillis() * NANOS_PER_MS) {
      door.counters().expired.incrementAndGet();
      refuse(RefusalReason.TOO_SLOW, "No Join came within " + limits.joinMillis() + " ms.");
    } else if (nowNs - frameNs > limits.idleMillis() * NANOS_PER_MS) {
      expel("nothing came for " + limits.idleMillis() + " ms");
    } else if (isStalled(nowNs, limits)) {
      door.counters().expelled.incrementAndGet();
      close("the client took nothing for " + limits.stallMillis() + " ms");
    } else if (link != null && nowNs - pingNs > PING_NANOS) {
      ping(nowNs);
    }
  }

  private boolean isStalled(long nowNs, PlainLimits limits) {
    synchronized (out) {
      return out.length() > 0 && nowNs - progressNs > limits.stallMillis() * NANOS_PER_MS;
    }
  }

  private void ping(long nowNs) {
    synchronized (out) {
      if (ended || out.length() > 0) {
        return; // bytes are on their way
      }
      pingNs = nowNs;
      pingWaits = true;
      PlainEncoder.ping(out, ++pings, false);
      flush();
    }
  }

  /** Closes at once; the door's thread. */
  void close(String reason) {
    if (closed) {
      return;
    }
    closed = true;
    synchronized (out) {
      ended = true;
      out.drop(out.length());
      sent = 0;
    }
    try {
      channel.close();
    } catch (IOException e) {
      door.counters().errors.add(e);
    }
    if (closeReason == null) {
      closeReason = reason;
    }
    PlainLink to = link;
    if (to != null) {
      to.gone(closeReason);
    }
    door.forget(this, to != null, leaving);
  }
}
