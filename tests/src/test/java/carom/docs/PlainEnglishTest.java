package carom.docs;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Goal: docs and doc comments stay plain. Method: the rules of CONTRIBUTING that a program can
 * check, over all sources and pages.
 */
final class PlainEnglishTest {
  private static final Path ROOT = Path.of("..");

  /**
   * Words that the glossary replaces, and forms that made sentences hard to read. The letters with
   * which they begin come first: most places of a text end there.
   */
  private static final Pattern OLD_WORDS =
      Pattern.compile(
          "(?i)(?=[wftiusrlp])(?:whoever|\\bwhom\\b|foresee|\\btellStruck|\\bfurnish|\\bis to"
              + " be\\b(?! able)|\\bthat"
              + " that\\b|\\bwish|wished|\\bstrikes?\\b|\\burg(e|es|ed|ing)\\b|\\brub(s|bed|bing)?\\b"
              + "|unsure|Solver\\.push\\(|lanes\\.push\\(|scalar\\.push\\(|push(Blocks|Trees))");

  /** A doc comment and, looked ahead at, what it is about. */
  private static final Pattern DOC_COMMENT =
      Pattern.compile(
          "/\\*\\*(.*?)\\*/\\s*((?:@\\w+(?:\\([^)]*\\))?\\s*)*)(?=([^{;=]*))", Pattern.DOTALL);

  /** A constant of an enum. */
  private static final Pattern CONSTANT =
      Pattern.compile("[A-Z][A-Z_0-9]*\\s*([,(}].*)?", Pattern.DOTALL);

  /** Words that begin a sentence which leans on the declaration above, or has no subject. */
  private static final Pattern TORSO =
      Pattern.compile(
          "(What|Which|Whether|Where|Whose?|How|And|Or|But|Nor|Also|Likewise|Then|Else|Otherwise|So"
              + "|It|They|Its|Their|(For|By) how|Of what)\\b.*");

  /** The same for constants of an enum, which stand in a row: they don't begin with a place. */
  private static final Pattern TORSO_OF_A_CONSTANT =
      Pattern.compile(
          "(As|At|By|For|From|In|Of|On|To|With|Without|Before|After|Until|When|If|Already)\\b.*");

  /** A declaration with parameters, but no constant of an enum. */
  private static final Pattern METHOD =
      Pattern.compile("(?s)(?![A-Z_0-9]+\\s*[,(])(?!//)(?:[\\w.<>\\[\\]?&,@ ]+\\s)?\\w+\\s*\\(.*");

  private static final Pattern TYPE = Pattern.compile("\\b(class|interface|enum|record)\\b");

  /** A verb in the third person, such as "Returns". */
  private static final Pattern VERB = Pattern.compile("[A-Z][a-z]+s\\b.*|\\{@inheritDoc.*");

  private static final String[] PRODUCT = {
    "shared/src/main",
    "shared/src/vector",
    "server/src/main",
    "client/src/main",
    "launcher/src/main",
    "testkit/src/main",
    "plain/src/main"
  };

  private static final String[] PRODUCT_AND_LABORATORY =
      Stream.concat(
              Stream.of(PRODUCT),
              Stream.of("tests/src/main", "tests/src/lab", "tests/src/peers", "tests/src/jmh"))
          .toArray(String[]::new);

  private static List<Path> files(String ending, String... folders) throws IOException {
    List<Path> found = new ArrayList<>();
    for (String folder : folders) {
      try (Stream<Path> files = Files.walk(ROOT.resolve(folder))) {
        files
            .filter(file -> file.toString().endsWith(ending))
            .filter(
                file -> !file.toString().contains("build/") && !file.toString().contains(".fast"))
            .forEach(found::add);
      }
    }
    return found;
  }

  /** Returns what a comment says, without its stars. */
  private static String text(Matcher doc) {
    return doc.group(1).replaceAll("(?m)^\\s*\\*", "").strip();
  }

  /** Returns the first sentence of a comment in one line. */
  private static String firstSentence(String text) {
    return text.split("(?s)(?<=\\.)\\s|<p>|<pre>", 2)[0].replaceAll("\\s+", " ").strip();
  }

