package carom.net.kryo;

import carom.net.protocol.ServerMessage;
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
 * A client's end of a connection, with the thread that drives KryoNet's client. KryoNet's own
 * {@code start()} and {@code stop()} are not used: closing from a second thread while the first one
 * receives deadlocks it. So everybody only asks, and the driver closes between two updates, when it
 * holds no lock.
 *
 * <p>KryoNet's {@code connect} blocks and must not run on the driver; a second thread does it and
 * ends.
 */
final class ClientLink extends KryoLink {
  private static final int SELECT_MILLIS = 50;
  private static final int MAX_ADDRESSES = 4;
  private static final int UNREAD_MESSAGES = 1_024;
  private static final int UNREAD_DATAGRAMS = 512;
  private static final int WRITE_BUFFER_BYTES = 16 * 1_024;
  private static final long DATAGRAM_SILENCE_NANOS = 1_000_000_000L;
  private static final long IDLE_NANOS = 10_000_000_000L;

  static {
    Setup.ensure();
  }

  private final KryoMessageCodec codec;
  private final String host;
  private final int tcpPort;
  private final int udpPort;
  private final int connectMillis;
  private final Consumer<ClientLink> finished;
  private final Thread driver;
  private final Thread connector;
  private final Frame.Payload datagram = new Frame.Payload();
  private final Object datagramLock = new Object();
  private final AtomicInteger users = new AtomicInteger(2); // threads that use the endpoint
  private volatile Endpoint endpoint;
  private volatile Thread datagramSender;
  private volatile long lastDatagramOut;
  private volatile boolean disconnected; // the sockets are of no use any more

  // driver thread
  private long token;
  private long lastFrame;
  private boolean tcpRegistered;
  private boolean udpRegistered;
  private boolean challenged;

