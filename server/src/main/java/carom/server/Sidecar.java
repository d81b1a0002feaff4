package carom.server;

import static java.nio.charset.StandardCharsets.UTF_8;

import carom.server.http.HttpClients;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Asks Agones' sidecar, which serves HTTP in the same pod. Each request has a deadline, whatever
 * the sidecar does. Any thread.
 */
final class Sidecar {
  /** Most bytes of an answer that are kept. */
  static final int MOST_BYTES = 1 << 20;

  /** Longest time until a stream has its first line, ms: it may not change for long. */
  private static final int STREAM_MS = 60_000;

  private final URI base;
  private final int deadlineMs;
  private final HttpClient client;

  /**
   * An answer.
   *
   * @param status of HTTP
   * @param text of the body
   */
  record Answer(int status, String text) {
    private static final int OK = 200;

    boolean isOk() {
      return status == OK;
    }

    /** Returns whether the sidecar says something; it has one status for most errors. */
    boolean says(String words) {
      return text.contains(words);
    }
  }

  /**
   * Creates a client that has asked nothing.
   *
   * @param port of this machine
   * @param deadlineMs longest time of a request
   */
  Sidecar(int port, int deadlineMs) {
    base = URI.create("http://localhost:" + port);
    this.deadlineMs = deadlineMs;
    client = HttpClients.direct("carom-agones-http", Thread.NORM_PRIORITY, deadlineMs).build();
  }

  private HttpRequest request(String method, String path, String body) {
    return HttpRequest.newBuilder(base.resolve(path))
        .header("Content-Type", "application/json")
        .method(
            method,
            body == null
                ? HttpRequest.BodyPublishers.noBody()
                : HttpRequest.BodyPublishers.ofString(body))
        .build();
  }

  /**
   * Asks for something.
   *
   * @param body JSON, or null for none
   * @throws IOException without an answer in time
   */
  Answer ask(String method, String path, String body) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    HttpResponse.BodyHandler<Void> keep =
        HttpResponse.BodyHandlers.ofByteArrayConsumer(
            some ->
                some.ifPresent(
                    part -> {
                      if (bytes.size() + part.length <= MOST_BYTES) {
                        bytes.write(part, 0, part.length);
                      }
                    }));
    HttpResponse<Void> response =
        await(client.sendAsync(request(method, path, body), keep), path, deadlineMs);
    return new Answer(response.statusCode(), bytes.toString(UTF_8));
  }

  /**
   * Tells something.
   *
   * @throws IOException without an answer in time, or if it isn't taken
   */
  void tell(String method, String path, String body) throws IOException {
    Answer answer = ask(method, path, body);
    if (!answer.isOk()) {
      throw refusal(path, answer);
    }
  }

  /** Returns an error that says what the sidecar answered. */
  static IOException refusal(String path, Answer answer) {
    String text = answer.text().strip();
    return new IOException(
        path + " is answered with " + answer.status() + (text.isEmpty() ? "" : " " + text));
  }

  /** Asks for lines that come when there are any. The caller closes them. */
  InputStream stream(String path) throws IOException {
    HttpResponse<InputStream> response =
        await(
            client.sendAsync(request("GET", path, null), HttpResponse.BodyHandlers.ofInputStream()),
            path,
            STREAM_MS);
    if (response.statusCode() != Answer.OK) {
      response.body().close();
      throw refusal(path, new Answer(response.statusCode(), ""));
    }
    return response.body();
  }

  private static <T> T await(CompletableFuture<T> answer, String path, int mostMs)
      throws IOException {
    try {
      return answer.get(mostMs, TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      answer.cancel(true);
      throw new IOException(path + " isn't answered within " + mostMs + " ms", e);
    } catch (ExecutionException e) {
      throw new IOException(path + " isn't answered: " + e.getCause(), e);
    } catch (InterruptedException e) {
      answer.cancel(true);
      Thread.currentThread().interrupt();
      throw new IOException(path + " is interrupted", e);
    }
  }
}
