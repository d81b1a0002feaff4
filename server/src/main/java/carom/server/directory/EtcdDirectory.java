package carom.server.directory;

import static java.nio.charset.StandardCharsets.UTF_8;

import carom.server.directory.EtcdGateway.Reply;
import java.io.IOException;
import java.net.URI;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.net.ssl.SSLContext;

/**
 * A directory in <a href="https://etcd.io">etcd</a>, version 3.4 or newer, by its JSON gateway.
 *
 * <p>An entry's number is the revision in which etcd created its key, a lease's that of etcd. Keys
 * begin with {@value #ROOT} in etcd, so that other programs can use the same cluster.
 *
 * <p>An attempt may fail after etcd has done what it was asked for. Therefore, each value has a
 * random first line, its mark, which stays and by which a repeated {@link #create} knows its own
 * entry. An update names the revision that it replaces, so that a late attempt can't undo a newer
 * one. A repeated {@link #delete} that finds nothing can't know who deleted it, and throws.
 */
final class EtcdDirectory implements Directory {
  private static final String ROOT = "/carom/";
  private static final int PAGE = 500;

  private final EtcdGateway gateway;
  private final SecureRandom random = new SecureRandom();
  private final List<EtcdWatch> watches = new CopyOnWriteArrayList<>();

  /** All entries of a prefix, by key, as they were at a revision. */
  record Range(List<DirectoryEntry> entries, long revision) {}

  /**
   * Creates a directory. Nothing is sent before the first call.
   *
   * @param urls client URLs of the cluster's members, {@code http} or {@code https}, one at least
   * @param tls what https uses; null for the JDK's own certificates
   */
  public EtcdDirectory(List<URI> urls, SSLContext tls) {
    this(urls, tls, DEADLINE_MS);
  }

  /** Creates a directory with another deadline, for tests on a busy machine. */
  EtcdDirectory(List<URI> urls, SSLContext tls, int deadlineMs) {
    gateway = new EtcdGateway(urls, tls, deadlineMs);
  }

  @Override
  public long lease(int ttlMs) throws DirectoryException {
    EntryLimits.checkTtl(ttlMs);
    EtcdJson json = call("/v3/lease/grant", "{\"TTL\":" + (ttlMs + 999) / 1_000 + "}").json();
    return read(() -> json.get("ID").number());
  }

  @Override
  public boolean renew(long lease) throws DirectoryException {
    EtcdJson json = call("/v3/lease/keepalive", ofLease(lease)).json();
    return json != null && read(() -> json.get("TTL").number()) > 0;
  }

  @Override
  public void revoke(long lease) throws DirectoryException {
    call("/v3/lease/revoke", ofLease(lease));
  }

  @Override
  public long create(String key, String value, long lease) throws DirectoryException {
    return create(key, value, lease, "").number();
  }

  // The note has no value: the revision that wrote it last is the entry's number.
  @Override
  public Succession succeed(String key, String value, long lease, String note)
      throws DirectoryException {
    EntryLimits.checkKey(note);
    String noted = ",{\"request_put\":{" + key(note) + ",\"prev_kv\":true}}";
    Creation made = create(key, value, lease, noted);
    if (made.number == 0) {
      return new Succession(0, 0);
    }
    String then = "{" + key(note) + ",\"revision\":\"" + (made.number - 1) + "\"}";
    EtcdJson before =
        made.answer == null
            ? first(call("/v3/kv/range", then).json())
            : made.answer.get("responses").items().get(1).get("response_put").get("prev_kv");
    boolean isFirst = before == null || before.get("key").text().isEmpty();
    return new Succession(
        made.number, isFirst ? 0 : read(() -> before.get("mod_revision").number()));
  }

  /**
   * An entry that was created.
   *
   * @param number 0 if it was not
   * @param answer null if an attempt before has created it, whose answer is lost
   */
  private record Creation(long number, EtcdJson answer) {}

