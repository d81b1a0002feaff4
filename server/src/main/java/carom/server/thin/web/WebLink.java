package carom.server.thin.web;

import carom.net.admission.TokenBucket;
import carom.server.thin.ThinClientMessage;
import carom.server.thin.ThinLink;
import carom.server.thin.ThinNews;
import carom.server.thin.ThinServerMessage;
import carom.server.thin.ThinSnapshot;
import io.undertow.websockets.core.AbstractReceiveListener;
import io.undertow.websockets.core.BufferedBinaryMessage;
import io.undertow.websockets.core.BufferedTextMessage;
import io.undertow.websockets.core.CloseMessage;
import io.undertow.websockets.core.WebSocketCallback;
import io.undertow.websockets.core.WebSocketChannel;
import io.undertow.websockets.core.WebSockets;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * A thin client behind a WebSocket.
 *
 * <p>What is told waits in order, within a bound. A snapshot goes only if no other one and little
 * else waits; the next one replaces it. What the system keeps beyond that is bounded, too: pings go
 * along with the snapshots, and while an answer is late, no further snapshot goes. The pings
 * measure the round trip.
 */
final class WebLink extends ThinLink {
  /** Largest message of a client, bytes. */
  static final int MAX_MESSAGE_BYTES = 8_192;

  /** Messages a second that a client may send in the long run, and at once. */
  static final int MAX_MESSAGES_PER_SECOND = 300;

  /** Bytes that may wait for a client; one message may be larger if nothing else waits. */
  static final int MAX_UNSENT_BYTES = 4 * 1_024 * 1_024;

  /** Bytes that may wait before a snapshot: events of the same tick, but no backlog. */
  private static final int MAX_NEWS_BYTES = 8_192;

  /** Time after which a client counts as gone that doesn't even answer pings, s. */
  static final int SILENCE_S = 15;

  /** Time in which a client must take a message, s. */
  static final int STALLED_S = 20;

  private static final int FAREWELL_S = 2;
  private static final long NS_PER_S = 1_000_000_000L;
  private static final long NS_PER_MS = 1_000_000L;

  /** Time between two pings while snapshots go. */
  private static final long PING_NS = 200 * NS_PER_MS;

  /** Time beyond the round trip and the next ping in which snapshots are answered. */
  private static final long LATE_NS = PING_NS + 150 * NS_PER_MS;

  /** Time for which the least round trip counts, at least. */
  private static final long LEAST_NS = 10 * NS_PER_S;

  /** Most characters of a reason in a close frame: UTF-8 of them fits its 123 bytes. */
  private static final int MAX_REASON = 120;

  private static final int WINDOW = 64; // a power of two

  private static final Function<ThinServerMessage, byte[]> JSON = JsonWriter::write;

  private final WebSocketChannel channel;
  private final boolean isPlainText;
  private final Consumer<Throwable> errors;
  private final JsonReader reader = new JsonReader();
  private final TokenBucket messages =
      new TokenBucket(MAX_MESSAGES_PER_SECOND, MAX_MESSAGES_PER_SECOND);
  private final Object lock = new Object();

  // Guarded by the lock.
  private final Bytes snapshotBytes = new Bytes();
  private BinaryForm binary; // null while JSON is spoken
  private boolean welcomed;
  private int unsent;
  private int unsentSnapshots;
  private long unsentBytes;
  private long progressNs;
  private long heardNs;
  private long closedNs;
  private boolean saidLast;
  private boolean hungUp;
  private final int[] sentTick = new int[WINDOW];
  private final long[] sentNs = new long[WINDOW];
  private int firstUnseen;
  private int nextSent;
  private int pings;
  private long pingNs;
  private final long[] pingedNs = new long[WINDOW];
  private final int[] pingedSent = new int[WINDOW];
  private long leastNs = Long.MAX_VALUE;
  private long leastBeforeNs = Long.MAX_VALUE;
  private long leastSinceNs;
  private int smoothMs;

