package carom.client.bots;

/** A crowd of bots, by whichever door they come. One thread. */
interface Crowd extends AutoCloseable {
  /** Does what is due; call it once per frame. */
  void update(long nowNs);

  /** Returns how many have joined or given up. */
  int settled();

  /** Returns whether none plays or will play. */
  boolean over();

  /** Returns how many play now. */
  int playing();

  /** Returns what went wrong last, for people; empty if nothing did. */
  String problem();

  /** Returns a line about how it goes. */
  String progress();

  /** Returns the figures. */
  BotReport report(long nowNs);

  /** Makes all bots leave. */
  @Override
  void close();
}
