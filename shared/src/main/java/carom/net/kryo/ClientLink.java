package carom.net.kryo;

import carom.net.frame.ClientEnd;
import carom.net.frame.Frame;
import carom.net.frame.Trust;
import carom.net.seal.StreamSeal;
import carom.net.transport.HandshakeLine;
import com.esotericsoftware.kryonet.Client;
import com.esotericsoftware.kryonet.Connection;
import com.esotericsoftware.kryonet.FrameworkMessage.KeepAlive;
import com.esotericsoftware.kryonet.FrameworkMessage.RegisterTCP;
import com.esotericsoftware.kryonet.KryoNetException;
import java.io.IOException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NoRouteToHostException;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;

/**
 * Client's end of a link: TCP over KryoNet, with the thread that drives KryoNet's client, and a UDP
 * socket of {@link ClientDatagrams}, opened when the server has told its port. This class does not
 * use KryoNet's own {@code start()} and {@code stop()}, because a close on a second thread
 * deadlocks with a receive on the first. Instead, other threads request the close, and the driver
 * closes between two updates, when it holds no lock.
 *
 * <p>KryoNet's {@code connect} blocks, so it must not run on the driver. A second thread runs it
 * and ends.
 */
final class ClientLink extends ClientEnd {
  private static final int SELECT_MILLIS = 50;

  /** Distance of two frames on a simulated line, so that its clock keeps their order, ns. */
  private static final long ORDER_NANOS = 1_000_000L;

  static {
    Setup.ensure();
  }

  private final int stepMillis;
  private final HandshakeLine line; // null without a simulated network
  private final InetAddress address;
  private final AtomicInteger delayed = new AtomicInteger(); // frames on the line
  private long lastDue; // guarded by the line
  private final Thread driver;
  private final Thread connector;
  private final ClientDatagrams datagrams;
  private final AtomicInteger users = new AtomicInteger(2); // threads that use the endpoint
  private volatile Endpoint endpoint;
  private volatile ClientDatagrams.Socket udp;

  ClientLink(
      KryoMessageCodec codec,
      ClientDatagrams datagrams,
      Trust trust,
      String host,
      int tcpPort,
      int udpPort,
      int stepMillis,
      HandshakeLine line,
      InetAddress address) {
    super(codec, trust, host, tcpPort, udpPort, stepMillis);
    this.datagrams = datagrams;
    this.stepMillis = stepMillis;
    this.line = line;
    this.address = address;
    driver = new Thread(this::drive, "carom-link-" + remote());
    driver.setDaemon(true);
    connector = new Thread(this::connectEndpoint, "carom-connect-" + remote());
    connector.setDaemon(true);
  }

  void start() {
    driver.start();
  }

  /** Returns whether its thread has ended. */
  boolean isOver() {
    return !driver.isAlive();
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
    if (line != null && (state() == State.CONNECTING || delayed.get() > 0)) {
      delay(() -> endpoint.sendTCP(frame));
      return true;
    }
    return endpoint.sendTCP(frame) > 0;
  }

  /** Sends a frame as late as a slow line would, behind those before it. */
  private void delay(Runnable send) {
    synchronized (line) {
      long now = System.nanoTime();
      long trip = state() == State.CONNECTING ? line.roundTripNanos() : 0;
      boolean follows = delayed.getAndIncrement() > 0;
      lastDue = follows ? Math.max(lastDue + ORDER_NANOS, now + trip) : now + trip;
      line.after(
          lastDue - now,
          () -> {
            send.run();
            delayed.decrementAndGet();
          });
    }
  }

  @Override
  protected boolean isWritable() {
    return endpoint.getTcpWriteBufferSize() == 0;
  }

