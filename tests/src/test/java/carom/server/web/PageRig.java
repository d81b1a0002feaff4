package carom.server.web;

import carom.client.bots.Bot;
import carom.net.transport.Impairment;
import carom.server.access.AccessCommands;
import carom.server.access.AccessLists;
import carom.server.access.AddressRange;
import carom.server.access.Logins;
import carom.server.access.Secret;
import carom.server.command.CommandRegistry;
import carom.server.command.RoomCommands;
import carom.server.command.SaveSource;
import carom.server.config.DataFolder;
import carom.testkit.Stepper;
import ch.qos.logback.classic.LoggerContext;
import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/** An arena with two bots that goes on by itself, and its page. */
final class PageRig implements AutoCloseable {
  /** A name that would be dangerous as HTML and awkward in a line of the console. */
  static final String HOSTILE = "<img src=x>\"@1 &amp;";

  static final String TOKEN = "a token of the test";

  final Stepper stepper;
  final LoggerContext logging = new LoggerContext();
  final WebServer web;
  private final Thread watch;
  private final Thread player;
  private volatile boolean ended;

  /**
   * Starts everything.
   *
   * @param strangersWatch whether the page shows rooms without the token
   */
  PageRig(Path folder, boolean strangersWatch) throws IOException {
    this(Stepper.of("arena"), folder, strangersWatch);
  }

  /** Starts everything behind proxies whose addresses are in some networks. */
  PageRig(Path folder, String... proxies) throws IOException {
    this(
        Stepper.of("arena"),
        folder,
        true,
        Stream.of(proxies).map(network -> AddressRange.parse(network).orElseThrow()).toList());
  }

  /** Starts everything with a game of its own; closes the stepper in the end. */
  PageRig(Stepper stepper, Path folder, boolean strangersWatch) throws IOException {
    this(stepper, folder, strangersWatch, List.of());
  }

  private PageRig(Stepper stepper, Path folder, boolean strangersWatch, List<AddressRange> proxies)
      throws IOException {
    this.stepper = stepper;
    DataFolder data = new DataFolder(folder);
    Files.writeString(data.adminToken(), TOKEN + "\n");
    stepper.join("Ann", Impairment.NONE, new Bot(Stepper.SEED));
    stepper.join(HOSTILE, Impairment.NONE, new Bot(Stepper.SEED + 1));
    CommandRegistry commands = new CommandRegistry();
    RoomCommands.add(commands, stepper.server().rooms(), data, null, SaveSource.NONE);
    AccessLists lists = new AccessLists(data, false, InstantSource.system());
    watch = AccessCommands.add(commands, lists, stepper.server().rooms());
    Logins logins = Logins.begin(System::nanoTime);
    PageConfig config =
        new PageConfig(
            "Carom test",
            commands,
            Secret.of(data.adminToken()),
            logins.page(),
            LogTail.begin(logging),
            List.of(data.recordings()),
            strangersWatch,
            proxies,
            Set.of("carom.example"));
    WebSubject subject =
        new WebSubject(
            "Carom", "test", stepper.server().rooms(), List.of(), logins, null, List.of());
    web =
        new WebServer(InetAddress.getLoopbackAddress(), 0, subject, new LivePage(config, subject));
    player = new Thread(this::play, "page-rig");
    player.start();
  }

  private void play() {
    while (!ended) {
      stepper.run(0.016);
      try {
        Thread.sleep(16);
      } catch (InterruptedException e) {
        return;
      }
    }
  }

  @Override
  public void close() {
    ended = true;
    try {
      player.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    watch.interrupt();
    web.close();
    stepper.close();
  }
}
