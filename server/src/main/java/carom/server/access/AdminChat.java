package carom.server.access;

import carom.server.command.Caller;
import carom.server.command.CommandRegistry;
import carom.server.command.Role;
import carom.server.room.Room;
import carom.server.session.ChatCommands;
import carom.server.session.PlayerInfo;
import carom.sim.message.BuiltInKinds;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Commands that admins write into the chat, such as {@code /kick bob}. One thread carries them out
 * in turn, while there are any, and the player alone reads the answer. Admins are {@linkplain
 * Role#MODERATOR moderators}; only operators decide who is one.
 */
public final class AdminChat implements ChatCommands {
  /** Most lines of an answer. */
  static final int MAX_LINES = 32;

  private static final Logger LOG = LoggerFactory.getLogger(AdminChat.class);
  private static final int MAX_WAITING = 16;

  /** Time by which its thread outlives the last command, s; so it needs no end of its own. */
  private static final long IDLE_S = 1;

  private final CommandRegistry registry;
  private final AccessLists lists;
  private final List<Room> rooms;
  private final ThreadPoolExecutor runner =
      new ThreadPoolExecutor(
          1,
          1,
          IDLE_S,
          TimeUnit.SECONDS,
          new ArrayBlockingQueue<>(MAX_WAITING),
          work -> {
            Thread thread = new Thread(work, "carom-admin-chat");
            thread.setDaemon(true);
            return thread;
          });

  /**
   * Creates it without commands to run.
   *
   * @param rooms all rooms
   */
  public AdminChat(CommandRegistry registry, AccessLists lists, List<Room> rooms) {
    this.registry = registry;
    this.lists = lists;
    this.rooms = rooms;
    runner.allowCoreThreadTimeOut(true);
  }

  @Override
  public boolean take(PlayerInfo player, String line) {
    if (!lists.isAdmin(player.account(), player.remote())) {
      return false;
    }
    try {
      runner.execute(() -> run(player, line.substring(BEGIN.length()).strip()));
    } catch (RejectedExecutionException full) {
      LOG.warn("{} gives commands faster than they are done; dropped: {}", player.name(), line);
    }
    return true;
  }

  private void run(PlayerInfo player, String line) {
    String account = player.account().isEmpty() ? "" : player.account() + " ";
    String who = "%s (%s%s)".formatted(player.name(), account, player.remote());
    String answer = registry.run(line, new Caller(Role.MODERATOR, "chat", who)).text();
    for (Room room : rooms) {
      LOG.debug("{}: {}", room.name(), room.operator().tell(player, lines(answer)));
    }
  }

  /** Returns an answer in lines that chat can take; what is too long is cut. */
  static List<String> lines(String answer) {
    List<String> lines = new ArrayList<>();
    for (String line : answer.split("\n", -1)) {
      for (int from = 0; from < line.length(); from += BuiltInKinds.MAX_CHAT) {
        lines.add(line.substring(from, Math.min(line.length(), from + BuiltInKinds.MAX_CHAT)));
      }
    }
    if (lines.size() <= MAX_LINES) {
      return lines;
    }
    List<String> cut = new ArrayList<>(lines.subList(0, MAX_LINES - 1));
    cut.add("... " + (lines.size() - cut.size()) + " more lines; operators see all");
    return cut;
  }
}
