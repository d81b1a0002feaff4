package carom.launcher;

import carom.game.Games;
import carom.options.BadFlag;
import carom.text.FileErrors;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Runs {@code carom new}, which lays out a project for a game of one's own. */
@Command(
    name = "new",
    sortOptions = false,
    usageHelpAutoWidth = true,
    mixinStandardHelpOptions = true,
    description = {"Lays out a project for a game of your own, for Gradle and for Maven.", ""},
    footer = {"", "Exit codes: 0 done, 1 a file can't be written, 2 bad name, folder or flag."})
final class NewCommand implements Callable<Integer> {
  private static final int FAILED = 1;
  private static final int SHORTEST = 2;
  private static final int LONGEST = 24;

  /** Words that Java, Windows or Carom have for themselves. */
  private static final Set<String> TAKEN =
      Set.of(
          ("abstract assert boolean break byte case catch char class const continue default do"
                  + " double else enum extends false final finally float for goto if implements"
                  + " import instanceof int interface long native new null package private"
                  + " protected public return short static strictfp super switch synchronized"
                  + " this throw throws transient true try void volatile while"
                  + " aux com1 com2 com3 com4 com5 com6 com7 com8 com9 con lpt1 lpt2 lpt3 lpt4"
                  + " lpt5 lpt6 lpt7 lpt8 lpt9 nul prn"
                  + " java javax jdk carom commons lagoon quarry rink sluice towers")
              .split(" "));

  @Spec private CommandSpec spec;

  @Parameters(
      paramLabel = "NAME",
      description = "Name of the game: also that of its folder, Java package and artifact.")
  private String name;

  @Option(
      names = "--in",
      paramLabel = "FOLDER",
      defaultValue = ".",
      description = "Where the folder NAME comes to be (the present folder).")
  private Path folder;

  /** Creates a command that picocli has yet to fill in. */
  NewCommand() {}

  @Override
  public Integer call() {
    String problem = problem(name);
    if (problem != null) {
      throw new BadFlag(spec.commandLine(), problem);
    }
    Path project = folder.resolve(name).normalize();
    try {
      if (!isFree(project)) {
        throw new BadFlag(
            spec.commandLine(),
            "folder=" + project + " is there and isn't empty; choose another name or --in FOLDER");
      }
      new ProjectTemplate(name).layOut(project, repository());
    } catch (IOException e) {
      spec.commandLine()
          .getErr()
          .println("carom new: can't write " + project + ": " + FileErrors.reason(e));
      return FAILED;
    }
    spec.commandLine()
        .getOut()
        .printf(
            Locale.ROOT,
            "%s is a game with a level and a test. In that folder:%n"
                + "  ./gradlew run     opens a window, a server and two bots%n"
                + "  ./gradlew test    plays it on a bad network%n"
                + "  ./gradlew jar     makes what goes into the folder games of an installation%n"
                + "With Maven: mvn compile exec:java, mvn test, mvn package.%n",
            project);
    return 0;
  }

  /** Returns why a game can't have this name, with one that it can have; null if it can. */
  static String problem(String name) {
    String letters = name.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]|^[^a-z]+", "");
    boolean isWord = name.matches("[a-z][a-z0-9]*");
    if (!isWord || name.length() < SHORTEST || name.length() > LONGEST) {
      String other = letters.substring(0, Math.min(letters.length(), LONGEST));
      return "name="
          + name
          + " can't be a game's: its name is a Java package, too, so it has "
          + SHORTEST
          + " to "
          + LONGEST
          + " letters a-z and digits, a letter first"
          + (other.equals(name) || problem(other.isEmpty() ? "carom" : other) != null
              ? ""
              : "; for example " + other);
    }
    if (TAKEN.contains(name)) {
      return "name=" + name + " is a word of Java, of Windows or of Carom; for example my" + name;
    }
    return Games.names().contains(name)
        ? "name=" + name + " is a game that is there already; for example my" + name
        : null;
  }

  private static boolean isFree(Path project) throws IOException {
    if (!Files.isDirectory(project)) {
      return !Files.exists(project);
    }
    try (Stream<Path> files = Files.list(project)) {
      return files.findAny().isEmpty();
    }
  }

  /**
   * Returns the folder in which this installation has Carom's artifacts; null when this isn't one.
   */
  private static Path repository() {
    try {
      Path jar =
          Path.of(NewCommand.class.getProtectionDomain().getCodeSource().getLocation().toURI());
      Path folder = jar.toAbsolutePath().resolveSibling("../repository").normalize();
      return Files.isDirectory(folder) ? folder : null;
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e); // can't happen, the JVM made the location
    }
  }
}
