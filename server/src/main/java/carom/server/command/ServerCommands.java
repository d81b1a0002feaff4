package carom.server.command;

import carom.options.Setting;
import carom.server.config.DataFolder;
import carom.server.config.EffectiveSetting;
import carom.server.config.EffectiveSettings;
import carom.text.Suggestion;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;

/** The commands that are about the whole server. */
public final class ServerCommands {
  private final Supplier<List<String>> status;
  private final Supplier<EffectiveSettings> settings;
  private final List<Path> recordings;
  private final UnaryOperator<String> replay;

  private ServerCommands(
      Supplier<List<String>> status,
      Supplier<EffectiveSettings> settings,
      List<Path> recordings,
      UnaryOperator<String> replay) {
    this.recordings = List.copyOf(recordings);
    this.status = status;
    this.settings = settings;
    this.replay = replay;
  }

  /**
   * Adds the commands to a registry.
   *
   * @param status returns lines about rooms and load
   * @param settings returns the settings in force
   * @param recordings folders with files that operators may have computed again
   * @param replay computes a recording again and returns the outcome
   */
  public static void add(
      CommandRegistry registry,
      Supplier<List<String>> status,
      Supplier<EffectiveSettings> settings,
      List<Path> recordings,
      UnaryOperator<String> replay) {
    ServerCommands all = new ServerCommands(status, settings, recordings, replay);
    registry.add(
        new Command(
                "status", "", "Shows load and traffic since the start.", all::status, Command.NONE)
            .thatShows());
    registry.add(
        new Command(
                "config",
                "[SETTING]",
                "Shows all settings with value and origin, or one with its default and what it"
                    + " does.",
                all::config,
                place -> place == 0 ? settings.get().names() : List.of())
            .thatShows());
    registry.add(
        new Command(
            "replay",
            "FILE",
            "Computes a recording again and compares every tick; takes a core for a while.",
            all::replay,
            place -> place == 0 ? DataFolder.recordingFiles(recordings) : List.of()));
  }

  private String status(CommandWords words) throws CommandException {
    words.requireAtMost(0);
    return String.join("\n", status.get().stream().map(HelpText::wrapClauses).toList());
  }

  private String config(CommandWords words) throws CommandException {
    words.requireAtMost(1);
    if (words.has(0)) {
      return describe(words.word(0, "SETTING"));
    }
    TextTable table = new TextTable("setting", "value", "origin");
    for (EffectiveSetting setting : settings.get().all()) {
      table.add(setting.name(), setting.row().shown(setting.value()), setting.origin());
    }
    return table.toString();
  }

  private String describe(String name) throws CommandException {
    EffectiveSetting setting =
        settings
            .get()
            .find(name)
            .orElseThrow(
                () ->
                    new CommandException(
                        "unknown setting="
                            + name
                            + Suggestion.didYouMean(name, settings.get().names())));
    Setting<?> row = setting.row();
    return "%s = %s\n  from: %s\n  default: %s\n  %s\n  set it with --%s, %s or in the file; it holds from %s"
        .formatted(
            setting.name(),
            row.shown(setting.value()),
            setting.origin(),
            row.shown(row.initialText()),
            row.doc(),
            row.name(),
            row.variable(),
            row.isLive() ? "the command 'reload' or 'set' on" : "the next start");
  }

  private String replay(CommandWords words) throws CommandException {
    words.requireAtMost(1);
    return replay.apply(NamedFiles.file(words, 0, "FILE", recordings).toString());
  }
}
