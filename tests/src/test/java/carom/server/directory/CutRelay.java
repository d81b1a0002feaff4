package carom.server.directory;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/** A way by TCP to a port of this machine that can be cut, stopped up and opened again. */
final class CutRelay implements AutoCloseable {
  private final int target;
  private final ServerSocket server;
  private final Set<Socket> sockets = ConcurrentHashMap.newKeySet();
  private volatile boolean isStoppedUp;
  private volatile boolean isCut;

  CutRelay(int target) throws IOException {
    this.target = target;
    server = new ServerSocket(0, 50, InetAddress.getLoopbackAddress());
    begin(this::accept);
  }

  int port() {
    return server.getLocalPort();
  }

  /** Ends all connections; new ones are ended at once until {@link #open}. */
  void cut() {
    isCut = true;
    breakAll();
  }

  /** Ends the connections that are open now. */
  void breakAll() {
    sockets.forEach(CutRelay::close);
    sockets.clear();
  }

  /** Swallows all bytes from now on, without ending a connection. */
  void stopUp() {
    isStoppedUp = true;
  }

  /** Lets new connections through again. */
  void open() {
    isStoppedUp = false;
    isCut = false;
    breakAll();
  }

  private static void begin(Runnable work) {
    Thread thread = new Thread(work, "test-relay");
    thread.setDaemon(true);
    thread.start();
  }

  private void accept() {
    while (!server.isClosed()) {
      try {
        Socket near = server.accept();
        if (isCut) {
          close(near);
          continue;
        }
        Socket far = new Socket();
        sockets.add(near);
        sockets.add(far);
        far.connect(new InetSocketAddress(InetAddress.getLoopbackAddress(), target), 2_000);
        begin(() -> copy(near, far));
        begin(() -> copy(far, near));
      } catch (IOException e) {
        breakAll(); // the target is gone, or this relay
      }
    }
  }

  private void copy(Socket from, Socket to) {
    byte[] bytes = new byte[8_192];
    try {
      InputStream in = from.getInputStream();
      OutputStream out = to.getOutputStream();
      for (int n = in.read(bytes); n >= 0; n = in.read(bytes)) {
        if (!isStoppedUp) {
          out.write(bytes, 0, n);
        }
      }
    } catch (IOException e) {
      // one end is gone
    }
    close(from);
    close(to);
    sockets.remove(from);
    sockets.remove(to);
  }

  private static void close(Socket socket) {
    try {
      socket.close();
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  @Override
  public void close() throws IOException {
    server.close();
    breakAll();
  }
}
