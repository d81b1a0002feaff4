package carom.server.directory;

import static java.nio.charset.StandardCharsets.UTF_8;

import carom.server.http.HttpClients;
import carom.text.Texts;
import java.io.IOException;
import java.net.ConnectException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpConnectTimeoutException;
import java.net.http.HttpHeaders;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.HttpTimeoutException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLException;

/**
 * Calls etcd by its JSON gateway: HTTP/1.1, without proxies. A call that fails at one URL goes to
 * the next until its time is over. Any thread.
 */
final class EtcdGateway {
  private static final int CONNECT_MS = 300;
  private static final int PAUSE_MS = 20;

  /** Codes of gRPC after which another member may know better; all others are an answer. */
  private static final List<Integer> FAILURES = List.of(1, 2, 4, 8, 10, 13, 14, 15);

  private final List<URI> urls;
  private final int deadlineMs;
  private final HttpClient client;
  private volatile int current;
  private final AtomicBoolean away = new AtomicBoolean();

  /**
   * An answer.
   *
   * @param json the answer; null if what was asked for isn't there
   * @param isRepeated whether an attempt before failed in a way that leaves open if it happened
   */
  record Reply(EtcdJson json, boolean isRepeated) {}

  /** Returns whether watches have logged that etcd is away; theirs to change. */
  AtomicBoolean away() {
    return away;
  }

  /** Says that etcd understood and refused; another member would, too. */
  private static final class Refusal extends IOException {
    private static final long serialVersionUID = 1;

    Refusal(String message) {
      super(message);
    }
  }

  /**
   * Creates a gateway to the members of a cluster.
   *
   * @param urls one at least, {@code http} or {@code https}, without a path
   * @param tls what https uses; null: the JDK's own
   * @param deadlineMs longest time of a call
   */
  EtcdGateway(List<URI> urls, SSLContext tls, int deadlineMs) {
    this.urls = List.copyOf(urls);
    this.deadlineMs = deadlineMs;
    HttpClient.Builder builder =
        HttpClients.direct("carom-directory-http", Thread.MAX_PRIORITY, CONNECT_MS);
    if (tls != null) {
      builder.sslContext(tls);
    }
    client = preferred(builder);
  }

  /** Builds a client whose own thread doesn't wait for rooms that tick: rooms wait for it. */
  private static HttpClient preferred(HttpClient.Builder builder) {
    Thread self = Thread.currentThread();
    int priority = self.getPriority();
    self.setPriority(Thread.MAX_PRIORITY); // the client's thread begins with that of its maker
    try {
      return builder.build();
    } finally {
      self.setPriority(priority);
    }
  }

  /** Returns the time at which a call that begins now must have its answer. */
  long deadlineNs() {
    return System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(deadlineMs);
  }

  /**
   * Asks until a member answers.
   *
   * @param path such as {@code /v3/kv/range}
   * @param body JSON
   * @param deadlineNs until when, by {@link System#nanoTime}
   * @throws DirectoryException without an answer, or if etcd refuses
   */
  Reply call(String path, String body, long deadlineNs) throws DirectoryException {
    boolean isRepeated = false;
    for (int attempt = 0; ; attempt++) {
      int index = current;
      URI url = urls.get(index);
      try {
        long leftNs = deadlineNs - System.nanoTime();
        int left = urls.size() - attempt % urls.size();
        return new Reply(once(url, path, body, System.nanoTime() + leftNs / left), isRepeated);
      } catch (Refusal e) {
        throw new DirectoryException(e.getMessage(), e);
      } catch (IOException e) {
        isRepeated |= mayHaveHappened(e);
        current = (index + 1) % urls.size();
        boolean isRoundOver = (attempt + 1) % urls.size() == 0;
        pause(isRoundOver ? PAUSE_MS : 0);
        if (deadlineNs - System.nanoTime() < TimeUnit.MILLISECONDS.toNanos(PAUSE_MS)) {
          throw new DirectoryException(problem(url, e) + others(), e);
        }
      } catch (InterruptedException e) {
        throw interrupted(e);
      }
    }
  }

  private static void pause(int ms) throws DirectoryException {
    try {
      Thread.sleep(ms);
    } catch (InterruptedException e) {
      throw interrupted(e);
    }
  }

  private static DirectoryException interrupted(InterruptedException e) {
    Thread.currentThread().interrupt();
    return new DirectoryException("directory=etcd: the call was interrupted", e);
  }

