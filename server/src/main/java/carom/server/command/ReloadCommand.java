package carom.server.command;

import carom.server.config.EffectiveSetting;
import carom.server.config.EffectiveSettings;
import carom.text.Suggestion;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * The commands {@code reload}, which reads the settings and the access lists again, and {@code
 * set}, which sets one until the next start. Some settings hold at once; the answer names the
 * others that differ, which need a restart.
 */
public final class ReloadCommand {
  /** Reads the settings of all layers. */
  @FunctionalInterface
  public interface Reader {
    /**
     * Returns the settings as the server would start with them now.
     *
     * @param set values of settings that an operator has set, which win over all layers
     * @throws CommandException if it would refuse them; the message says which and why
     */
    EffectiveSettings read(Map<String, String> set) throws CommandException;
  }

  private final Reader reader;
  private final Map<String, Consumer<String>> live;
  private final Supplier<String> lists;

  private final Map<String, String> set = new TreeMap<>();

  /** The settings in force: those of the start, but for those that have changed. */
  private volatile EffectiveSettings present;

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
   * Adds the commands to a registry.
   *
   * @param present the settings that the server began with
   * @param live takes the new value of each setting that can change while the server runs
   * @param lists reads the access lists again and describes them
   * @return returns the settings in force
   */
  public static Supplier<EffectiveSettings> add(
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
    registry.add(
        new Command(
            "set",
            "SETTING [VALUE]",
            "Sets a setting until the next start, or takes that back: what flags and files say"
                + " holds again.",
            command::set,
            place -> place == 0 ? List.copyOf(new TreeSet<>(live.keySet())) : List.of()));
    return () -> command.present;
  }

  private synchronized String set(CommandWords words) throws CommandException {
    String name = words.word(0, "SETTING");
    words.requireAtMost(2);
    if (!live.containsKey(name)) {
      List<String> names = List.copyOf(new TreeSet<>(live.keySet()));
      throw new CommandException(
          "setting=%s can't change while the server runs; %s can%s"
              .formatted(name, String.join(", ", names), Suggestion.didYouMean(name, names)));
    }
    Map<String, String> next = new TreeMap<>(set);
    if (words.has(1)) {
      next.put(name, words.word(1, "VALUE"));
    } else {
      next.remove(name);
    }
    String changes = apply(reader.read(next));
    set.clear();
    set.putAll(next);
    return changes.isEmpty()
        ? name
            + " = "
            + shown(present.find(name).map(EffectiveSetting::value).orElse(""))
            + " as before"
        : changes.strip();
  }

  private synchronized String reload(CommandWords words) throws CommandException {
    words.requireAtMost(0);
    String changes = apply(reader.read(set));
    return (changes.isEmpty() ? "no setting has changed\n" : changes) + lists.get();
  }

  /**
   * Puts settings in force, as far as they can change, and returns a line for each that differs.
   */
  private String apply(EffectiveSettings next) {
    StringBuilder text = new StringBuilder();
    Set<String> refused = new TreeSet<>();
    for (EffectiveSetting setting : next.all()) {
      EffectiveSetting before = present.find(setting.name()).orElseThrow();
      if (!setting.isSameAs(before)) {
        Consumer<String> change = live.get(setting.name());
        String outcome = change == null ? "needs a restart" : "holds now";
        try {
          if (change != null) {
            change.accept(setting.value());
          }
        } catch (IllegalArgumentException e) {
          refused.add(setting.name());
          outcome = "not changed: " + e.getMessage();
        }
        text.append(
            "%s = %s, was %s: %s\n"
                .formatted(setting.name(), shown(setting.value()), shown(before.value()), outcome));
      }
    }
    // What needs a restart is named again by the next reload.
    present =
        new EffectiveSettings(
            next.all().stream()
                .map(
                    s ->
                        live.containsKey(s.name()) && !refused.contains(s.name())
                            ? s
                            : present.find(s.name()).orElse(s))
                .toList());
    return text.toString();
  }

  private static String shown(String value) {
    return value.isEmpty() ? "-" : value;
  }
}
