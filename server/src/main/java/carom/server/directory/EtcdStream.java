package carom.server.directory;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.http.HttpResponse.BodySubscriber;
import java.net.http.HttpTimeoutException;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Flow;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/**
 * The body of an answer, line by line, with a time until which the reader waits. One chunk is under
 * way at a time, so that a fast sender fills no memory. One thread reads; any thread may close.
 */
final class EtcdStream implements BodySubscriber<EtcdStream>, AutoCloseable {
  /** Longest line. A page of a range has 500 entries of 24 kB at most. */
  static final int MAX_LINE_BYTES = 16 << 20;

  private static final Object END = new Object();

  private final boolean isUnread;
  private final LinkedBlockingQueue<Object> arrived = new LinkedBlockingQueue<>();
  private final ByteArrayOutputStream begun = new ByteArrayOutputStream();
  private volatile Flow.Subscription subscription;
  private ByteBuffer chunk = ByteBuffer.allocate(0);
  private boolean ended;

  /**
   * Creates a stream.
   *
   * @param isUnread whether to drop the connection instead of reading the body
   */
  EtcdStream(boolean isUnread) {
    this.isUnread = isUnread;
  }

  @Override
  public CompletionStage<EtcdStream> getBody() {
    return CompletableFuture.completedFuture(this);
  }

  @Override
  public void onSubscribe(Flow.Subscription s) {
    subscription = s;
    if (isUnread) {
      s.cancel();
      onComplete();
    } else {
      s.request(1);
    }
  }

  @Override
  public void onNext(List<ByteBuffer> buffers) {
    ByteBuffer whole = ByteBuffer.allocate(buffers.stream().mapToInt(ByteBuffer::remaining).sum());
    buffers.forEach(whole::put);
    arrived.add(whole.flip());
  }

  @Override
  public void onError(Throwable reason) {
    arrived.add(reason);
  }

  @Override
  public void onComplete() {
    arrived.add(END);
  }

  /**
   * Waits for the next line.
   *
   * @param deadlineNs until when, by {@link System#nanoTime}
   * @return the line; at the end what is left without a line's end, or null
   * @throws HttpTimeoutException if none is there in time
   * @throws IOException if the connection broke, or the line is too long
   */
  byte[] line(long deadlineNs) throws IOException, InterruptedException {
    while (!ended) {
      while (chunk.hasRemaining()) {
        byte next = chunk.get();
        if (next == '\n') {
          return taken();
        }
        begun.write(next);
      }
      if (begun.size() > MAX_LINE_BYTES) {
        throw new IOException("the answer has more than " + MAX_LINE_BYTES + " bytes");
      }
      Object next = arrived.poll(deadlineNs - System.nanoTime(), TimeUnit.NANOSECONDS);
      if (next == null) {
        throw new HttpTimeoutException("no answer in time");
      } else if (next instanceof Throwable reason) {
        throw new IOException(reason.getMessage(), reason);
      } else if (next == END) {
        ended = true;
      } else {
        chunk = (ByteBuffer) next;
        subscription.request(1);
      }
    }
    return begun.size() == 0 ? null : taken();
  }

  private byte[] taken() {
    byte[] line = begun.toByteArray();
    begun.reset();
    return line;
  }

  /** Drops the connection, if the answer hasn't ended. */
  @Override
  public void close() {
    Flow.Subscription open = subscription;
    if (open != null) {
      open.cancel();
    }
  }
}
