package carom.server.account;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.sim.field.Field;
import carom.sim.field.Schema;
import carom.sim.field.Scope;
import java.util.List;
import org.junit.jupiter.api.Test;

/** What each store of accounts keeps to. Each test has accounts of its own. */
abstract class AccountStoreContract {
  static final Schema SCHEMA =
      Schema.of(
          List.of(
              Field.count("wins").of(Scope.ACCOUNT),
              Field.flag("seen").of(Scope.ACCOUNT).times(2)));

  private static final AccountWrite.Place PLACE = new AccountWrite.Place("cup", 3, 1_234);

  /** Returns the store, as another run of a server would open it. */
  abstract AccountStore store() throws Exception;

  private static AccountWrite write(Stay stay, boolean ends, int... words) {
    Stay now = new Stay(stay.account(), stay.stamp(), stay.values().with("duel", SCHEMA, words));
    return AccountWrite.of(now, "Ann", "duel", PLACE, true, ends);
  }

  private static Stay begin(AccountStore store, String account, boolean takesOver)
      throws Exception {
    return store.begin(account, 0, takesOver);
  }

  @Test
  void whatIsWrittenIsThereInTheNextStay() throws Exception {
    try (AccountStore store = store()) {
      Stay first = begin(store, "7", false);
      assertArrayEquals(new int[] {0, 0, 0}, first.values().words("duel", SCHEMA));
      assertTrue(store.write(write(first, false, 1, 0, 1)));
      assertTrue(store.write(write(first, true, 5, 0, 1)));
    }
    try (AccountStore store = store()) {
      Stay second = begin(store, "7", false);
      assertNotNull(second, "the first stay has ended");
      assertArrayEquals(new int[] {5, 0, 1}, second.values().words("duel", SCHEMA));
      assertArrayEquals(new int[] {0, 0, 0}, second.values().words("other", SCHEMA));
    }
  }

  @Test
  void theNewestStayAloneWrites() throws Exception {
    try (AccountStore store = store()) {
      Stay first = begin(store, "8", false);
      assertTrue(store.write(write(first, false, 1, 0, 0)));
      assertNull(begin(store, "8", false), "the first stay goes on");
      Stay second = begin(store, "8", true);
      assertTrue(store.write(write(first, false, 8, 0, 0)), "the second may not have joined");
      assertTrue(store.write(write(second, false, 2, 0, 0)));
      assertFalse(store.write(write(first, true, 9, 0, 0)));
      assertTrue(store.write(write(second.moved(), false, 3, 0, 0)));
      assertFalse(store.write(write(second.resumed(), true, 2, 0, 0)), "the room is left");
      Stay third = begin(store, "8", true);
      assertArrayEquals(new int[] {3, 0, 0}, third.values().words("duel", SCHEMA));
    }
  }

  @Test
  void ofPlayersWhoGainNothingNothingStays() throws Exception {
    try (AccountStore store = store()) {
      Stay first = begin(store, "key:zero", false);
      assertTrue(store.write(AccountWrite.of(first, "Ann", "duel", PLACE, false, true)));
      Stay second = begin(store, "key:zero", false);
      assertEquals(first.stamp(), second.stamp(), "as if it had never been there");
    }
  }

  @Test
  void theEndOfAStayThatGainedNothingLeavesTheNextOneAlone() throws Exception {
    try (AccountStore store = store()) {
      Stay first = begin(store, "10", false);
      Stay second = store.begin("10", first.stamp(), false);
      assertNull(second.values(), "what the first has is newer");
      assertTrue(store.write(AccountWrite.of(first, "Ann", "duel", PLACE, false, true)));
      assertNull(begin(store, "10", false), "the second goes on");
      Stay now =
          new Stay(
              "10", second.stamp(), AccountValues.NONE.with("duel", SCHEMA, new int[] {4, 0, 0}));
      assertTrue(store.write(AccountWrite.of(now, "Ann", "duel", PLACE, true, true)));
      assertArrayEquals(
          new int[] {4, 0, 0}, begin(store, "10", false).values().words("duel", SCHEMA));
    }
  }

  @Test
  void theBestComeFirstAndNamesAreThoseOfTheLastStay() throws Exception {
    try (AccountStore store = store()) {
      for (int i = 0; i < 4; i++) {
        Stay stay = begin(store, "best" + i, false);
        Stay now =
            new Stay(
                stay.account(),
                stay.stamp(),
                AccountValues.NONE.with("race", SCHEMA, new int[] {i * 10, 0, 0}));
        assertTrue(store.write(AccountWrite.of(now, "P" + i, "race", PLACE, true, true)));
      }
      assertEquals(
          List.of(new AccountStore.Row("best3", "P3", 30), new AccountStore.Row("best2", "P2", 20)),
          store.best("race", "wins", false, 0, 2));
      assertEquals(
          List.of("P1", "P2", "P3"),
          store.best("race", "wins", true, 0, 5).stream().map(AccountStore.Row::name).toList());
    }
  }

  @Test
  void accountsAreFoundByIdAndByName() throws Exception {
    try (AccountStore store = store()) {
      for (String account : List.of("find1", "find2")) {
        Stay stay = begin(store, account, false);
        assertTrue(store.write(write(stay, true, 3, 1, 2)));
      }
      assertEquals(List.of("find2"), ids(store.find("find2", 5)));
      List<String> sameName = ids(store.find("aNN", 1_000)); // with those of other tests
      assertEquals(
          List.of("find1", "find2"),
          sameName.stream().filter(account -> account.startsWith("find")).toList());
      AccountStore.KnownValue wins =
          store.find("find1", 5).get(0).values().stream()
              .filter(value -> value.field().equals("wins"))
              .findAny()
              .orElseThrow();
      assertEquals(3, wins.kept().word());
      assertEquals("duel", wins.game());
      assertEquals(List.of(), store.find("nobody", 5));
    }
  }

  private static List<String> ids(List<AccountStore.Known> found) {
    return found.stream().map(AccountStore.Known::account).toList();
  }

  @Test
  void whatIsForgottenNoEarlierStayWritesAgain() throws Exception {
    try (AccountStore store = store()) {
      Stay first = begin(store, "forgotten", false);
      assertTrue(store.write(write(first, false, 7, 1, 1)));
      long stamp = store.forget("forgotten", first.stamp());
      assertTrue(stamp > first.stamp());
      assertFalse(store.write(write(first, false, 8, 1, 1)), "while the player is in");
      assertFalse(store.write(write(first.resumed(), true, 8, 1, 1)), "after a crash, too");
      Stay next = begin(store, "forgotten", false);
      assertArrayEquals(new int[3], next.values().words("duel", SCHEMA));
      assertTrue(next.stamp() > stamp);
      assertTrue(store.write(write(next, true, 1, 0, 0)), "it begins anew");
      assertEquals(0, store.forget("never seen", 0));
    }
  }

  @Test
  void aValueThatIsDeclaredOtherwiseCountsAsFarAsItCan() throws Exception {
    Schema narrower =
        Schema.of(
            List.of(
                Field.count("wins", 0, 3).of(Scope.ACCOUNT),
                Field.ratio("seen").of(Scope.ACCOUNT).times(2).startsAt(0.5f)));
    try (AccountStore store = store()) {
      Stay first = begin(store, "9", false);
      store.write(write(first, true, 12, 1, 1));
      int[] words = begin(store, "9", false).values().words("duel", narrower);
      assertEquals(3, words[0]);
      assertEquals(narrower.field(Scope.PLAYER, 1).start(), words[1]);
    }
  }
}
