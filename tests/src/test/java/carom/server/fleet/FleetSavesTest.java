package carom.server.fleet;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.config.DataFolder;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Goal: a match that was saved on one server can be loaded on any, and the newest counts. */
final class FleetSavesTest {
  @TempDir Path folder;

  private Path file(String server, String name) {
    return new DataFolder(folder.resolve(server)).saved(name);
  }

  private void save(String server, String name, long atMs, byte... bytes) throws IOException {
    Files.createDirectories(file(server, name).getParent());
    Files.write(file(server, name), bytes);
    Files.setLastModifiedTime(file(server, name), FileTime.fromMillis(atMs));
  }

  private FleetRig rig() throws IOException {
    FleetRig rig = new FleetRig(folder, 2);
    for (String name : new String[] {"a", "b", "c"}) {
      rig.node(name, 1);
    }
    rig.run(1);
    return rig;
  }

  @Test
  void theNewestSaveComesToTheServerThatLoadsIt() throws Exception {
    try (FleetRig rig = rig()) {
      save("a", "cup", 5_000, (byte) 1);
      save("b", "cup", 7_000, (byte) 2);
      save("c", "cup", 6_000, (byte) 3);
      FleetMember c = rig.nodes.get("c").member;
      assertEquals("b", c.saves().bring("cup"));
      assertArrayEquals(new byte[] {2}, Files.readAllBytes(file("c", "cup")));
      assertEquals("", c.saves().bring("cup"), "it has the newest now");
      assertEquals("", c.saves().bring("nothing"));
      assertFalse(Files.exists(file("c", "nothing")));

      rig.nodes.get("b").kill();
      rig.run(3);
      assertEquals("c", rig.nodes.get("a").member.saves().bring("cup"), "the copy goes on");
    }
  }

  @Test
  void aSaveThatIsTooLargeStaysAndSaysSo() throws Exception {
    try (FleetRig rig = rig()) {
      save("a", "huge", 5_000, new byte[FleetSaves.MOST_BYTES + 1]);
      IOException e =
          assertThrows(IOException.class, () -> rig.nodes.get("b").member.saves().bring("huge"));
      assertTrue(e.getMessage().contains("a has a newer save huge"), e.getMessage());
      save("a", "large", 5_000, new byte[FleetSaves.MOST_BYTES]);
      assertEquals("a", rig.nodes.get("b").member.saves().bring("large"));
    }
  }

  @Test
  void noNameLeadsOutOfTheFolder() throws Exception {
    try (FleetRig rig = rig()) {
      Files.writeString(folder.resolve("secret.carom-save"), "secret");
      byte[] nothing = {};
      PeerFrame ask = PeerFrame.of(PeerFrame.Kind.SAVED, 0, "../../secret", nothing);
      PeerFrame answer = rig.nodes.get("a").member.inbox().answer(ask);
      assertEquals(-1, answer.number());
      assertFalse(new String(answer.bytes(), StandardCharsets.UTF_8).contains("secret"));
    }
  }
}
