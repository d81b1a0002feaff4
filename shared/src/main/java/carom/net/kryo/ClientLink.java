package carom.net.kryo;

import carom.net.frame.ClientEnd;
import carom.net.frame.Frame;
import carom.net.frame.Trust;
import carom.net.seal.StreamSeal;
import com.esotericsoftware.kryonet.Client;
import com.esotericsoftware.kryonet.Connection;
import com.esotericsoftware.kryonet.FrameworkMessage.KeepAlive;
import com.esotericsoftware.kryonet.FrameworkMessage.RegisterTCP;
import com.esotericsoftware.kryonet.FrameworkMessage.RegisterUDP;
import com.esotericsoftware.kryonet.KryoNetException;
import com.esotericsoftware.kryonet.Listener;
import java.io.IOException;
import java.net.InetAddress;
import java.net.NoRouteToHostException;
import java.net.PortUnreachableException;
import java.net.UnknownHostException;
import java.nio.ByteBuffer;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;

/**
 * Client's end of a link over KryoNet, with the thread that drives KryoNet's client. This class
 * does not use KryoNet's own {@code start()} and {@code stop()}, because a close on a second thread
 * deadlocks with a receive on the first. Instead, other threads request the close, and the driver
 * closes between two updates, when it holds no lock.
 *
 * <p>KryoNet's {@code connect} blocks, so it must not run on the driver. A second thread runs it
 * and ends.
 */
final class ClientLink extends ClientEnd {
  private static final int SELECT_MILLIS = 50;
  private static final int MAX_ADDRESSES = 4;

  static {
    Setup.ensure();
  }

  private final int connectMillis;
  private final Consumer<ClientLink> finished;
  private final Thread driver;
  private final Thread connector;
  private final Frame.Payload datagram = new Frame.Payload();
  private final Object datagramLock = new Object();
  private final AtomicInteger users =
      new AtomicInteger(2); // number of threads that use the endpoint
  private volatile Endpoint endpoint;
  private volatile Thread datagramSender;

  ClientLink(
      KryoMessageCodec codec,
      Trust trust,
      String host,
      int tcpPort,
      int udpPort,
      int connectMillis,
      Consumer<ClientLink> finished) {
    super(codec, trust, host, tcpPort, udpPort, connectMillis);
    this.connectMillis = connectMillis;
    this.finished = finished;
    driver = new Thread(this::drive, "carom-link-" + remote());
    driver.setDaemon(true);
    connector = new Thread(this::connectEndpoint, "carom-connect-" + remote());
    connector.setDaemon(true);
  }

  void start() {
    driver.start();
  }

  /**
   * Waits until the threads have ended. Returns true if the waiting thread was interrupted
   * meanwhile.
   */
  boolean await(long deadline) {
    boolean interrupted = false;
    while (driver.isAlive() && System.nanoTime() - deadline < 0) {
      try {
        driver.join(50);
      } catch (InterruptedException x) {
        interrupted = true;
      }
    }
    return interrupted;
  }

  @Override
  protected boolean transmit(Frame.Payload frame) {
    return endpoint.sendTCP(frame) > 0;
  }

  @Override
  protected boolean transmitDatagram(byte tag, byte[] bytes, int offset, int length) {
    synchronized (datagramLock) {
      return endpoint.sendUDP(datagram.set(tag, bytes, offset, length)) > 0;
    }
  }

  @Override
  protected void disconnect(State before, String reason) {
    if (before == State.OPEN) {
      transmit(Frame.bye(reason)); // also wakes the driver
    } else {
      lose(reason);
      connector.interrupt();
    }
  }

  /** Runs the driver: it connects, updates until the link is closed, and releases everything. */
  private void drive() {
    Endpoint client = null;
    try {
      client = new Endpoint();
      endpoint = client;
      connector.start();
      while (!isDisconnected() && state() != State.CLOSED) {
        step(client);
        checkDeadlines(System.nanoTime());
      }
      long left = System.nanoTime(); // the owner sent BYE, and the server closes
      while (!isDisconnected() && System.nanoTime() - left < Frame.LINGER_NANOS) {
        step(client);
      }
    } catch (Throwable x) { // for example, no file descriptor is left for a selector
      finish("the connection to " + remote() + " failed: " + x);
    } finally {
      lose("connection lost");
      release(client);
      finished.accept(this);
    }
  }

  /** Closes the sockets. The second of the two threads to finish disposes of the selector. */
  private void release(Endpoint client) {
    if (client == null) {
      return;
    }
    connector.interrupt(); // ends a connection attempt that is no use
    client.closeNow();
    disposeWhenLast();
  }

  private void disposeWhenLast() {
    if (users.decrementAndGet() > 0) {
      return;
    }
    try {
      endpoint.closeNow();
      endpoint.dispose();
    } catch (IOException x) {
      finish("connection lost: " + x.getMessage());
    }
  }

