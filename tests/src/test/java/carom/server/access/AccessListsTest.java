package carom.server.access;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import carom.net.protocol.RefusalReason;
import carom.server.config.DataFolder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Goal: the lists are files that people and commands change, at the same time. */
final class AccessListsTest {
  @TempDir private Path folder;
  private Instant now = Instant.parse("2026-11-23T12:00:00Z");

  private AccessLists lists(boolean onlyAllowed) throws IOException {
    return new AccessLists(new DataFolder(folder), onlyAllowed, () -> now);
  }

  private Path bans() {
    return folder.resolve("bans.txt");
  }

  @Test
  void everybodyMayPlayWhileThereAreNoFiles() throws IOException {
    assertNull(lists(false).refusal("Bob", "", "203.0.113.7:1"));
  }

  @Test
  void editsComeIntoForceAndBadLinesHaveNoEffect() throws IOException {
    AccessLists lists = lists(false);
    assertFalse(lists.reloadIfChanged());
    Files.writeString(bans(), "# mine\nname Bob until 2026-11-23T12:30:00Z rude\nnonsense\n");
    assertTrue(lists.reloadIfChanged());
    EntryRule.Refusal refusal = lists.refusal("bob", "", "203.0.113.7:1");
    assertEquals(RefusalReason.BANNED, refusal.reason());
    assertEquals("Reason: rude. Until 2026-11-23 12:30 UTC.", refusal.text());
    now = now.plusSeconds(1_800);
    assertNull(lists.refusal("bob", "", "203.0.113.7:1"));
    Files.delete(bans());
    assertTrue(lists.reloadIfChanged());
    assertEquals(List.of(), lists.bans().entries());
  }

  @Test
  void onAFullDiskABanIsRefusedAndTheOthersStay() throws IOException {
    Path full = Path.of("/dev/full");
    assumeTrue(Files.exists(full), "a device of Linux");
    AccessLists lists = lists(false);
    lists.bans().add(AccessEntry.parse("name mallory"));
    String before = Files.readString(bans());
    Files.createSymbolicLink(bans().resolveSibling("bans.txt.new"), full);
    AccessEntry more = AccessEntry.parse("name trudy");
    IOException e = assertThrows(IOException.class, () -> lists.bans().add(more));
    assertTrue(e.getMessage().contains("nothing has changed"), e.getMessage());
    assertEquals(before, Files.readString(bans()));
    lists.bans().add(more);
    assertTrue(Files.readString(bans()).contains("trudy"));
  }

  @Test
  void commandsKeepWhatPeopleWrote() throws IOException {
    Files.writeString(bans(), "# mine\nname Bob\nnonsense\naddress 192.0.2.1\n");
    AccessLists lists = lists(false);
    lists.bans().add(AccessEntry.parse("name BOB until 2027-01-01T00:00:00Z again"));
    lists.bans().remove(AccessEntry.parse("address 192.0.2.1")::isAboutSame);
    assertEquals(
        "# mine\nnonsense\nname \"BOB\" until 2027-01-01T00:00:00Z again\n",
        Files.readString(bans()));
    assertFalse(lists.reloadIfChanged(), "own changes are known");
    assertNotNull(lists.refusal("Bob", "", "x"));
    assertFalse(Files.exists(folder.resolve("bans.txt.new")));
  }

  @Test
  void onlyTheListedPlayWhereTheOperatorWantsThat() throws IOException {
    AccessLists lists = lists(true);
    assertEquals(RefusalReason.NOT_ALLOWED, lists.refusal("Ann", "", "192.0.2.1:1").reason());
    lists.allowed().add(AccessEntry.parse("name Ann"));
    lists.allowed().add(AccessEntry.parse("address 198.51.100.0/24"));
    assertNull(lists.refusal("ann", "", "192.0.2.1:1"));
    assertNull(lists.refusal("Bob", "", "198.51.100.9:1"));
    assertNotNull(lists.refusal(null, "", "192.0.2.1:1"), "spectators, too");
    lists.bans().add(AccessEntry.parse("name Ann"));
    assertEquals(RefusalReason.BANNED, lists.refusal("Ann", "", "192.0.2.1:1").reason());
  }

  @Test
  void aFileThatCannotBeReadIsNamedAndTheBansStay() throws IOException {
    Files.createDirectory(bans());
    IOException e = assertThrows(IOException.class, () -> lists(false));
    assertTrue(e.getMessage().contains("bans.txt can't be read: it is a folder"), e.getMessage());
    Files.delete(bans());
    Files.writeString(bans(), "name Bob\n");
    AccessLists lists = lists(false);
    Files.write(bans(), new byte[] {'#', (byte) 0xff, '\n'});
    assertFalse(lists.reloadIfChanged());
    assertNotNull(lists.refusal("Bob", "", "x"), "the last good list stays in force");
  }
}
