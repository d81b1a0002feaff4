package carom.options;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** A command that a class of the {@link Lab} carries out. It passes all arguments on unchanged. */
@Command
public final class LabCommand implements Callable<Integer> {
  private final String className;

  @Parameters(hidden = true)
  private List<String> args = new ArrayList<>();

  @Spec private CommandSpec spec;

  private LabCommand(String className) {
    this.className = className;
  }

  /**
   * Adds a laboratory command to a program.
   *
   * @param program the program that users start
   * @param name name of the command
   * @param description a line for the program's help
   * @param className full name of a {@link Command} class in the laboratory that has a constructor
   *     without parameters
   */
  public static void add(CommandLine program, String name, String description, String className) {
    CommandLine command = new CommandLine(new LabCommand(className));
    command.setUnmatchedOptionsArePositionalParams(true);
    command.getCommandSpec().usageMessage().description(description);
    program.addSubcommand(name, command);
  }

  @Override
  public Integer call() {
    Object command;
    try {
      command = Lab.create(Object.class, className);
    } catch (IllegalStateException e) {
      throw new BadFlag(spec.commandLine(), e.getMessage());
    }
    return BadFlag.explainedBy(new CommandLine(command))
        .setCommandName(spec.qualifiedName())
        .setOut(spec.commandLine().getOut())
        .setErr(spec.commandLine().getErr())
        .execute(args.toArray(new String[0]));
  }
}
