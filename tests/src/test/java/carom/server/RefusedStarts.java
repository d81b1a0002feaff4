package carom.server;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

/**
 * Runs the server's program again and again in one process of its own, with flags that it refuses.
 * A process for each would take most of its time to begin.
 */
final class RefusedStarts implements AutoCloseable {
  private static final int MOST_SECONDS = 30;

  /**
   * What a start came to.
   *
   * @param exitCode the program's
   * @param out what it printed to standard output
   * @param err what it printed to standard error
   */
  record Refusal(int exitCode, String out, String err) {}

  private final Process process;
  private final DataOutputStream flags;
  private final DataInputStream refusals;

  /**
   * Starts the process.
   *
   * @param program begins {@link #main}; its environment is that of all starts
   * @param errors a file for what the process itself has to say
   */
  RefusedStarts(ProcessBuilder program, Path errors) throws IOException {
    process = program.redirectError(errors.toFile()).start();
    flags = new DataOutputStream(process.getOutputStream());
    refusals = new DataInputStream(process.getInputStream());
  }

  /** Starts the server's program with flags, and waits until it ends, which must come soon. */
  Refusal start(String... args) throws Exception {
    flags.writeInt(args.length);
    for (String arg : args) {
      flags.writeUTF(arg);
    }
    flags.flush();
    return CompletableFuture.supplyAsync(this::next).get(MOST_SECONDS, TimeUnit.SECONDS);
  }

  private Refusal next() {
    try {
      return new Refusal(refusals.readInt(), refusals.readUTF(), refusals.readUTF());
    } catch (IOException e) {
      throw new IllegalStateException("the program ended the process", e);
    }
  }

  @Override
  public void close() {
    process.destroyForcibly();
  }

  /** Runs the program with the flags that standard input brings, until that ends. */
  public static void main(String[] none) throws IOException {
    DataOutputStream refusals = new DataOutputStream(System.out);
    DataInputStream flags = new DataInputStream(System.in);
    try {
      while (true) {
        String[] args = new String[flags.readInt()];
        for (int i = 0; i < args.length; i++) {
          args[i] = flags.readUTF();
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        System.setOut(new PrintStream(out, true, StandardCharsets.UTF_8));
        System.setErr(new PrintStream(err, true, StandardCharsets.UTF_8));
        refusals.writeInt(ServerMain.run(args));
        for (ByteArrayOutputStream text : List.of(out, err)) {
          refusals.writeUTF(text.toString(StandardCharsets.UTF_8));
        }
        refusals.flush();
      }
    } catch (EOFException e) {
      System.exit(0);
    }
  }
}
