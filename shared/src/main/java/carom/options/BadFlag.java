package carom.options;

import java.io.PrintWriter;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;

/**
 * A flag that is understood but has an unusable value. Its message names flag, value and limit, and
 * how to fix it. All programs report such flags, and flags they don't understand, in the same way:
 * a line or two on standard error instead of a page of help, and exit code 2.
 */
public final class BadFlag extends ParameterException {
  private static final long serialVersionUID = 1;

  /**
   * Creates an error for a flag.
   *
   * @param commandLine command line of the program
   * @param message message for the user
   */
  public BadFlag(CommandLine commandLine, String message) {
    super(commandLine, message);
  }

  /** Makes a program report wrong flags in this way, and returns the program. */
  public static CommandLine explainedBy(CommandLine program) {
    return program.setParameterExceptionHandler((e, args) -> explain(e));
  }

  private static int explain(ParameterException e) {
    CommandLine program = e.getCommandLine();
    String name = program.getCommandSpec().qualifiedName();
    PrintWriter err = program.getErr();
    err.println(name + ": " + e.getMessage());
    if (!(e instanceof BadFlag)) {
      UnmatchedArgumentException.printSuggestions(e, err);
      err.println("Try '" + name + " --help'.");
    }
    err.flush();
    return program.getCommandSpec().exitCodeOnInvalidInput();
  }
}
