package carom.server.access;

import carom.net.protocol.PlayerName;
import carom.server.command.Command;
import carom.server.command.CommandException;
import carom.server.command.CommandRegistry;
import carom.server.command.CommandWords;
import carom.server.command.RoomFinder;
import carom.server.room.Room;
import carom.server.session.PlayerInfo;
import carom.server.threads.LastingThread;
import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
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
            "Bans: a player by account, or else by name and address, or one of them; TIME is 30m,"
                + " 12h, 7d or 2w. Alone: shows the bans.",
            all::ban,
            place -> place == 0 ? all.playerNames() : List.of()));
    registry.add(
        new Command(
            "unban",
            "NAME | ADDRESS[/BITS] | account ID",
            "Ends bans of a name, account or address.",
            words -> all.remove(lists.bans(), words, "ban"),
            place -> place == 0 ? values(lists.bans()) : List.of()));
    registry.add(
        new Command(
            "allow",
            "[NAME | ADDRESS[/BITS] | account ID]",
            "Lets a name, account or address play where allow-list = true. Alone: shows the list.",
            all::allow,
            place -> place == 0 ? all.playerNames() : List.of()));
    registry.add(
        new Command(
            "disallow",
            "NAME | ADDRESS[/BITS] | account ID",
            "Takes a name, account or address from that list.",
            words -> all.remove(lists.allowed(), words, "entry"),
            place -> place == 0 ? values(lists.allowed()) : List.of()));
    registry.add(
        new Command(
            "admin",
            "[ADDRESS[/BITS] | account ID]",
            "Lets an account or address give commands in the chat (/kick bob). Alone: shows the"
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
    if (next == 1 && RoomFinder.isId(who)) {
      who = new RoomFinder(rooms).player(words, 0).player().name();
    }
    Instant until = null;
    if (words.has(next)) {
      Matcher time = TIME.matcher(words.word(next, "TIME"));
      if (time.matches()) {
        until = lists.clock().instant().truncatedTo(ChronoUnit.SECONDS).plus(duration(time));
        next++;
      } else if (words.word(next, "TIME").equals(FOREVER)) {
        next++;
      }
    }
    String reason = words.rest(next);
    Instant end = until;
    List<AccessEntry> entries = new ArrayList<>();
    Optional<AddressRange> range = AddressRange.parse(who);
    Set<String> accounts = byAccount ? Set.of(who) : byName ? Set.of() : accounts(who);
    if (!accounts.isEmpty()) {
      accounts.forEach(id -> entries.add(new AccessEntry(null, null, id, end, reason)));
    } else if (byName || range.isEmpty()) {
      entries.add(new AccessEntry(null, nameOf(who, byName), null, end, reason));
      for (AddressRange household : byName ? Set.<AddressRange>of() : households(who)) {
        entries.add(new AccessEntry(household, null, null, end, reason));
      }
    } else {
      entries.add(new AccessEntry(range.get(), null, null, end, reason));
    }
    change(lists.bans(), entries);
    StringBuilder text = new StringBuilder("banned ");
    text.append(String.join(" and ", entries.stream().map(AccessEntry::what).toList()))
        .append(end == null ? " forever" : " until " + end);
    int removed = removePlayers();
    return text.append("; ").append(removed).append(removed == 1 ? " player" : " players")
        + " removed";
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

  /** Returns a name; without the word {@code name}, only that of a player who is here. */
  private String nameOf(String who, boolean byName) throws CommandException {
    if (!byName && playerNames().stream().noneMatch(name -> isSame(name, who))) {
      throw new CommandException(
          "no player=" + who + " plays here; to ban a name in advance: ban name " + who);
    }
    return who;
  }

  private static boolean isSame(String name, String other) {
    return PlayerName.folded(name).equals(PlayerName.folded(other));
  }

  /** Returns the accounts of the players of a name who are here. */
  private Set<String> accounts(String name) {
    Set<String> accounts = new LinkedHashSet<>();
    for (Room room : rooms) {
      for (PlayerInfo player : room.operator().players()) {
        if (isSame(player.name(), name) && !player.account().isEmpty()) {
          accounts.add(player.account());
        }
      }
    }
    return accounts;
  }

  private Set<AddressRange> households(String name) {
    Set<AddressRange> ranges = new LinkedHashSet<>();
    for (Room room : rooms) {
      for (PlayerInfo player : room.operator().players()) {
        if (isSame(player.name(), name)) {
          AddressRange.household(player.remote()).ifPresent(ranges::add);
        }
      }
    }
    return ranges;
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
    words.requireAtMost(1);
    Optional<AddressRange> range = AddressRange.parse(value);
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
    try {
      int removed = file.remove(wanted::isAboutSame);
      if (removed == 0) {
        throw new CommandException("no " + what + " of " + wanted.what());
      }
      removePlayers();
      return "removed the " + what + " of " + wanted.what();
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
