package carom.server.directory;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.net.URLDecoder;
import java.util.Properties;
import java.util.regex.Pattern;

/**
 * Address of a PostgreSQL, with the user that asks.
 *
 * @param shown the address without user, password and options, for messages
 * @param jdbcUrl URL of the JDBC driver
 * @param properties what the driver is told besides
 * @param deadlineMs longest time of a call
 */
public record PostgresAddress(String shown, String jdbcUrl, Properties properties, int deadlineMs) {
  private static final String SCHEME = "postgresql://";
  private static final String HOST = "([\\w.-]+|\\[[\\p{XDigit}:.]+])(:\\d{1,5})?";
  private static final Pattern HOSTS = Pattern.compile(HOST + "(," + HOST + ")*");

  /**
   * Reads an address as PostgreSQL's own tools write it: {@code
   * postgresql://[USER[:PASSWORD]@]HOST[:PORT][,...]/DATABASE[?OPTION=VALUE[&...]]}. User and
   * password are percent-encoded, options are those of the JDBC driver.
   *
   * @param flag that has it, for messages
   * @throws IOException if it is none; doesn't repeat it, because of the password
   */
  public static PostgresAddress parse(String flag, String address, DirectoryTls tls, int deadlineMs)
      throws IOException {
    String rest = address.startsWith(SCHEME) ? address.substring(SCHEME.length()) : "";
    int slash = rest.indexOf('/');
    int at = rest.lastIndexOf('@', Math.max(slash, 0));
    String hosts = slash < 0 ? "" : rest.substring(at + 1, slash);
    String database = rest.substring(slash + 1).replaceFirst("\\?.*", "");
    if (hosts.isEmpty()
        || database.isEmpty()
        || database.contains("@")
        || !HOSTS.matcher(hosts).matches()) {
      throw new IOException(
          flag
              + " needs a host and a database; for example"
              + " postgresql://carom:PASSWORD@db.example.org:5432/carom");
    }
    Properties properties = new Properties();
    if (at > 0) {
      int colon = rest.substring(0, at).indexOf(':');
      properties.setProperty("user", decoded(flag, rest.substring(0, colon < 0 ? at : colon)));
      if (colon >= 0) {
        properties.setProperty("password", decoded(flag, rest.substring(colon + 1, at)));
      }
    }
    String seconds = "" + (deadlineMs + 999) / 1_000;
    properties.setProperty("ApplicationName", "carom");
    properties.setProperty("connectTimeout", seconds);
    properties.setProperty("socketTimeout", seconds);
    properties.setProperty("tcpKeepAlive", "true");
    properties.setProperty("gssEncMode", "disable");
    properties.setProperty(
        "options",
        "-c statement_timeout="
            + deadlineMs
            + " -c default_transaction_isolation=read\\ committed");
    if (tls.ca() != null) {
      properties.setProperty("sslmode", "verify-full");
      properties.setProperty("sslrootcert", tls.ca().toString());
    }
    if (tls.cert() != null) {
      properties.setProperty("sslcert", tls.cert().toString());
      properties.setProperty("sslkey", tls.key().toString());
    }
    return new PostgresAddress(
        SCHEME + hosts + "/" + database,
        "jdbc:" + SCHEME + rest.substring(at + 1),
        properties,
        deadlineMs);
  }

  private static String decoded(String flag, String text) throws IOException {
    try {
      return URLDecoder.decode(text.replace("+", "%2B"), UTF_8);
    } catch (IllegalArgumentException e) {
      throw new IOException(
          flag
              + " has a % in user or password that isn't written %25; for example "
              + "postgresql://carom:PASSWORD@db.example.org:5432/carom",
          e);
    }
  }
}
