package carom.server.directory;

import java.io.IOException;
import java.net.http.HttpTimeoutException;
import java.util.concurrent.TimeUnit;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A watch of etcd: reads all entries, then asks for the changes since. When that breaks, or what it
 * asks for is compacted, it reads all anew. A connection on which nothing came for {@value
 * #SILENT_MS} ms is replaced, as it may be dead: a watch has no sign of life.
 */
final class EtcdWatch implements Runnable {
  private static final Logger LOG = LoggerFactory.getLogger(EtcdWatch.class);
  private static final int SILENT_MS = 2_000;
  private static final int BEGIN_MS = 500;
  private static final int PAUSE_MS = 100;

  /** Revisions from which on reading all is cheaper than what changed since. */
  private static final long FAR_BEHIND = 10_000;

  private final EtcdDirectory directory;
  private final EtcdGateway gateway;
  private final Watch watch;
  private final Thread thread = new Thread(this, "carom-directory-watch");
  private volatile boolean isClosed;
  private int member;

  /** Revision up to which all is told; 0: it must read all. */
  private long revision;

  EtcdWatch(EtcdDirectory directory, EtcdGateway gateway, Watch watch) {
    this.directory = directory;
    this.gateway = gateway;
    this.watch = watch;
    thread.setDaemon(true);
    thread.setPriority(Thread.MAX_PRIORITY); // players of a room without an owner wait for it
  }

  void start() {
    thread.start();
  }

  void close() {
    isClosed = true;
    thread.interrupt();
  }

  @Override
  public void run() {
    while (!isClosed) {
      try {
        if (revision == 0) {
          readAll();
        }
        follow();
      } catch (InterruptedException e) {
        return; // closed
      } catch (IOException | RuntimeException e) {
        if (!isClosed) {
          failed(e);
        }
      }
    }
  }

  private void readAll() throws IOException {
    EtcdDirectory.Range range = directory.range(watch.prefix);
    member = gateway.current();
    if (isClosed) {
      return;
    }
    watch.all(range.entries());
    watch.complete();
    revision = range.revision();
    if (gateway.away().compareAndSet(true, false)) {
      LOG.info("directory: etcd answers again");
    }
  }

  private void failed(Exception e) {
    if (gateway.away().compareAndSet(false, true)) {
      LOG.warn("{}; trying on", gateway.problem(member, e));
    }
    revision = 0;
    member++;
    try {
      Thread.sleep(PAUSE_MS);
    } catch (InterruptedException interrupted) {
      isClosed = true;
    }
  }

  /** Tells of changes, until nothing comes for a while. */
  private void follow() throws IOException, InterruptedException {
    String body =
        "{\"create_request\":{"
            + EtcdDirectory.keys(watch.prefix)
            + ",\"start_revision\":\""
            + (revision + 1)
            + "\"}}";
    long beginNs = after(BEGIN_MS);
    try (EtcdStream stream = gateway.stream(member, "/v3/watch", body, beginNs)) {
      take(stream.line(beginNs));
      while (!isClosed && revision != 0) {
        byte[] line;
        try {
          line = stream.line(after(SILENT_MS));
        } catch (HttpTimeoutException e) {
          return;
        }
        take(line);
      }
    }
  }

  private void take(byte[] line) throws IOException {
    if (line == null) {
      throw new IOException("the watch ended");
    }
    EtcdJson answer = EtcdJson.parse(line);
    EtcdJson told = answer.get("result");
    if (answer.has("error") || told.get("canceled").isTrue()) {
      if (told.get("compact_revision").number() == 0) {
        throw new IOException(
            answer.get("error").get("message").text() + told.get("cancel_reason").text());
      }
      revision = 0;
      return;
    }
    if (told.get("header").get("revision").number() - revision > FAR_BEHIND) {
      revision = 0;
      return;
    }
    for (EtcdJson event : told.get("events").items()) {
      if (isClosed) {
        return;
      }
      EtcdJson kv = event.get("kv");
      if (event.get("type").text().equals("DELETE")) {
        watch.gone(EtcdDirectory.key(kv));
      } else {
        watch.present(EtcdDirectory.entry(kv));
      }
      revision = Math.max(revision, kv.get("mod_revision").number());
    }
  }

  private static long after(int ms) {
    return System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(ms);
  }
}
