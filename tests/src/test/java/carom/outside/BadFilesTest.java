package carom.outside;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.suite.Needs;
import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: whatever a file is, a person reads what is wrong with it. Method: the installed programs,
 * with each file of the data folder and each path of a flag as junk, a folder, a loop, empty or
 * huge. A run draws some of the cases; {@code -Dcarom.all=true} takes all.
 */
@Needs("processes")
@Timeout(600)
final class BadFilesTest {
  private static final int DRAWN = 8;

  /** Matches words of the JDK; {@code true, false or null} are words of JSON. */
  private static final Pattern BARE =
      Pattern.compile("Exception|Input length|(?<!'|or )\\bnull\\b|(?m)^\\s+at \\S+\\(");

  /** Matches a path with nothing said of it. */
  private static final Pattern LONELY_PATH = Pattern.compile("(?m)^([\\w-]+: )*\\S*/\\S*$");

  private static final String FLEET =
      "--fleet=etcd:https://127.0.0.1:1 --advertise=localhost --fleet-port=0 --fleet-key=k ";

  /** The flags that name a file, each at the end and behind those that it needs. */
  private static final List<String> FLAGS =
      List.of(
          "--config=",
          "--data=",
          "--level=",
          "--record=",
          "--join-key=",
          "--password-file=",
          "--play-port=0 --tls-key=k --tls-cert=",
          "--play-port=0 --tls-cert=c --tls-key=",
          FLEET.replace("--fleet-key=k ", "--fleet-key="),
          FLEET + "--directory-ca=",
          FLEET + "--directory-key=k --directory-cert=",
          FLEET + "--directory-cert=c --directory-key=");

  private enum Kind {
    JUNK,
    LATIN,
    FOLDER,
    LOOP,
    EMPTY,
    HUGE,
    MISSING,
    BEHIND_A_FILE
  }

  /** A case: the flag that names the file, or null if it is found in the data folder. */
  private record BadFile(String program, String flag, String file, Kind kind) {}

  @TempDir Path folder;

  private static List<BadFile> all() {
    List<BadFile> all = new ArrayList<>();
    for (Kind kind : Kind.values()) {
      for (String flag : FLAGS) {
        all.add(new BadFile("carom-server", flag, "x/file.json", kind));
      }
      all.add(new BadFile("carom", "replay ", "x/file.carom", kind));
      all.add(new BadFile("carom-client", "--headless --replay ", "x/file.carom", kind));
      for (String file :
          List.of(
              "carom.conf",
              "bans.txt",
              "allow.txt",
              "admin.txt",
              "admin.token",
              "rcon.password",
              "server.key",
              "levels",
              "levels/x.json",
              "logs",
              "checkpoints",
              "recordings",
              "saves")) {
        all.add(new BadFile("carom-server", null, "data/" + file, kind));
      }
    }
    return all;
  }

  private static void make(Path file, Kind kind) throws IOException {
    Files.createDirectories(file.getParent());
    switch (kind) {
      case JUNK -> {
        byte[] junk = new byte[3_000];
        new Random(7).nextBytes(junk);
        Files.write(file, junk);
      }
      case LATIN -> Files.write(file, Installation.latin("Bj\u00f8rn\n"));
      case FOLDER -> Files.createDirectory(file);
      case LOOP -> Files.createSymbolicLink(file, file);
      case EMPTY -> Files.createFile(file);
      case HUGE -> {
        try (RandomAccessFile huge = new RandomAccessFile(file.toFile(), "rw")) {
          huge.setLength(3L << 30); // sparse
        }
      }
      case MISSING -> {}
      case BEHIND_A_FILE -> {
        Files.delete(file.getParent());
        Files.createFile(file.getParent());
      }
    }
  }

  private static String[] flags(String flag, Path file) {
    return ("--no-query " + flag + file).split(" ");
  }

  private static String said(BadFile bad, Path base) throws Exception {
    Path file = base.resolve(bad.file);
    make(file, bad.kind);
    try (Installation programs = new Installation(Files.createDirectory(base.resolve("work")))) {
      Installation.Running running;
      if (bad.program.equals("carom-server")) {
        String data = base.resolve("data").toString();
        running =
            bad.flag == null
                ? programs.server(
                    Map.of(), data, "--no-query", "--rcon", "--rcon-port=0", "--checkpoint=5s")
                : programs.server(Map.of(), data, flags(bad.flag, file));
        if (running.port() > 0) {
          running.type("stop");
        }
      } else {
        List<String> words = new ArrayList<>(List.of(bad.flag.strip().split(" ")));
        words.add(file.toString());
        running = programs.start(Map.of(), bad.program, words.toArray(new String[0]));
      }
      running.end();
      return running.output();
    }
  }

  @Test
  void whatIsWrongWithAFileIsSaid() throws Exception {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println("BadFilesTest seed=" + seed);
    List<BadFile> cases = all();
    if (!Boolean.getBoolean("carom.all")) {
      Collections.shuffle(cases, new Random(seed));
      cases = cases.subList(0, DRAWN);
    }
    int told = 0;
    for (int i = 0; i < cases.size(); i++) {
      BadFile bad = cases.get(i);
      String said = said(bad, Files.createDirectory(folder.resolve("case" + i)));
      String about = "seed=" + seed + " " + bad + ":\n" + said;
      assertFalse(BARE.matcher(said).find(), about);
      assertFalse(LONELY_PATH.matcher(said).find(), about);
      assertFalse(said.isBlank(), about);
      told += said.contains(bad.file.replaceAll(".*/", "")) ? 1 : 0;
    }
    assertTrue(told > 0, "no message names its file");
  }
}
