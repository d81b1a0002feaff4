package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.fixtures.Jvm;
import carom.net.kryo.KryoClientTransport;
import carom.net.protocol.ClientMessage;
import carom.net.protocol.ServerMessage;
import carom.net.transport.Link;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.Message;
import carom.sim.message.MessageKind.Direction;
import carom.sim.message.MessageKinds;
import carom.suite.Needs;
import java.io.BufferedReader;
import java.io.DataInputStream;
import java.io.File;
import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: no command gives a secret away or harms a file that is none of its own, in any role.
 * Method: the program as a process; every command that {@code help} lists, with every secret as its
 * first and second word, by RCON, in the chat and at the console.
 */
@Needs("sockets")
@Timeout(300)
final class SecretsTest {
  private static final Pattern READY = Pattern.compile("ready tcp=(\\d+) udp=(\\d+)");

  /** Length of a piece of a secret that nobody says by chance. */
  private static final int PIECE = 6;

  /** Words that may stand before a file. */
  private static final Map<String, String> FIRST =
      Map.of(
          "game", "arena", "ban", "name", "unban", "name", "allow", "name", "stop", "--redirect");

  @TempDir Path folder;
  private final MessageKinds kinds = new MessageKinds();
  private final Map<Path, String> secrets = new LinkedHashMap<>();
  private final TreeSet<String> pieces = new TreeSet<>();
  private Path data;
  private Process server;
  private BufferedReader out;
  private int tcp;
  private int udp;
  private int said;

  private void secret(Path file, String content) throws IOException {
    Files.createDirectories(file.getParent());
    Files.writeString(file, content);
    secrets.put(file, content);
  }

  private void start() throws Exception {
    data = folder.resolve("data");
    secret(data.resolve("admin.token"), "zqtokenalphabravo\n");
    secret(data.resolve("rcon.password"), "880011220033\n");
    secret(data.resolve("notes.json"), "{\"password\": \"vjsecretvalue\", \"bodies\": 7}\n");
    secret(data.resolve("logs/old.txt"), "\"xwquotedsecret\"\n");
    secret(folder.resolve("backend.pem"), "-----BEGIN PRIVATE KEY-----\nMC4CAQAwBQYDK2VwBCIE\n");
    secret(folder.resolve("list.txt"), "[xkfirstword, yksecondword]\n");
    secret(folder.resolve("half.json"), "{\"name\": ykunfinished\n");
    Files.createSymbolicLink(data.resolve("leak.json"), folder.resolve("half.json"));
    List<String> command = Jvm.command(ServerMain.class);
    command.addAll(List.of("--bind", "127.0.0.1", "--tcp-port", "0", "--udp-port", "0"));
    command.addAll(List.of("--rcon", "--rcon-port", "0", "--no-web", "--no-query"));
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    builder.environment().put("CAROM_DATA", "data");
    builder.environment().keySet().removeIf(name -> name.startsWith("CAROM_W"));
    server = builder.redirectError(new File(folder.toFile(), "err")).start();
    out = server.inputReader(StandardCharsets.UTF_8);
    for (String line; (line = out.readLine()) != null; ) {
      Matcher ready = READY.matcher(line);
      if (ready.find()) {
        tcp = Integer.parseInt(ready.group(1));
        udp = Integer.parseInt(ready.group(2));
        break;
      }
    }
    assertTrue(tcp > 0, () -> log());
    for (Map.Entry<Path, String> secret : secrets.entrySet()) {
      for (String line : secret.getValue().split("[^A-Za-z0-9]+")) {
        for (int i = 0; i + PIECE <= line.length(); i++) {
          pieces.add(line.substring(i, i + PIECE));
        }
      }
    }
    pieces.removeIf(piece -> "-----BEGIN PRIVATE KEY bodies password".contains(piece));
  }

  @AfterEach
  void end() {
    if (server != null) {
      server.destroyForcibly();
    }
  }

  private String log() {
    try {
      return Files.readString(folder.resolve("err"));
    } catch (IOException e) {
      return e.toString();
    }
  }

