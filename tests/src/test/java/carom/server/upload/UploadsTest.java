package carom.server.upload;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.PackedLevel;
import carom.server.match.MatchLibrary;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.suite.Needs;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: levels of players stay bounded, whole and their owners'. Method: the service with a judge
 * that believes the name in the file, on a real disk.
 */
@Needs("waits")
final class UploadsTest {
  @TempDir private Path folder;
  private Uploads uploads;
  private long nowNs;

  private Uploads open(Uploads.Judge judge) throws Exception {
    if (uploads != null) {
      uploads.close();
    }
    uploads = new Uploads(folder, () -> Instant.ofEpochSecond(1_000), () -> nowNs, judge);
    return uploads;
  }

  private Uploads open() throws Exception {
    return open(
        (level, verdict) -> {
          try {
            String name = Level.parse("level", Files.readAllBytes(level)).name();
            return new TrialProcess.Verdict(name, "arena", List.of());
          } catch (LevelException e) {
            return TrialProcess.Verdict.bad(e.getMessage());
          }
        });
  }

  @AfterEach
  void close() {
    if (uploads != null) {
      uploads.close();
    }
  }

  /** Returns the level of the arena under a name. */
  static byte[] level(String name) throws LevelException {
    String source = new String(Level.builtIn("arena").source(), StandardCharsets.UTF_8);
    String own = Level.builtIn("arena").name();
    return source.replace("\"" + own + "\"", "\"" + name + "\"").getBytes(StandardCharsets.UTF_8);
  }

  private Uploads.Outcome send(String account, byte[] level) throws Exception {
    return uploads
        .submit(account, "Ann", PackedLevel.pack(level), level.length)
        .get(20, TimeUnit.SECONDS);
  }

  private List<String> names() {
    return uploads.levels().stream().map(UploadedLevel::name).toList();
  }

  private long files() throws Exception {
    try (Stream<Path> files = Files.list(folder)) {
      return files.filter(file -> file.toString().endsWith(".json")).count();
    }
  }

  @Test
  void aLevelIsFoundByItsNameAlsoAfterAStart() throws Exception {
    open();
    assertTrue(send("1", level("Tall Tower")).taken());
    open();
    UploadedLevel tower = uploads.find("uploads/tall tower");
    assertEquals("Tall Tower", tower.name());
    assertEquals("1", tower.account());
    MatchLibrary library = uploads.library(MatchLibrary.INSTALLED);
    assertArrayEquals(level("Tall Tower"), library.level("uploads/TALL TOWER").level().source());
    assertEquals("arena", library.level("arena").level().gameName());
    assertFalse(library.isGone("uploads/Tall Tower"));
    assertTrue(uploads.remove("tall tower"));
    assertTrue(library.isGone("uploads/Tall Tower"));
    assertThrows(LevelException.class, () -> library.level("uploads/Tall Tower"));
    assertEquals(0, files());
    assertFalse(uploads.remove("tall tower"));
  }

  @Test
  void aLevelIsFoundByItsHashWhateverOthersCallTheirs() throws Exception {
    open();
    assertTrue(send("1", level("Tall Tower")).taken());
    String hash = uploads.find("Tall Tower").hash();
    String shown = hash.substring(0, 12);
    assertTrue(send("2", level(shown)).taken());
    assertEquals("Tall Tower", uploads.find("uploads/" + shown).name());
    assertEquals("Tall Tower", uploads.find(hash).name());
    assertNull(uploads.find(hash.substring(0, 11)), "too short");
    assertEquals("Tall Tower", Uploads.level(folder, "uploads/" + shown).name());
    LevelException e =
        assertThrows(LevelException.class, () -> Uploads.level(folder, "uploads/Tal Tower"));
    assertTrue(e.getMessage().contains("uploads/Tall Tower"), e.getMessage());
    assertTrue(uploads.remove("Tall Tower"));
    assertEquals(shown, uploads.find(shown).name());
    assertThrows(LevelException.class, () -> Uploads.level(folder, "uploads/" + hash));
    String[] files = folder.toFile().list();
    assertEquals(2, files.length, "the index and a level: reading changes nothing");
  }

  @Test
  void noNameIsAPath() throws Exception {
    open();
    Path secret = folder.resolveSibling("secret.json");
    Files.write(secret, level("Secret"));
    MatchLibrary library = uploads.library(MatchLibrary.INSTALLED);
    for (String name :
        List.of("uploads/../secret.json", "uploads/index.txt", "uploads/", "uploads//etc/passwd")) {
      LevelException e = assertThrows(LevelException.class, () -> library.level(name));
      assertFalse(e.getMessage().contains("Secret"), e.getMessage());
    }
    for (String name : List.of("../up", "a,b", "a\\\\b", "@cup", "a:b")) {
      String problem = UploadedLevel.problemOf(name);
      assertNotNull(problem, name);
    }
    assertNull(UploadedLevel.problemOf("Zoë's 2nd tower"));
  }

