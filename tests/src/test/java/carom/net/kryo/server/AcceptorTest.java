package carom.net.kryo.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import carom.suite.Needs;
import com.esotericsoftware.kryonet.Connection;
import com.esotericsoftware.kryonet.Serialization;
import com.esotericsoftware.kryonet.Server;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Goal: who connects is heard, however many others connect. Method: a server that takes its turns
 * when the test says so.
 */
@Needs("sockets")
class AcceptorTest {
  private static final String HOST = "127.0.0.1";
  private static final int CONNECTIONS = 120; // some systems keep 128
  private static final int TIMEOUT_MS = 900; // the system repeats a lost attempt after a second

  private int taken;

  private Server server() {
    return new Server(1_024, 1_024, new Frames()) {
      @Override
      protected Connection newConnection() {
        taken++;
        return super.newConnection();
      }
    };
  }

  @Test
  void manyConnectionsWaitForABusyServerAndAreTakenInFewTurns() throws IOException {
    Server server = server();
    Acceptor acceptor = new Acceptor(server, List.of(InetAddress.getByName(HOST)), 0);
    List<Socket> sockets = new ArrayList<>();
    try {
      for (int i = 0; i < CONNECTIONS; i++) {
        Socket socket = new Socket();
        sockets.add(socket);
        socket.connect(new InetSocketAddress(HOST, acceptor.port()), TIMEOUT_MS);
      }
      assertEquals(0, taken, "the server hasn't looked yet");
      for (int turn = 0; turn < 2; turn++) {
        server.update(TIMEOUT_MS); // comes back because connections wait
        acceptor.acceptWaiting();
      }
      assertEquals(CONNECTIONS, taken);
      server.update(1);
      acceptor.acceptWaiting();
      assertEquals(CONNECTIONS, taken, "nobody waits any more");
    } finally {
      for (Socket socket : sockets) {
        socket.close();
      }
      acceptor.close();
      server.dispose();
    }
  }

  @Test
  void aPortIsFreeOnceItIsClosed() throws IOException {
    Server server = server();
    Acceptor acceptor = new Acceptor(server, List.of(InetAddress.getByName(HOST)), 0);
    int port = acceptor.port();
    InetAddress host = InetAddress.getByName(HOST);
    assertThrows(IOException.class, () -> new Acceptor(server, List.of(host), port).close());
    acceptor.close();
    new ServerSocket(port, 1, host).close(); // throws if the port is still taken
    server.dispose();
  }

  /** Nothing is read, and a registration is one byte. */
  private static final class Frames implements Serialization {
    @Override
    public void write(Connection connection, ByteBuffer buffer, Object frame) {
      buffer.put((byte) 0);
    }

    @Override
    public Object read(Connection connection, ByteBuffer buffer) {
      throw new UnsupportedOperationException();
    }

    @Override
    public int getLengthLength() {
      return Integer.BYTES;
    }

    @Override
    public void writeLength(ByteBuffer buffer, int length) {
      buffer.putInt(length);
    }

    @Override
    public int readLength(ByteBuffer buffer) {
      return buffer.getInt();
    }
  }
}
