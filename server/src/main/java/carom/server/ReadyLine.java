package carom.server;

import java.io.Console;
import java.io.PrintStream;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.List;

/**
 * Prints the line {@code ready tcp=54555 udp=54777} to standard output, for programs that wait for
 * it. On a terminal a few hints for people follow.
 */
final class ReadyLine {
  private static final String TERMINAL_PROPERTY = "carom.terminal";
  private static final int DEFAULT_TCP_PORT = 54_555;

  private ReadyLine() {}

  /** Returns whether gradlew starts the server for a person at a terminal. */
  public static boolean isByGradle() {
    return Boolean.getBoolean(TERMINAL_PROPERTY);
  }

  /**
   * Prints the line, with the ports at which players can join.
   *
   * @param play port of browsers, or 0 if there is none; then the line doesn't have it
   * @param plain ports of stock KryoNet, {@code TCP} or {@code TCP:UDP}; null without any
   */
  public static void print(PrintStream out, int tcp, int udp, int play, String plain) {
    out.println(
        "ready tcp="
            + tcp
            + " udp="
            + udp
            + (play == 0 ? "" : " play=" + play)
            + (plain == null ? "" : " plain=" + plain));
    out.flush();
  }

  /**
   * Prints the hints, if standard output is a terminal: the last thing that is printed at the
   * start, so that they stay in sight.
   *
   * @param page address of the live page; null without one
   * @param play address of the page that plays; null without one
   * @param onlyHere whether only this machine reaches the ports
   */
  public static void printHints(
      PrintStream out, int tcp, String page, String play, boolean onlyHere) {
    if (isOnTerminal()) {
      out.println();
      hints(tcp, page, play, isByGradle(), onlyHere).forEach(out::println);
      out.println();
      out.flush();
    }
  }

  /**
   * Returns the hints, a line each.
   *
   * @param sources whether gradlew runs the server, so that it can run the other programs, too
   * @param onlyHere whether only this machine reaches the ports
   */
  static List<String> hints(int tcp, String page, String play, boolean sources, boolean onlyHere) {
    boolean usual = tcp == DEFAULT_TCP_PORT;
    String port = usual ? "" : ":" + tcp;
    String here = "--host localhost" + port;
    String args = usual ? "" : " -Pargs='" + here + "'";
    List<String> lines = new ArrayList<>();
    lines.add("  The server is ready. Players can join.");
    lines.add("");
    lines.add("  join      " + (sources ? "./gradlew play" + args : "carom-client " + here));
    lines.add(
        onlyHere
            ? "            (from this machine only; see --bind)"
            : "            carom-client --host " + hostName() + port + "   (another machine)");
    lines.add(
        "  add bots  "
            + (sources ? "./gradlew bots -Pn=20" + args : "carom-bots --count 20 " + here));
    if (play != null) {
      lines.add("  browser   " + play);
    }
    if (page != null) {
      lines.add("  page      " + page);
    }
    lines.add("  commands  help");
    lines.add("  stop      Ctrl-C, or the command stop");
    return lines;
  }

  private static String hostName() {
    try {
      return InetAddress.getLocalHost().getHostName();
    } catch (UnknownHostException e) {
      return "HOST";
    }
  }

  /**
   * Returns whether standard output is a terminal. Under Gradle this process can't see the
   * terminal, so gradlew sets a property instead. From Java 22 on there is a console object even
   * without a terminal; its {@code isTerminal} tells.
   */
  private static boolean isOnTerminal() {
    if (isByGradle()) {
      return true;
    }
    Console console = System.console();
    if (console == null) {
      return false;
    }
    try {
      return (Boolean) Console.class.getMethod("isTerminal").invoke(console);
    } catch (NoSuchMethodException e) {
      return true;
    } catch (ReflectiveOperationException e) {
      return false;
    }
  }
}