  private Creation create(String key, String value, long lease, String more)
      throws DirectoryException {
    EntryLimits.checkKey(key);
    EntryLimits.checkValue(value);
    String mark = Long.toString(random.nextLong(), Character.MAX_RADIX);
    String put =
        "{\"request_put\":{"
            + key(key)
            + ",\"value\":"
            + EtcdJson.encode(mark + "\n" + value)
            + ",\"lease\":\""
            + lease
            + "\"}}"
            + more;
    Reply reply = change(key, "\"target\":\"CREATE\",\"create_revision\":\"0\"", put);
    EtcdJson json = reply.json();
    if (json == null) {
      return new Creation(0, null); // the lease has ended
    }
    return read(
        () -> {
          if (json.get("succeeded").isTrue()) {
            return new Creation(json.get("header").get("revision").number(), json);
          }
          EtcdJson kv = found(json);
          boolean isOwn =
              kv != null && reply.isRepeated() && kv.get("value").decoded().startsWith(mark + '\n');
          return new Creation(isOwn ? kv.get("create_revision").number() : 0, null);
        });
  }

  @Override
  public boolean update(String key, String value, long number) throws DirectoryException {
    EntryLimits.checkKey(key);
    EntryLimits.checkValue(value);
    long deadlineNs = gateway.deadlineNs();
    EtcdJson range = gateway.call("/v3/kv/range", "{" + key(key) + "}", deadlineNs).json();
    EtcdJson before = first(range);
    if (!isNumber(before, number)) {
      return false;
    }
    String marked = read(() -> before.get("value").decoded());
    String mark = marked.substring(0, Math.max(marked.indexOf('\n'), 0));
    String put =
        "{\"request_put\":{"
            + key(key)
            + ",\"value\":"
            + EtcdJson.encode(mark + "\n" + value)
            + ",\"ignore_lease\":true}}";
    String unchanged =
        "\"target\":\"MOD\",\"mod_revision\":\""
            + read(() -> before.get("mod_revision").number())
            + '"';
    Reply reply = gateway.call("/v3/kv/txn", transaction(key, unchanged, put), deadlineNs);
    // What isn't as it was has been updated meanwhile: by an attempt before, or by another caller
    // after this one. If it is gone, an attempt before may have come first.
    return reply.json() != null
        && (reply.json().get("succeeded").isTrue()
            || isNumber(found(reply.json()), number)
            || reply.isRepeated());
  }

  @Override
  public boolean delete(String key, long number) throws DirectoryException {
    EntryLimits.checkKey(key);
    if (number <= 0) {
      return false; // etcd's number of a key that isn't there is 0
    }
    Reply reply =
        change(
            key,
            "\"target\":\"CREATE\",\"create_revision\":\"" + number + '"',
            "{\"request_delete_range\":{" + key(key) + "}}");
    boolean isDone = reply.json() != null && reply.json().get("succeeded").isTrue();
    if (!isDone && reply.isRepeated()) {
      throw new DirectoryException(
          "directory=etcd: a member failed while it deleted " + key + "; it is gone", null);
    }
    return isDone;
  }

  @Override
  public DirectoryEntry get(String key) throws DirectoryException {
    EntryLimits.checkKey(key);
    EtcdJson kv = first(call("/v3/kv/range", "{" + key(key) + "}").json());
    return kv == null ? null : read(() -> entry(kv));
  }

  @Override
  public List<DirectoryEntry> list(String prefix) throws DirectoryException {
    EntryLimits.checkPrefix(prefix);
    return range(prefix).entries();
  }

