package carom.server.http;

import java.net.http.HttpClient;
import java.time.Duration;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/** Clients of HTTP/1.1 that go to their server directly, and keep no process running. */
public final class HttpClients {
  private HttpClients() {}

  /**
   * Returns a builder of a client without proxies and redirects.
   *
   * @param threads name of its threads, which are daemons and end after 10 idle seconds
   * @param priority of its threads that the caller gives it; its own has that of the thread that
   *     builds it
   * @param connectMs longest time until a connection is open
   */
  public static HttpClient.Builder direct(String threads, int priority, int connectMs) {
    return HttpClient.newBuilder()
        .version(HttpClient.Version.HTTP_1_1)
        .proxy(HttpClient.Builder.NO_PROXY)
        .followRedirects(HttpClient.Redirect.NEVER)
        .connectTimeout(Duration.ofMillis(connectMs))
        .executor(
            new ThreadPoolExecutor(
                0,
                Integer.MAX_VALUE,
                10,
                TimeUnit.SECONDS,
                new SynchronousQueue<>(),
                task -> {
                  Thread thread = new Thread(task, threads);
                  thread.setDaemon(true);
                  thread.setPriority(priority);
                  return thread;
                }));
  }
}
