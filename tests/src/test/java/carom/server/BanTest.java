package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.kryo.KryoClientTransport;
import carom.net.kryo.server.KryoLimits;
import carom.net.kryo.server.KryoServerTransport;
import carom.net.kryo.server.ServerIdentity;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.GoodbyeReason;
import carom.net.protocol.Protocol;
import carom.net.protocol.RefusalReason;
import carom.net.protocol.ServerMessage;
import carom.net.seal.Encryption;
import carom.net.seal.PlayerKey;
import carom.net.transport.Link;
import carom.server.access.AccessCommands;
import carom.server.access.AccessLists;
import carom.server.access.AdminChat;
import carom.server.command.Caller;
import carom.server.command.CommandRegistry;
import carom.server.config.DataFolder;
import carom.server.config.ServerConfig;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.Message;
import carom.sim.message.MessageKind.Direction;
import carom.sim.message.MessageKinds;
import carom.suite.Needs;
import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Goal: who is banned stays out. Method: real sockets, commands, and an editor's changes. */
@Needs("sockets")
@Timeout(60)
final class BanTest {
  @TempDir private Path folder;
  private final CommandRegistry commands = new CommandRegistry();
  private final KryoClientTransport transport = new KryoClientTransport();
  private Server server;
  private Thread watch;
  private final MessageKinds kinds = new MessageKinds(); // the room's belong to its thread
  private int said;

  @BeforeEach
  void start() throws IOException {
    InetAddress loopback = InetAddress.getLoopbackAddress();
    server =
        new Server(
            ServerConfig.defaults(),
            () -> new TestGame(3),
            TestGame.level(),
            new KryoServerTransport(
                loopback, 0, 0, KryoLimits.DEFAULT, ServerIdentity.temporary(Encryption.ON)),
            System::nanoTime);
    AccessLists lists = new AccessLists(new DataFolder(folder), false, InstantSource.system());
    server.admit(lists);
    watch = AccessCommands.add(commands, lists, server.rooms());
    server.chatCommands(new AdminChat(commands, lists, server.rooms()));
    server.start();
  }

  @AfterEach
  void stop() {
    watch.interrupt();
    transport.close();
    server.close();
  }

  private FakeClient connect(String name) throws InterruptedException {
    FakeClient client =
        new FakeClient(transport.connect("127.0.0.1", server.tcpPort(), server.udpPort()));
    await(client, () -> client.link.state() == Link.State.OPEN);
    client.hello(name);
    await(client, () -> client.ready || client.refused != null);
    return client;
  }

  private static void await(FakeClient client, BooleanSupplier what) throws InterruptedException {
    for (int i = 0; i < 2_000 && !what.getAsBoolean(); i++) {
      client.step(0);
      Thread.sleep(5);
    }
    assertTrue(what.getAsBoolean(), () -> "" + client.messages);
  }

  /** Waits until a player is in the room, as its thread takes it in with a tick. */
  private FakeClient join(String name) throws InterruptedException {
    FakeClient client = connect(name);
    await(
        client,
        () ->
            server.rooms().get(0).operator().players().stream()
                .anyMatch(player -> player.name().equals(name)));
    return client;
  }

  private String run(String line) {
    CommandRegistry.Answer answer = commands.run(line, Caller.CONSOLE);
    assertTrue(answer.ok(), answer.text());
    return answer.text();
  }

  @Test
  void aBannedPlayerIsRemovedAndStaysOutUntilUnbanned() throws Exception {
    FakeClient bob = join("Bob B");
    assertTrue(
        commands
            .run("ban Rob", Caller.CONSOLE)
            .text()
            .contains("to ban a name in advance: ban name Rob"));
    String mistyped = commands.run("ban \"bob b\" 7x threats in chat", Caller.CONSOLE).text();
    assertTrue(mistyped.startsWith("TIME=7x is none, so nobody is banned; give 30m"), mistyped);
    for (String line : List.of("ban 10.0.0.0/99", "allow 10.0.0.0/99", "unban 300.1.2.3")) {
      CommandRegistry.Answer refused = commands.run(line, Caller.CONSOLE);
      assertFalse(refused.ok(), line);
      assertTrue(refused.text().contains(" is no address such as 203.0.113.7"), refused.text());
    }
    assertEquals("nobody is banned", run("ban"));
    assertTrue(run("allow").endsWith("the list is empty"));
    String answer = run("ban \"bob b\" 7d threats in chat");
    String expected = "banned name \"Bob B\" and address 127.0.0.1 of \"Bob B\" until 20";
    assertTrue(answer.startsWith(expected), answer);
    assertTrue(answer.endsWith("1 player removed"), answer);
    await(bob, () -> bob.goodbye != null);
    assertEquals(GoodbyeReason.KICKED, bob.goodbye.reason());
    assertTrue(
        bob.goodbye.text().contains("Reason: threats in chat. Until 20"), bob.goodbye.text());

    FakeClient again = connect("Somebody");
    assertEquals(RefusalReason.BANNED, again.refused.reason(), "the address is banned, too");
    assertTrue(again.refused.text().contains("threats in chat"), again.refused.text());
    run("unban 127.0.0.1");
    assertEquals(RefusalReason.BANNED, connect("BOB B").refused.reason());
    run("unban \"Bob B\"");
    assertNotNull(join("Bob B"));
    assertEquals("nobody is banned", run("ban"));
    assertTrue(run("ban #0").endsWith("1 player removed"));
    assertEquals(
        "removed the ban of name \"Bob B\" and of address 127.0.0.1 of \"Bob B\"",
        run("unban name \"bob b\""));
    assertNotNull(join("Somebody"));
  }

