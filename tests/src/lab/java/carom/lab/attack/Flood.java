package carom.lab.attack;

/** A flood of datagrams that begins and ends. */
interface Flood {
  /** Returns what the table calls it. */
  String name();

  /** Begins. */
  void begin();

  /** Ends, and waits for its threads. */
  void end() throws InterruptedException;

  /** Returns how many datagrams it has sent in all. */
  long sent();

  /** Returns what it saw, in a sentence, or an empty text. */
  default String findings() {
    return "";
  }
}
