package carom.server.config;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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
  void whatListsShowAboutARoomIsReadByRoomAndKey() {
    Map<String, Map<String, String>> metadata = new LinkedHashMap<>();
    metadata.put("cup", new LinkedHashMap<>());
    metadata.put("1", new LinkedHashMap<>());
    RoomFlag.readInfo("cup:skill=for beginners: a=b", metadata);
    RoomFlag.readInfo("1:region=eu", metadata);
    assertEquals(Map.of("skill", "for beginners: a=b"), metadata.get("cup"));
    assertEquals(Map.of("region", "eu"), metadata.get("1"));
    for (String wrong : List.of("cup", "cup:skill", "cup:skill=", "skill=x", ":a=b", "cup:=b")) {
      assertTrue(infoProblem(wrong, metadata).contains("write ROOM:KEY=VALUE"), wrong);
    }
    String noRoom = infoProblem("cpu:a=b", metadata);
    assertEquals("--room-info=cpu:a=b: there is no room=cpu; rooms are cup, 1", noRoom);
    String twice = infoProblem("cup:skill=x", metadata);
    assertTrue(twice.contains("room=cup has key=skill already"), twice);
  }

  private static String infoProblem(String text, Map<String, Map<String, String>> metadata) {
    return assertThrows(IllegalArgumentException.class, () -> RoomFlag.readInfo(text, metadata))
        .getMessage();
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
