package carom.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.suite.Needs;
import com.sun.net.httpserver.HttpServer;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: the first command of a newcomer works or says what to do. Method: {@code gradlew} and
 * {@code gradle/Wrapper.java}, which {@code gradlew.bat} runs, with a home of their own and a small
 * release that only prints what it is called with.
 */
@Needs("processes")
@Timeout(120)
final class GradlewTest {
  private static final Path ROOT = Path.of("..").toAbsolutePath().normalize();

  @TempDir private Path folder;
  private HttpServer web;
  private byte[] release;
  private String path;

  @BeforeEach
  void layOut() throws Exception {
    assumeTrue(File.separatorChar == '/', "the release of this test is a shell script");
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
      zip.putNextEntry(new ZipEntry("gradle-9.9/bin/gradle"));
      zip.write("#!/bin/sh\necho called with \"$@\"\nexit 7\n".getBytes(StandardCharsets.UTF_8));
    }
    release = bytes.toByteArray();
    path = folder.resolve("bin") + File.pathSeparator + System.getenv("PATH");
    web = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    web.createContext(
        "/gradle-9.9-bin.zip",
        exchange -> {
          exchange.sendResponseHeaders(200, release.length);
          exchange.getResponseBody().write(release);
          exchange.close();
        });
    web.start();
    Path gradle = Files.createDirectories(folder.resolve("gradle/wrapper"));
    Files.copy(ROOT.resolve("gradlew"), folder.resolve("gradlew"));
    assertTrue(folder.resolve("gradlew").toFile().setExecutable(true));
    Files.copy(ROOT.resolve("gradle/Wrapper.java"), gradle.resolveSibling("Wrapper.java"));
  }

  @AfterEach
  void stop() {
    web.stop(0);
  }

  private void pin(String sum) throws IOException {
    Files.writeString(
        folder.resolve("gradle/wrapper/gradle-wrapper.properties"),
        String.format(
            Locale.ROOT,
            "distributionUrl=http\\://127.0.0.1\\:%d/gradle-9.9-bin.zip\n"
                + "distributionSha256Sum=%s\n",
            web.getAddress().getPort(),
            sum));
  }

  private String sum() throws Exception {
    return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(release));
  }

  /** A program and what it printed. */
  private record Ran(int status, String text) {}

  private Ran run(String... command) throws Exception {
    Path output = folder.resolve("output.txt");
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
    builder.environment().put("HOME", folder.resolve("home").toString());
    builder.environment().put("GRADLE_USER_HOME", folder.resolve("home/.gradle").toString());
    builder.environment().put("PATH", path);
    Process process = builder.redirectErrorStream(true).redirectOutput(output.toFile()).start();
    assertTrue(process.waitFor(60, TimeUnit.SECONDS));
    return new Ran(process.exitValue(), Files.readString(output));
  }

  private Ran script(String... args) throws Exception {
    return run(Stream.concat(Stream.of("./gradlew"), Stream.of(args)).toArray(String[]::new));
  }

  /** Runs what gradlew.bat runs. */
  private Ran launcher(String... args) throws Exception {
    List<String> start =
        List.of(
            System.getProperty("java.home") + "/bin/java",
            "-Dcarom.root=" + folder,
            "gradle/Wrapper.java");
    return run(Stream.concat(start.stream(), Stream.of(args)).toArray(String[]::new));
  }

  @Test
  void thePinnedReleaseIsFetchedOnceAndRun() throws Exception {
    pin(sum());
    assertEquals(new Ran(7, "called with run -Pargs=a b\n"), script("run", "-Pargs=a b"));
    web.stop(0);
    assertEquals(new Ran(7, "called with test\n"), script("test"), "without the network");
    assertEquals(new Ran(7, "called with test\n"), launcher("test"), "both use one folder");
  }

  @Test
  void theLauncherForWindowsFetchesItToo() throws Exception {
    pin(sum());
    Ran ran = launcher("run", "-Pargs=a b");
    assertEquals(7, ran.status, ran.text);
    assertTrue(ran.text.endsWith("called with run -Pargs=a b\n"), ran.text);
    assertEquals(new Ran(7, "called with test\n"), script("test"), "both use one folder");
  }

  @Test
  void aWrongChecksumIsBlamedAndNothingRuns() throws Exception {
    pin("0".repeat(64));
    fakeGradle();
    for (Ran ran : List.of(script("run"), launcher("run"))) {
      assertEquals(1, ran.status, ran.text);
      assertTrue(ran.text.contains("gradlew: wrong checksum: what http://127.0.0.1"), ran.text);
      assertTrue(ran.text.contains(sum()) && ran.text.contains("0".repeat(64)), ran.text);
      assertFalse(ran.text.contains("Exception"), ran.text);
      assertFalse(ran.text.contains("old gradle"), ran.text);
    }
    try (Stream<Path> left = Files.walk(folder.resolve("home"))) {
      assertEquals(0, left.filter(Files::isRegularFile).count(), "what was fetched is gone");
    }
  }

  /** Puts a gradle on the PATH. */
  private void fakeGradle() throws IOException {
    Path gradle = Files.createDirectories(folder.resolve("bin")).resolve("gradle");
    Files.writeString(gradle, "#!/bin/sh\necho old gradle \"$@\"\n");
    assertTrue(gradle.toFile().setExecutable(true));
  }

  @Test
  void withoutTheNetworkTheGradleOnThePathRunsAndOneLineSaysSo() throws Exception {
    pin(sum());
    web.stop(0);
    fakeGradle();
    Ran ran = script("play");
    assertEquals(0, ran.status, ran.text);
    assertEquals(2, ran.text.lines().count(), ran.text);
    assertTrue(ran.text.startsWith("gradlew: can't download gradle-9.9, so this runs"), ran.text);
    // No daemon, which would have another environment; no warnings before the program's words.
    assertTrue(ran.text.endsWith("old gradle --no-daemon -q play\n"), ran.text);
    assertTrue(script("test").text.endsWith("old gradle --no-daemon test\n"));
    assertEquals(ran, launcher("play"), "the launcher for Windows does the same");
    assertEquals(script("test", "-Pargs=a b"), launcher("test", "-Pargs=a b"));
  }

  @Test
  void aHostThatRefusesIsLikeNoNetwork() throws Exception {
    pin(sum());
    web.removeContext("/gradle-9.9-bin.zip"); // 404
    fakeGradle();
    Ran ran = launcher("play");
    assertEquals(script("play"), ran);
    assertEquals(0, ran.status, ran.text);
    assertTrue(ran.text.endsWith("old gradle --no-daemon -q play\n"), ran.text);
  }

  @Test
  void theLauncherForWindowsSaysWhatToDoWhereNoGradleIs() throws Exception {
    pin(sum());
    web.stop(0);
    path = folder.resolve("bin").toString();
    Ran ran = launcher("play");
    assertEquals(1, ran.status, ran.text);
    assertTrue(ran.text.contains("can't download http://127.0.0.1"), ran.text);
    assertTrue(ran.text.contains("ConnectException"), ran.text);
    assertTrue(ran.text.contains("put its folder bin on the\ngradlew: PATH"), ran.text);
    assertFalse(ran.text.contains("at Wrapper"), ran.text);
  }

  @Test
  void theScriptForWindowsRunsTheLauncher() throws Exception {
    String script = Files.readString(ROOT.resolve("gradlew.bat"));
    assertTrue(script.contains("\"%~dp0gradle\\Wrapper.java\" %*\r\n"), script);
    assertFalse(script.replace("\r\n", "").contains("\n"), "cmd needs both characters");
  }
}
