package carom.server;

import carom.options.BadFlag;
import carom.options.Setting;
import carom.server.access.AccessLists;
import carom.server.command.CommandException;
import carom.server.command.ReloadCommand;
import carom.server.config.BadSettingException;
import carom.server.config.EffectiveSettings;
import carom.server.config.RoomConfig;
import carom.server.config.ServerConfig;
import carom.server.room.Room;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.UnaryOperator;

/**
 * The settings that change while the server runs. Reads all layers again, as a start would, and
 * puts the next values in force. The command that reads calls the consumers, one after the other.
 */
final class LiveSettings implements ReloadCommand.Reader {
  /** Reads the layers below some values. */
  @FunctionalInterface
  interface Start {
    /**
     * Returns what a server would be that starts now.
     *
     * @throws BadSettingException if a file can't be used
     * @throws BadFlag if a value can't be used
     */
    Next read(Map<String, String> set) throws BadSettingException;
  }

  /** A server that would start now: its settings and rooms. */
  record Next(EffectiveSettings settings, ServerConfig config, List<RoomConfig> rooms) {}

  private final Start start;
  private final Server server;
  private List<RoomConfig> known;
  private Next next;

  /**
   * Creates the settings of a server that has started.
   *
   * @param known the rooms that it began with
   */
  LiveSettings(Start start, Server server, List<RoomConfig> known) {
    this.start = start;
    this.server = server;
    this.known = known;
  }

  @Override
  public EffectiveSettings read(Map<String, String> set) throws CommandException {
    try {
      next = start.read(set);
      return next.settings();
    } catch (BadSettingException | picocli.CommandLine.ParameterException e) {
      throw new CommandException("nothing has changed: " + e.getMessage());
    }
  }

  /**
   * Returns what takes the new value of each setting that can change.
   *
   * @param logLevel takes the name of a level of the log
   */
  Map<String, Consumer<String>> consumers(AccessLists access, Consumer<String> logLevel) {
    Map<String, Consumer<String>> consumers = new HashMap<>();
    for (Setting<?> row : ServerConfig.ROWS.all()) {
      if (row.isLive()) {
        consumers.put(row.name(), text -> server.configure(next.config()));
      }
    }
    consumers.put(
        ServerConfig.ALLOW_LIST.name(),
        text -> access.onlyAllowed(next.config().get(ServerConfig.ALLOW_LIST)));
    consumers.put(ServerConfig.LOG_LEVEL.name(), logLevel);
    consumers.put(
        ServerConfig.MAX_PLAYERS.name(),
        text -> {
          change(RoomConfig::places, RoomConfig::withPlaces);
          server.configure(next.config());
        });
    consumers.put(
        ServerConfig.LEVELS.name(), text -> change(RoomConfig::levels, RoomConfig::withLevels));
    return consumers;
  }

  /** Changes something of the rooms for which the settings say another thing than before. */
  private <T> void change(Function<RoomConfig, T> of, BiFunction<RoomConfig, T, RoomConfig> with) {
    for (RoomConfig before : known) {
      for (RoomConfig after : next.rooms()) {
        if (after.name().equals(before.name()) && !of.apply(after).equals(of.apply(before))) {
          changeRoom(before.name(), present -> with.apply(present, of.apply(after)));
        }
      }
    }
    known =
        known.stream()
            .map(
                before ->
                    next.rooms().stream()
                        .filter(after -> after.name().equals(before.name()))
                        .findFirst()
                        .map(after -> with.apply(before, of.apply(after)))
                        .orElse(before))
            .toList();
  }

  private void changeRoom(String name, UnaryOperator<RoomConfig> change) {
    for (Room room : server.rooms()) {
      if (room.name().equals(name)) {
        server.changeRoom(room, change);
      }
    }
  }
}
