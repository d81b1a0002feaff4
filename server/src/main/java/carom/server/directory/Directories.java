package carom.server.directory;

import java.io.IOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.util.ArrayList;
import java.util.List;

/** Opens the directory that an operator names. */
public final class Directories {
  private static final String EXAMPLE =
      "; for example etcd:http://a:2379,http://b:2379 or postgresql://carom@db.example.org/carom";

  private Directories() {}

  /**
   * Opens a directory. It needn't answer now: each call says if it doesn't.
   *
   * @param address {@code etcd:URL[,URL...]} or {@code
   *     postgresql://[USER[:PASSWORD]@]HOST[:PORT]/DATABASE}
   * @param tls files for encrypted connections
   * @throws IOException if the address is none, or a file can't be used; says what to do
   */
  public static Directory open(String address, DirectoryTls tls) throws IOException {
    if (address.startsWith("etcd:")) {
      List<URI> urls = new ArrayList<>();
      for (String url : address.substring("etcd:".length()).split(",", -1)) {
        urls.add(etcdUrl(url));
      }
      return new EtcdDirectory(urls, tls.context());
    }
    if (address.startsWith("postgresql:")) {
      tls.context(); // says which file can't be used; the driver reads them again
      return new PostgresDirectory(
          PostgresAddress.parse("--fleet", address, tls, Directory.DEADLINE_MS));
    }
    throw bad("begins with no directory that Carom knows");
  }

  private static URI etcdUrl(String url) throws IOException {
    URI uri;
    try {
      uri = new URI(url.strip());
    } catch (URISyntaxException e) {
      throw bad("has something that is no URL"); // it may contain a password: not repeated
    }
    boolean isHttp = "http".equals(uri.getScheme()) || "https".equals(uri.getScheme());
    String path = uri.getRawPath();
    if (!isHttp || uri.getHost() == null) {
      throw bad("needs http://HOST:PORT or https://HOST:PORT for each member, comma between");
    } else if (uri.getRawUserInfo() != null) {
      throw bad("has a user name; etcd's gateway takes client certificates (--directory-cert)");
    } else if (!(path.isEmpty() || path.equals("/")) || uri.getRawQuery() != null) {
      throw bad("has a path behind a port; give the client URL alone");
    }
    return uri;
  }

  /** Returns an error without the address, which may have a password. */
  private static IOException bad(String problem) {
    return new IOException("--fleet " + problem + EXAMPLE);
  }
}
