package carom.server;

import carom.options.BadFlag;
import carom.options.Sockets;
import carom.text.FileErrors;
import carom.text.Texts;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.net.HttpURLConnection;
import java.net.MalformedURLException;
import java.net.Proxy;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/**
 * Runs {@code carom health}, which asks a running server whether it is well. It is for what
 * supervises a server where no {@code curl} is: the health check of the container image, scripts.
 */
@Command(
    name = "health",
    sortOptions = false,
    usageHelpAutoWidth = true,
    mixinStandardHelpOptions = true,
    description = {
      "Asks a running server over HTTP whether it is well, and prints the answer.",
      ""
    },
    footer = {"", "Exit codes: 0 well, 1 unwell or no answer, 2 bad flag."})
final class HealthCommand implements Callable<Integer> {
  private static final int UNWELL = 1;
  private static final int MOST_ANSWER_BYTES = 4096;
  private static final String NOT_A_SERVER =
      "The server must be HOST:PORT, for example 127.0.0.1:8090 or [::1]:8090: ";

  @Spec private CommandSpec spec;

  @Parameters(
      arity = "0..1",
      paramLabel = "HOST:PORT",
      defaultValue = "127.0.0.1:8090",
      description =
          "Where the server answers HTTP: its --web-bind and --web-port (${DEFAULT-VALUE}).")
  private String server;

  @Option(
      names = "--ready",
      description = "Ask whether it takes players (/readyz) instead of whether it runs (/healthz).")
  private boolean ready;

  @Option(
      names = "--timeout",
      paramLabel = "SECONDS",
      defaultValue = "5",
      description = "How long the server may take to answer, 1..60 (${DEFAULT-VALUE}).")
  private int timeoutSeconds;

  /** Creates a command that picocli has yet to fill in. */
  public HealthCommand() {}

  @Override
  public Integer call() {
    PrintWriter out = spec.commandLine().getOut();
    URL url = url();
    try {
      HttpURLConnection http = (HttpURLConnection) url.openConnection(Proxy.NO_PROXY);
      http.setConnectTimeout(timeoutSeconds * 1000);
      http.setReadTimeout(timeoutSeconds * 1000);
      boolean well = http.getResponseCode() == HttpURLConnection.HTTP_OK;
      try (InputStream answer = well ? http.getInputStream() : http.getErrorStream()) {
        out.println(answer == null ? "HTTP status " + http.getResponseCode() : text(answer));
      }
      return well ? 0 : UNWELL;
    } catch (IOException e) {
      out.println("No answer from " + url + " (" + FileErrors.reason(e) + ").");
      return UNWELL;
    } finally {
      out.flush();
    }
  }

  private URL url() {
    if (timeoutSeconds < 1 || timeoutSeconds > 60) {
      throw new BadFlag(
          spec.commandLine(), "--timeout must be 1..60 seconds: --timeout " + timeoutSeconds);
    }
    try {
      URI uri = new URI("http://" + server + (ready ? "/readyz" : "/healthz"));
      boolean whole = uri.getHost() != null && server.equals(uri.getRawAuthority());
      if (!whole || uri.getPort() > Sockets.MAX_PORT) {
        throw new BadFlag(spec.commandLine(), NOT_A_SERVER + server);
      }
      return uri.toURL();
    } catch (URISyntaxException | MalformedURLException e) {
      throw new BadFlag(spec.commandLine(), NOT_A_SERVER + server);
    }
  }

  private static String text(InputStream answer) throws IOException {
    byte[] bytes = answer.readNBytes(MOST_ANSWER_BYTES);
    return Texts.clean(new String(bytes, StandardCharsets.UTF_8).strip());
  }
}
