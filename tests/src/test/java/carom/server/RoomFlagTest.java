package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class RoomFlagTest {
  @Test
  void namesLevelsAndPlacesAreReadFromOneValue() {
    assertEquals(
        new RoomFlag("cup", List.of("arena", "commons"), 16),
        RoomFlag.parse("cup=arena,commons:16"));
    assertEquals(new RoomFlag("jump", List.of("platformer"), 0), RoomFlag.parse("jump=platformer"));
  }

  @Test
  void aColonInAPathIsNoNumberOfPlaces() {
    assertEquals(
        new RoomFlag("a", List.of("C:\\levels\\a=b.json"), 0),
        RoomFlag.parse("a=C:\\levels\\a=b.json"));
    assertEquals(new RoomFlag("a", List.of("C:\\a.json"), 8), RoomFlag.parse("a=C:\\a.json:8"));
  }

  @Test
  void everyWrongFormIsNamedWithTheRightOne() {
    for (String wrong : List.of("cup", "=arena", "cup=", "cup=arena,", "cup=,arena", "cup=:4")) {
      String message =
          assertThrows(IllegalArgumentException.class, () -> RoomFlag.parse(wrong)).getMessage();
      assertTrue(message.startsWith("--room=" + wrong), message);
    }
    for (String wrong : List.of("a=arena:0", "a=arena:1025", "a=arena:99999999999")) {
      String message =
          assertThrows(IllegalArgumentException.class, () -> RoomFlag.parse(wrong)).getMessage();
      assertTrue(message.contains("is outside 1..1024"), message);
    }
  }
}
