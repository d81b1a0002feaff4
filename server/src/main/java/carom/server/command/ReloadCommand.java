package carom.server.command;

import carom.server.config.EffectiveSettings;
import carom.server.config.Setting;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * The command {@code reload}: reads the settings and the access lists again. Some settings hold at
 * once; the answer names the others that differ, which need a restart.
 */
public final class ReloadCommand {
  /** Reads the settings of all layers. */
  @FunctionalInterface
  public interface Reader {
    /**
     * Returns the settings as the server would start with them now.
     *
     * @throws CommandException if it would refuse them; the message says which and why
     */
    EffectiveSettings read() throws CommandException;
  }

  private final Reader reader;
  private final Map<String, Consumer<String>> live;
  private final Supplier<String> lists;

  /** The settings in force: those of the start, but for those that a reload has changed. */
  private EffectiveSettings present;

  private ReloadCommand(
      EffectiveSettings present,
      Reader reader,
      Map<String, Consumer<String>> live,
      Supplier<String> lists) {
    this.present = present;
    this.reader = reader;
    this.live = Map.copyOf(live);
    this.lists = lists;
  }

  /**
   * Adds the command to a registry.
   *
   * @param present the settings that the server began with
   * @param live takes the new value of each setting that can change while the server runs
   * @param lists reads the access lists again and describes them
   */
  public static void add(
      CommandRegistry registry,
      EffectiveSettings present,
      Reader reader,
      Map<String, Consumer<String>> live,
      Supplier<String> lists) {
    ReloadCommand command = new ReloadCommand(present, reader, live, lists);
    registry.add(
        new Command(
            "reload",
            "",
            "Reads the settings and the lists of bans, allowed players and admins again, and says"
                + " which changes hold now and which need a restart.",
            command::reload,
            Command.NONE));
  }

  private synchronized String reload(CommandWords words) throws CommandException {
    words.requireAtMost(0);
    EffectiveSettings next = reader.read();
    StringBuilder text = new StringBuilder();
    for (Setting setting : next.all()) {
      String before = present.find(setting.name()).map(Setting::value).orElse("");
      if (!setting.value().equals(before)) {
        Consumer<String> change = live.get(setting.name());
        if (change != null) {
          change.accept(setting.value());
        }
        text.append(
            "%s = %s, was %s: %s\n"
                .formatted(
                    setting.name(),
                    shown(setting.value()),
                    shown(before),
                    change != null ? "holds now" : "needs a restart"));
      }
    }
    // What needs a restart is named again by the next reload.
    present =
        new EffectiveSettings(
            next.all().stream()
                .map(s -> live.containsKey(s.name()) ? s : present.find(s.name()).orElse(s))
                .toList());
    return (text.isEmpty() ? "no setting has changed\n" : text.toString()) + lists.get();
  }

  private static String shown(String value) {
    return value.isEmpty() ? "-" : value;
  }
}