  /** Waits until the store of accounts, which opens beside the start, has its file. */
  private void awaitStore() throws Exception {
    Path file = data.resolve("accounts.mv.db");
    byte[] last = {};
    for (int i = 0; last.length == 0 || !Arrays.equals(last, Files.readAllBytes(file)); i++) {
      assertTrue(i < 100, () -> "the store isn't opened: " + log());
      last = Files.exists(file) ? Files.readAllBytes(file) : last;
      Thread.sleep(300);
    }
  }

  /** Returns the content of all files that no command may change. */
  private Map<Path, String> kept() throws IOException {
    Map<Path, String> kept = new HashMap<>();
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : (Iterable<Path>) files.filter(Files::isRegularFile)::iterator) {
        String name = folder.relativize(file).toString().replace(File.separatorChar, '/');
        boolean own =
            name.matches(
                "err|data/(bans|allow|admin)\\.txt|data/(recordings|saves)/.*|data/logs/c.*");
        if (!own) {
          byte[] bytes = Files.readAllBytes(file);
          kept.put(file, new String(bytes, StandardCharsets.ISO_8859_1));
        }
      }
    }
    return kept;
  }

  /** Returns the ways in which somebody may write a file. */
  private List<String> spellings(Path file) {
    String name = folder.relativize(file).toString();
    Path fromLevels = data.resolve("levels").relativize(file);
    return List.of(
        name,
        file.toString(),
        fromLevels.toString(),
        "\"" + folder.resolve("data/..") + "/" + name + "\"");
  }

  private List<String> lines(List<String> commands) {
    List<String> lines = new ArrayList<>();
    List<Path> files = new ArrayList<>(secrets.keySet());
    files.add(data.resolve("server.key"));
    files.add(data.resolve("leak.json"));
    int turn = 0;
    for (String command : commands) {
      for (Path file : files) {
        List<String> ways = spellings(file);
        String first = command + " " + ways.get(turn++ % ways.size());
        lines.add(first);
        String word = FIRST.getOrDefault(command, "x");
        lines.add(command + " " + word + " " + ways.get(turn++ % ways.size()));
      }
    }
    return lines;
  }

  private void gaveNothingAway(String how, String answer) {
    for (String piece : pieces) {
      assertFalse(answer.contains(piece), () -> how + " told " + piece + ": " + answer);
    }
  }

  /** A connection by Source RCON, written for this test. */
  private static final class Rcon implements AutoCloseable {
    private final Socket socket;
    private final DataInputStream in;

    Rcon(int port, String password) throws IOException {
      socket = new Socket(InetAddress.getLoopbackAddress(), port);
      in = new DataInputStream(socket.getInputStream());
      send(3, password);
      assertEquals("", receive());
    }

    String run(String line) throws IOException {
      send(2, line);
      return receive();
    }

    private void send(int type, String text) throws IOException {
      byte[] body = text.getBytes(StandardCharsets.UTF_8);
      ByteBuffer bytes = ByteBuffer.allocate(14 + body.length).order(ByteOrder.LITTLE_ENDIAN);
      socket
          .getOutputStream()
          .write(bytes.putInt(10 + body.length).putInt(1).putInt(type).put(body).array());
    }

    private String receive() throws IOException {
      StringBuilder text = new StringBuilder();
      int length;
      do {
        length = Integer.reverseBytes(in.readInt()) - 10;
        assertEquals(1, Integer.reverseBytes(in.readInt()), "the id of an answer");
        in.readInt();
        text.append(new String(in.readNBytes(length), StandardCharsets.UTF_8));
        in.readNBytes(2);
      } while (length == 4_096);
      return text.toString();
    }

    @Override
    public void close() throws IOException {
      socket.close();
    }
  }

  private int rconPort() throws InterruptedException {
    for (int i = 0; i < 2_000; i++) {
      Matcher port = Pattern.compile("rcon: tcp (\\d+)").matcher(log());
      if (port.find()) {
        return Integer.parseInt(port.group(1));
      }
      Thread.sleep(10);
    }
    throw new AssertionError(log());
  }

  private static List<String> listed(String help) {
    return help.lines()
        .filter(line -> line.matches("[a-z].*"))
        .map(line -> line.split(" ", 2)[0])
        .toList();
  }

  @Test
  void noCommandGivesASecretAwayOrHarmsAFile() throws Exception {
    start();
    try (Rcon rcon = new Rcon(rconPort(), "880011220033")) {
      List<String> commands = listed(rcon.run("help"));
      assertTrue(commands.contains("level") && commands.contains("replay"), commands.toString());
      awaitStore();
      Map<Path, String> before = kept();
      for (String line : lines(commands)) {
        gaveNothingAway("rcon: " + line, rcon.run(line));
      }
      rcon.run("record stop");
      for (String line :
          List.of("level data/notes.json", "record ../x.carom", "replay ../../half.json")) {
        String answer = rcon.run(line);
        assertTrue(answer.contains("only the server's console names"), line + ": " + answer);
      }
      assertEquals(before, kept(), "what operators can change");
      moderate(rcon, commands);
      assertEquals(before, kept(), "what moderators can change");
      atTheConsole(lines(commands));
    }
    gaveNothingAway("the log", log());
  }

  /** Gives all lines at standard input. The console may name files, and quotes none of them. */
  private void atTheConsole(List<String> lines) throws IOException {
    List<String> all = new ArrayList<>(lines);
    all.removeIf(line -> line.startsWith("record ")); // it may write anywhere
    StringBuilder text = new StringBuilder();
    all.forEach(line -> text.append(line).append('\n'));
    text.append("help help\n");
    Thread writer =
        new Thread(
            () -> {
              try {
                server.getOutputStream().write(text.toString().getBytes(StandardCharsets.UTF_8));
                server.getOutputStream().flush();
              } catch (IOException e) {
                throw new AssertionError(e);
              }
            });
    writer.start();
    StringBuilder answers = new StringBuilder();
    for (String line; (line = out.readLine()) != null && !line.equals("help [COMMAND]"); ) {
      answers.append(line).append('\n');
    }
    assertTrue(answers.toString().contains("not JSON"), "levels were read");
    gaveNothingAway("console", answers.toString());
  }

  /** Gives lines in the chat, as a player whose address is listed. */
  private void moderate(Rcon rcon, List<String> commands) throws Exception {
    rcon.run("admin 127.0.0.1");
    rcon.run("level arena");
    KryoClientTransport transport = new KryoClientTransport();
    try {
      FakeClient mod = new FakeClient(transport.connect("127.0.0.1", tcp, udp));
      await(mod, () -> mod.link.state() == Link.State.OPEN);
      mod.hello("Mod");
      await(mod, () -> mod.ready);
      mod.link.send(new ClientMessage.Heard(0));
      say(mod, "/help");
      await(mod, () -> heard(mod).contains("Quotes hold words together"));
      List<String> own = listed(heard(mod).replaceAll("(?m)^-1: ", ""));
      for (String command : commands) {
        if (!own.contains(command)) {
          int from = heard(mod).length();
          say(mod, "/" + command + " data/admin.token");
          await(mod, () -> heard(mod).substring(from).contains(command + " isn't a moderator's"));
        }
      }
      assertTrue(
          own.containsAll(List.of("list", "say", "kick", "mute", "ban", "spectate", "allow")),
          own.toString());
      assertFalse(own.contains("level") || own.contains("admin") || own.contains("config"));
      gaveNothingAway("chat", heard(mod));
    } finally {
      transport.close();
    }
  }

  private FakeClient say(FakeClient client, String text) {
    byte[] bytes = kinds.encode(BuiltInKinds.SAY.of(false, text), Direction.FROM_CLIENT);
    client.link.send(new ClientMessage.GameMessage(++said, bytes));
    return client;
  }

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

  private static void await(FakeClient client, BooleanSupplier what) throws InterruptedException {
    for (int i = 0; i < 1_000 && !what.getAsBoolean(); i++) {
      client.step(0);
      Thread.sleep(10);
    }
    assertTrue(what.getAsBoolean(), () -> "" + client.messages);
  }
}
