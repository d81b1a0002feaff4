package carom.server.command;

import carom.text.Suggestion;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * All commands of the operator, by name. Any thread but a room's may run lines, several at once.
 * Add all commands before.
 */
public final class CommandRegistry {
  /** Longest line, in characters. */
  public static final int MAX_LINE = 4_096;

  private static final String HELP = "help";
  private static final String WHERE = "operators give it at the console, on the page or by RCON";
  private static final Logger LOG = LoggerFactory.getLogger(CommandRegistry.class);

  private final Map<String, Command> commands = new TreeMap<>();

  /**
   * The answer to a line.
   *
   * @param ok whether the command was carried out
   * @param text lines for the operator, {@linkplain Printable printable}; may be empty
   */
  public record Answer(boolean ok, String text) {}

  /** Creates a registry that has {@code help} only. */
  public CommandRegistry() {
    add(
        new Command(HELP, "[COMMAND]", "Shows this, or one command.", this::help, Command.NONE)
            .forModerators()
            .thatShows());
  }

  /** Adds a command. */
  public void add(Command command) {
    if (commands.putIfAbsent(command.name(), command) != null) {
      throw new IllegalArgumentException("command=" + command.name() + " is there already");
    }
  }

  /**
   * Carries out a line. Never throws: the answer names what went wrong. A command that may change
   * something leaves a line in the log: who gave it, what it was, and the answer.
   *
   * @param line a command and its words; empty and comments (#) have an empty answer
   * @param caller who gives it, which decides what it may do
   */
  public Answer run(String line, Caller caller) {
    String text = line.strip();
    if (text.isEmpty() || text.startsWith("#")) {
      return new Answer(true, "");
    }
    if (text.length() > MAX_LINE) {
      return new Answer(false, "the line has more than " + MAX_LINE + " characters");
    }
    if (text.chars().anyMatch(c -> c == '\n' || c == '\r')) {
      return new Answer(false, "this is more than one line; give one command at a time");
    }
    try {
      CommandWords words = CommandWords.parse(text, caller);
      return run(name(words.all()), words.behindFirst());
    } catch (IllegalArgumentException e) {
      return answer(false, e.getMessage());
    }
  }

  private Answer run(String name, CommandWords words) {
    Command command = commands.get(name);
    Caller caller = words.caller();
    if (command == null) {
      String near = Suggestion.didYouMean(name, namesFor(caller));
      return answer(false, "unknown command=" + name + near + (near.isEmpty() ? "; try help" : ""));
    }
    Answer answer =
        caller.role().includes(command.least())
            ? run(command, words)
            : answer(false, name + " isn't a moderator's; " + WHERE + "; try help");
    if (command.changes()) {
      String said = answer.text().lines().findFirst().orElse("");
      LOG.info("{}: {} -> {}", caller, Printable.text(command.line(words)), said);
    }
    return answer;
  }

  private static Answer run(Command command, CommandWords words) {
    try {
      return answer(true, command.action().run(words));
    } catch (CommandException e) {
      String usage = e.isOfWords() ? "; usage: " + command.synopsis() : "";
      return answer(false, e.getMessage() + usage);
    } catch (RuntimeException | Error e) { // threads of consoles go on
      LOG.error("the command {} failed", command.name(), e);
      return answer(false, command.name() + " failed because of a bug, see the log: " + e);
    }
  }

  private static String name(List<String> words) {
    return words.get(0).toLowerCase(Locale.ROOT);
  }

  private List<Command> commandsFor(Caller caller) {
    return commands.values().stream()
        .filter(command -> caller.role().includes(command.least()))
        .toList();
  }

  private List<String> namesFor(Caller caller) {
    return commandsFor(caller).stream().map(Command::name).toList();
  }

  private static Answer answer(boolean ok, String text) {
    return new Answer(ok, Printable.text(text));
  }

  /**
   * Returns the words that may stand at the end of a line.
   *
   * @param words the words before the one to complete
   * @param caller who writes the line
   */
  public List<String> complete(List<String> words, Caller caller) {
    if (words.isEmpty()) {
      return namesFor(caller);
    }
    Command command = commands.get(name(words));
    long rooms = words.stream().skip(1).filter(word -> word.startsWith("@")).count();
    if (command == null || !caller.role().includes(command.least())) {
      return List.of();
    }
    if (command.name().equals(HELP)) {
      return words.size() == 1 ? namesFor(caller) : List.of();
    }
    List<String> next = command.completer().words((int) (words.size() - 1 - rooms));
    return rooms == 0 ? next : next.stream().filter(word -> !word.startsWith("@")).toList();
  }

  private String help(CommandWords words) throws CommandException {
    words.requireAtMost(1);
    List<Command> known = commandsFor(words.caller());
    if (words.has(0)) {
      String wanted = words.word(0, "COMMAND");
      for (Command command : known) {
        if (command.name().equals(wanted)) {
          return command.synopsis() + "\n" + HelpText.wrap(command.doc(), 2);
        }
      }
      throw new CommandException(
          "unknown command="
              + wanted
              + Suggestion.didYouMean(wanted, known.stream().map(Command::name).toList()));
    }
    return HelpText.of(known)
        + "@NAME anywhere in a line names a room. Quotes hold words together.";
  }
}
