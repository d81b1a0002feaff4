package carom.server.query;

import carom.net.transport.AddressFamily;
import carom.server.access.LoginThrottle;
import carom.server.access.Secret;
import carom.server.command.Caller;
import carom.server.command.CommandRegistry;
import carom.server.command.Role;
import carom.server.threads.LastingThread;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ProtocolFamily;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.ServerSocketChannel;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Source RCON: the operator's commands over TCP, for programs that know the password. Each
 * connection has a daemon thread, and there are at most {@value #MAX_CONNECTIONS}: of one more, the
 * one that has waited longest without the password gives way. RCON sends the password and all
 * commands unencrypted.
 */
final class RemoteConsole implements AutoCloseable {
  /** Most connections at once. */
  static final int MAX_CONNECTIONS = 8;

  /** Longest text of a message. */
  static final int MAX_BODY_BYTES = 4_096;

  private static final Logger LOG = LoggerFactory.getLogger(RemoteConsole.class);
  private static final int AUTH = 3;
  private static final int AUTH_ANSWER = 2;
  private static final int COMMAND = 2;
  private static final int ANSWER = 0;
  private static final int REFUSED = -1;

  /** Bytes of id, type and the two zeros at the end. */
  private static final int FRAME_BYTES = 10;

  private static final int STRANGER_MS = 10_000;
  private static final int SILENCE_MS = 600_000;
  private static final int BACKLOG = 8;

  private final ServerSocket server;
  private final CommandRegistry commands;
  private final Secret password;
  private final LoginThrottle throttle;
  private final Set<Socket> connections = ConcurrentHashMap.newKeySet();

  /** Connections that haven't logged in, in the order of their coming. */
  private final Queue<Socket> strangers = new ConcurrentLinkedQueue<>();

  /** A message of the protocol. */
  record Packet(int id, int type, String body) {}

  /**
   * Opens the port.
   *
   * @param address address of this machine
   * @param port 0..65,535, 0 = any free one
   * @param throttle limits wrong passwords
   * @throws IOException if the port can't be opened; the message says what to do
   */
  public RemoteConsole(
      InetAddress address,
      int port,
      CommandRegistry commands,
      Secret password,
      LoginThrottle throttle)
      throws IOException {
    this.commands = commands;
    this.password = password;
    this.throttle = throttle;
    try {
      ProtocolFamily family = AddressFamily.of(address);
      server =
          (family == null ? ServerSocketChannel.open() : ServerSocketChannel.open(family)).socket();
      server.bind(new InetSocketAddress(address, port), BACKLOG);
    } catch (IOException e) {
      throw new IOException(
          String.format(
              Locale.ROOT,
              "rcon-port=%d can't be opened: %s; choose another with --rcon-port",
              port,
              e.getMessage()),
          e);
    }
    LastingThread.start("carom-rcon", () -> !server.isClosed(), this::accept);
  }

  private static void start(String name, Runnable task) {
    Thread thread = new Thread(task, name);
    thread.setDaemon(true);
    thread.start();
  }

  /** Returns the port. */
  public int port() {
    return server.getLocalPort();
  }

  private void accept() {
    try {
      Socket socket = server.accept();
      if (throttle.mustWait(socket.getInetAddress()) || !hasRoom()) {
        socket.close();
        return;
      }
      connections.add(socket);
      strangers.add(socket);
      try {
        start("carom-rcon-client", () -> serve(socket));
      } catch (Error e) { // the system has no thread left
        forget(socket);
        socket.close();
        throw e;
      }
    } catch (IOException e) {
      LOG.debug("no connection", e);
    }
  }

  private void serve(Socket socket) {
    try (socket) {
      socket.setSoTimeout(STRANGER_MS);
      DataInputStream in = new DataInputStream(socket.getInputStream());
      OutputStream out = socket.getOutputStream();
      if (!login(socket, in, out)) {
        return;
      }
      socket.setSoTimeout(SILENCE_MS);
      Caller caller = new Caller(Role.OPERATOR, "rcon", socket.getInetAddress().getHostAddress());
      while (true) {
        Packet message = read(in);
        if (message.type == COMMAND) {
          write(out, message.id, ANSWER, commands.run(message.body, caller).text());
        } else {
          // Clients send an empty message to see where a long answer ends.
          write(out, message.id, ANSWER, "");
        }
      }
    } catch (EOFException | SocketTimeoutException e) {
      LOG.debug("rcon: a connection ended", e);
    } catch (IOException e) {
      LOG.debug("rcon: a connection broke", e);
    } finally {
      forget(socket);
    }
  }

  private void forget(Socket socket) {
    strangers.remove(socket);
    connections.remove(socket);
  }

  /** Returns whether there is a place, for which the stranger who has waited longest gives way. */
  private boolean hasRoom() throws IOException {
    if (connections.size() < MAX_CONNECTIONS) {
      return true;
    }
    Socket oldest = strangers.poll();
    if (oldest == null) {
      return false;
    }
    connections.remove(oldest);
    oldest.close();
    return true;
  }

  /** Returns whether the first message is the right password. Another message is no try. */
  private boolean login(Socket socket, DataInputStream in, OutputStream out) throws IOException {
    Packet first = read(in);
    InetAddress address = socket.getInetAddress();
    if (first.type != AUTH || throttle.mustWait(address)) {
      return false;
    }
    boolean right = password.matches(first.body);
    if (right && !strangers.remove(socket)) {
      return false; // it gave way in this moment
    }
    // Some servers send an empty answer before; clients that read ahead lose what follows it.
    write(out, right ? first.id : REFUSED, AUTH_ANSWER, "");
    if (right) {
      throttle.right(address);
      LOG.info("rcon: {} logged in", address.getHostAddress());
    } else {
      throttle.wrong(address);
      LOG.warn("rcon: a wrong password from {}", address.getHostAddress());
    }
    return right;
  }

  /** Reads the next message; fails where the stream ends or the size is wrong. */
  static Packet read(DataInputStream in) throws IOException {
    int size = Integer.reverseBytes(in.readInt());
    if (size < FRAME_BYTES || size > FRAME_BYTES + MAX_BODY_BYTES) {
      throw new IOException("size=" + size);
    }
    ByteBuffer bytes = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    in.readFully(bytes.array());
    String body =
        new String(bytes.array(), 2 * Integer.BYTES, size - FRAME_BYTES, StandardCharsets.UTF_8);
    return new Packet(bytes.getInt(), bytes.getInt(), body);
  }

  /**
   * Writes a text. A long one takes several messages, all but the last full: clients take a full
   * one for a sign that there are more.
   */
  private static void write(OutputStream out, int id, int type, String text) throws IOException {
    byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
    int from = 0;
    do {
      int length = Math.min(MAX_BODY_BYTES, bytes.length - from);
      out.write(
          ByteBuffer.allocate(Integer.BYTES + FRAME_BYTES + length)
              .order(ByteOrder.LITTLE_ENDIAN)
              .putInt(FRAME_BYTES + length)
              .putInt(id)
              .putInt(type)
              .put(bytes, from, length)
              .array());
      from += length;
    } while (from < bytes.length);
    out.flush();
  }

  @Override
  public void close() {
    try {
      server.close();
      for (Socket socket : connections) {
        socket.close();
      }
    } catch (IOException e) {
      LOG.debug("rcon: not closed", e);
    }
  }
}
