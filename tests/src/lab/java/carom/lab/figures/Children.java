package carom.lab.figures;

import carom.options.Lab;
import java.io.File;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Processes with the JVM, the flags and the class path of this one, the laboratory's included. */
final class Children {
  private Children() {}

  /**
   * Starts a program.
   *
   * @param log takes what it writes; null: output is piped, errors go where ours go
   */
  static Process start(File log, Class<?> program, String... args) throws IOException {
    return start(log, List.of(), program, args);
  }

  /** As the other one, with further flags for the JVM, which count more than this one's. */
  static Process start(File log, List<String> flags, Class<?> program, String... args)
      throws IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments());
    command.addAll(flags);
    command.add("-cp");
    command.add(Lab.classPath());
    command.add(program.getName());
    command.addAll(List.of(args));
    ProcessBuilder builder = new ProcessBuilder(command);
    if (log == null) {
      builder.redirectError(ProcessBuilder.Redirect.INHERIT);
    } else {
      builder.redirectErrorStream(true).redirectOutput(log);
    }
    return builder.start();
  }
}