  private void step(Endpoint client) {
    try {
      client.update(SELECT_MILLIS);
    } catch (PortUnreachableException x) {
      if (state() == State.CONNECTING) {
        lose(blocked());
      } // otherwise the server's UDP port has just closed, and TCP will report why
    } catch (IOException x) {
      lose(isTcpRegistered() ? gone() : notCarom());
    } catch (KryoNetException x) {
      lose(isTcpRegistered() ? "the server sent an invalid frame: " + x.getMessage() : notCarom());
    } finally {
      Thread.interrupted(); // an interrupted thread would never wait in select again
    }
  }

  /** Runs the connector. */
  private void connectEndpoint() {
    try {
      String failure = tryAddresses();
      if (failure != null) {
        lose(failure);
      }
    } finally {
      disposeWhenLast();
    }
  }

  /** Returns what went wrong, or null when the connection is established. */
  private String tryAddresses() {
    String failure = "no server answers at " + remote();
    try {
      InetAddress[] addresses = InetAddress.getAllByName(host());
      long start = System.nanoTime();
      for (int i = 0; i < Math.min(MAX_ADDRESSES, addresses.length) && !isDisconnected(); i++) {
        if (i > 0 && System.nanoTime() - start > connectMillis * 1_000_000L) {
          break;
        }
        try {
          endpoint.connect(connectMillis, addresses[i], tcpPort(), udpPort());
          return null;
        } catch (IOException x) {
          failure = explain(x);
        }
      }
    } catch (UnknownHostException x) {
      failure = unknownHost();
    } catch (RuntimeException x) {
      failure = "can't connect to " + remote() + ": " + x.getMessage();
    }
    return failure;
  }

  private String explain(IOException failure) {
    String text = String.valueOf(failure.getMessage());
    if (failure instanceof PortUnreachableException || text.contains("during UDP registration")) {
      return blocked();
    }
    if (text.contains("during TCP registration")) {
      return notCarom();
    }
    if (failure.getCause() instanceof NoRouteToHostException) {
      return noRoute();
    }
    return noAnswer();
  }

  /** KryoNet's client, made safe to send and to close from any thread. */
  private final class Endpoint extends Client {

    Endpoint() {
      super(WRITE_BUFFER_BYTES, Frame.CLIENT_BUFFER_BYTES, new ClientFrames());
      setTimeout(0); // checkDeadlines() does this
      setKeepAliveTCP(Frame.KEEP_ALIVE_MILLIS);
      setIdleThreshold(0);
      addListener(
          new Listener() {
            @Override
            public void connected(Connection connection) {
              udpRegistered();
            }
          });
    }

    @Override
    public int sendTCP(Object frame) {
      if (isDisconnected()) {
        return 0;
      }
      if (WRITE_BUFFER_BYTES - getTcpWriteBufferSize() < FrameCodec.tcpBytes(frame)) {
        lose("the server doesn't read what it is sent");
        return 0;
      }
      try {
        return super.sendTCP(frame);
      } catch (
          RuntimeException
              x) { // two senders overflowed the buffer at once, or the key is cancelled
        lose("connection lost");
        return 0;
      }
    }

    @Override
    public int sendUDP(Object frame) {
      if (isDisconnected() || frame instanceof KeepAlive) {
        return 0; // KryoNet's keep-alives aren't sealed; checkDeadlines() sends others
      }
      synchronized (datagramLock) {
        datagramSender = Thread.currentThread();
        try {
          datagramLeft();
          return super.sendUDP(frame);
        } catch (RuntimeException x) {
          return 0;
        } finally {
          datagramSender = null;
        }
      }
    }

    /** Closes the sockets for the connector. On any other thread it only requests the close. */
    @Override
    public void close() {
      if (Thread.currentThread() == connector) {
        super.close();
      } else if (datagramSender
          != Thread.currentThread()) { // a datagram that can't be sent is simply lost
        lose(gone());
      }
    }

    void closeNow() {
      super.close();
    }
  }

  /** The codec through which KryoNet makes the driver thread read. */
  private final class ClientFrames extends FrameCodec {
    private ByteBuffer tcpBuffer;

    @Override
    void writeRegistration(Connection connection, ByteBuffer buffer, Object registration) {
      buffer.putInt(id()).putLong(token());
    }

    @Override
    StreamSeal streamSeal(Connection connection) {
      return ClientLink.this.streamSeal();
    }

    @Override
    @SuppressWarnings("ReferenceEquality") // the buffer's identity tells UDP from TCP
    public Object read(Connection connection, ByteBuffer buffer) {
      if (tcpBuffer == null) {
        tcpBuffer = buffer; // UDP doesn't start before the first TCP frame
      }
      int end = buffer.limit();
      try {
        if (buffer == tcpBuffer) {
          return register(readFrame(buffer));
        }
        readDatagram(buffer);
      } catch (RuntimeException x) {
        if (buffer == tcpBuffer) {
          lose("the server sent an invalid frame");
        }
      } finally {
        buffer.limit(end).position(end);
      }
      return FrameCodec.HANDLED;
    }

    /** Returns the KryoNet object for a frame that KryoNet must know about. */
    private Object register(byte tag) {
      if (tag == Frame.REGISTER_TCP) {
        RegisterTCP registered = new RegisterTCP();
        registered.connectionID = id();
        return registered;
      }
      return tag == Frame.REGISTER_UDP ? new RegisterUDP() : FrameCodec.HANDLED;
    }
  }
}
