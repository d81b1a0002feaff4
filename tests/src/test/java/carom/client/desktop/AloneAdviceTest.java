package carom.client.desktop;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

/** Goal: the command that a lone player reads exists where the player is. */
final class AloneAdviceTest {
  @Test
  void namesTheProgramOfAnInstallationOrTheTaskOfTheSources() {
    assertEquals("carom-bots --host play.example", AloneAdvice.command(false, "play.example", "1"));
    assertEquals("./gradlew bots", AloneAdvice.command(true, "localhost", "1"));
    assertEquals(
        "./gradlew bots -Pargs='--host localhost:41100'",
        AloneAdvice.command(true, "localhost:41100", "1"));
  }

  @Test
  void namesTheRoomSoThatTheBotsComeIntoIt() {
    assertEquals("carom-bots --host a --room cup", AloneAdvice.command(false, "a", "cup"));
    assertEquals(
        "./gradlew bots -Pargs='--host localhost --room cup'",
        AloneAdvice.command(true, "localhost", "cup"));
  }
}