  @Test
  void aNameThatLooksLikeThatOfAnotherAccountIsItsOwn() throws Exception {
    open();
    assertTrue(send("1", level("Illusion")).taken());
    Uploads.Outcome other = send("2", level("lllusi0n"));
    assertFalse(other.taken());
    assertTrue(other.text().contains("another"), other.text());
    assertTrue(send("1", level("ILLUSION")).taken(), "one's own is replaced");
    assertEquals(List.of("ILLUSION"), names());
    assertEquals(1, files());
  }

  @Test
  void anAccountHasItsShareAndTheServerToo() throws Exception {
    open();
    for (int i = 0; i < Uploads.MOST_OF_ACCOUNT; i++) {
      assertTrue(send("1", level("Level " + (char) ('A' + i))).taken());
    }
    assertFalse(send("1", level("One more")).taken());
    assertTrue(send("1", level("Level A")).taken(), "in the place of its own");
    for (int i = 0; i < Uploads.MOST; i++) {
      send("account " + i, level("Number " + words(i)));
    }
    assertEquals(Uploads.MOST, uploads.levels().size());
    Uploads.Outcome last = send("late", level("Late"));
    assertFalse(last.taken());
    assertTrue(last.text().contains("no more"), last.text());
    open();
    assertEquals(Uploads.MOST, uploads.levels().size());
    assertEquals(Uploads.MOST, files());
  }

  private static String words(int number) {
    String letters = "abcdefghjkpqstxz";
    return "" + letters.charAt(number / 16) + letters.charAt(number % 16);
  }

  @Test
  void aFloodIsRefusedBeforeAByteIsTaken() throws Exception {
    CountDownLatch begun = new CountDownLatch(1);
    CountDownLatch go = new CountDownLatch(1);
    open(
        (level, verdict) -> {
          begun.countDown();
          go.await();
          return TrialProcess.Verdict.bad("no");
        });
    assertNotNull(uploads.refusal("", "192.0.2.1"), "an account is needed");
    assertNull(uploads.refusal("1", "192.0.2.1"));
    assertNotNull(uploads.refusal("1", "192.0.2.2"), "again so soon");
    assertNotNull(uploads.refusal("2", "192.0.2.1"), "another key costs nothing");
    assertNull(uploads.refusal("3", "192.0.2.3"));
    nowNs += Uploads.PAUSE_NS;
    assertNull(uploads.refusal("1", "192.0.2.1"));
    List<CompletableFuture<Uploads.Outcome>> all = new ArrayList<>();
    byte[] level = level("Flood");
    byte[] packed = PackedLevel.pack(level);
    all.add(uploads.submit("first", "Ann", packed, level.length));
    assertTrue(begun.await(20, TimeUnit.SECONDS));
    for (int i = 0; i < 3 * Uploads.MOST_WAITING; i++) {
      all.add(uploads.submit("" + i, "Ann", packed, level.length));
    }
    assertTrue(all.get(all.size() - 1).isDone(), "one too many to wait");
    nowNs += Uploads.PAUSE_NS;
    assertNotNull(uploads.refusal("9", "192.0.2.9"));
    go.countDown();
    for (CompletableFuture<Uploads.Outcome> outcome : all) {
      assertFalse(outcome.get(20, TimeUnit.SECONDS).taken());
    }
  }

  @Test
  void whatDidNotArriveWholeIsRefused() throws Exception {
    open();
    byte[] packed = PackedLevel.pack(level("Whole"));
    int size = level("Whole").length;
    for (int wrong : new int[] {size - 1, size + 1, 1}) {
      assertFalse(uploads.submit("1", "Ann", packed, wrong).get(20, TimeUnit.SECONDS).taken());
    }
    byte[] bomb = PackedLevel.pack(new byte[200_000]);
    assertFalse(uploads.submit("1", "Ann", bomb, 1_000).get(20, TimeUnit.SECONDS).taken());
    assertEquals(0, files());
  }

  @Test
  void aCrashBetweenFileAndIndexLeavesTheIndexRight() throws Exception {
    open();
    assertTrue(send("1", level("Kept")).taken());
    assertTrue(send("1", level("Lost file")).taken());
    Files.delete(folder.resolve(uploads.find("Lost file").hash() + ".json"));
    Files.write(folder.resolve("0".repeat(64) + ".json"), level("No index"));
    Files.writeString(folder.resolve("index.txt.new"), "half a li");
    Files.writeString(folder.resolve("trial.level"), "half");
    open();
    assertEquals(List.of("Kept"), names());
    assertEquals(1, files());
    Files.write(folder.resolve(uploads.find("Kept").hash() + ".json"), level("Forged"));
    MatchLibrary library = uploads.library(MatchLibrary.INSTALLED);
    assertThrows(LevelException.class, () -> library.level("uploads/Kept"), "the hash says it");
  }

  @Test
  void aLineOfGarbageInTheIndexCostsNoOther() throws Exception {
    open();
    assertTrue(send("1", level("Kept")).taken());
    Path index = folder.resolve("index.txt");
    String line = Files.readString(index);
    Files.writeString(index, "garbage\n" + line + line.replace("Kept", "../../Kept") + "\t\t\n");
    open();
    assertEquals(List.of("Kept"), names());
  }
}
