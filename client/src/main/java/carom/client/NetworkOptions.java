package carom.client;

import carom.net.transport.ClientTransport;
import carom.net.transport.Impairment;
import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.encoder.PatternLayoutEncoder;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.ConsoleAppender;
import org.slf4j.LoggerFactory;
import picocli.CommandLine.Option;

/** Command line flags that all client programs share: where the server is, and a bad network. */
public final class NetworkOptions {
  /** How much is logged, to standard error. */
  public enum LogLevel {
    /** Only what broke. */
    ERROR,
    /** And what looks wrong. */
    WARN,
    /** And what happens. */
    INFO,
    /** And why. */
    DEBUG
  }

  @Option(
      names = "--host",
      paramLabel = "HOST",
      description = "server's name or address (default: ${DEFAULT-VALUE})",
      defaultValue = "localhost")
  String host = "localhost";

  @Option(
      names = "--tcp-port",
      paramLabel = "N",
      description = "server's TCP port (default: ${DEFAULT-VALUE})",
      defaultValue = "54555")
  int tcpPort = ClientConfig.DEFAULT_TCP_PORT;

  @Option(
      names = "--udp-port",
      paramLabel = "N",
      description = "server's UDP port (default: ${DEFAULT-VALUE})",
      defaultValue = "54777")
  int udpPort = ClientConfig.DEFAULT_UDP_PORT;

  @Option(
      names = "--log-level",
      paramLabel = "LEVEL",
      description = "error, warn, info or debug (default: ${DEFAULT-VALUE})",
      defaultValue = "warn")
  LogLevel logLevel = LogLevel.WARN;

  @Option(
      names = "--loss",
      paramLabel = "PERCENT",
      description = "drop this share of the datagrams, each way",
      defaultValue = "0")
  double loss;

  @Option(
      names = "--burst",
      paramLabel = "N",
      description = "lose that many datagrams in a row on average",
      defaultValue = "1")
  double burst = 1;

  @Option(
      names = "--latency",
      paramLabel = "MS",
      description = "delay everything by this, each way",
      defaultValue = "0")
  double latency;

  @Option(
      names = "--jitter",
      paramLabel = "MS",
      description = "vary the delay by plus or minus this",
      defaultValue = "0")
  double jitter;

  @Option(
      names = "--reorder",
      paramLabel = "PERCENT",
      description = "hold back this share of the datagrams",
      defaultValue = "0")
  double reorder;

  @Option(
      names = "--duplicate",
      paramLabel = "PERCENT",
      description = "deliver this share of the datagrams twice",
      defaultValue = "0")
  double duplicate;

  @Option(
      names = "--network-seed",
      paramLabel = "N",
      description = "seed of the bad network (default: ${DEFAULT-VALUE})",
      defaultValue = "1")
  long networkSeed = 1;

  /** Creates the defaults; the command line fills them in. */
  public NetworkOptions() {}

  /** A config for this server and a player of this name. */
  public ClientConfig config(String name) {
    return ClientConfig.of(name).withServer(host, tcpPort, udpPort);
  }

  /** What is wrong with the flags, in words that name flag, value and range; null when nothing. */
  public String problem() {
    if (tcpPort < 1 || tcpPort > 65_535) {
      return "--tcp-port=" + tcpPort + " is outside 1..65535";
    }
    if (udpPort < 1 || udpPort > 65_535) {
      return "--udp-port=" + udpPort + " is outside 1..65535";
    }
    if (!(loss >= 0 && loss <= 100)) {
      return "--loss=" + loss + " is outside 0..100";
    }
    if (!(reorder >= 0 && reorder <= 100)) {
      return "--reorder=" + reorder + " is outside 0..100";
    }
    if (!(duplicate >= 0 && duplicate <= 100)) {
      return "--duplicate=" + duplicate + " is outside 0..100";
    }
    if (!(burst >= 1 && burst <= 1_000)) {
      return "--burst=" + burst + " is outside 1..1000";
    }
    if (!(latency >= 0 && latency <= 10_000)) {
      return "--latency=" + latency + " is outside 0..10000";
    }
    if (!(jitter >= 0 && jitter <= 10_000)) {
      return "--jitter=" + jitter + " is outside 0..10000";
    }
    return null;
  }

  /** The bad network asked for; {@code Impairment.NONE} when none was. */
  public Impairment impairment() {
    if (loss == 0 && latency == 0 && jitter == 0 && reorder == 0 && duplicate == 0) {
      return Impairment.NONE;
    }
    return Impairment.NONE
        .withSeed(networkSeed)
        .withBursts(loss, burst)
        .withLatency(latency, jitter)
        .withReorder(reorder, duplicate);
  }

  /** Puts the bad network asked for in front of a transport. */
  public ClientTransport impair(ClientTransport transport) {
    Impairment asked = impairment();
    return asked.equals(Impairment.NONE)
        ? transport
        : new ImpairedTransport(transport, asked, System::nanoTime);
  }

  /** Lets the program log to standard error, as much as was asked for. */
  public void startLogging() {
    LoggerContext context = (LoggerContext) LoggerFactory.getILoggerFactory();
    context.reset();
    PatternLayoutEncoder encoder = new PatternLayoutEncoder();
    encoder.setContext(context);
    encoder.setPattern("%d{HH:mm:ss.SSS} %-5level %logger{0}: %msg%n");
    encoder.start();
    ConsoleAppender<ILoggingEvent> console = new ConsoleAppender<>();
    console.setContext(context);
    console.setTarget("System.err");
    console.setEncoder(encoder);
    console.start();
    Logger root = context.getLogger(org.slf4j.Logger.ROOT_LOGGER_NAME);
    root.setLevel(Level.toLevel(logLevel.name()));
    root.addAppender(console);
  }
}
