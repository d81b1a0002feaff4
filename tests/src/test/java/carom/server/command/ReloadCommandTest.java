package carom.server.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import carom.server.config.EffectiveSetting;
import carom.server.config.EffectiveSettings;
import carom.server.config.ServerConfig;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** Goal: a reload applies what can change and names what can't. Method: settings that change. */
final class ReloadCommandTest {
  private final CommandRegistry registry = new CommandRegistry();
  private final List<String> levels = new ArrayList<>();
  private EffectiveSettings next = settings("info", "64");

  private static EffectiveSettings settings(String level, String players) {
    return new EffectiveSettings(
        List.of(
            new EffectiveSetting(ServerConfig.LOG_LEVEL, List.of(level), "carom.conf: 1"),
            new EffectiveSetting(ServerConfig.MAX_PLAYERS, List.of(players), "carom.conf: 2")));
  }

  ReloadCommandTest() {
    ReloadCommand.add(
        registry,
        next,
        set -> {
          if (next == null) {
            throw new CommandException("nothing has changed: carom.conf: 1 is wrong");
          }
          String players = next.find("max-players").orElseThrow().value();
          String level = next.find("log-level").orElseThrow().value();
          return set.isEmpty() ? next : settings(set.getOrDefault("log-level", level), players);
        },
        Map.of(
            "log-level",
            level -> {
              if (level.equals("off")) {
                throw new IllegalArgumentException("level=off is refused");
              }
              levels.add(level);
            }),
        () -> "in force: bans 1");
  }

  private String reload() {
    return registry.run("reload", Caller.CONSOLE).text();
  }

  @Test
  void aChangeHoldsNowOrIsNamedUntilTheRestart() {
    assertEquals("no setting has changed\nin force: bans 1", reload());
    next = settings("debug", "32");
    assertEquals(
        "log-level = debug, was info: holds now\n"
            + "max-players = 32, was 64: needs a restart\n"
            + "in force: bans 1",
        reload());
    assertEquals(List.of("debug"), levels);
    assertEquals("max-players = 32, was 64: needs a restart\nin force: bans 1", reload());
    assertEquals(List.of("debug"), levels, "applied once");
  }

  @Test
  void theSameValueInOtherWordsIsNoChange() {
    next = settings("INFO", "064");
    assertEquals("no setting has changed\nin force: bans 1", reload());
    assertEquals(List.of(), levels);
  }

  @Test
  void whatIsSetHoldsOverReloadsUntilItIsTakenBack() {
    assertEquals("log-level = debug, was info: holds now", run("set log-level debug"));
    next = settings("warn", "64");
    assertEquals("no setting has changed\nin force: bans 1", reload());
    assertEquals("log-level = warn, was debug: holds now", run("set log-level"));
    assertEquals("log-level = warn as before", run("set log-level warn"));
    assertEquals(
        "setting=max-players can't change while the server runs; log-level can",
        run("set max-players 5"));
    assertEquals(
        "log-level = off, was warn: not changed: level=off is refused", run("set log-level off"));
    assertEquals(List.of("debug", "warn"), levels);
  }

  private String run(String line) {
    return registry.run(line, Caller.CONSOLE).text();
  }

  @Test
  void aFileThatCannotBeUsedChangesNothing() {
    next = null;
    CommandRegistry.Answer answer = registry.run("reload", Caller.CONSOLE);
    assertFalse(answer.ok());
    assertEquals("nothing has changed: carom.conf: 1 is wrong", answer.text());
    assertEquals(List.of(), levels);
  }
}
