package carom.server.command;

import java.util.ArrayList;
import java.util.List;

/**
 * The one rule by which texts are words, in lines of commands and of list files.
 *
 * <p>White space parts words. A word that begins with a double quote goes on to the next one, with
 * spaces and all, and a quote within it is written twice: {@code "Ann ""the boss"" B"}. White space
 * or the end follows the closing quote. Anywhere else in a word a quote is a character like others,
 * as is a backslash everywhere.
 */
public final class Quoting {
  private static final char QUOTE = '"';

  private Quoting() {}

  /**
   * A word of a line.
   *
   * @param text what it says
   * @param quoted whether it was written in quotes, and so has no other meaning than its text
   * @param begin place of its first character in the line
   * @param isOpen whether its closing quote is yet to come
   */
  public record Word(String text, boolean quoted, int begin, boolean isOpen) {
    /** Returns whether this is a certain word that was not written in quotes. */
    public boolean is(String keyword) {
      return !quoted && text.equals(keyword);
    }
  }

  /**
   * Returns the words of a line.
   *
   * @throws IllegalArgumentException if a quote isn't closed, or not followed by white space; the
   *     message says what to do
   */
  public static List<Word> words(String line) {
    return words(line, false);
  }

  /** Returns the words of an unfinished line: the last quote may be open. */
  public static List<Word> begunWords(String line) {
    return words(line, true);
  }

  private static List<Word> words(String line, boolean begun) {
    List<Word> words = new ArrayList<>();
    int at = 0;
    while (at < line.length()) {
      if (Character.isWhitespace(line.charAt(at))) {
        at++;
      } else if (line.charAt(at) == QUOTE) {
        at = addQuoted(line, at, begun, words);
      } else {
        int end = at;
        while (end < line.length() && !Character.isWhitespace(line.charAt(end))) {
          end++;
        }
        words.add(new Word(line.substring(at, end), false, at, false));
        at = end;
      }
    }
    return words;
  }

  /** Adds the word that begins with a quote, and returns the place behind it. */
  private static int addQuoted(String line, int begin, boolean begun, List<Word> words) {
    StringBuilder text = new StringBuilder();
    int at = begin + 1;
    while (at < line.length()) {
      char c = line.charAt(at++);
      boolean twice = at < line.length() && line.charAt(at) == QUOTE;
      if (c != QUOTE) {
        text.append(c);
      } else if (twice) {
        text.append(QUOTE);
        at++;
      } else if (begun || at == line.length() || Character.isWhitespace(line.charAt(at))) {
        words.add(new Word(text.toString(), true, begin, false));
        return at;
      } else {
        throw new IllegalArgumentException(
            "something follows a closing quote; a quote within quotes is written twice (\"\")");
      }
    }
    if (!begun) {
      throw new IllegalArgumentException(
          "a quote is opened and never closed; a word that begins with a quote is written"
              + " \"\"\"so\"");
    }
    words.add(new Word(text.toString(), true, begin, true));
    return at;
  }

  /** Returns a text in quotes: one word that means nothing but the text. */
  public static String quoted(String text) {
    return QUOTE + text.replace("\"", "\"\"") + QUOTE;
  }

  /** Returns a text as a person would write it: in quotes only where it needs them. */
  public static String shown(String text) {
    boolean plain =
        !text.isEmpty()
            && text.charAt(0) != QUOTE
            && text.chars().noneMatch(Character::isWhitespace);
    return plain ? text : quoted(text);
  }
}
