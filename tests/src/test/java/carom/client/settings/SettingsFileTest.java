package carom.client.settings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Goal: what a player has set is there at the next start, and no file of theirs is ever lost. */
final class SettingsFileTest {
  @TempDir private Path folder;

  private Path file() {
    return folder.resolve("deep").resolve("player.conf");
  }

  private SettingsFile loaded() {
    SettingsFile settings = new SettingsFile(file());
    settings.load();
    return settings;
  }

  private void write(String text) throws IOException {
    Files.createDirectories(file().getParent());
    Files.writeString(file(), text);
  }

  private List<String> files() throws IOException {
    try (Stream<Path> files = Files.list(file().getParent())) {
      return files.map(f -> f.getFileName().toString()).sorted().toList();
    }
  }

  @Test
  void whatIsSetIsThereAtTheNextStart() throws Exception {
    PlayerSettings changed =
        PlayerSettings.defaults()
            .with(PlayerSettings.NAME, "Ann \u00c4")
            .with(PlayerSettings.PARTY, "trio")
            .with(PlayerSettings.VOLUME, 70)
            .withWindow(1_920, 1_080)
            .with(PlayerSettings.FULLSCREEN, true)
            .with(PlayerSettings.TEXT_SIZE, 150)
            .with(PlayerSettings.PALETTE, Palette.COLOUR_BLIND)
            .with(PlayerSettings.INTERPOLATION, 75)
            .withKeys(KeyAction.LEFT, List.of("J", "Left"))
            .withKeys(KeyAction.MUTE, List.of())
            .withGameKeys("tag", "sprint", List.of("Space", "L-Shift"))
            .withGameKeys("tag", "shout", List.of())
            .withRecent("a")
            .withRecent("b:1/2")
            .withFavouriteToggled("c")
            .withFavouriteToggled("[::1]:9");
    loaded().save(changed);
    assertEquals(changed, loaded().settings());
    assertEquals(List.of("player.conf"), files());
    String text = Files.readString(file());
    assertTrue(text.contains("\nwindow = 1920 x 1080\n"), text);
    assertTrue(text.contains("\nkey.left = J, Left\n"), text);
    assertTrue(text.contains("\ngame-keys = tag.shout:  | tag.sprint: Space, L-Shift\n"), text);
    assertTrue(text.contains("\nrecent = b:1/2, a\n"), text);
  }

  @Test
  void aByteOrderMarkCostsNoLine() throws Exception {
    write("\ufeffname = Zo\u00eb\r\nvolume = 35\r\n");
    SettingsFile settings = loaded();
    assertEquals("Zo\u00eb", settings.settings().get(PlayerSettings.NAME));
    assertEquals(35, settings.settings().get(PlayerSettings.VOLUME));
    assertEquals("", settings.problem());
  }

  @Test
  void withoutAFileEverythingIsAsByDefault() {
    SettingsFile settings = loaded();
    assertEquals(PlayerSettings.defaults(), settings.settings());
    assertEquals("", settings.problem());
    assertFalse(Files.exists(file()), "nothing is written before something is set");
  }

  @Test
  void aLineThatCannotBeReadIsNamedAndTheFileIsKeptAside() throws Exception {
    String text = "name = Ann\nvolum = 3\nvolume = loud\ntext-size = 900\njust words\nwindow = x\n";
    write(text);
    SettingsFile settings = loaded();
    assertEquals("Ann", settings.settings().get(PlayerSettings.NAME), "the other lines count");
    assertEquals(25, settings.settings().get(PlayerSettings.VOLUME));
    String said = settings.problem();
    assertTrue(said.contains("player.conf"), said);
    assertTrue(said.contains("line 2: unknown setting volum"), said);
    assertTrue(said.contains("did you mean \"volume\"?"), said);
    assertTrue(said.contains("line 3: volume=loud is not a whole number"), said);
    assertTrue(said.contains("line 4: text-size=900 is outside 75..200"), said);
    assertTrue(said.contains("line 5: \"just words\" is not like name = value"), said);
    assertTrue(said.contains("line 6: window=x: not like 1280 x 720"), said);
    assertTrue(said.endsWith("The file is kept as player.conf.unreadable."), said);
    assertEquals(text, Files.readString(file().resolveSibling("player.conf.unreadable")));
    loaded();
    assertEquals(List.of("player.conf", "player.conf.unreadable"), files(), "kept once");

    settings.save(settings.settings().with(PlayerSettings.VOLUME, 1));
    assertEquals("", loaded().problem());
    write("again = bad\n");
    loaded();
    assertEquals(text, Files.readString(file().resolveSibling("player.conf.unreadable")));
    assertEquals(
        "again = bad\n", Files.readString(file().resolveSibling("player.conf.unreadable-2")));
  }

