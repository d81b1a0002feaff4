package carom.server.command;

import carom.game.Games;
import carom.server.config.DataFolder;
import carom.server.match.MatchLibrary;
import carom.server.upload.UploadedLevel;
import carom.server.upload.Uploads;
import carom.text.Suggestion;
import java.util.ArrayList;
import java.util.List;

/**
 * Finds the levels that the words of a command name. Only the console names files elsewhere.
 *
 * @param uploads levels of players, or null if the server takes none
 */
record LevelWords(DataFolder data, Uploads uploads) {
  /** Returns the levels that everybody may name. */
  List<String> names() {
    List<String> names = new ArrayList<>(data.levelNames());
    names.addAll(MatchLibrary.builtInLevels());
    if (uploads != null) {
      uploads.levels().forEach(level -> names.add(level.title()));
    }
    return names;
  }

  /**
   * Returns a level that the caller may name.
   *
   * @throws CommandException if it may not, because there is no such level but perhaps a file
   */
  String allowed(CommandWords words, String name) throws CommandException {
    boolean ofPlayer = name.startsWith(UploadedLevel.PREFIX);
    boolean known =
        ofPlayer
            ? uploads != null && uploads.find(name) != null
            : data.levelNames().contains(name) || MatchLibrary.isBuiltInLevel(name);
    if (!known && ofPlayer) {
      throw new CommandException(
          "no player has sent LEVEL=%s, nor one whose hash begins so%s"
              .formatted(name, Suggestion.didYouMean(name, names())));
    }
    if (!known && !words.mayNameAnyFile()) {
      throw new CommandException(
          "LEVEL=%s is none of %s and none that comes along%s; only the server's console names files"
              .formatted(name, data.levels(), Suggestion.didYouMean(name, names())));
    }
    return name;
  }

  /** Returns levels that the caller may name, where a game's name stands for its default level. */
  List<String> allowed(CommandWords words, List<String> wanted) throws CommandException {
    List<String> found = new ArrayList<>();
    for (String name : wanted) {
      boolean isLevel = data.levelNames().contains(name) || MatchLibrary.isBuiltInLevel(name);
      boolean isGame = !isLevel && Games.names().contains(name);
      found.add(allowed(words, isGame ? Games.create(name).defaultLevel() : name));
    }
    return found;
  }
}
