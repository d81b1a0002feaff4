package carom.options;

import java.io.PrintWriter;
import java.util.List;
import java.util.Map;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;

/**
 * A flag that is understood but has an unusable value. Its message names flag, value and limit, and
 * how to fix it. All programs report such flags, and flags they don't understand, in the same way:
 * a line or two on standard error instead of a page of help, and exit code 2.
 */
public final class BadFlag extends ParameterException {
  private static final long serialVersionUID = 1;

  private static final Map<Class<?>, String> NUMBERS =
      Map.of(int.class, "whole number", long.class, "whole number", double.class, "number");

  /**
   * Creates an error for a flag.
   *
   * @param commandLine command line of the program
   * @param message message for the user
   */
  public BadFlag(CommandLine commandLine, String message) {
    super(commandLine, message);
  }

  /**
   * Makes a program report wrong flags in this way, and returns the program. Its help doesn't begin
   * with a list of all flags either, as the table of flags follows.
   */
  public static CommandLine explainedBy(CommandLine program) {
    abbreviate(program);
    return program.setParameterExceptionHandler((e, args) -> explain(e));
  }

  private static void abbreviate(CommandLine program) {
    program.getCommandSpec().usageMessage().abbreviateSynopsis(true);
    program.getSubcommands().values().forEach(BadFlag::abbreviate);
  }

  private static int explain(ParameterException e) {
    CommandLine program = e.getCommandLine();
    String name = program.getCommandSpec().qualifiedName();
    PrintWriter err = program.getErr();
    String flag = unknownFlag(e);
    boolean told = e.getCause() instanceof Flags.Refusal;
    String message = told ? e.getCause().getMessage() : message(e);
    err.println(name + ": " + (flag == null ? message : "unknown flag '" + flag + "'"));
    if (!(e instanceof BadFlag) && !told) {
      if (flag == null) {
        UnmatchedArgumentException.printSuggestions(e, err);
      } else {
        printSuggestions(program, flag, err);
      }
      err.println("Try '" + name + " --help'.");
    }
    err.flush();
    return program.getCommandSpec().exitCodeOnInvalidInput();
  }

  /** Returns what is wrong; of a value that is no number, with what the flag takes. */
  private static String message(ParameterException e) {
    return e.getArgSpec() instanceof OptionSpec option
            && e.getValue() != null
            && e.getMessage().startsWith("Invalid value")
            && NUMBERS.containsKey(option.type())
        ? option.longestName()
            + "="
            + e.getValue()
            + " is no "
            + NUMBERS.get(option.type())
            + "; "
            + String.join(" ", option.description())
        : e.getMessage();
  }

  /** Returns the first flag that the program doesn't have, or null if that isn't what is wrong. */
  private static String unknownFlag(ParameterException e) {
    return e instanceof UnmatchedArgumentException unmatched
        ? unmatched.getUnmatched().stream()
            .filter(word -> word.startsWith("-"))
            .findFirst()
            .orElse(null)
        : null;
  }

  private static void printSuggestions(CommandLine program, String flag, PrintWriter err) {
    List<String> known =
        program.getCommandSpec().options().stream()
            .filter(option -> !option.hidden())
            .map(OptionSpec::longestName)
            .toList();
    List<String> meant = FlagSuggestion.of(flag, known);
    if (!meant.isEmpty()) {
      err.println("Possible solutions: " + String.join(", ", meant));
    }
  }
}
