package carom.server.command;

import carom.net.protocol.PlayerName;
import carom.server.account.AccountService;
import carom.server.account.AccountStore;
import carom.server.room.Room;
import carom.server.session.PlayerInfo;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/** The command {@code account}: shows what is kept of a player, and forgets it. */
public final class AccountCommands {
  private static final String FORGET = "forget";
  private static final int MOST = 5;
  private static final long ANSWER_S = 5;

  private final AccountService accounts;
  private final List<Room> rooms;

  private AccountCommands(AccountService accounts, List<Room> rooms) {
    this.accounts = accounts;
    this.rooms = rooms;
  }

  /**
   * Adds the command to a registry.
   *
   * @param accounts null if the server keeps none
   */
  public static void add(CommandRegistry registry, AccountService accounts, List<Room> rooms) {
    AccountCommands all = new AccountCommands(accounts, rooms);
    registry.add(
        new Command(
                "account",
                "[forget] PLAYER | ID",
                "Shows what is kept of a player, by name or account, also of one who isn't here; or"
                    + " forgets it, and removes a player who is here.",
                all::account,
                place -> place == 0 ? all.words() : List.of())
            .forModerators());
  }

  private List<String> words() {
    List<String> words = new ArrayList<>(new RoomFinder(rooms).playerNames());
    words.add(FORGET);
    return words;
  }

  private String account(CommandWords words) throws CommandException {
    boolean forgets = words.word(0, "PLAYER").equals(FORGET) && words.has(1);
    words.requireAtMost(forgets ? 2 : 1);
    if (accounts == null) {
      throw new CommandException("this server keeps nothing of accounts: store=off");
    }
    String who = words.word(forgets ? 1 : 0, "PLAYER");
    List<AccountStore.Known> found = find(who);
    if (found.isEmpty()) {
      throw new CommandException("nothing is kept of " + Quoting.shown(who));
    }
    if (!forgets) {
      return String.join("\n", found.stream().map(AccountCommands::shown).toList());
    }
    if (found.size() > 1) {
      throw new CommandException(
          "several accounts go by PLAYER=%s, so none is forgotten; name one: %s"
              .formatted(
                  Quoting.shown(who),
                  String.join(", ", found.stream().map(AccountStore.Known::account).toList())));
    }
    String account = found.get(0).account();
    boolean kept = await(accounts.forget(account));
    int removed = remove(account);
    return String.format(
        Locale.ROOT,
        "%s account=%s; %d %s removed",
        kept ? "forgot" : "nothing is kept of",
        account,
        removed,
        removed == 1 ? "player" : "players");
  }

  /** Returns the accounts of a name or with an ID, those of players who are here among them. */
  private List<AccountStore.Known> find(String who) throws CommandException {
    Set<String> ids = new LinkedHashSet<>();
    List<AccountStore.Known> found = new ArrayList<>();
    for (Room room : rooms) {
      for (PlayerInfo player : room.operator().players()) {
        boolean named = PlayerName.folded(player.name()).equals(PlayerName.folded(who));
        if (!player.account().isEmpty() && (named || player.account().equals(who))) {
          ids.add(player.account());
        }
      }
    }
    for (String id : ids) {
      found.addAll(await(accounts.find(id, 1)));
    }
    for (AccountStore.Known known : await(accounts.find(who, MOST))) {
      if (!ids.contains(known.account())) {
        found.add(known);
      }
    }
    return found;
  }

  private int remove(String account) {
    int removed = 0;
    for (Room room : rooms) {
      for (PlayerInfo player : room.operator().players()) {
        if (player.account().equals(account)) {
          room.operator().kick(player.id(), "An operator has had your account forgotten.");
          removed++;
        }
      }
    }
    return removed;
  }

  private static String shown(AccountStore.Known known) {
    StringBuilder text = new StringBuilder("account=").append(known.account());
    text.append(" name=").append(Quoting.shown(known.name()));
    if (known.values().isEmpty()) {
      text.append("; it has gained nothing");
    }
    for (AccountStore.KnownValue value : known.values()) {
      text.append(
          String.format(
              Locale.ROOT,
              "\n  %s: %s = %d (%s; room=%s match=%d tick=%d)",
              value.game(),
              value.field(),
              value.kept().word(),
              value.kept().form(),
              value.place().room(),
              value.place().match(),
              value.place().tick()));
    }
    return text.toString();
  }

  private static <T> T await(CompletableFuture<T> answer) throws CommandException {
    try {
      return answer.get(ANSWER_S, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new CommandException("interrupted");
    } catch (ExecutionException e) {
      throw new CommandException(e.getCause().getMessage() + "; try again in a moment");
    } catch (TimeoutException e) {
      throw new CommandException(
          "the store of accounts doesn't answer within seconds=" + ANSWER_S + "; try again later");
    }
  }
}
