package carom.lab.fleet;

/** Sums of what servers ask a directory, and of what it tells them. One thread. */
final class DirectoryTraffic {
  long renewals;
  long claims;
  long updates;
  long others;
  long bytes;
  long events;
  long eventBytes;

  DirectoryTraffic() {}

  void add(DirectoryTraffic more) {
    renewals += more.renewals;
    claims += more.claims;
    updates += more.updates;
    others += more.others;
    bytes += more.bytes;
    events += more.events;
    eventBytes += more.eventBytes;
  }

  /** Returns what has come since there was only so much. */
  public DirectoryTraffic since(DirectoryTraffic before) {
    DirectoryTraffic since = new DirectoryTraffic();
    since.add(this);
    since.renewals -= before.renewals;
    since.claims -= before.claims;
    since.updates -= before.updates;
    since.others -= before.others;
    since.bytes -= before.bytes;
    since.events -= before.events;
    since.eventBytes -= before.eventBytes;
    return since;
  }

  /** Returns all calls. */
  public long calls() {
    return renewals + claims + updates + others;
  }

  /** Returns the renewals of leases. */
  public long renewals() {
    return renewals;
  }

  /** Returns the claims of rooms. */
  public long claims() {
    return claims;
  }

  /** Returns the updates of entries. */
  public long updates() {
    return updates;
  }

  /** Returns the calls for tickets, leases, and entries that are removed. */
  public long others() {
    return others;
  }

  /** Returns the bytes of keys and values in calls. */
  public long bytes() {
    return bytes;
  }

  /** Returns how often a server was told of an entry. */
  public long events() {
    return events;
  }

  /** Returns the bytes of keys and values of which servers were told. */
  public long eventBytes() {
    return eventBytes;
  }
}
