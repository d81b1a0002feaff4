package carom.server.access;

import carom.net.protocol.PlayerName;
import carom.net.seal.PlayerKey;
import carom.server.command.Command;
import carom.server.command.CommandException;
import carom.server.command.CommandRegistry;
import carom.server.command.CommandWords;
import carom.server.command.Quoting;
import carom.server.command.RoomFinder;
import carom.server.room.Room;
import carom.server.session.PlayerInfo;
import carom.server.threads.LastingThread;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The commands that change who may play, and a thread that reads the lists again when somebody has
 * edited them. Players who may no longer play are removed.
 */
public final class AccessCommands {
  private static final Logger LOG = LoggerFactory.getLogger(AccessCommands.class);
  private static final long LOOK_MS = 1_000;
  private static final String FOREVER = "forever";
  private static final String ACCOUNT = "account";
  private static final Pattern TIME = Pattern.compile("(\\d{1,5})([mhdw])");

  /** A word that an operator who mistyped a time may have meant as one. */
  private static final Pattern LIKE_TIME = Pattern.compile("\\d+\\w*");

  private final AccessLists lists;
  private final List<Room> rooms;

  private AccessCommands(AccessLists lists, List<Room> rooms) {
    this.lists = lists;
    this.rooms = rooms;
  }

  /**
   * Adds the commands to a registry, and starts the thread that looks for changes of the files.
   *
   * @return the thread, which ends with the process or when it is interrupted
   */
  public static Thread add(CommandRegistry registry, AccessLists lists, List<Room> rooms) {
    AccessCommands all = new AccessCommands(lists, rooms);
    registry.add(
        new Command(
                "ban",
                "[PLAYER | ADDRESS[/BITS] | name NAME | account ID] [TIME] [REASON]",
                "Bans: a player by account, or else by name and, if nobody else here has it,"
                    + " address; or one of them. TIME is 30m, 12h, 7d or 2w. Alone: shows the"
                    + " bans.",
                all::ban,
                place -> place == 0 ? all.playerNames() : List.of())
            .forModerators());
    registry.add(
        new Command(
                "unban",
                "[name] NAME | ADDRESS[/BITS] | account ID",
                "Ends bans of a name, account or address; of a name also that of its address.",
                words -> all.remove(lists.bans(), words, "ban"),
                place -> place == 0 ? values(lists.bans()) : List.of())
            .forModerators());
    registry.add(
        new Command(
                "allow",
                "[NAME | ADDRESS[/BITS] | account ID]",
                "Lets a name, account or address play where allow-list = true. Alone: shows the"
                    + " list.",
                all::allow,
                place -> place == 0 ? all.playerNames() : List.of())
            .forModerators());
    registry.add(
        new Command(
                "disallow",
                "NAME | ADDRESS[/BITS] | account ID",
                "Takes a name, account or address from that list.",
                words -> all.remove(lists.allowed(), words, "entry"),
                place -> place == 0 ? values(lists.allowed()) : List.of())
            .forModerators());
    registry.add(
        new Command(
            "admin",
            "[ADDRESS[/BITS] | account ID]",
            "Lets an account or address moderate in the chat (/kick bob, /help). Alone: shows the"
                + " list.",
            all::admin,
            Command.NONE));
    registry.add(
        new Command(
            "unadmin",
            "ADDRESS[/BITS] | account ID",
            "Takes an account or address from that list.",
            words -> all.remove(lists.admins(), words, "entry"),
            place -> place == 0 ? values(lists.admins()) : List.of()));
    return LastingThread.start("carom-access", () -> true, all::watch);
  }

  private static List<String> values(AccessFile file) {
    return file.entries().stream().map(AccessEntry::value).toList();
  }

  private List<String> playerNames() {
    List<String> names = new ArrayList<>();
    rooms.forEach(room -> room.operator().players().forEach(player -> names.add(player.name())));
    return names;
  }

  private void watch() throws InterruptedException {
    Thread.sleep(LOOK_MS);
    if (lists.reloadIfChanged()) {
      removePlayers();
    }
  }