  private EtcdJson once(URI url, String path, String body, long deadlineNs)
      throws IOException, InterruptedException {
    HttpResponse<EtcdStream> response = send(url, path, body, deadlineNs);
    if (isNotFound(response.statusCode(), response.headers())) {
      return null;
    }
    try (EtcdStream stream = response.body()) {
      byte[] first = stream.line(deadlineNs);
      if (stream.line(deadlineNs) != null) {
        throw new IOException("the answer has several lines");
      }
      if (response.statusCode() != 200 && !isJson(response)) {
        throw new Refusal(notEtcd(url, path, response.statusCode()));
      }
      EtcdJson json = EtcdJson.parse(first == null ? new byte[0] : first);
      if (json.has("error")) {
        throw error(url, json);
      }
      return json.has("result") ? json.get("result") : json;
    }
  }

  private static boolean isJson(HttpResponse<?> response) {
    return response.headers().firstValue("Content-Type").orElse("").startsWith("application/json");
  }

  private static String notEtcd(URI url, String path, int status) {
    return "directory=etcd: "
        + url
        + " answers "
        + path
        + " with status "
        + status
        + "; check that it is the client URL of etcd 3.4 or newer";
  }

  /**
   * Returns whether a lease isn't there. The body only repeats it, and ends with a trailer, which
   * the JDK's client can't read: so it isn't read. A path that isn't there has no trailer.
   */
  private static boolean isNotFound(int status, HttpHeaders headers) {
    return status == 404 && headers.firstValue("Trailer").isPresent();
  }

  private static IOException error(URI url, EtcdJson json) throws IOException {
    boolean inStream = json.get("error").has("message");
    EtcdJson error = inStream ? json.get("error") : json;
    int code = (int) error.get(inStream ? "grpc_code" : "code").number();
    String said = "directory=etcd: " + url + " says: " + Texts.clean(error.get("message").text());
    return FAILURES.contains(code) ? new IOException(said) : new Refusal(said);
  }

  /**
   * Asks one member and returns as soon as its answer begins.
   *
   * @param index number of the attempt: each asks the next member
   */
  EtcdStream stream(int index, String path, String body, long deadlineNs)
      throws IOException, InterruptedException {
    URI url = urls.get(index % urls.size());
    HttpResponse<EtcdStream> response = send(url, path, body, deadlineNs);
    if (response.statusCode() != 200) {
      response.body().close();
      throw new IOException(notEtcd(url, path, response.statusCode()));
    }
    return response.body();
  }

  /** Returns which member answered last; attempts begin there. */
  int current() {
    return current;
  }

  private HttpResponse<EtcdStream> send(URI url, String path, String body, long deadlineNs)
      throws IOException, InterruptedException {
    long leftNs = deadlineNs - System.nanoTime();
    if (leftNs <= 0) {
      throw new HttpTimeoutException("no answer in time");
    }
    HttpRequest request =
        HttpRequest.newBuilder(url.resolve(path))
            .timeout(Duration.ofNanos(leftNs))
            .header("Content-Type", "application/json")
            // A watch at a member that has lost the others ends, instead of being silent.
            .header("Grpc-Metadata-hasleader", "true")
            .POST(HttpRequest.BodyPublishers.ofByteArray(body.getBytes(UTF_8)))
            .build();
    return client.send(
        request, info -> new EtcdStream(isNotFound(info.statusCode(), info.headers())));
  }

  private static boolean mayHaveHappened(IOException e) {
    return !(e instanceof ConnectException || e instanceof HttpConnectTimeoutException);
  }

  /** Returns what to tell the operator. */
  String problem(URI url, Exception e) {
    if (e.getMessage() != null && e.getMessage().startsWith("directory=")) {
      return e.getMessage();
    }
    String said;
    if (e instanceof HttpTimeoutException) {
      said = "doesn't answer in time; check the address and the load of its disk";
    } else if (e instanceof ConnectException) {
      said = "can't be reached; check that etcd runs there (--listen-client-urls)";
    } else if (e instanceof SSLException) {
      said = "refuses TLS, or its certificate isn't good: " + Texts.clean(e.getMessage() + "");
    } else {
      said = "broke the connection: " + Texts.clean(e.getMessage() + "");
    }
    return "directory=etcd: " + url + " " + said;
  }

  private String others() {
    return urls.size() == 1 ? "" : " (nor do the other " + (urls.size() - 1) + " answer)";
  }

  /** Returns a message about a member that was asked by {@link #stream}. */
  String problem(int index, Exception e) {
    return problem(urls.get(index % urls.size()), e);
  }
}
