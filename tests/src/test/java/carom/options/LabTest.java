package carom.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.lab.trace.CodecCommand;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.concurrent.Callable;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import picocli.CommandLine.Command;

/** Programs find the laboratory by name, and say where they looked if it isn't there. */
final class LabTest {
  /** A program without commands of its own. */
  @Command(name = "program")
  private static final class Program {}

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int run(String className, String... args) {
    CommandLine program = new CommandLine(new Program());
    LabCommand.add(program, "measure", "Measures.", className);
    return BadFlag.explainedBy(program)
        .setOut(new PrintWriter(out, true))
        .setErr(new PrintWriter(err, true))
        .execute(args);
  }

  @Test
  void aClassOfTheLaboratoryIsFoundByItsName() {
    Object found = Lab.create(Callable.class, "carom.lab.trace.CodecCommand");
    assertInstanceOf(CodecCommand.class, found);
  }

  @Test
  void whatIsMissingIsNamedWithTheFolder() {
    IllegalStateException e =
        assertThrows(
            IllegalStateException.class, () -> Lab.create(Object.class, "carom.lab.Nowhere"));
    assertTrue(e.getMessage().matches("folder=.*lab has no carom.lab.Nowhere; .*"), e.getMessage());
    assertEquals(2, run("carom.lab.Nowhere", "measure"));
    assertTrue(err.toString().startsWith("program measure: folder="), err.toString());
  }

  @Test
  void aCommandGetsAllFlagsAndSpeaksAsThePrograms() {
    assertEquals(0, run("carom.lab.trace.CodecCommand", "measure", "--help"));
    assertTrue(out.toString().startsWith("Usage: program measure "), out.toString());
    assertEquals(2, run("carom.lab.trace.CodecCommand", "measure", "--trace=x", "--lag=none"));
    assertTrue(err.toString().startsWith("program measure: Invalid value"), err.toString());
  }

  @Test
  void theHelpOfAProgramListsItsCommands() {
    CommandLine program = new CommandLine(new Program());
    LabCommand.add(program, "measure", "Measures.", "carom.lab.Nowhere");
    assertTrue(program.getUsageMessage().contains("measure  Measures."), program.getUsageMessage());
  }
}