  /** Removes the players who may not play, and returns how many. */
  private int removePlayers() {
    int removed = 0;
    for (Room room : rooms) {
      for (PlayerInfo player : room.operator().players()) {
        EntryRule.Refusal refusal = lists.refusal(player.name(), player.account(), player.remote());
        if (refusal != null) {
          String text = refusal.reason().playerText() + " " + refusal.text();
          LOG.info("{}", room.operator().kick(player.id(), text.strip()));
          removed++;
        }
      }
    }
    return removed;
  }

  private String ban(CommandWords words) throws CommandException {
    if (!words.has(0)) {
      return show(lists.bans(), "nobody is banned");
    }
    boolean byName = words.word(0, "PLAYER").equals("name") && words.has(1);
    boolean byAccount = words.word(0, "PLAYER").equals(ACCOUNT) && words.has(1);
    int next = byName || byAccount ? 2 : 1;
    String who = words.word(next - 1, "NAME");
    Optional<AddressRange> range = next == 1 ? AddressRange.parse(who) : Optional.empty();
    PlayerInfo player = next == 1 && range.isEmpty() ? playerToBan(words) : null;
    Instant until = null;
    if (words.has(next)) {
      Matcher time = TIME.matcher(words.word(next, "TIME"));
      if (time.matches()) {
        until = lists.clock().instant().truncatedTo(ChronoUnit.SECONDS).plus(duration(time));
        next++;
      } else if (words.word(next, "TIME").equals(FOREVER)) {
        next++;
      } else if (LIKE_TIME.matcher(words.word(next, "TIME")).matches()) {
        throw new CommandException(
            "TIME=%s is none, so nobody is banned; give 30m, 12h, 7d, 2w or forever, and put a"
                    .formatted(words.word(next, "TIME"))
                + " reason that begins with a number in quotes");
      }
    }
    String reason = words.rest(next);
    Instant end = until;
    List<AccessEntry> entries = new ArrayList<>();
    String spared = "";
    if (byAccount || player != null && !player.account().isEmpty()) {
      String account = byAccount ? who : player.account();
      entries.add(new AccessEntry(null, null, account, end, reason));
      if (player != null && account.startsWith(PlayerKey.ACCOUNT)) { // a new key costs nothing
        spared = addHousehold(entries, player, account, end, reason);
      }
    } else if (range.isPresent()) {
      entries.add(new AccessEntry(range.get(), null, null, end, reason));
    } else {
      String name = byName ? who : player.name();
      entries.add(new AccessEntry(null, name, null, end, reason));
      spared = byName ? "" : addHousehold(entries, player, name, end, reason);
    }
    change(lists.bans(), entries);
    int removed = removePlayers();
    return String.format(
        Locale.ROOT,
        "banned %s%s; %d %s removed%s",
        String.join(" and ", entries.stream().map(AccessEntry::what).toList()),
        end == null ? " forever" : " until " + end,
        removed,
        removed == 1 ? "player" : "players",
        spared);
  }

  /**
   * Bans the address of a player, too, unless other players have it.
   *
   * @param of name or account with which the ban of the address ends
   * @return what to add to the answer
   */
  private String addHousehold(
      List<AccessEntry> entries, PlayerInfo player, String of, Instant end, String reason) {
    AddressRange household = AddressRange.household(player.remote()).orElse(null);
    long others = household == null ? 0 : others(household, player.name());
    if (others > 0) {
      return String.format(
          Locale.ROOT,
          "; not address %s, which %d other %s: ban %s",
          household,
          others,
          others == 1 ? "player has" : "players have",
          household);
    }
    if (household != null) {
      entries.add(new AccessEntry(household, of, null, end, reason));
    }
    return "";
  }

