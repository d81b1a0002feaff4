package carom.server.room;

/** Plays bots for rooms: clients like those of players, which send inputs and nothing else. */
public interface BotCrew extends AutoCloseable {
  /**
   * Lets a bot come, soon. From any thread; returns at once. If none comes, the room asks again.
   *
   * @param token lets the bot's link in, once
   * @param strength {@code weak}, {@code medium} or {@code strong}; empty for one by chance
   */
  void play(String token, String strength);

  /** Ends all bots. */
  @Override
  default void close() {}
}
