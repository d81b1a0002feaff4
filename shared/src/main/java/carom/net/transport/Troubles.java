package carom.net.transport;

/** Builds the text of {@link ServerTransport#troubles}: what happened how often. One thread. */
public final class Troubles {
  private final StringBuilder text = new StringBuilder();

  /** Creates an empty text. */
  public Troubles() {}

  /** Adds what happened, such as {@code 3 refused}, unless it never did. */
  public Troubles add(long count, String what) {
    if (count > 0) {
      text.append(text.length() == 0 ? "" : ", ").append(count).append(' ').append(what);
    }
    return this;
  }

  /** Returns the text, behind a heading if there is any. */
  public String under(String heading) {
    return text.length() == 0 ? "" : heading + text;
  }

  @Override
  public String toString() {
    return text.toString();
  }
}
