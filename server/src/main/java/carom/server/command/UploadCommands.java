package carom.server.command;

import carom.server.upload.UploadedLevel;
import carom.server.upload.Uploads;
import carom.text.Suggestion;
import java.io.IOException;
import java.time.Instant;
import java.util.List;

/** The command {@code levels}: shows the levels that players have sent, and removes them. */
public final class UploadCommands {
  private static final String REMOVE = "remove";
  private static final int HASH_SHOWN = 12;

  private final Uploads uploads;

  private UploadCommands(Uploads uploads) {
    this.uploads = uploads;
  }

  /**
   * Adds the command to a registry.
   *
   * @param uploads null if the server takes no levels
   */
  public static void add(CommandRegistry registry, Uploads uploads) {
    UploadCommands all = new UploadCommands(uploads);
    registry.add(
        new Command(
                "levels",
                "[remove NAME | remove account ID]",
                "Shows the levels that players have sent; or removes one, or all of an account. A"
                    + " match that is played in it goes on.",
                all::levels,
                all::complete)
            .forModerators());
  }

  private List<String> complete(int place) {
    return place == 0
        ? List.of(REMOVE)
        : place == 1 && uploads != null
            ? uploads.levels().stream().map(UploadedLevel::name).toList()
            : List.of();
  }

  private String levels(CommandWords words) throws CommandException {
    if (uploads == null) {
      throw new CommandException("this server takes no levels of players: uploads=false");
    }
    if (!words.has(0)) {
      return table();
    }
    if (!words.word(0, REMOVE).equals(REMOVE)) {
      throw CommandException.ofWords("\"" + words.word(0, REMOVE) + "\" isn't remove");
    }
    String name = words.word(1, "NAME");
    boolean ofAccount = name.equals("account") && words.has(2);
    words.requireAtMost(ofAccount ? 3 : 2);
    try {
      return ofAccount ? removeAll(words.word(2, "ID")) : remove(name);
    } catch (IOException e) {
      throw new CommandException("nothing is removed: " + e.getMessage());
    }
  }

  private String remove(String name) throws IOException, CommandException {
    UploadedLevel level = uploads.find(name);
    if (level == null || !uploads.remove(level.name())) {
      List<String> names = uploads.levels().stream().map(UploadedLevel::name).toList();
      throw new CommandException(
          "no player has sent a level " + name + Suggestion.didYouMean(name, names));
    }
    return "removed level=%s of account=%s".formatted(level.title(), level.account());
  }

  private String removeAll(String account) throws IOException {
    int removed = 0;
    for (UploadedLevel level : uploads.levels()) {
      if (level.account().equals(account) && uploads.remove(level.name())) {
        removed++;
      }
    }
    return "removed levels=" + removed + " of account=" + account;
  }

  private String table() {
    if (uploads.levels().isEmpty()) {
      return "no player has sent a level";
    }
    TextTable table = new TextTable("level", "game", "bytes", "by", "account", "since", "hash");
    for (UploadedLevel level : uploads.levels()) {
      table.add(
          level.title(),
          level.game(),
          Integer.toString(level.size()),
          level.author(),
          level.account(),
          Instant.ofEpochSecond(level.since()).toString(),
          level.hash().substring(0, HASH_SHOWN));
    }
    return table.toString();
  }
}