  /** Reads all entries of a prefix, page by page at one revision. */
  Range range(String prefix) throws DirectoryException {
    long deadlineNs = gateway.deadlineNs();
    List<DirectoryEntry> entries = new ArrayList<>();
    String from = ROOT + prefix;
    long revision = 0;
    boolean isMore = true;
    while (isMore) {
      String body =
          "{\"key\":"
              + EtcdJson.encode(from)
              + ",\"range_end\":"
              + end(prefix)
              + ",\"limit\":"
              + PAGE
              + ",\"revision\":\""
              + revision
              + "\"}";
      EtcdJson page = gateway.call("/v3/kv/range", body, deadlineNs).json();
      for (EtcdJson kv : page.get("kvs").items()) {
        entries.add(read(() -> entry(kv)));
      }
      if (revision == 0) {
        revision = read(() -> page.get("header").get("revision").number());
      }
      isMore = page.get("more").isTrue() && !entries.isEmpty();
      from = isMore ? ROOT + entries.get(entries.size() - 1).key() + '\0' : from;
    }
    entries.sort(Comparator.comparing(DirectoryEntry::key));
    return new Range(entries, revision);
  }

  @Override
  public void watch(String prefix, DirectoryWatcher watcher) {
    EntryLimits.checkPrefix(prefix);
    EtcdWatch watch = new EtcdWatch(this, gateway, new Watch(prefix, watcher));
    watches.add(watch);
    watch.start();
  }

  @Override
  public void close() {
    watches.forEach(EtcdWatch::close);
    watches.clear();
  }

  private Reply call(String path, String body) throws DirectoryException {
    return gateway.call(path, body, gateway.deadlineNs());
  }

  /** Does something to a key if a comparison holds, and else returns what is there. */
  private Reply change(String key, String comparison, String operation) throws DirectoryException {
    return call("/v3/kv/txn", transaction(key, comparison, operation));
  }

  private static String transaction(String key, String comparison, String operation) {
    return "{\"compare\":[{"
        + key(key)
        + ','
        + comparison
        + "}],\"success\":["
        + operation
        + "],\"failure\":[{\"request_range\":{"
        + key(key)
        + "}}]}";
  }

  private static String ofLease(long lease) {
    return "{\"ID\":\"" + lease + "\"}";
  }

  private static String key(String key) {
    return "\"key\":" + EtcdJson.encode(ROOT + key);
  }

  /** Returns the fields of a request for all keys that begin with a prefix. */
  static String keys(String prefix) {
    return key(prefix) + ",\"range_end\":" + end(prefix);
  }

  /** Returns the first key after all that begin with a prefix. */
  private static String end(String prefix) {
    byte[] bytes = (ROOT + prefix).getBytes(UTF_8);
    bytes[bytes.length - 1]++; // below 0xff in UTF-8
    return EtcdJson.encode(bytes);
  }

  /** Returns the key that a transaction found in its way. */
  private static EtcdJson found(EtcdJson answer) {
    List<EtcdJson> responses = answer.get("responses").items();
    return responses.isEmpty() ? null : first(responses.get(0).get("response_range"));
  }

  private static EtcdJson first(EtcdJson range) {
    List<EtcdJson> kvs = range.get("kvs").items();
    return kvs.isEmpty() ? null : kvs.get(0);
  }

  private static boolean isNumber(EtcdJson kv, long number) throws DirectoryException {
    return kv != null && read(() -> kv.get("create_revision").number()) == number;
  }

  /** Returns the key of an entry, as callers know it. */
  static String key(EtcdJson kv) throws IOException {
    String key = kv.get("key").decoded();
    if (!key.startsWith(ROOT)) {
      throw new IOException("the answer has a key that wasn't asked for");
    }
    return key.substring(ROOT.length());
  }

  static DirectoryEntry entry(EtcdJson kv) throws IOException {
    String marked = kv.get("value").decoded();
    return new DirectoryEntry(
        key(kv),
        marked.substring(marked.indexOf('\n') + 1),
        kv.get("create_revision").number(),
        kv.get("lease").number());
  }

  private interface Reading<T> {
    T read() throws IOException;
  }

  private static <T> T read(Reading<T> reading) throws DirectoryException {
    try {
      return reading.read();
    } catch (IOException e) {
      throw new DirectoryException("directory=etcd: " + e.getMessage(), e);
    }
  }
}
