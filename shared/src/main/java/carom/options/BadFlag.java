package carom.options;

import java.io.PrintWriter;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;

/**
 * A flag that is understood but can't be used; its message says all: which flag, value and limit,
 * and how to mend it. All programs tell of it, and of flags that aren't understood, in the same
 * way: a line or two on standard error instead of a page of help, and exit code 2.
 */
public final class BadFlag extends ParameterException {
  private static final long serialVersionUID = 1;

  /**
   * Creates one.
   *
   * @param commandLine of the program
   * @param message for the user
   */
  public BadFlag(CommandLine commandLine, String message) {
    super(commandLine, message);
  }

  /** Has a program tell of wrong flags like this. */
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
