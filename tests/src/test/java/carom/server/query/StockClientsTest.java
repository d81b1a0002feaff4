package carom.server.query;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.transport.Impairment;
import carom.outside.Python;
import carom.server.access.LoginThrottle;
import carom.server.access.Secret;
import carom.server.command.Command;
import carom.server.command.CommandRegistry;
import carom.server.command.RoomCommands;
import carom.server.command.SaveSource;
import carom.server.config.DataFolder;
import carom.suite.Needs;
import carom.testkit.Stepper;
import java.net.InetAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: clients that others wrote speak with the server. Method: the Python packages python-a2s and
 * rcon, installed by pip into the build folder, ask a running arena with two bots.
 */
@Needs("processes")
@Timeout(400)
final class StockClientsTest {
  private static final InetAddress LOOPBACK = InetAddress.getLoopbackAddress();
  private static final List<String> PACKAGES = List.of("python-a2s==1.4.2", "rcon==2.4.9");
  private static final String PASSWORD = "a long password";

  @TempDir private Path folder;
  private Python python;
  private Stepper stepper;
  private StatusQuery query;
  private RemoteConsole console;
  private Thread play;

  @BeforeEach
  void start() throws Exception {
    python = new Python(folder, "stock-clients", PACKAGES);
    stepper = Stepper.of("arena");
    // They stand still, so that the score stays 0.
    stepper.join("Ann", Impairment.NONE, (view, tick, in) -> {});
    stepper.join("Zoë", Impairment.NONE, (view, tick, in) -> {});
    stepper.run(2);
    StatusFacts facts =
        new StatusFacts("My server", "1.2", 54_555, 54_777, stepper.server().rooms());
    query = new StatusQuery(LOOPBACK, 0, facts);
    CommandRegistry commands = new CommandRegistry();
    RoomCommands.add(
        commands, stepper.server().rooms(), new DataFolder(folder), null, SaveSource.NONE);
    commands.add(
        new Command("long", "", "", words -> "0123456789".repeat(1_000) + "end", Command.NONE));
    Path file = Files.writeString(folder.resolve("rcon.password"), PASSWORD);
    console =
        new RemoteConsole(
            LOOPBACK, 0, commands, Secret.of(file), new LoginThrottle(System::nanoTime));
    play =
        new Thread(
            () -> {
              while (!Thread.interrupted()) {
                stepper.run(0.01);
              }
            });
    play.start();
  }

  @AfterEach
  void stop() throws InterruptedException {
    if (play != null) {
      play.interrupt();
      play.join();
    }
    if (console != null) {
      console.close();
      query.close();
      stepper.close();
    }
  }

  /** Runs lines of Python with the arguments in {@code argv[1:]} and returns what they print. */
  private String python(String lines, Object... arguments) throws Exception {
    Path script = folder.resolve("client.py");
    Files.writeString(script, "from sys import argv\n" + lines, StandardCharsets.UTF_8);
    return python.run(script, arguments);
  }

  @Test
  void pythonA2sReadsInfoPlayersAndRules() throws Exception {
    String text =
        python(
            """
            import a2s
            server = (argv[1], int(argv[2]))
            info = a2s.info(server, timeout=20)
            print(info.server_name, info.map_name, info.folder, info.game, sep="|")
            print(info.player_count, info.max_players, info.bot_count, info.server_type, sep="|")
            print(info.password_protected, info.vac_enabled, info.version, info.port, sep="|")
            print(info.keywords)
            for player in a2s.players(server, timeout=20):
                print(player.name, player.score, player.duration > 1, sep="|")
            for name, value in a2s.rules(server, timeout=20).items():
                print(name, value, sep="=")
            """,
            LOOPBACK.getHostAddress(),
            query.port());
    List<String> lines = text.lines().toList();
    assertEquals("My server|Corner Pocket|carom|arena", lines.get(0));
    assertEquals("2|64|0|d", lines.get(1));
    assertEquals("False|False|1.2|54555", lines.get(2));
    assertTrue(lines.get(3).startsWith("carom,tcp=54555,udp=54777,protocol="), lines.get(3));
    assertEquals(List.of("Ann|0|True", "Zoë|0|True"), lines.subList(4, 6));
    assertTrue(lines.contains("room_1=arena, Corner Pocket, 2/64"), text);
  }

  @Test
  void rconRunsCommands() throws Exception {
    String text =
        python(
            """
            from rcon.source import Client
            with Client(argv[1], int(argv[2]), timeout=20, passwd=argv[3]) as client:
                for command in ("rooms", "list", "say hello", "kick Zoë", "lost"):
                    print(client.run(command))
                text = client.run("long")
                print(len(text), text[-13:])
            """,
            LOOPBACK.getHostAddress(),
            console.port(),
            PASSWORD);
    List<String> lines = text.lines().toList();
    assertTrue(lines.get(0).matches("room +players +game +level .*"), text);
    assertTrue(lines.get(1).matches("@1 +2/64 +arena +Corner Pocket .*"), text);
    assertTrue(lines.get(2).matches("id +name +room .*"), text);
    assertTrue(lines.get(3).matches("\\d+ +Ann +1 .*"), text);
    assertTrue(lines.get(4).matches("\\d+ +Zoë +1 .*"), text);
    assertEquals("said to 2 players", lines.get(5));
    assertTrue(lines.get(6).contains("Zoë"), text);
    assertTrue(lines.get(7).startsWith("unknown command=lost; did you mean \"list\"?"), text);
    assertEquals("10003 0123456789end", lines.get(8));
  }

  @Test
  void rconIsToldThatAPasswordIsWrong() throws Exception {
    String text =
        python(
            """
            from rcon.exceptions import WrongPassword
            from rcon.source import Client
            try:
                with Client(argv[1], int(argv[2]), timeout=20, passwd="guess") as client:
                    print(client.run("rooms"))
            except WrongPassword:
                print("refused")
            """,
            LOOPBACK.getHostAddress(),
            console.port());
    assertEquals("refused", text.strip());
  }
}
