package carom.suite;

import carom.fixtures.Jvm;
import carom.server.ServerMain;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;

/**
 * An archive of the classes that a server loads, parsed and verified (class data sharing). With it
 * a server process takes two thirds of the processor's time until it is ready. A JVM takes it if
 * its class path begins with the same jars; folders can't be archived.
 */
final class ClassArchive {
  private static final int LIMIT_SECONDS = 120;

  private ClassArchive() {}

  /**
   * Makes an archive by a server that starts and stops.
   *
   * @param folder an existing folder of its own
   * @return the JVM's flags that use it; empty if there is none, which costs nothing but time
   */
  static List<String> make(Path folder) throws IOException, InterruptedException {
    Path file = folder.resolve("classes.jsa").toAbsolutePath();
    String quiet = "-Xlog:cds*=off";
    List<String> flags = List.of("-cp", jars(), quiet, "-XX:ArchiveClassesAtExit=" + file);
    String data = "--data=" + folder.resolve("data");
    List<String> command =
        Jvm.command(flags, ServerMain.class, "--tcp-port=0", "--udp-port=0", data);
    Process server =
        new ProcessBuilder(command)
            .redirectErrorStream(true)
            .redirectOutput(folder.resolve("server.txt").toFile())
            .start();
    server.getOutputStream().write("stop\n".getBytes(StandardCharsets.UTF_8));
    server.getOutputStream().close();
    boolean made = server.waitFor(LIMIT_SECONDS, TimeUnit.SECONDS) && server.exitValue() == 0;
    server.destroyForcibly();
    return made && Files.exists(file) ? List.of(quiet, "-XX:SharedArchiveFile=" + file) : List.of();
  }

  /** Returns the jars with which the class path begins. */
  private static String jars() {
    return Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
        .takeWhile(path -> path.endsWith(".jar"))
        .collect(Collectors.joining(File.pathSeparator));
  }
}
