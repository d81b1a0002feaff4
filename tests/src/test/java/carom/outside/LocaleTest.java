package carom.outside;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.suite.Needs;
import java.io.IOException;
import java.net.DatagramPacket;
import java.net.DatagramSocket;
import java.net.InetAddress;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: no protocol, file or log depends on the locale. Method: installed programs, each under a
 * locale that has digits, letters or years of its own, against each other. A run draws two servers
 * of four; {@code -Dcarom.all=true} takes all.
 */
@Needs("processes")
@Timeout(180)
final class LocaleTest {
  /** Arabic digits, a dotless i, Persian digits and months, Devanagari digits. */
  private static final List<String> LOCALES =
      List.of(
          "-Duser.language=ar -Duser.country=EG",
          "-Duser.language=tr -Duser.country=TR",
          "-Duser.language=fa -Duser.country=IR -Duser.extensions=u-ca-persian-nu-arabext",
          "-Duser.language=hi -Duser.country=IN -Duser.extensions=u-nu-deva");

  private static final Pattern FOREIGN_DIGIT = Pattern.compile("[\\p{Nd}&&[^0-9]]");
  private static final Pattern QUERIES = Pattern.compile("status queries: udp (\\d+)");
  private static final Pattern RECORDING = Pattern.compile("recording: (\\S+\\.carom)");

  @TempDir Path folder;
  private Installation programs;

  @BeforeEach
  void install() {
    programs = new Installation(folder);
  }

  @AfterEach
  void end() {
    programs.close();
  }

  private static Map<String, String> locale(int index) {
    return Map.of("LC_ALL", "C", "JAVA_OPTS", LOCALES.get(index % LOCALES.size()));
  }

  /** Asks a server for its status as stock tools do, and returns the answer as Latin letters. */
  private static String status(int port) throws IOException {
    byte[] ask =
        "\u00ff\u00ff\u00ff\u00ffTSource Engine Query\0".getBytes(StandardCharsets.ISO_8859_1);
    try (DatagramSocket socket = new DatagramSocket()) {
      socket.setSoTimeout(5_000);
      byte[] request = ask;
      while (true) {
        InetAddress here = InetAddress.getLoopbackAddress();
        socket.send(new DatagramPacket(request, request.length, here, port));
        DatagramPacket answer = new DatagramPacket(new byte[2_000], 2_000);
        socket.receive(answer);
        byte[] bytes = Arrays.copyOf(answer.getData(), answer.getLength());
        if (bytes[4] != 'A') {
          return new String(bytes, StandardCharsets.UTF_8);
        }
        request = ByteBuffer.allocate(ask.length + 4).put(ask).put(bytes, 5, 4).array();
      }
    }
  }

  @Test
  void programsOfAllLocalesUnderstandEachOther() throws Exception {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println("LocaleTest seed=" + seed);
    List<Integer> servers = new ArrayList<>(List.of(0, 1, 2, 3));
    Collections.shuffle(servers, new Random(seed));
    for (int i : servers.subList(0, Boolean.getBoolean("carom.all") ? 4 : 2)) {
      String data = "data" + i;
      Installation.Running server =
          programs.server(locale(i), data, "--query-port=0", "--record=" + data + ".carom");
      int port = server.port();
      Matcher queries = server.await(QUERIES);
      String status = status(Integer.parseInt(queries.group(1)));
      assertTrue(status.contains("tcp=" + port), status);

      Installation.Running bots =
          programs.start(
              locale(i + 1), "carom-bots", "--host=127.0.0.1:" + port, "--count=2", "--seconds=2");
      assertEquals(0, bots.end(), bots.output());
      Installation.Running client =
          programs.start(locale(i + 2), "carom-client", "--list", "--host=127.0.0.1:" + port);
      assertEquals(0, client.end(), client.output());
      assertTrue(client.output().contains("arena"), client.output());

      server.type("stop");
      assertEquals(0, server.end(), server.output());
      Installation.Running replay =
          programs.start(locale(i + 3), "carom", "replay", recording(server));
      assertEquals(0, replay.end(), replay.output());
      assertTrue(replay.output().contains("OK: "), replay.output());
      for (Installation.Running program : List.of(server, bots, client, replay)) {
        assertFalse(FOREIGN_DIGIT.matcher(program.output()).find(), program.output());
      }
      requireAsciiDigits(folder.resolve(data));
    }
  }

  private static String recording(Installation.Running server) throws Exception {
    return server.await(RECORDING).group(1);
  }

  /** Requires that no file of a data folder has other digits in its name or its text. */
  private static void requireAsciiDigits(Path data) throws IOException {
    List<Path> files = new ArrayList<>();
    try (Stream<Path> all = Files.walk(data)) {
      all.filter(Files::isRegularFile).forEach(files::add);
    }
    assertFalse(files.isEmpty());
    for (Path file : files) {
      String text = file + "\n" + new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
      assertFalse(FOREIGN_DIGIT.matcher(text).find(), text);
    }
  }

  @Test
  void whatIsTypedAndGivenIsUtf8WithoutALocale() throws Exception {
    Map<String, String> none = Map.of("LC_ALL", "C");
    String data = "Sp\u00efele \u2764";
    Installation.Running server =
        programs.server(none, data, "--no-query", "--name=Bj\u00f8rns Server");
    assertTrue(server.port() > 0, server.output());
    server.type("ban name Bj\u00f8rn pour \u00e7a");
    server.type(Installation.latin("ban name J\u00f8rn"));
    server.type("stop");
    assertEquals(0, server.end(), server.output());
    assertTrue(server.output().contains("The line isn't UTF-8"), server.output());
    assertTrue(server.output().contains("start: Bj\u00f8rns Server"), server.output());
    String bans = Files.readString(folder.resolve(data).resolve("bans.txt"));
    assertTrue(bans.contains("Bj\u00f8rn"), bans);
    assertFalse(bans.contains("J\u00f8rn") || bans.contains("J?rn"), bans);

    Installation.Running again = programs.server(none, data, "--no-query");
    assertTrue(again.port() > 0, again.output());
    again.type("unban name Bj\u00f8rn");
    again.type("stop");
    assertEquals(0, again.end(), again.output());
    String left = Files.readString(folder.resolve(data).resolve("bans.txt"));
    assertFalse(left.contains("Bj\u00f8rn"), left + again.output());
  }
}