  /**
   * Creates an open link.
   *
   * @param remote the client's address and port
   * @param isPlainText whether others on the way can read what is sent
   * @param errors takes errors of this server, which close the link
   */
  WebLink(
      WebSocketChannel channel, String remote, boolean isPlainText, Consumer<Throwable> errors) {
    super(remote, true);
    this.isPlainText = isPlainText;
    this.channel = channel;
    this.errors = errors;
    long nowNs = System.nanoTime();
    heardNs = nowNs;
    progressNs = nowNs;
    pingNs = nowNs - PING_NS;
    leastSinceNs = nowNs;
  }

  /** Begins to read. The thread that reads and writes sockets. */
  void begin() {
    channel.addCloseTask(closed -> lost("the connection ended"));
    channel.getReceiveSetter().set(new Listener());
    channel.resumeReceives();
  }

  /** Passes what the WebSocket has read on. */
  private final class Listener extends AbstractReceiveListener {
    @Override
    protected long getMaxTextBufferSize() {
      return MAX_MESSAGE_BYTES;
    }

    @Override
    protected long getMaxBinaryBufferSize() {
      return MAX_MESSAGE_BYTES;
    }

    @Override
    protected void onFullTextMessage(WebSocketChannel from, BufferedTextMessage message) {
      take(message.getData().getBytes(StandardCharsets.UTF_8), false);
    }

    @Override
    protected void onFullBinaryMessage(WebSocketChannel from, BufferedBinaryMessage message)
        throws IOException {
      var data = message.getData();
      byte[] bytes;
      try {
        ByteBuffer whole = WebSockets.mergeBuffers(data.getResource());
        bytes = new byte[whole.remaining()];
        whole.get(bytes);
      } finally {
        data.free();
      }
      take(bytes, true);
    }

    @Override
    protected void onFullPongMessage(WebSocketChannel from, BufferedBinaryMessage message)
        throws IOException {
      var data = message.getData();
      try {
        ByteBuffer bytes = WebSockets.mergeBuffers(data.getResource());
        if (bytes.remaining() == Integer.BYTES) {
          answered(bytes.getInt());
        }
      } finally {
        data.free();
      }
      isWithinRate();
    }

    @Override
    protected void onError(WebSocketChannel on, Throwable error) {
      lost("the connection broke: " + error.getMessage());
      super.onError(on, error);
    }
  }

  private boolean isWithinRate() {
    long nowNs = System.nanoTime();
    synchronized (lock) {
      heardNs = nowNs;
    }
    if (messages.take(nowNs)) {
      return true;
    }
    violate("more than " + MAX_MESSAGES_PER_SECOND + " messages a second");
    return false;
  }

  private void take(byte[] bytes, boolean isBinary) {
    if (state() != State.OPEN || !isWithinRate()) {
      return;
    }
    counters().messageBytesIn.addAndGet(bytes.length);
    try {
      ThinClientMessage message = isBinary ? BinaryForm.readInput(bytes) : reader.read(bytes);
      if (message instanceof ThinClientMessage.Input input) {
        seen(input.seenTick());
      } else if (message instanceof ThinClientMessage.Join) {
        speak(reader.wantsBinary());
      }
      receive(message);
    } catch (BadMessage e) {
      counters().malformed.incrementAndGet();
      violate(e.getMessage());
    } catch (RuntimeException e) {
      errors.accept(e);
      violate("this message makes the server fail");
    }
  }

  private void speak(boolean isBinary) {
    synchronized (lock) {
      if (!welcomed) {
        binary = isBinary ? new BinaryForm() : null;
      }
    }
  }

  /** Closes the link because of something that the client did. */
  private void violate(String what) {
    boolean isIn;
    synchronized (lock) {
      isIn = welcomed;
    }
    if (state() == State.OPEN) {
      tell(
          isIn
              ? new ThinServerMessage.Goodbye("PROTOCOL_ERROR", what)
              : new ThinServerMessage.Refused("BAD_REQUEST", what));
    }
    close(what);
  }