  @Test
  void aBanSparesTheOthersBehindTheSameAddress() throws Exception {
    FakeClient ann = join("Ann");
    FakeClient bob = join("Bob");
    join("Cid");
    int id =
        server.rooms().get(0).operator().players().stream()
            .filter(player -> player.name().equals("Bob"))
            .mapToInt(player -> player.id())
            .findFirst()
            .orElseThrow();
    assertEquals(
        "banned name \"Bob\" forever; 1 player removed; not address 127.0.0.1, which 2 other"
            + " players have: ban 127.0.0.1",
        run("ban " + id));
    await(bob, () -> bob.goodbye != null);
    for (int i = 0; i < 50; i++) {
      ann.step(0);
      Thread.sleep(5);
    }
    assertEquals(2, server.rooms().get(0).operator().players().size());
    assertTrue(run("ban 127.0.0.1 1h").endsWith("2 players removed"));
    await(ann, () -> ann.goodbye != null);
  }

  private void say(FakeClient client, String text) {
    byte[] bytes = kinds.encode(BuiltInKinds.SAY.of(false, text), Direction.FROM_CLIENT);
    client.link.send(new ClientMessage.GameMessage(++said, bytes));
  }

  /** Returns what the server has said to a client, as a player reads it. */
  private String heard(FakeClient client) {
    StringBuilder lines = new StringBuilder();
    for (Object message : client.messages) {
      if (message instanceof ServerMessage.GameMessage m) {
        Message line = kinds.decode(m.bytes(), 0, m.bytes().length, Direction.FROM_SERVER);
        if (line.is(BuiltInKinds.SAID)) {
          lines.append(line.count("player")).append(": ").append(line.text("text")).append('\n');
        }
      }
    }
    return lines.toString();
  }

  @Test
  void onlyAnAdminGivesCommandsInTheChat() throws Exception {
    FakeClient ann = join("Ann");
    FakeClient bob = join("Bob");
    ann.link.send(new ClientMessage.Heard(0));
    bob.link.send(new ClientMessage.Heard(0));
    say(ann, "/ban name bob");
    await(bob, () -> heard(bob).contains(": /ban name bob")); // Ann is no admin: it is chat
    assertTrue(
        commands.run("admin Ann", Caller.CONSOLE).text().contains("anybody can take the name"));
    Files.writeString(folder.resolve("admin.txt"), "name Ann\naddress 127.0.0.1\n");
    await(ann, () -> run("admin").equals("address 127.0.0.1")); // the name has no effect
    say(ann, "/ban name bob");
    await(ann, () -> heard(ann).contains("-1: banned name \"bob\" forever; 1 player removed"));
    await(bob, () -> bob.goodbye != null);
    say(ann, "/unadmin 127.0.0.1");
    say(ann, "/\"UnAdmin\" 127.0.0.1");
    String refusal = "-1: unadmin isn't a moderator's; operators give it at the console";
    await(ann, () -> heard(ann).split(refusal, -1).length == 3);
    assertEquals("address 127.0.0.1", run("admin"));
    run("unadmin 127.0.0.1");
    assertEquals("nobody gives commands in the chat", run("admin"));
  }

  @Test
  void anEditedFileComesIntoForceWithinSeconds() throws Exception {
    FakeClient bob = join("Bob");
    Files.writeString(folder.resolve("bans.txt"), "name Bob spam\n");
    await(bob, () -> bob.goodbye != null);
    assertTrue(bob.goodbye.text().contains("spam"), bob.goodbye.text());
    assertEquals(RefusalReason.BANNED, connect("Bob").refused.reason());
    assertNotNull(join("Ann"), "same address, other name");
  }

  /** Says hello with a key, over sockets, and returns when the answer is there. */
  private FakeClient connect(String name, PlayerKey key) throws InterruptedException {
    FakeClient client =
        new FakeClient(transport.connect("127.0.0.1", server.tcpPort(), server.udpPort()));
    await(client, () -> client.link.state() == Link.State.OPEN);
    String proof = key.proof(client.link.binding());
    client.link.send(
        new ClientMessage.Hello(
            Protocol.VERSION, Protocol.physicsDigest(), name, 0, "", "", "", proof));
    await(client, () -> client.ready || client.refused != null);
    return client;
  }

  @Test
  void aBanOfAKeyGoesWithTheAddressAndBothEndTogether() throws Exception {
    PlayerKey key = PlayerKey.random();
    connect("Kim", key);
    for (int i = 0; i < 400 && server.rooms().get(0).operator().players().isEmpty(); i++) {
      Thread.sleep(5);
    }
    String banned = run("ban Kim");
    assertTrue(banned.contains(key.account()) && banned.contains("127.0.0.1"), banned);
    assertEquals(RefusalReason.BANNED, connect("Kim", key).refused.reason());
    assertEquals(RefusalReason.BANNED, connect("Kim", PlayerKey.random()).refused.reason());
    run("unban account " + key.account());
    assertNotNull(connect("Kim", key).welcome);
  }
}
