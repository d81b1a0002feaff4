import com.google.cloud.tools.jib.api.Containerizer;
import com.google.cloud.tools.jib.api.Jib;
import com.google.cloud.tools.jib.api.JibContainerBuilder;
import com.google.cloud.tools.jib.api.TarImage;
import com.google.cloud.tools.jib.api.buildplan.AbsoluteUnixPath;
import com.google.cloud.tools.jib.api.buildplan.FileEntriesLayer;
import com.google.cloud.tools.jib.api.buildplan.FilePermissions;
import com.google.cloud.tools.jib.api.buildplan.ImageFormat;
import com.google.cloud.tools.jib.api.buildplan.Port;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.apache.commons.compress.archivers.tar.TarArchiveEntry;
import org.apache.commons.compress.archivers.tar.TarArchiveOutputStream;

/**
 * Makes the container image of the server, without a container engine: {@code java Image.java
 * OUTPUT.tar VERSION RUNTIME JARS JVM-ARGUMENTS...}. {@code docker load} and {@code podman load}
 * take the file.
 *
 * <p>The image has a Java runtime, the server's jars, and those libraries of this machine that the
 * runtime is linked to (glibc, zlib); no shell and nothing else. The libraries come from this
 * machine because the runtime does, and so nothing is fetched from a registry. All times are fixed,
 * so that equal builds make equal files.
 *
 * <p>Jib makes no health check of its own, but keeps the one of the image it begins with. So the
 * libraries are such an image, written here in the form of {@code docker save}.
 */
final class Image {
  private static final String HOME = "/opt/carom";
  private static final String DATA = "/data";

  /** Numeric, so that {@code runAsNonRoot} of Kubernetes can see that it isn't root. */
  private static final String USER = "10001:10001";

  /** What shows windows and plays sounds; a server does neither. */
  private static final Pattern DESKTOP =
      Pattern.compile("lib(j?awt|font|freetype|javajpeg|jsound|lcms|mlib|splash).*");

  private Image() {}

  public static void main(String[] args) throws Exception {
    Path output = Path.of(args[0]);
    String version = args[1];
    Path runtime = Path.of(args[2]);
    Path jars = Path.of(args[3]);
    List<String> jvmArgs = List.of(args).subList(4, args.length);
    Files.createDirectories(output.getParent());
    Files.deleteIfExists(output);
    Path base = output.resolveSibling(output.getFileName() + ".base");
    Path cache = Files.createTempDirectory("carom-image");
    try {
      writeBase(base, runtime);
      server(base, version, runtime, jars, jvmArgs)
          .containerize(
              Containerizer.to(TarImage.at(output).named("carom:" + version))
                  .setBaseImageLayersCache(cache)
                  .setApplicationLayersCache(cache)
                  .setOfflineMode(true)
                  .setToolName("carom"));
    } finally {
      Files.delete(base);
      try (Stream<Path> left = Files.walk(cache)) {
        left.sorted(Comparator.reverseOrder()).forEach(path -> path.toFile().delete());
      }
    }
    System.exit(0); // Jib's threads would keep the JVM for a minute
  }

  private static JibContainerBuilder server(
      Path base, String version, Path runtime, Path jars, List<String> jvmArgs) throws Exception {
    List<String> entry = new ArrayList<>(List.of(HOME + "/runtime/bin/java"));
    entry.addAll(jvmArgs);
    // No file in /tmp for jps and jstat: the root of a container is often read-only.
    entry.addAll(List.of("-XX:-UsePerfData", "-Duser.home=" + DATA));
    entry.addAll(List.of("-cp", HOME + "/lib/*:" + HOME + "/games/*", "carom.server.ServerMain"));
    return Jib.from(TarImage.at(base))
        .setFormat(ImageFormat.Docker) // the other one has no health check
        .addFileEntriesLayer(layer("runtime", runtime, HOME + "/runtime"))
        .addFileEntriesLayer(layer("server", jars, HOME + "/lib"))
        .setCreationTime(Instant.EPOCH)
        .setUser(USER)
        .setWorkingDirectory(AbsoluteUnixPath.get(DATA))
        .setVolumes(Set.of(AbsoluteUnixPath.get(DATA)))
        .setExposedPorts(Set.of(Port.tcp(54_555), Port.udp(54_777), Port.udp(27_015)))
        .setEnvironment(
            new TreeMap<>(
                Map.of(
                    "LANG", "C.UTF-8",
                    "CAROM_DATA", DATA,
                    "CAROM_CHECKPOINT", "5s",
                    "CAROM_LOG_KEEP", "0")))
        .setLabels(
            new TreeMap<>(
                Map.of(
                    "org.opencontainers.image.title",
                    "Carom game server",
                    "org.opencontainers.image.version",
                    version)))
        .setEntrypoint(entry);
  }