  @Override
  protected boolean write(List<ThinNews> news) {
    for (int i = 0; i < news.size(); ) {
      int end = i + 1;
      while (isEvent(news.get(i)) && end < news.size() && isEvent(news.get(end))) {
        end++; // a frame costs more than an event
      }
      byte[] text = isEvent(news.get(i)) ? events(news.subList(i, end)) : news.get(i).bytes(JSON);
      if (!write(news.get(i).message(), text)) {
        return false;
      }
      i = end;
    }
    return true;
  }

  private static boolean isEvent(ThinNews news) {
    return news.message() instanceof ThinServerMessage.Event;
  }

  private static byte[] events(List<ThinNews> events) {
    Bytes text = new Bytes().ascii("{\"events\":{\"events\":[");
    for (int i = 0; i < events.size(); i++) {
      text.ascii(i == 0 ? "" : ",").put(events.get(i).bytes(JSON));
    }
    return text.ascii("]}}").toArray();
  }

  private boolean write(ThinServerMessage message, byte[] text) {
    if (!channel.isOpen()) {
      return false;
    }
    synchronized (lock) {
      if (hungUp || saidLast) {
        return false;
      }
      if (unsent == 0 || unsentBytes + text.length <= MAX_UNSENT_BYTES) {
        if (message instanceof ThinServerMessage.Welcome) {
          welcomed = true;
        } else if (message instanceof ThinServerMessage.Match) {
          binary = binary == null ? null : new BinaryForm();
          firstUnseen = nextSent;
        }
        saidLast = message.isLast();
        send(ByteBuffer.wrap(text), true, false);
        counters().messageBytesOut.addAndGet(text.length);
        return true;
      }
    }
    close("unsentBytes=" + MAX_UNSENT_BYTES + " wait, the limit");
    return false;
  }

  /** Sends a frame. The caller holds the lock, so that frames go in order. */
  private void send(ByteBuffer bytes, boolean isText, boolean isSnapshot) {
    int size = bytes.remaining();
    if (unsent == 0) {
      progressNs = System.nanoTime();
    }
    unsent++;
    unsentSnapshots += isSnapshot ? 1 : 0;
    unsentBytes += size;
    WebSocketCallback<Void> sent =
        new WebSocketCallback<>() {
          @Override
          public void complete(WebSocketChannel on, Void context) {
            left(size, isSnapshot);
          }

          @Override
          public void onError(WebSocketChannel on, Void context, Throwable error) {
            left(size, isSnapshot);
            lost("the connection broke: " + error.getMessage());
            end();
          }
        };
    if (isText) {
      WebSockets.sendText(bytes, channel, sent);
    } else {
      WebSockets.sendBinary(bytes, channel, sent);
    }
  }

  private void left(int size, boolean wasSnapshot) {
    synchronized (lock) {
      unsent--;
      unsentSnapshots -= wasSnapshot ? 1 : 0;
      unsentBytes -= size;
      progressNs = System.nanoTime();
    }
  }

  @Override
  public boolean takesSnapshot() {
    long nowNs = System.nanoTime();
    synchronized (lock) {
      if (unsentSnapshots > 0 || unsentBytes > MAX_NEWS_BYTES || hungUp) {
        return false;
      }
      long leastTripNs = Math.min(leastNs, leastBeforeNs);
      return firstUnseen == nextSent
          || leastTripNs == Long.MAX_VALUE && nextSent - firstUnseen < WINDOW
          || nextSent - firstUnseen < WINDOW
              && nowNs - sentNs[firstUnseen & WINDOW - 1] <= leastTripNs + LATE_NS;
    }
  }

