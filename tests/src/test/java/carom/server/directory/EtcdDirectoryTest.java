package carom.server.directory;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.suite.Needs;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: the directory in etcd keeps what the contract asks for. Method: etcd itself, in a folder
 * and on ports of its own; skipped where it isn't installed.
 */
@Needs("processes")
final class EtcdDirectoryTest extends RemoteDirectoryContract {
  @TempDir private static Path folder;
  private static EtcdProgram etcd;

  @BeforeAll
  static void start() throws Exception {
    etcd = new EtcdProgram(folder, "http");
    try (Directory directory = new EtcdDirectory(List.of(etcd.url()), null)) {
      etcd.await(directory);
    }
  }

  @AfterAll
  static void stop() throws Exception {
    if (etcd != null) {
      etcd.close();
    }
  }

  @Override
  int port() {
    return etcd.port();
  }

  @Override
  Directory open(List<Integer> ports, int deadlineMs) {
    return new EtcdDirectory(
        ports.stream().map(port -> URI.create("http://127.0.0.1:" + port)).toList(),
        null,
        deadlineMs);
  }

  private static String post(String path, String body) throws Exception {
    HttpRequest request =
        HttpRequest.newBuilder(etcd.url().resolve(path))
            .POST(HttpRequest.BodyPublishers.ofString(body))
            .build();
    return HttpClient.newHttpClient().send(request, HttpResponse.BodyHandlers.ofString()).body();
  }

  @Test
  void keysHaveAFolderOfTheirOwn() throws Exception {
    Directory a = door();
    post("/v3/kv/put", "{\"key\":" + EtcdJson.encode("other") + ",\"value\":\"eA==\"}");
    post(
        "/v3/kv/put",
        "{\"key\":" + EtcdJson.encode("/carom/" + key("by-hand")) + ",\"value\":\"eA==\"}");
    assertEquals("x", a.get(key("by-hand")).value());
    assertTrue(a.list("").stream().noneMatch(entry -> entry.key().contains("other")));
  }

  @Test
  void aWatchGoesOnWhenWhatItAsksForIsCompacted() throws Exception {
    Directory other = door();
    try (CutRelay relay = new CutRelay(port());
        Directory way = open(List.of(relay.port()))) {
      Heard heard = new Heard();
      way.watch(root(), heard);
      await("complete", () -> heard.completes() > 0);
      long number = other.create(key("a"), "1", 0);
      await("a", () -> heard.values().size() == 1);
      int before = heard.completes();
      // Another program changes much, then all that is old goes. The watch asks for it when it has
      // been silent for a while.
      for (int i = 0; i < 20; i++) {
        post("/v3/kv/put", "{\"key\":" + EtcdJson.encode("other") + ",\"value\":\"eA==\"}");
      }
      long last = other.create("elsewhere/" + root(), "x", 0);
      assertEquals(
          "",
          EtcdJson.parse(post("/v3/kv/compaction", "{\"revision\":" + last + "}").getBytes(UTF_8))
              .get("error")
              .text());
      await("read anew", () -> heard.completes() > before);
      other.update(key("a"), "2", number);
      await("and told of", () -> heard.values().containsValue("2"));
      heard.check();
    }
  }

  @Test
  void whatIsNoEtcdIsNamed() throws Exception {
    try (Directory way = new EtcdDirectory(List.of(URI.create("http://127.0.0.1:1")), null)) {
      DirectoryException e = assertThrows(DirectoryException.class, () -> way.get("a"));
      assertEquals(
          "directory=etcd: http://127.0.0.1:1 can't be reached; check that etcd runs there"
              + " (--listen-client-urls)",
          e.getMessage());
    }
  }

  @Test
  void anEntryOutlivesARestart(@TempDir Path own) throws Exception {
    try (EtcdProgram program = new EtcdProgram(own, "http");
        Directory way = new EtcdDirectory(List.of(program.url()), null)) {
      program.await(way);
      long lease = way.lease(60_000);
      long number = way.create("a", "1", lease);
      Heard heard = new Heard();
      way.watch("", heard);
      await("complete", () -> heard.completes() > 0);
      int before = heard.completes();
      program.stop();
      assertThrows(DirectoryException.class, () -> way.get("a"));
      program.start();
      program.await(way);
      assertEquals(new DirectoryEntry("a", "1", number, lease), way.get("a"));
      assertTrue(way.renew(lease));
      await("complete again", () -> heard.completes() > before);
      assertTrue(way.create("b", "1", lease) > number);
      await("watched", () -> heard.values().size() == 2);
    }
  }
}
