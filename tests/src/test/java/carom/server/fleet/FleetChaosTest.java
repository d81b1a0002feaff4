package carom.server.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.GameClient;
import carom.client.link.ConnectionPhase;
import carom.server.config.ServerConfig.Durability;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: whatever happens to servers and directory, a room has at most one owner, and in the end all
 * play. Method: crashes, freezes, slow links, partitions, false words of a death and clocks that go
 * wrong, drawn at random, in virtual time; a seed reproduces. {@code -Dcarom.fleet.seed=N} draws
 * another one.
 */
class FleetChaosTest {
  private static final double SLICE_S = FleetRig.SLICE_NS / 1e9;
  private static final List<String> ROOMS = List.of("1", "2", "3", "4", "5", "6");

  /** A hundred times what a quartz does. */
  private static final double MOST_DRIFT = 0.01;

  @TempDir private Path folder;

  @Test
  void aRoomHasAtMostOneOwnerAndEverybodyPlaysInTheEnd() throws Exception {
    Random random = FleetRig.draws();
    try (FleetRig rig = new FleetRig(folder, 4)) {
      rig.durability = random.nextBoolean() ? Durability.SYNC : Durability.ASYNC;
      rig.lagNs = random.nextInt(3) * 10_000_000L;
      for (String name : List.of("a", "b", "c")) {
        rig.nextPace = 1 + MOST_DRIFT * (2 * random.nextDouble() - 1);
        rig.node(name, 2);
      }
      rig.run(1);
      for (int i = 0; i < 9; i++) {
        rig.client("bot" + i, List.of("a", "b", "c").get(i % 3));
      }
      rig.run(3);
      int restarts = 0;
      for (int i = 0; i < 6; i++) {
        List<FleetRig.Node> all = List.copyOf(rig.nodes.values());
        FleetRig.Node node = all.get(random.nextInt(all.size()));
        switch (random.nextInt(6)) {
          case 0 -> node.frozen = true;
          case 1 -> node.door.away(true);
          case 2 -> node.stuck = true;
          case 4 -> node.slander();
          case 3 -> {
            node.kill();
            run(rig, random.nextDouble());
            rig.node(node.name, restarts++ % 2); // another process at the same address
          }
          default -> node.member.drain();
        }
        run(rig, 0.2 + 4 * random.nextDouble());
        node.frozen = false;
        node.stuck = false;
        node.door.away(false);
        if (node.member.isDrained() && !node.dead) {
          node.server.close();
          node.member.close();
          rig.node(node.name, 0);
        }
        run(rig, 2 * random.nextDouble());
      }
      run(rig, 15);
      Set<String> seats = new HashSet<>();
      for (GameClient client : rig.clients) {
        assertEquals(ConnectionPhase.PLAYING, client.view().phase(), client.view().message());
        assertTrue(seats.add(client.view().room() + "#" + client.view().playerId()), "own seats");
      }
    }
  }

  private static void run(FleetRig rig, double seconds) {
    for (double t = 0; t < seconds; t += SLICE_S) {
      rig.run(SLICE_S);
      for (String room : ROOMS) {
        assertTrue(rig.owners(room).size() <= 1, () -> "room " + room + " has two owners");
      }
    }
  }
}
