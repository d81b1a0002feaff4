package carom.text;

import java.util.Collection;

/** Finds the known word that a person probably meant. */
public final class Suggestion {
  /** Fewest letters of a beginning that tell which word is meant. */
  private static final int BEGINNING = 3;

  private Suggestion() {}

  /**
   * Returns the known word nearest to the given one, or null when none is near. The only word that
   * begins with the given one is nearest, if three letters are given. Otherwise a third of its
   * letters, and always two, may be wrong, missing, added or swapped with their neighbour.
   */
  public static String nearest(String word, Collection<String> known) {
    String begun = null;
    int beginWithIt = 0;
    for (String candidate : known) {
      if (candidate.regionMatches(true, 0, word, 0, word.length())) {
        begun = candidate;
        beginWithIt++;
      }
    }
    if (beginWithIt == 1 && word.length() >= BEGINNING) {
      return begun;
    }
    String best = null;
    int bestDistance = Math.max(2, word.length() / 3) + 1;
    if (word.length() > 64) {
      return null;
    }
    for (String candidate : known) {
      int distance = distance(word, candidate);
      if (distance < bestDistance && distance < candidate.length()) {
        best = candidate;
        bestDistance = distance;
      }
    }
    return best;
  }

  /** Returns {@code ; did you mean "x"?}, or an empty text when no known word is near. */
  public static String didYouMean(String word, Collection<String> known) {
    String nearest = nearest(word, known);
    return nearest == null ? "" : "; did you mean \"" + nearest + "\"?";
  }

  /** Returns the optimal string alignment distance, ignoring case. */
  private static int distance(String a, String b) {
    int[][] d = new int[a.length() + 1][b.length() + 1];
    for (int i = 0; i <= a.length(); i++) {
      for (int j = 0; j <= b.length(); j++) {
        if (i == 0 || j == 0) {
          d[i][j] = i + j;
          continue;
        }
        int change = same(a, i, b, j) ? 0 : 1;
        d[i][j] = Math.min(d[i - 1][j - 1] + change, Math.min(d[i - 1][j], d[i][j - 1]) + 1);
        if (i > 1 && j > 1 && same(a, i, b, j - 1) && same(a, i - 1, b, j)) {
          d[i][j] = Math.min(d[i][j], d[i - 2][j - 2] + 1);
        }
      }
    }
    return d[a.length()][b.length()];
  }

  private static boolean same(String a, int i, String b, int j) {
    return Character.toLowerCase(a.charAt(i - 1)) == Character.toLowerCase(b.charAt(j - 1));
  }
}