  @Override
  protected boolean transmitDatagram(byte tag, byte[] bytes, int offset, int length) {
    ClientDatagrams.Socket socket = udp;
    if (socket == null || isDisconnected()) {
      return false;
    }
    datagramLeft();
    if (line != null && tag != Frame.DATAGRAM) {
      if (!line.loses()) {
        byte[] copy = Arrays.copyOfRange(bytes, offset, offset + length);
        long trip = state() == State.CONNECTING ? line.roundTripNanos() : 0;
        line.after(trip, () -> socket.send(tag, copy, 0, copy.length));
      }
      return true;
    }
    return socket.send(tag, bytes, offset, length);
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
        long now = System.nanoTime();
        if (udp != null) {
          registerUdp(now);
        }
        checkDeadlines(now);
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
    }
  }

  /** Closes the sockets. The second of the two threads to finish disposes of the selector. */
  private void release(Endpoint client) {
    if (client == null) {
      return;
    }
    if (udp != null) {
      udp.close();
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
      if (line != null) {
        TimeUnit.NANOSECONDS.sleep(line.roundTripNanos()); // SYN and its answer
      }
      endpoint.connect(stepMillis, address, tcpPort());
    } catch (InterruptedException x) {
      lose("closed while connecting");
    } catch (IOException x) {
      lose(explain(x));
    } catch (RuntimeException x) {
      lose("can't connect to " + remote() + ": " + x.getMessage());
    } finally {
      disposeWhenLast();
    }
  }

  private String explain(IOException failure) {
    String text = String.valueOf(failure.getMessage());
    if (text.contains("during TCP registration")) {
      return notCarom();
    }
    Throwable cause = failure.getCause();
    mayPass(!(cause instanceof NoRouteToHostException || cause instanceof ConnectException));
    return cause instanceof NoRouteToHostException ? noRoute() : noAnswer();
  }

  /** Returns whether a Carom server has answered by TCP. */
  boolean isAnswered() {
    return isTcpRegistered();
  }

  /** KryoNet's client, made safe to send and to close from any thread. */
  private final class Endpoint extends Client {

    Endpoint() {
      super(WRITE_BUFFER_BYTES, Frame.CLIENT_BUFFER_BYTES, new ClientFrames());
      setTimeout(0); // checkDeadlines() does this
      setKeepAliveTCP(Frame.KEEP_ALIVE_MILLIS);
      setIdleThreshold(0);
    }

    @Override
    public int sendTCP(Object frame) {
      if (isDisconnected() || (frame instanceof KeepAlive && !mayKeepAlive())) {
        return 0;
      }
      if (WRITE_BUFFER_BYTES - getTcpWriteBufferSize() < FrameCodec.tcpBytes(frame)) {
        lose("the server doesn't read what it is sent");
        return 0;
      }
      try {
        return super.sendTCP(frame);
      } catch (RuntimeException x) {
        lose("connection lost"); // two senders overflowed the buffer, or the key is cancelled
        return 0;
      }
    }

    /** Closes the sockets for the connector. On any other thread it only requests the close. */
    @Override
    public void close() {
      if (Thread.currentThread() == connector) {
        super.close();
      } else {
        lose(gone());
      }
    }

    void closeNow() {
      super.close();
    }
  }

  /**
   * Returns whether the server accepts a keep-alive, and none overtakes a frame of the handshake.
   */
  private boolean mayKeepAlive() {
    return isUdpRegistered() && (line == null || state() == State.OPEN && delayed.get() == 0);
  }

  /** Opens the UDP socket to the machine that answers by TCP, at the port that it told. */
  private void openDatagrams() {
    try {
      InetAddress server = endpoint.getRemoteAddressTCP().getAddress();
      udp =
          datagrams.open(
              new InetSocketAddress(server, udpPort()),
              new ClientDatagrams.Receiver() {
                @Override
                public void datagram(ByteBuffer datagram) {
                  if (line == null || !line.isDeaf()) {
                    readDatagram(datagram);
                  }
                }

                @Override
                public void unreachable() {
                  udpRefused();
                }
              });
      registerUdp(System.nanoTime());
    } catch (IOException x) {
      lose("no UDP socket: " + x.getMessage());
    }
  }

  /** The codec through which KryoNet makes the driver thread read TCP. */
  private final class ClientFrames extends FrameCodec {

    @Override
    protected void writeRegistration(
        Connection connection, ByteBuffer buffer, Object registration) {
      throw new IllegalStateException("a client registers by a datagram");
    }

    @Override
    protected StreamSeal streamSeal(Connection connection) {
      return ClientLink.this.streamSeal();
    }

    @Override
    public Object read(Connection connection, ByteBuffer buffer) {
      int end = buffer.limit();
      try {
        return register(readFrame(buffer));
      } catch (RuntimeException x) {
        lose("the server sent an invalid frame");
        return FrameCodec.HANDLED;
      } finally {
        buffer.limit(end).position(end);
      }
    }

    /** Does what follows a frame. Returns the KryoNet object if KryoNet must know about it. */
    private Object register(byte tag) {
      if (tag == Frame.REGISTER_UDP) {
        udpRegistered();
      }
      if (tag != Frame.REGISTER_TCP) {
        return FrameCodec.HANDLED;
      }
      if (state() == State.CONNECTING && udp == null) {
        openDatagrams();
      }
      RegisterTCP registered = new RegisterTCP();
      registered.connectionID = id();
      return registered;
    }
  }
}
