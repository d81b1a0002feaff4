package carom.server.command;

import carom.text.Suggestion;
import java.util.ArrayList;
import java.util.Collection;
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
    add(new Command("help", "[COMMAND]", "Shows this, or one command.", this::help, this::names));
  }

  /** Adds a command. */
  public void add(Command command) {
    if (commands.putIfAbsent(command.name(), command) != null) {
      throw new IllegalArgumentException("command=" + command.name() + " is there already");
    }
  }

  /** Returns the names of all commands, sorted. */
  public Collection<String> names() {
    return List.copyOf(commands.keySet());
  }

  /**
   * Carries out a line. Never throws: whatever goes wrong is the answer.
   *
   * @param line a command and its words; empty and comments (#) have an empty answer
   */
  public Answer run(String line) {
    String text = line.strip();
    if (text.isEmpty() || text.startsWith("#")) {
      return new Answer(true, "");
    }
    if (text.length() > MAX_LINE) {
      return new Answer(false, "the line has more than " + MAX_LINE + " characters");
    }
    CommandWords words = CommandWords.parse(text);
    String name = name(words.all());
    Command command = commands.get(name);
    if (command == null) {
      String near = Suggestion.didYouMean(name, commands.keySet());
      return answer(false, "unknown command=" + name + near + (near.isEmpty() ? "; try help" : ""));
    }
    try {
      return answer(true, command.action().run(words.behindFirst()));
    } catch (CommandException e) {
      String usage = e.isOfWords() ? "; usage: " + command.synopsis() : "";
      return answer(false, e.getMessage() + usage);
    } catch (RuntimeException | Error e) { // threads of consoles go on
      LOG.error("the command {} failed", name, e);
      return answer(false, name + " failed because of a bug, see the log: " + e);
    }
  }

  /** Returns the name of the command that a line would run, or "" if it has no words. */
  public static String verb(String line) {
    List<String> words = CommandWords.split(line);
    return words.isEmpty() ? "" : name(words);
  }

  private static String name(List<String> words) {
    return words.get(0).toLowerCase(Locale.ROOT);
  }

  private static Answer answer(boolean ok, String text) {
    return new Answer(ok, Printable.text(text));
  }

  /**
   * Returns the words that may stand at the end of a line.
   *
   * @param words the words before the one to complete
   */
  public List<String> complete(List<String> words) {
    if (words.isEmpty()) {
      return new ArrayList<>(commands.keySet());
    }
    Command command = commands.get(name(words));
    long rooms = words.stream().skip(1).filter(word -> word.startsWith("@")).count();
    if (command == null) {
      return List.of();
    }
    List<String> next = command.completer().words((int) (words.size() - 1 - rooms));
    return rooms == 0 ? next : next.stream().filter(word -> !word.startsWith("@")).toList();
  }

  private List<String> names(int place) {
    return place == 0 ? new ArrayList<>(commands.keySet()) : List.of();
  }

  private String help(CommandWords words) throws CommandException {
    words.requireAtMost(1);
    if (words.has(0)) {
      Command command = commands.get(words.all().get(0));
      if (command == null) {
        String wanted = words.all().get(0);
        throw new CommandException(
            "unknown command=" + wanted + Suggestion.didYouMean(wanted, commands.keySet()));
      }
      return command.synopsis() + "\n" + HelpText.wrap(command.doc(), 2);
    }
    return HelpText.of(commands.values())
        + "@NAME anywhere in a line names a room. Quotes hold words together.";
  }
}
