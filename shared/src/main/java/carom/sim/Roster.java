package carom.sim;

/** Notes that entities came, went or were teleported, for {@link Simulation#rosterVersion}. */
final class Roster {
  private long version;

  void change() {
    version++;
  }

  long version() {
    return version;
  }
}
