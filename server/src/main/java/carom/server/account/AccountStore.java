package carom.server.account;

import java.io.IOException;
import java.util.List;

/** A store of accounts. Every method may wait, and is called by one thread. */
public interface AccountStore extends AutoCloseable {
  /**
   * One row of a best list.
   *
   * @param name the name under which the account's player played last
   * @param word the value
   */
  record Row(String account, String name, int word) {}

  /**
   * The values of an account, as the store has them.
   *
   * @param name the name under which its player played last
   * @param values one for each value
   */
  record Known(String account, String name, List<KnownValue> values) {}

  /** A value, and after which tick it is so. */
  record KnownValue(String game, String field, AccountValues.Kept kept, AccountWrite.Place place) {}

  /** Returns what it is, for messages; without a password. */
  String title();

  /**
   * Opens it, so that the first player needn't wait for that.
   *
   * @throws IOException if the store doesn't answer
   */
  void open() throws IOException;

  /**
   * Begins a stay. Older ones may write until it writes for the first time: a join that a crash
   * undoes changes nothing.
   *
   * @param known stamp of the account's newest stay here, or 0; what that has is newer than what is
   *     stored, unless a stay elsewhere has written since
   * @param takesOver whether to begin although a stay elsewhere hasn't ended
   * @return null if such a stay hasn't ended; without values if those of the known one are newer
   * @throws IOException if the store doesn't answer
   */
  Stay begin(String account, long known, boolean takesOver) throws IOException;

  /**
   * Stores values, unless a newer stay has written.
   *
   * @return whether they are stored
   * @throws IOException if the store doesn't answer
   * @throws IllegalArgumentException if the store never takes it
   */
  boolean write(AccountWrite write) throws IOException;

  /**
   * Returns the best of a field, the best first.
   *
   * @param start the value that counts as none
   * @throws IOException if the store doesn't answer
   */
  List<Row> best(String game, String field, boolean lowest, int start, int most) throws IOException;

  /**
   * Returns what is kept of accounts.
   *
   * @param who an account, or the name under which its player played last, in any case
   * @param most accounts at most
   * @throws IOException if the store doesn't answer
   */
  List<Known> find(String who, int most) throws IOException;

  /**
   * Returns what is kept of an account, nothing of an unknown one.
   *
   * @throws IOException if the store doesn't answer
   */
  List<KnownValue> valuesOf(String account) throws IOException;

  /**
   * Forgets an account. Its number stays for a while, so that no stay before now writes again.
   *
   * @param known stamp of the account's newest stay here, or 0
   * @return the stamp of which older stays write nothing; 0 if nothing was kept
   * @throws IOException if the store doesn't answer
   */
  long forget(String account, long known) throws IOException;

  @Override
  void close();
}
