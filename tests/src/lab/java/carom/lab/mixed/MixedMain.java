package carom.lab.mixed;

import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Runs a {@link MixedRoom}. */
@Command(
    name = "mixed",
    mixinStandardHelpOptions = true,
    description = "Own clients, stock KryoNet and WebSocket in one room, by the clock.",
    footer = "Exit code 0 only if all showed what the server had, and nobody was lost.")
public final class MixedMain implements Callable<Integer> {
  @Option(names = "--minutes", paramLabel = "N", description = "how long, default ${DEFAULT-VALUE}")
  private double minutes = 60;

  @Option(
      names = "--each",
      paramLabel = "N",
      description = "clients of each of the five kinds, default ${DEFAULT-VALUE}")
  private int each = 4;

  @Option(names = "--seed", paramLabel = "N", description = "seed; default: another every time")
  private long seed = System.nanoTime();

  private MixedMain() {}

  /** Runs the command. */
  public static void main(String[] args) {
    System.exit(new CommandLine(new MixedMain()).execute(args));
  }

  @Override
  public Integer call() throws Exception {
    System.out.println("seed=" + seed);
    try (MixedRoom room = new MixedRoom(each, seed)) {
      boolean good = room.run(60 * minutes, System.out::println);
      room.wrong().forEach(System.out::println);
      return good ? 0 : 1;
    }
  }
}
