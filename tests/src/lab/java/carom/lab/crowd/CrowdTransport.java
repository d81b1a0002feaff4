package carom.lab.crowd;

import carom.net.frame.Frame;
import carom.net.frame.Trust;
import carom.net.kryo.KryoClientTransport;
import carom.net.kryo.KryoMessageCodec;
import carom.net.transport.ClientTransport;
import carom.net.transport.Link;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.Selector;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.locks.LockSupport;

/**
 * A transport for hundreds of clients in one process, such as bots. All links share one daemon
 * thread and its selector, whereas {@link KryoClientTransport} has a thread for each link. On the
 * wire there is no difference. Any thread may connect; only a link's owner calls its {@code poll}.
 */
public final class CrowdTransport implements ClientTransport, Runnable {
  private static final int CONNECT_MILLIS = 8_000;
  private static final int SELECT_MILLIS = 50;
  private static final long SWEEP_NANOS = 50_000_000L;
  private static final long CLOSE_MILLIS = 2_000;

  /**
   * Number of ready sockets from which the thread pauses after a selection, so that more datagrams
   * gather, as at a server.
   */
  private static final int CROWD = 4;

  private static final long GATHER_NANOS = 1_000_000L;

  private final KryoMessageCodec codec = new KryoMessageCodec();
  private final ConcurrentLinkedQueue<CrowdLink> coming = new ConcurrentLinkedQueue<>();
  private final List<CrowdLink> links = new ArrayList<>(); // the thread's
  private final ByteBuffer in = ByteBuffer.allocateDirect(Frame.SERVER_BUFFER_BYTES);
  private final Trust trust = Trust.firstUse();
  private final int connectMillis;
  private final Selector selector;
  private final Thread thread;
  private volatile boolean closed;

  /**
   * Creates a transport without connections.
   *
   * @throws UncheckedIOException when the system gives no selector
   */
  public CrowdTransport() {
    this(CONNECT_MILLIS);
  }

  /** Creates a transport with another connect timeout, ms. */
  CrowdTransport(int connectMillis) {
    this.connectMillis = connectMillis;
    try {
      selector = Selector.open();
    } catch (IOException x) {
      throw new UncheckedIOException("no selector for a crowd of clients", x);
    }
    thread = new Thread(this, "carom-crowd");
    thread.setDaemon(true);
    thread.start();
  }

  /**
   * {@inheritDoc}
   *
   * @throws IllegalArgumentException when a port is outside its range
   * @throws IllegalStateException when this transport is closed
   */
  @Override
  public Link connect(String host, int tcpPort, int udpPort) {
    if (closed) {
      throw new IllegalStateException("connect after close");
    }
    CrowdLink link = new CrowdLink(codec, trust, host, tcpPort, udpPort, connectMillis, selector);
    coming.add(link);
    selector.wakeup();
    return link;
  }

  @Override
  public void run() {
    long nextSweep = System.nanoTime();
    while (!closed || !links.isEmpty() || !coming.isEmpty()) {
      try {
        int ready =
            selector.select(key -> ((CrowdLink) key.attachment()).ready(key, in), SELECT_MILLIS);
        for (CrowdLink link = coming.poll(); link != null; link = coming.poll()) {
          links.add(link);
          link.begin();
        }
        long now = System.nanoTime();
        if (now - nextSweep >= 0) {
          nextSweep = now + SWEEP_NANOS;
          sweep(now);
        }
        if (ready >= CROWD) {
          LockSupport.parkNanos(GATHER_NANOS);
        }
      } catch (IOException x) {
        links.forEach(link -> link.lose("can't go on with the connections: " + x.getMessage()));
        sweep(System.nanoTime());
      } finally {
        Thread.interrupted(); // an interrupted thread would never wait in select again
      }
    }
    try {
      selector.close();
    } catch (IOException x) {
      throw new UncheckedIOException(x);
    }
  }

  private void sweep(long now) {
    for (int i = links.size() - 1; i >= 0; i--) {
      CrowdLink link = links.get(i);
      if (closed) {
        link.close("the game closed the connection");
      }
      link.sweep(now);
      if (link.isDisconnected()) {
        link.release();
        links.remove(i);
      }
    }
  }

  @Override
  public void close() {
    closed = true;
    selector.wakeup();
    boolean interrupted = false;
    long deadline = System.nanoTime() + CLOSE_MILLIS * 1_000_000L;
    while (thread.isAlive() && System.nanoTime() - deadline < 0) {
      try {
        thread.join(CLOSE_MILLIS);
      } catch (InterruptedException x) {
        interrupted = true;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
