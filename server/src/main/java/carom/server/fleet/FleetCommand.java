package carom.server.fleet;

import carom.net.seal.ServerKey;
import carom.options.BadFlag;
import carom.server.directory.Directories;
import carom.server.directory.Directory;
import carom.server.directory.DirectoryTls;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/**
 * Runs {@code carom fleet}, which shows a fleet's servers and rooms, moves a room to another
 * server, and empties a server, from any machine that reaches the directory and the servers.
 */
@Command(
    name = "fleet",
    sortOptions = false,
    usageHelpAutoWidth = true,
    mixinStandardHelpOptions = true,
    description = {
      "Shows a fleet and moves its rooms: status | rooms | move ROOM [SERVER] | drain SERVER"
          + " | undrain SERVER.",
      ""
    },
    footer = {"", "Exit codes: 0 done, 1 not done or no answer, 2 bad flag."})
public final class FleetCommand implements Callable<Integer> {
  private static final int FAILED = 1;

  @Spec private CommandSpec spec;

  @Parameters(
      arity = "0..3",
      paramLabel = "WORD",
      description = {
        "status: the servers (default); rooms: the rooms, their owners and followers;",
        "move ROOM [SERVER]: moves a running room; drain SERVER: moves all rooms of a server away;",
        "undrain SERVER: lets it take rooms and players again."
      })
  private List<String> words = List.of();

  @Option(
      names = "--fleet",
      paramLabel = "DIRECTORY",
      defaultValue = "etcd:http://127.0.0.1:2379",
      description = "The fleet's directory, as the servers have it (${DEFAULT-VALUE}).")
  private String fleet;

  @Option(
      names = "--fleet-key",
      paramLabel = "FILE",
      description = "The fleet's key; move, drain and undrain need it.")
  private Path keyFile;

  @Option(names = "--directory-ca", paramLabel = "FILE", description = "As the servers have it.")
  private Path ca;

  @Option(names = "--directory-cert", paramLabel = "FILE", description = "As the servers have it.")
  private Path certificate;

  @Option(names = "--directory-key", paramLabel = "FILE", description = "As the servers have it.")
  private Path key;

  /** Creates a command that picocli has yet to fill in. */
  public FleetCommand() {}

  @Override
  public Integer call() {
    FleetVerb verb;
    try {
      verb = FleetVerb.of(words);
    } catch (IllegalArgumentException e) {
      throw bad(e.getMessage());
    }
    if (verb.needsName() && words.size() < 2) {
      throw bad("use it like this: carom fleet " + verb.usage());
    }
    PrintWriter out = spec.commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    try (Directory directory = Directories.open(fleet, new DirectoryTls(ca, certificate, key))) {
      FleetCommands.Snapshot snapshot = new FleetCommands.Snapshot(directory);
      out.println(
          switch (verb) {
            case STATUS -> snapshot.status();
            case ROOMS -> snapshot.roomList();
            case MOVE -> tell(snapshot.owner(words.get(1)), String.join(" ", words));
            case DRAIN, UNDRAIN -> tell(snapshot.server(words.get(1)), verb.word());
          });
      return 0;
    } catch (IOException e) {
      err.println("carom fleet: " + e.getMessage());
      return FAILED;
    } catch (IllegalArgumentException e) {
      throw bad(e.getMessage());
    } finally {
      out.flush();
      err.flush();
    }
  }

  private BadFlag bad(String message) {
    return new BadFlag(spec.commandLine(), message);
  }

  /** Tells a server what to do, and returns its answer. */
  private String tell(ServerRecord server, String line) throws IOException {
    if (keyFile == null) {
      throw bad("--fleet-key FILE is missing: servers obey only who has the fleet's key");
    }
    if (!Files.isRegularFile(keyFile)) {
      throw bad("--fleet-key=" + keyFile + " isn't there; copy it from a server of the fleet");
    }
    PeerFrame answer = TcpPeers.ask(server, ServerKey.load(keyFile), Peers.command(line));
    return Peers.words(server, answer);
  }
}
