package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.ClientMessage;
import carom.server.account.MemoryAccounts;
import carom.server.session.Session;
import carom.sim.entity.Input;
import carom.testkit.Folders;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: wherever a server is killed and whenever the store fails, an account has exactly what the
 * checkpoint's log says that it has earned: nothing counts twice, and nothing is lost. Method:
 * virtual time; the disk and the store lag and fail at random, a crash drops what waits for them,
 * and the next server begins from what is left.
 */
@Timeout(120)
class AccountCrashTest {
  private static final int CRASHES = Integer.getInteger("carom.crashes", 25);
  private static final String ROOM = "cup";

  @TempDir Path folder;

  @Test
  void anAccountHasWhatTheLogSays() throws Exception {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println("crashes of accounts: seed=" + seed);
    Random random = new Random(seed);
    MemoryAccounts store = new MemoryAccounts();
    Path kept = Files.createDirectory(folder.resolve("kept0"));
    long nowNs = 1_000_000_000L;
    int earned = 0;
    int waited = 0;
    for (int crash = 0; crash < CRASHES; crash++) {
      String what = "crash=" + crash + " seed=" + seed;
      AccountRig rig = new AccountRig(store, kept, folder, nowNs, ROOM);
      rig.settle();
      compare(rig, store, what);
      Map<String, FakeClient> playing = new TreeMap<>();
      int ticks = 60 + random.nextInt(240);
      for (int tick = 0; tick < ticks; tick++) {
        String account = "" + random.nextInt(EarnGame.ACCOUNTS);
        FakeClient client = playing.get(account);
        if (client == null && random.nextInt(20) == 0) {
          Session there = rig.session(account, ROOM);
          long secret = there == null ? 0 : there.seat().secret();
          playing.put(account, rig.hello(account, ROOM, secret));
        } else if (client != null && client.ready && random.nextInt(80) == 0) {
          client.link.send(new ClientMessage.Leave());
          playing.remove(account);
          for (int i = 0; i < 10; i++) {
            rig.step(); // so that the seat is free
          }
        } else if (client != null) {
          client.input.hold(Input.ACTION, random.nextInt(3) > 0);
        }
        store.takesNothing = random.nextInt(100) < (store.takesNothing ? 95 : 3);
        rig.step();
        for (int i = random.nextInt(4); i > 0 && !rig.disk.isEmpty(); i--) {
          rig.disk.poll().run();
        }
        for (int i = random.nextInt(3); i > 0; i--) {
          rig.accounts.turn();
        }
        waited = Math.max(waited, rig.accounts.waiting());
      }
      Path left = folder.resolve("kept" + (crash + 1));
      Folders.copy(kept, left);
      MemoryAccounts stored = store.copy();
      nowNs = rig.nowNs;
      rig.disk.clear();
      rig.close();
      Folders.delete(kept);
      kept = left;
      store = stored;
    }
    try (AccountRig last = new AccountRig(store, kept, folder, nowNs, ROOM)) {
      for (int account = 0; account < EarnGame.ACCOUNTS; account++) {
        Session there = last.session("" + account, ROOM);
        if (there != null) {
          last.hello("" + account, ROOM, there.seat().secret())
              .link
              .send(new ClientMessage.Leave());
        }
        earned += last.paid("" + account, ROOM);
      }
      last.settle();
      compare(last, store, "at last, seed=" + seed);
    }
    System.out.println("crashes=" + CRASHES + " earned=" + earned + " waited=" + waited);
    assertTrue(earned > 10 * CRASHES && waited > 1, "earned=" + earned + " waited=" + waited);
  }

  private static void compare(AccountRig rig, MemoryAccounts store, String what) {
    for (int i = 0; i < EarnGame.ACCOUNTS; i++) {
      String account = "" + i;
      int paid = rig.paid(account, ROOM);
      assertEquals(paid, store.value(account, "earn", "coins"), what + ": account " + account);
      if (rig.session(account, ROOM) != null) {
        assertEquals(paid, rig.coins(account, ROOM), what + ": player of account " + account);
      }
    }
  }
}