  /** Returns whether the first sentence of a comment can't be understood alone. */
  private static boolean isTorso(String text, String declaration) {
    String sentence = firstSentence(text);
    if (TORSO.matcher(sentence).matches()) {
      return true;
    }
    return CONSTANT.matcher(declaration.strip()).matches()
        && !sentence.startsWith("{@link")
        && (TORSO_OF_A_CONSTANT.matcher(sentence).matches() || sentence.split(" ").length < 2);
  }

  @Test
  void oldWordsStayAway() throws IOException {
    List<Path> all = files(".java", "shared", "server", "client", "launcher", "testkit", "tests");
    all.addAll(files(".md", "docs"));
    all.add(ROOT.resolve("README.md"));
    all.add(ROOT.resolve("SECURITY.md"));
    all.add(ROOT.resolve("CHANGELOG.md"));
    List<String> found = new ArrayList<>();
    for (Path file : all) {
      Matcher old = OLD_WORDS.matcher(Files.readString(file));
      if (!file.endsWith("PlainEnglishTest.java") && old.find()) {
        found.add(file + ": " + old.group());
      }
    }
    assertEquals(List.of(), found);
    assertTrue(all.size() > 1_000, "files=" + all.size());
  }

  @Test
  void docCommentsAreSentences() throws IOException {
    List<String> found = new ArrayList<>();
    int comments = 0;
    for (Path file : files(".java", PRODUCT_AND_LABORATORY)) {
      Matcher doc = DOC_COMMENT.matcher(Files.readString(file));
      while (doc.find()) {
        comments++;
        String text = text(doc);
        if (!text.matches("(?s)[A-Z0-9{<(].*\\..*|\\{@inheritDoc.*")) {
          found.add(file.getFileName() + ": " + text);
        }
      }
    }
    assertEquals(List.of(), found, "they begin with a capital letter and end with a full stop");
    assertTrue(comments > 10_000, "comments=" + comments);
  }

  @Test
  void docCommentsStandAlone() throws IOException {
    List<String> found = new ArrayList<>();
    int constants = 0;
    for (Path file : files(".java", PRODUCT_AND_LABORATORY)) {
      Matcher doc = DOC_COMMENT.matcher(Files.readString(file));
      while (doc.find()) {
        constants += CONSTANT.matcher(doc.group(3).strip()).matches() ? 1 : 0;
        if (isTorso(text(doc), doc.group(3))) {
          found.add(file.getFileName() + ": " + firstSentence(text(doc)));
        }
      }
    }
    assertEquals(List.of(), found, "a whole sentence, or a noun that says what the thing is");
    assertTrue(constants > 300, "constants=" + constants);
  }

  @Test
  void eachConstantIsRead() {
    String source =
        "enum A {\n/** Before the inputs. */\nONE(1),\n/** The second of three. */ TWO,\n"
            + "/** Nothing. */\nTHREE\n}";
    List<Boolean> torsos = new ArrayList<>();
    Matcher doc = DOC_COMMENT.matcher(source);
    while (doc.find()) {
      torsos.add(isTorso(text(doc), doc.group(3)));
    }
    assertEquals(List.of(true, false, true), torsos);
  }

  @Test
  void docCommentsOfMethodsBeginWithAVerb() throws IOException {
    List<String> found = new ArrayList<>();
    int methods = 0;
    for (Path file : files(".java", PRODUCT_AND_LABORATORY)) {
      Matcher doc = DOC_COMMENT.matcher(Files.readString(file));
      while (doc.find()) {
        String declaration = doc.group(3).strip();
        if (!METHOD.matcher(declaration).matches() || TYPE.matcher(declaration).find()) {
          continue;
        }
        methods++;
        String text = text(doc);
        if (!VERB.matcher(text.lines().findFirst().orElse("")).matches()) {
          found.add(file.getFileName() + ": " + text.lines().findFirst().orElse(""));
        }
      }
    }
    assertEquals(List.of(), found, "such as Returns, Adds, Marks");
    assertTrue(methods > 4_000, "methods=" + methods);
  }
}
