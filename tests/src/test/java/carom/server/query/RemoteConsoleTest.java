package carom.server.query;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.access.LoginThrottle;
import carom.server.access.Secret;
import carom.server.command.Command;
import carom.server.command.CommandRegistry;
import carom.suite.Needs;
import java.io.DataInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: every byte of RCON is as specified, and strangers get nowhere. Method: the bytes that the
 * package {@code rcon} 2.4.9 sends, which {@link StockClientsTest} runs itself.
 */
@Needs("sockets")
@Timeout(60)
final class RemoteConsoleTest {
  private static final String PASSWORD = "a long password";

  @TempDir private Path folder;
  private final CommandRegistry commands = new CommandRegistry();
  private RemoteConsole server;

  @BeforeEach
  void start() throws IOException {
    Path file = Files.writeString(folder.resolve("rcon.password"), PASSWORD);
    commands.add(new Command("echo", "TEXT", "", words -> words.rest(0), Command.NONE));
    commands.add(new Command("long", "", "", words -> "a".repeat(10_000), Command.NONE));
    server =
        new RemoteConsole(
            InetAddress.getLoopbackAddress(),
            0,
            commands,
            Secret.of(file),
            new LoginThrottle(System::nanoTime));
  }

  @AfterEach
  void stop() {
    server.close();
  }

  /** A client. */
  private final class Client implements AutoCloseable {
    final Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.port());
    final DataInputStream in = new DataInputStream(socket.getInputStream());
    int id;
    int type;

    Client() throws IOException {
      socket.setSoTimeout(20_000);
    }

    void send(int newId, int newType, String text) throws IOException {
      byte[] body = text.getBytes(StandardCharsets.UTF_8);
      socket
          .getOutputStream()
          .write(
              ByteBuffer.allocate(14 + body.length)
                  .order(ByteOrder.LITTLE_ENDIAN)
                  .putInt(10 + body.length)
                  .putInt(newId)
                  .putInt(newType)
                  .put(body)
                  .array());
    }

    String receive() throws IOException {
      int size = Integer.reverseBytes(in.readInt());
      id = Integer.reverseBytes(in.readInt());
      type = Integer.reverseBytes(in.readInt());
      String text = new String(in.readNBytes(size - 10), StandardCharsets.UTF_8);
      assertEquals(0, in.readShort());
      return text;
    }

    Client login(String password) throws IOException {
      send(7, 3, password);
      assertEquals("", receive());
      assertEquals(2, type);
      return this;
    }

    @Override
    public void close() throws IOException {
      socket.close();
    }
  }

  @Test
  void thePasswordOpensTheCommands() throws IOException {
    try (Client client = new Client().login(PASSWORD)) {
      assertEquals(7, client.id);
      client.send(8, 2, "echo Zoë plays");
      assertEquals("Zoë plays", client.receive());
      assertEquals(8, client.id);
      client.send(9, 2, "ecko");
      assertTrue(client.receive().startsWith("unknown command=ecko; did you mean"));
    }
  }

  @Test
  void strangersWhoSayNothingKeepNobodyOut() throws IOException {
    List<Client> strangers = new ArrayList<>();
    for (int i = 0; i < 3 * RemoteConsole.MAX_CONNECTIONS; i++) {
      strangers.add(new Client());
      strangers.get(i).socket.getOutputStream().write(20); // and nothing more, for a long time
    }
    List<Client> operators = new ArrayList<>();
    for (int i = 0; i < RemoteConsole.MAX_CONNECTIONS; i++) {
      operators.add(new Client().login(PASSWORD));
    }
    for (Client stranger : strangers) {
      assertThrows(IOException.class, stranger::receive, "it gave way");
      stranger.close();
    }
    try (Client tooMany = new Client()) {
      assertThrows(IOException.class, () -> tooMany.login(PASSWORD), "nobody gives way to it");
    }
    for (Client operator : operators) {
      operator.send(8, 2, "echo here");
      assertEquals("here", operator.receive());
      operator.close();
    }
  }

  @Test
  void aLongAnswerComesInPiecesThatAreFullButForTheLast() throws IOException {
    try (Client client = new Client().login(PASSWORD)) {
      client.send(1, 2, "long");
      client.send(2, 0, "");
      StringBuilder text = new StringBuilder();
      for (int length : new int[] {4_096, 4_096, 1_808}) {
        String piece = client.receive();
        assertEquals(1, client.id);
        assertEquals(length, piece.length());
        text.append(piece);
      }
      assertEquals("", client.receive());
      assertEquals(2, client.id);
      assertEquals("a".repeat(10_000), text.toString());
    }
  }

  @Test
  void strangersAreRefusedSlowedDownAndCutOff() throws IOException {
    try (Client client = new Client()) {
      client.send(1, 2, "echo x"); // before the password
      assertEquals(-1, client.in.read());
    }
    try (Client client = new Client()) {
      client.socket.getOutputStream().write(new byte[] {-1, -1, -1, 127});
      assertEquals(-1, client.in.read());
    }
    for (int i = 0; i < LoginThrottle.MOST; i++) {
      try (Client client = new Client().login("wrong " + i)) {
        assertEquals(-1, client.id);
        assertEquals(-1, client.in.read());
      }
    }
    // Now even the right one has to wait.
    assertThrows(
        IOException.class,
        () -> {
          try (Client client = new Client()) {
            client.login(PASSWORD);
          }
        });
  }
}
