package carom.lab.figures;

import carom.options.Lab;
import java.io.File;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Starts processes with the JVM, the flags and the class path of this one, lab included. */
final class Children {
  private Children() {}

  /**
   * Starts a program.
   *
   * @param log receives the output; if null, output is piped and errors go to this process's stderr
   */
  static Process start(File log, Class<?> program, String... args) throws IOException {
    return start(log, List.of(), program, args);
  }

  /** Starts a program with further JVM flags, which override those of this process. */
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
