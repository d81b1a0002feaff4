package carom.client.app;

import carom.client.ClientConfig;
import carom.client.link.ServerAddress;
import carom.net.frame.Trust;
import carom.net.kryo.KryoClientTransport;
import carom.net.kryo.KryoMessageCodec;
import carom.net.protocol.ProtocolLimits;
import carom.net.seal.Encryption;
import carom.net.seal.KnownServers;
import carom.net.transport.ClientTransport;
import carom.net.transport.ImpairedClientTransport;
import carom.net.transport.Impairment;
import carom.options.NetworkConditions;
import carom.options.Rows;
import carom.options.Setting;
import carom.text.FileErrors;
import carom.text.Json;
import carom.text.JsonException;
import carom.text.TextFile;
import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.encoder.PatternLayoutEncoder;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.ConsoleAppender;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Base64;
import org.slf4j.LoggerFactory;

/** Command line flags that all client programs share: the server, and a simulated bad network. */
public final class NetworkOptions {
  private static final int MAX_PASSWORD_FILE = 10_000;

  /** Amount of logging to standard error. */
  public enum LogLevel {
    /** The log has failures only. */
    ERROR,
    /** The log has failures and suspicious things. */
    WARN,
    /** The log also has what happens. */
    INFO,
    /** The log also has why things happen. */
    DEBUG
  }

  /** The flags. */
  public static final Rows ROWS = Rows.ofFlags();

  static {
    ROWS.addAll(ClientConfig.SERVER, ClientConfig.ROOM, ClientConfig.GAME, ClientConfig.PARTY);
  }

  private static final Setting<LogLevel> LOG_LEVEL =
      ROWS.choice("log-level", "LEVEL", LogLevel.WARN)
          .text("How much is logged: error, warn, info or debug ({default}).");

  static {
    ROWS.addAll(ClientConfig.TOKEN, ClientConfig.KEY);
  }

  private static final Setting<Path> PASSWORD_FILE =
      ROWS.path("password-file", "FILE", null)
          .text(
              "File whose first line is the password of the server, for servers that demand one"
                  + " (none; the window asks).");

  private static final Setting<Encryption> ENCRYPTION =
      ROWS.choice("encryption", "on|off", Encryption.ON)
          .text(
              "Encrypt what is sent; off only for a server that runs with --encryption off, in"
                  + " a network you trust ({default}).");

  static {
    ROWS.addAll(ClientConfig.DEV);
    ROWS.addAll(NetworkConditions.ROWS);
  }

  private final ClientConfig flags;

  /** Creates the options that a command line gives. */
  public NetworkOptions(ClientConfig flags) {
    this.flags = flags;
  }

  /** Returns a config for this server and a player of this name. */
  public ClientConfig config(String name) {
    return flags.with(ClientConfig.NAME, name).with(ClientConfig.PASSWORD, password());
  }

  /** Returns what is wrong with the flags (flag, value, range), or null if nothing is. */
  public String problem() {
    try {
      password();
    } catch (IllegalArgumentException e) {
      return e.getMessage();
    }
    return null;
  }

  /**
   * Returns the password in the file, or empty without one.
   *
   * @throws IllegalArgumentException if there is none that can be shown; the message says why
   */
  private String password() {
    Path passwordFile = flags.get(PASSWORD_FILE);
    if (passwordFile == null) {
      return "";
    }
    String flag = "--password-file=" + passwordFile;
    String text;
    try {
      text = TextFile.read(passwordFile, MAX_PASSWORD_FILE).lines().findFirst().orElse("").strip();
    } catch (IOException e) {
      throw new IllegalArgumentException(flag + " can't be read: " + FileErrors.reason(e), e);
    }
    int bytes = text.getBytes(StandardCharsets.UTF_8).length;
    if (bytes < 1 || bytes > ProtocolLimits.MAX_PASSWORD_BYTES) {
      throw new IllegalArgumentException(
          flag
              + ": the first line has bytes="
              + bytes
              + ", allowed are 1.."
              + ProtocolLimits.MAX_PASSWORD_BYTES);
    }
    return text;
  }

  /** Returns the server's address. */
  public ServerAddress address() {
    return flags.get(ClientConfig.SERVER);
  }

  /**
   * Returns the simulated bad network; {@code Impairment.NONE} with a seed if none was asked for.
   */
  public Impairment impairment() {
    return NetworkConditions.impairment(flags);
  }

  /** Returns whether links are encrypted. */
  public boolean isEncrypted() {
    return flags.get(ENCRYPTION) == Encryption.ON;
  }

  /** Returns what a server must be like to be played on. */
  public Trust trust(KnownServers known) {
    String fingerprint = fingerprint(flags.get(ClientConfig.TOKEN));
    if (fingerprint != null) {
      known.expect(address().toString(), fingerprint);
    }
    return new Trust(flags.get(ENCRYPTION), known);
  }

  /** Returns the fingerprint of the server that a join token is for, or null if it names none. */
  static String fingerprint(String token) {
    String[] parts = token.split("\\.", -1);
    if (parts.length != 3) {
      return null;
    }
    try {
      byte[] claims = Base64.getUrlDecoder().decode(parts[1]);
      Json server = Json.parse(claims).fields.get("server");
      return server == null || server.text.isEmpty() ? null : server.text;
    } catch (IllegalArgumentException | JsonException e) {
      return null; // the server will say what is wrong with it
    }
  }

  /** Returns a transport of sockets, over the simulated bad network from the first byte on. */
  public ClientTransport sockets(Trust trust) {
    return impair(new KryoClientTransport(trust, impairment()));
  }

  /** Returns whether the network is made bad on purpose. */
  public boolean isBad() {
    return NetworkConditions.isBad(flags);
  }

  /** Wraps a transport with the simulated bad network. */
  public ClientTransport impair(ClientTransport transport) {
    return NetworkConditions.isBad(flags)
        ? new ImpairedClientTransport(
            transport, impairment(), new KryoMessageCodec(), System::nanoTime)
        : transport;
  }

  /** Starts logging to standard error. */
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
    root.setLevel(Level.toLevel(flags.get(LOG_LEVEL).name()));
    root.addAppender(console);
    if (root.getLevel() == Level.WARN) {
      // A game of this machine has its server in this process; its warnings advise operators.
      context.getLogger("carom.server").setLevel(Level.ERROR);
    }
  }
}