  @Override
  protected int draw(ThinSnapshot snapshot) {
    synchronized (lock) {
      if (hungUp || saidLast || !channel.isOpen()) {
        return 0;
      }
      // The snapshot before has left, so nobody reads these bytes any more.
      Bytes bytes = unsentSnapshots == 0 ? snapshotBytes : new Bytes();
      bytes.clear();
      if (binary == null) {
        JsonWriter.write(snapshot, bytes);
      } else {
        binary.write(snapshot, bytes);
      }
      if (nextSent - firstUnseen == WINDOW) {
        firstUnseen++;
      }
      sentTick[nextSent & WINDOW - 1] = snapshot.tick;
      sentNs[nextSent & WINDOW - 1] = System.nanoTime();
      nextSent++;
      counters().datagramsOut.incrementAndGet();
      counters().datagramBytesOut.addAndGet(bytes.length());
      send(bytes.view(), binary == null, true);
      ping(System.nanoTime(), PING_NS);
      return bytes.length();
    }
  }

  /** Notes that the client has the snapshots up to a tick. */
  private void seen(int tick) {
    synchronized (lock) {
      while (firstUnseen != nextSent && sentTick[firstUnseen & WINDOW - 1] <= tick) {
        firstUnseen++;
      }
    }
  }

  /** Sends a ping if the last one is so long ago. The caller holds the lock. */
  private void ping(long nowNs, long everyNs) {
    if (nowNs - pingNs < everyNs) {
      return;
    }
    pingNs = nowNs;
    pingedNs[pings & WINDOW - 1] = nowNs;
    pingedSent[pings & WINDOW - 1] = nextSent;
    ByteBuffer number = ByteBuffer.allocate(Integer.BYTES).putInt(pings++).flip();
    WebSockets.sendPing(number, channel, null);
  }

  private void answered(int ping) {
    long nowNs = System.nanoTime();
    synchronized (lock) {
      if (pings - ping <= 0 || pings - ping > WINDOW) {
        return; // none of ours, or too old
      }
      long tripNs = nowNs - pingedNs[ping & WINDOW - 1];
      int before = pingedSent[ping & WINDOW - 1];
      if (before - firstUnseen > 0) {
        firstUnseen = before;
      }
      if (nowNs - leastSinceNs > LEAST_NS) {
        leastSinceNs = nowNs;
        leastBeforeNs = leastNs;
        leastNs = tripNs;
      }
      leastNs = Math.min(leastNs, tripNs);
      int ms = (int) Math.min(60_000, (tripNs + NS_PER_MS / 2) / NS_PER_MS);
      smoothMs = smoothMs == 0 ? ms : (3 * smoothMs + ms + 2) / 4;
      roundTripMs(smoothMs);
    }
    heard();
  }

  /** Does what is due each second: pings, deadlines. The thread that reads and writes sockets. */
  void second() {
    long nowNs = System.nanoTime();
    String late = null;
    boolean isOver;
    synchronized (lock) {
      isOver = hungUp && nowNs - closedNs > FAREWELL_S * NS_PER_S;
      if (!hungUp) {
        ping(nowNs, NS_PER_S / 2);
        if (unsent > 0 && nowNs - progressNs > STALLED_S * NS_PER_S) {
          late = "the client has read nothing for " + STALLED_S + " s";
        } else if (unsent == 0 && nowNs - heardNs > SILENCE_S * NS_PER_S) {
          late = "nothing heard, not even answers to pings, for " + SILENCE_S + " s";
        }
      }
    }
    if (late != null) {
      close(late);
    }
    if (isOver) {
      end();
    }
  }

  @Override
  protected void hangUp(String reason) {
    synchronized (lock) {
      hungUp = true;
      closedNs = System.nanoTime();
    }
    String text = reason.length() > MAX_REASON ? reason.substring(0, MAX_REASON) : reason;
    String ascii = new String(text.getBytes(StandardCharsets.US_ASCII), StandardCharsets.US_ASCII);
    WebSockets.sendClose(CloseMessage.NORMAL_CLOSURE, ascii, channel, null);
  }

  @Override
  public boolean isPlainText() {
    return isPlainText;
  }

  /** Ends the connection at once. Any thread. */
  void end() {
    try {
      channel.close();
    } catch (IOException e) {
      // it is gone either way
    }
  }
}