  ClientLink(
      KryoMessageCodec codec,
      String host,
      int tcpPort,
      int udpPort,
      int connectMillis,
      Consumer<ClientLink> finished) {
    super(codec, UNREAD_MESSAGES, UNREAD_DATAGRAMS);
    this.codec = codec;
    this.host = host;
    this.tcpPort = tcpPort;
    this.udpPort = udpPort;
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

  /** Waits until the threads have ended; true when the waiting thread was interrupted meanwhile. */
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
  public String remote() {
    return host + ":" + tcpPort;
  }

  @Override
  boolean transmit(Frame.Payload frame) {
    return endpoint.sendTCP(frame) > 0;
  }

  @Override
  boolean transmitDatagram(byte[] bytes, int offset, int length) {
    synchronized (datagramLock) {
      return endpoint.sendUDP(datagram.set(Frame.DATAGRAM, bytes, offset, length)) > 0;
    }
  }

  @Override
  void disconnect(State before, String reason) {
    if (before == State.OPEN) {
      transmit(Frame.bye(reason)); // wakes the driver, too
    } else {
      disconnected = true;
      connector.interrupt();
    }
  }

  /** The driver's life: connect, update until the link is closed, let go of everything. */
  private void drive() {
    Endpoint client = null;
    try {
      client = new Endpoint();
      endpoint = client;
      connector.start();
      long start = System.nanoTime();
      lastFrame = start;
      while (!disconnected && state() != State.CLOSED) {
        step(client);
        checkDeadlines(start);
      }
      long left = System.nanoTime(); // the owner said BYE: the server closes
      while (!disconnected && System.nanoTime() - left < Frame.LINGER_NANOS) {
        step(client);
      }
    } catch (Throwable x) { // such as: no file descriptors left for a selector
      finish("can't go on with the connection to " + remote() + ": " + x);
    } finally {
      disconnected = true;
      finish("connection lost");
      release(client);
      finished.accept(this);
    }
  }

  /** Closes the sockets; the selector goes when the second of the two threads is done with it. */
  private void release(Endpoint client) {
    if (client == null) {
      return;
    }
    connector.interrupt(); // ends a connection attempt that nobody waits for any more
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
      } // else the server's UDP port has just gone, and TCP will tell why
    } catch (IOException x) {
      lose(tcpRegistered ? gone() : notCarom());
    } catch (KryoNetException x) {
      lose(tcpRegistered ? "the server sent what is no frame: " + x.getMessage() : notCarom());
    } finally {
      Thread.interrupted(); // an interrupted thread would never wait in select again
    }
  }

  private void checkDeadlines(long start) {
    long now = System.nanoTime();
    if (state() == State.CONNECTING) {
      if (now - start > connectMillis * 1_000_000L && tcpRegistered) {
        lose(stuck());
      }
      return;
    }
    if (now - lastFrame > IDLE_NANOS) {
      lose("nothing heard from the server for " + IDLE_NANOS / 1_000_000_000L + " s");
    } else if (now - lastDatagramOut > DATAGRAM_SILENCE_NANOS) {
      endpoint.sendUDP(new KeepAlive()); // keeps the address translation of routers alive
    }
  }

  private void lose(String reason) {
    finish(reason);
    disconnected = true;
  }

  /**
   * Why the connection ended; a server that waits in vain for datagrams gives up without a word.
   */
  private String gone() {
    boolean waited = state() == State.CONNECTING && tcpRegistered;
    return waited ? stuck() : "the server closed the connection";
  }

  private String stuck() {
    return udpRegistered
        ? "server reachable, but its answers from UDP port " + udpPort + " are blocked"
        : blocked();
  }

  private String blocked() {
    return "server reachable by TCP, but UDP port " + udpPort + " is blocked";
  }

  private String notCarom() {
    return "something answers at " + remote() + ", but it isn't a Carom server";
  }

  /** The connector's life. */
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

  /** What went wrong, or null when a connection stands. */
  private String tryAddresses() {
    String failure = "no server answers at " + remote();
    try {
      InetAddress[] addresses = InetAddress.getAllByName(host);
      long start = System.nanoTime();
      for (int i = 0; i < Math.min(MAX_ADDRESSES, addresses.length) && !disconnected; i++) {
        if (i > 0 && System.nanoTime() - start > connectMillis * 1_000_000L) {
          break;
        }
        try {
          endpoint.connect(connectMillis, addresses[i], tcpPort, udpPort);
          return null;
        } catch (IOException x) {
          failure = explain(x);
        }
      }
    } catch (UnknownHostException x) {
      failure = "unknown host " + host + ": check the address";
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
      return "no way to " + remote() + ": check the address and your network";
    }
    return "no server answers at " + remote() + ": is it running, and are address and port right?";
  }

  private void openWhenReady() {
    if (udpRegistered && challenged) {
      open();
    }
  }

  /** KryoNet's client, made safe to send from any thread and to close from any. */
  private final class Endpoint extends Client {

    Endpoint() {
      super(WRITE_BUFFER_BYTES, Frame.CLIENT_BUFFER_BYTES, new ClientFrames());
      setTimeout(0); // checkDeadlines() does it
      setKeepAliveTCP(Frame.KEEP_ALIVE_MILLIS);
      setIdleThreshold(0);
      addListener(
          new Listener() {
            @Override
            public void connected(Connection connection) {
              udpRegistered = true;
              openWhenReady();
            }
          });
    }

    @Override
    public int sendTCP(Object frame) {
      if (disconnected) {
        return 0;
      }
      if (WRITE_BUFFER_BYTES - getTcpWriteBufferSize() < Frame.tcpBytes(frame)) {
        lose("the server doesn't read what it is sent");
        return 0;
      }
      try {
        return super.sendTCP(frame);
      } catch (RuntimeException x) { // overflow by two senders at once, or the key is cancelled
        lose("connection lost");
        return 0;
      }
    }

    @Override
    public int sendUDP(Object frame) {
      if (disconnected) {
        return 0;
      }
      synchronized (datagramLock) {
        datagramSender = Thread.currentThread();
        try {
          lastDatagramOut = System.nanoTime();
          return super.sendUDP(frame);
        } catch (RuntimeException x) {
          return 0;
        } finally {
          datagramSender = null;
        }
      }
    }

    /** Closes for the connector; all others only ask for it. */
    @Override
    public void close() {
      if (Thread.currentThread() == connector) {
        super.close();
      } else if (datagramSender
          != Thread.currentThread()) { // a datagram that can't be sent is just lost
        lose(gone());
      }
    }

    void closeNow() {
      super.close();
    }
  }

  /** How a client reads, on the driver thread. */
  private final class ClientFrames extends Frame.Codec {
    private ByteBuffer tcpBuffer;

    @Override
    long token(Connection connection) {
      return token;
    }

    @Override
    boolean server() {
      return false;
    }

    @Override
    @SuppressWarnings("ReferenceEquality") // it is the buffer's identity that tells UDP from TCP
    public Object read(Connection connection, ByteBuffer buffer) {
      if (tcpBuffer == null) {
        tcpBuffer = buffer; // UDP doesn't start before TCP's first frame
      }
      try {
        return buffer == tcpBuffer ? readFrame(buffer) : readDatagram(buffer);
      } catch (RuntimeException x) {
        if (buffer == tcpBuffer) {
          lose("the server sent what is no frame");
        }
        return Frame.HANDLED;
      } finally {
        buffer.position(buffer.limit());
      }
    }

    private Object readFrame(ByteBuffer buffer) {
      lastFrame = System.nanoTime();
      int length = buffer.remaining() - 1;
      byte tag = buffer.get();
      switch (tag) {
        case Frame.REGISTER_TCP -> {
          RegisterTCP registered = new RegisterTCP();
          registered.connectionID = buffer.getInt();
          token = buffer.getLong();
          tcpRegistered = true;
          return registered;
        }
        case Frame.REGISTER_UDP -> {
          return new RegisterUDP();
        }
        case Frame.KEEP_ALIVE -> {}
        case Frame.MESSAGE -> readMessage(buffer, length);
        case Frame.BYE -> {
          tcpRegistered = true; // a Carom server, whatever comes next
          String text = Frame.byeText(buffer);
          lose(text.isEmpty() ? "the server closed the connection" : text);
        }
        default ->
            lose(tcpRegistered ? "the server sent an unknown frame (tag=" + tag + ")" : notCarom());
      }
      return Frame.HANDLED;
    }

    private void readMessage(ByteBuffer buffer, int length) {
      ServerMessage message =
          codec.decodeFromServer(buffer.array(), buffer.arrayOffset() + buffer.position(), length);
      if (message == null) {
        counters().malformed.incrementAndGet();
        lose("the server sent a message that can't be read");
      } else if (!receiveMessage(message, length)) {
        lose("more than " + UNREAD_MESSAGES + " unread messages");
      }
    }

    private Object readDatagram(ByteBuffer buffer) {
      int length = buffer.remaining();
      byte tag = length == 0 ? 0 : buffer.get();
      if (tag == Frame.DATAGRAM && length > 1 && length <= 1 + Frame.MAX_PAYLOAD_BYTES) {
        receiveDatagram(buffer, System.nanoTime());
      } else if (tag == Frame.CHALLENGE && length == Frame.NONCE_BYTES) {
        byte[] nonce = Frame.nonce(buffer.getLong());
        endpoint.sendUDP(new Frame.Payload().set(Frame.ANSWER, nonce, 0, nonce.length));
        challenged = true;
        openWhenReady();
      } else {
        counters().malformed.incrementAndGet();
      }
      return Frame.HANDLED;
    }
  }
}
