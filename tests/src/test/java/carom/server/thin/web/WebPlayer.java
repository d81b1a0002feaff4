package carom.server.thin.web;

import carom.text.Json;
import carom.text.JsonException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;

/** A thin client by the JDK's WebSocket: what it was told waits until it is asked for. */
final class WebPlayer implements WebSocket.Listener, AutoCloseable {
  private static final HttpClient HTTP =
      HttpClient.newBuilder().connectTimeout(Duration.ofSeconds(20)).build();
  private static final long PATIENCE_S = 30;

  /** Texts and bytes, in the order of their coming. */
  final BlockingQueue<Object> told = new LinkedBlockingQueue<>();

  final AtomicLong payloadBytes = new AtomicLong();
  volatile String ended;

  private final StringBuilder text = new StringBuilder();
  private final List<byte[]> parts = new ArrayList<>();
  private boolean paused;
  private int owed;
  private final WebSocket socket;

  WebPlayer(int port) {
    socket =
        HTTP.newWebSocketBuilder()
            .buildAsync(URI.create("ws://127.0.0.1:" + port + "/thin"), this)
            .join();
  }

  @Override
  public CompletionStage<?> onText(WebSocket on, CharSequence data, boolean last) {
    text.append(data);
    if (last) {
      payloadBytes.addAndGet(text.toString().getBytes(StandardCharsets.UTF_8).length);
      told.add(text.toString());
      text.setLength(0);
    }
    next(on);
    return null;
  }

  @Override
  public CompletionStage<?> onBinary(WebSocket on, ByteBuffer data, boolean last) {
    byte[] part = new byte[data.remaining()];
    data.get(part);
    parts.add(part);
    if (last) {
      ByteBuffer whole = ByteBuffer.allocate(parts.stream().mapToInt(p -> p.length).sum());
      parts.forEach(whole::put);
      parts.clear();
      payloadBytes.addAndGet(whole.capacity());
      told.add(whole.flip());
    }
    next(on);
    return null;
  }

  @Override
  public CompletionStage<?> onClose(WebSocket on, int status, String reason) {
    ended = status + " " + reason;
    return null;
  }

  @Override
  public void onError(WebSocket on, Throwable error) {
    ended = error.toString();
  }

  private synchronized void next(WebSocket on) {
    if (paused) {
      owed++;
    } else {
      on.request(1);
    }
  }

  /** Reads no more. */
  synchronized void pause() {
    paused = true;
  }

  /** Reads on. */
  synchronized void resume() {
    paused = false;
    socket.request(owed);
    owed = 0;
  }

  void say(String json) {
    socket.sendText(json, true).join();
  }

  void say(byte[] bytes) {
    socket.sendBinary(ByteBuffer.wrap(bytes), true).join();
  }

  /** Waits for the next message of a name, and drops those before. */
  Json await(String name) throws InterruptedException {
    long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
    while (System.nanoTime() < endNs) {
      Object next = told.poll(100, TimeUnit.MILLISECONDS);
      if (next instanceof String message) {
        Json root = parsed(message);
        if (root.fields.containsKey(name)) {
          return root.fields.get(name);
        }
      }
    }
    throw new AssertionError("no " + name + "; ended=" + ended);
  }

  static Json parsed(String message) {
    try {
      return Json.parseMachineMade(message.getBytes(StandardCharsets.UTF_8));
    } catch (JsonException e) {
      throw new AssertionError(message, e);
    }
  }

  /** Waits for the end of the connection, and returns its status and reason. */
  String awaitEnd() throws InterruptedException {
    long endNs = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
    while (ended == null && System.nanoTime() < endNs) {
      Thread.sleep(5);
    }
    return ended;
  }

  @Override
  public void close() {
    socket.abort();
  }
}