  private static FileEntriesLayer layer(String name, Path from, String to) throws IOException {
    FileEntriesLayer.Builder layer = FileEntriesLayer.builder().setName(name);
    try (Stream<Path> files = Files.walk(from)) {
      for (Path file : files.sorted().toList()) {
        boolean sharedArchive = file.toString().endsWith(".jsa"); // as in the zips
        if (!sharedArchive) {
          boolean executable = Files.isDirectory(file) || Files.isExecutable(file);
          AbsoluteUnixPath place = AbsoluteUnixPath.get(to + "/" + from.relativize(file));
          layer.addEntry(file, place, FilePermissions.fromOctalString(executable ? "755" : "644"));
        }
      }
    }
    return layer.build();
  }

  /** Writes an image with the system's libraries, the data folder, {@code /tmp}, a health check. */
  private static void writeBase(Path to, Path runtime) throws Exception {
    ByteArrayOutputStream layerBytes = new ByteArrayOutputStream();
    try (TarArchiveOutputStream layer = new TarArchiveOutputStream(layerBytes)) {
      for (Path library : librariesOf(runtime)) {
        add(layer, library.toString().substring(1), Files.readAllBytes(library), 0755);
      }
      folder(layer, "tmp/", 01777, 0);
      folder(layer, "data/", 0750, 10_001);
      folder(layer, "opt/carom/games/", 0755, 0);
    }
    String config = config(sha256(layerBytes.toByteArray()));
    try (OutputStream file = Files.newOutputStream(to);
        TarArchiveOutputStream image = new TarArchiveOutputStream(file)) {
      add(image, "layer.tar", layerBytes.toByteArray(), 0644);
      add(image, "config.json", config.getBytes(StandardCharsets.UTF_8), 0644);
      String manifest =
          "[{\"Config\":\"config.json\",\"RepoTags\":[\"base:base\"],\"Layers\":[\"layer.tar\"]}]";
      add(image, "manifest.json", manifest.getBytes(StandardCharsets.UTF_8), 0644);
    }
  }

  private static String config(String layerDigest) {
    String machine = System.getProperty("os.arch");
    String architecture = machine.equals("aarch64") ? "arm64" : machine;
    List<String> probe =
        List.of(
            "CMD",
            HOME + "/runtime/bin/java",
            "-XX:+UseSerialGC",
            "-XX:TieredStopAtLevel=1",
            "-XX:-UsePerfData",
            "-cp",
            HOME + "/lib/*",
            "carom.server.CaromMain",
            "health");
    long second = 1_000_000_000L;
    return """
    {"architecture":"%s","os":"linux","created":"1970-01-01T00:00:00Z",\
    "config":{"Healthcheck":{"Test":["%s"],\
    "Interval":%d,"Timeout":%d,"StartPeriod":%d,"Retries":3}},\
    "history":[{"created":"1970-01-01T00:00:00Z","created_by":"libraries of the system"}],\
    "rootfs":{"type":"layers","diff_ids":["sha256:%s"]}}\
    """
        .formatted(
            architecture,
            String.join("\",\"", probe),
            30 * second,
            10 * second,
            10 * second,
            layerDigest);
  }

  /** Returns what a runtime is linked to outside of itself. */
  private static Set<Path> librariesOf(Path runtime) throws Exception {
    Set<Path> libraries = new TreeSet<>();
    List<Path> linked = new ArrayList<>(List.of(runtime.resolve("bin/java")));
    try (Stream<Path> files = Files.walk(runtime.resolve("lib"))) {
      files
          .filter(file -> file.toString().endsWith(".so"))
          .filter(file -> !DESKTOP.matcher(file.getFileName().toString()).matches())
          .forEach(linked::add);
    }
    for (Path file : linked) {
      Process ldd = new ProcessBuilder("ldd", file.toString()).redirectErrorStream(true).start();
      for (String line : new String(ldd.getInputStream().readAllBytes()).split("\n", -1)) {
        String target = line.contains("=>") ? line.substring(line.indexOf("=>") + 2) : line;
        String path = target.strip().split(" ", 2)[0];
        boolean ofRuntime = path.startsWith(runtime.toAbsolutePath().toString());
        if (path.startsWith("/") && !ofRuntime) {
          libraries.add(Path.of(path));
        }
      }
    }
    if (libraries.isEmpty()) {
      throw new IllegalStateException("ldd found no library of runtime=" + runtime);
    }
    return libraries;
  }

  private static void folder(TarArchiveOutputStream tar, String name, int mode, int owner)
      throws IOException {
    TarArchiveEntry entry = entry(name, mode);
    entry.setIds(owner, owner);
    tar.putArchiveEntry(entry);
    tar.closeArchiveEntry();
  }

  private static void add(TarArchiveOutputStream tar, String name, byte[] bytes, int mode)
      throws IOException {
    TarArchiveEntry entry = entry(name, mode);
    entry.setSize(bytes.length);
    tar.putArchiveEntry(entry);
    tar.write(bytes);
    tar.closeArchiveEntry();
  }

  private static TarArchiveEntry entry(String name, int mode) {
    TarArchiveEntry entry = new TarArchiveEntry(name);
    entry.setMode(mode);
    entry.setModTime(0);
    entry.setIds(0, 0);
    return entry;
  }

  private static String sha256(byte[] bytes) throws Exception {
    return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
  }
}