  @Test
  void bytesThatAreNoTextAreKeptAside() throws Exception {
    byte[] bytes = "name = Ann\nfavourites = a\n".getBytes(StandardCharsets.UTF_16);
    Files.createDirectories(file().getParent());
    Files.write(file(), bytes);
    SettingsFile settings = loaded();
    assertEquals(PlayerSettings.defaults(), settings.settings());
    assertTrue(settings.problem().contains("kept as player.conf.unreadable"), settings.problem());
    settings.save(settings.settings().with(PlayerSettings.NAME, "Ben"));
    assertEquals("Ben", loaded().settings().get(PlayerSettings.NAME));
    assertEquals(
        List.of("player.conf", "player.conf.unreadable"),
        files().stream().filter(name -> !name.endsWith(".new")).toList());
  }

  @Test
  void whatCannotBeWrittenIsSaid() throws Exception {
    Files.writeString(folder.resolve("deep"), "a file where the folder would be");
    SettingsFile settings = new SettingsFile(file());
    settings.save(PlayerSettings.defaults().with(PlayerSettings.VOLUME, 1));
    assertTrue(settings.problem().startsWith("The settings can't be saved: "), settings.problem());
    assertEquals(
        1, settings.settings().get(PlayerSettings.VOLUME), "they count until the program ends");
  }

  @Test
  void theFileIsWhereThisSystemKeepsSettings() {
    Map<String, String> none = Map.of();
    assertEquals(
        Path.of("/home/ann/.config/carom/player.conf"),
        SettingsFile.usual("Linux", "/home/ann", none::get));
    assertEquals(
        Path.of("/etc/ann/carom/player.conf"),
        SettingsFile.usual("Linux", "/home/ann", Map.of("XDG_CONFIG_HOME", "/etc/ann")::get));
    assertEquals(
        Path.of("/home/ann/.config/carom/player.conf"),
        SettingsFile.usual("Linux", "/home/ann", Map.of("XDG_CONFIG_HOME", "relative")::get));
    assertEquals(
        Path.of("/tmp/ann/.config/carom/player.conf"),
        SettingsFile.usual("Linux", "/home/ann", Map.of("HOME", "/tmp/ann")::get));
    assertEquals(
        Path.of("roaming", "Carom", "player.conf"),
        SettingsFile.usual("Windows 11", "home", Map.of("APPDATA", "roaming")::get));
    assertEquals(
        Path.of("/Users/ann/Library/Application Support/Carom/player.conf"),
        SettingsFile.usual("Mac OS X", "/Users/ann", none::get));
  }

  @Test
  void aKeyDoesOneThingOnly() {
    PlayerSettings changed =
        PlayerSettings.defaults().withKeys(KeyAction.JUMP, List.of("Space", "A"));
    assertEquals(List.of("Space", "A"), changed.keys().get(KeyAction.JUMP));
    assertEquals(List.of(), changed.keys().get(KeyAction.MAIN));
    assertEquals(List.of("Left"), changed.keys().get(KeyAction.LEFT));
    assertEquals(PlayerSettings.defaults(), changed.withDefaultKeys());
  }

  @Test
  void theLastServerComesFirstAndOldOnesGo() {
    PlayerSettings s = PlayerSettings.defaults();
    for (int i = 0; i < 20; i++) {
      s = s.withRecent("s" + i);
    }
    s = s.withRecent("s15");
    assertEquals(PlayerSettings.MAX_RECENT, s.get(PlayerSettings.RECENT).size());
    assertEquals(List.of("s15", "s19", "s18"), s.get(PlayerSettings.RECENT).subList(0, 3));
    assertEquals(
        List.of(),
        s.withFavouriteToggled("x").withFavouriteToggled("x").get(PlayerSettings.FAVOURITES));
  }

  @Test
  void valuesOutOfRangeAreRefused() {
    PlayerSettings s = PlayerSettings.defaults();
    assertThrows(IllegalArgumentException.class, () -> s.with(PlayerSettings.NAME, ""));
    assertThrows(IllegalArgumentException.class, () -> s.with(PlayerSettings.VOLUME, 101));
    assertThrows(IllegalArgumentException.class, () -> s.withWindow(10, 720));
    assertThrows(IllegalArgumentException.class, () -> s.with(PlayerSettings.INTERPOLATION, -1));
  }
}