  /** Returns the player of the first word, who must be here. */
  private PlayerInfo playerToBan(CommandWords words) throws CommandException {
    try {
      return new RoomFinder(rooms).player(words, 0).player();
    } catch (CommandException e) {
      String who = words.word(0, "PLAYER");
      if (AddressRange.isMeant(who)) {
        throw new CommandException(
            AddressRange.problem(who)
                + ", and no player of that name plays here; nobody is banned");
      }
      String advice =
          RoomFinder.isId(who) ? "" : "; to ban a name in advance: ban name " + Quoting.shown(who);
      throw new CommandException(e.getMessage() + advice);
    }
  }

  /** Returns how many players with other names and without accounts have one of the addresses. */
  private long others(AddressRange range, String name) {
    return rooms.stream()
        .flatMap(room -> room.operator().players().stream())
        .filter(player -> !isSame(player.name(), name))
        .filter(player -> AddressRange.household(player.remote()).filter(range::equals).isPresent())
        .count();
  }

  private static Duration duration(Matcher time) {
    long count = Long.parseLong(time.group(1));
    return switch (time.group(2)) {
      case "m" -> Duration.ofMinutes(count);
      case "h" -> Duration.ofHours(count);
      case "d" -> Duration.ofDays(count);
      default -> Duration.ofDays(7 * count);
    };
  }

  private static boolean isSame(String name, String other) {
    return PlayerName.folded(name).equals(PlayerName.folded(other));
  }

  private String allow(CommandWords words) throws CommandException {
    if (!words.has(0)) {
      String state = lists.onlyAllowed() ? "" : "allow-list = false: everybody may play\n";
      return state + show(lists.allowed(), "the list is empty");
    }
    AccessEntry entry = entry(words);
    change(lists.allowed(), List.of(entry));
    return "allowed " + entry.what();
  }

  private String admin(CommandWords words) throws CommandException {
    if (!words.has(0)) {
      return show(lists.admins(), "nobody gives commands in the chat");
    }
    AccessEntry entry = entry(words);
    if (entry.name() != null) {
      throw new CommandException(
          "anybody can take the name "
              + entry.name()
              + "; name an account (admin account ID) or an address");
    }
    change(lists.admins(), List.of(entry));
    return entry.what() + " may give commands in the chat";
  }

  private static AccessEntry entry(CommandWords words) throws CommandException {
    String value = words.word(0, "NAME");
    if (value.equals(ACCOUNT) && words.has(1)) {
      words.requireAtMost(2);
      return new AccessEntry(null, null, words.word(1, "ID"), null, "");
    }
    if (value.equals("name") && words.has(1)) {
      words.requireAtMost(2);
      return new AccessEntry(null, words.word(1, "NAME"), null, null, "");
    }
    words.requireAtMost(1);
    Optional<AddressRange> range = AddressRange.parse(value);
    if (range.isEmpty() && AddressRange.isMeant(value)) {
      throw new CommandException(
          AddressRange.problem(value)
              + "; if it is a player's name, write: name "
              + Quoting.shown(value));
    }
    return new AccessEntry(range.orElse(null), range.isPresent() ? null : value, null, null, "");
  }

  private static void change(AccessFile file, List<AccessEntry> entries) throws CommandException {
    try {
      for (AccessEntry entry : entries) {
        file.add(entry);
      }
    } catch (IOException e) {
      throw new CommandException(e.getMessage());
    }
  }

  private String remove(AccessFile file, CommandWords words, String what) throws CommandException {
    AccessEntry wanted = entry(words);
    List<String> found = new ArrayList<>();
    Predicate<AccessEntry> isMeant =
        entry -> wanted.isAboutSame(entry) || wanted.range() == null && entry.isOf(wanted.value());
    file.entries().stream().filter(isMeant).forEach(entry -> found.add(entry.what()));
    try {
      if (file.remove(isMeant) == 0) {
        throw new CommandException("no " + what + " of " + wanted.what());
      }
      removePlayers();
      return "removed the " + what + " of " + String.join(" and of ", found);
    } catch (IOException e) {
      throw new CommandException(e.getMessage());
    }
  }

  private static String show(AccessFile file, String empty) {
    List<AccessEntry> entries = file.entries();
    return entries.isEmpty()
        ? empty
        : String.join("\n", entries.stream().map(AccessEntry::line).toList());
  }
}
