package carom.server.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.server.access.AccessLists;
import carom.server.access.SharedList;
import carom.server.config.DataFolder;
import carom.server.directory.MemoryDirectory;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Goal: who is banned, allowed or an admin on one server is so on all. Method: lists changed at
 * random on servers that come, go, edit files and lose the directory, against one list that
 * everybody would have changed.
 */
class FleetListsTest {
  private static final List<String> SUBJECTS =
      List.of("name \"mallory\"", "name \"Bob B\"", "account \"42\"", "address 192.0.2.7");

  @TempDir private Path folder;
  private long nowNs;
  private final MemoryDirectory directory = new MemoryDirectory(() -> nowNs);

  /** A server with lists, which may be down. */
  private final class Node {
    private final DataFolder data;
    private MemoryDirectory.Door door;
    private AccessLists access;
    private FleetLists lists;

    Node(String name) throws IOException {
      data = new DataFolder(folder.resolve(name));
      Files.createDirectories(data.root());
      start();
    }

    void start() throws IOException {
      door = directory.door();
      access = new AccessLists(data, false, InstantSource.system());
      lists = new FleetLists(door, data.agreed(), access.shared());
    }

    boolean isUp() {
      return lists != null;
    }

    void stop() {
      lists = null;
      door.close();
    }

    SharedList bans() {
      return access.shared().get(0);
    }

    Path file() {
      return data.root().resolve("bans.txt");
    }

    void change(String subject, String line, boolean byHand) throws IOException {
      String key = bans().subjectOf(subject);
      if (!byHand && isUp()) {
        Map<String, String> lines = new TreeMap<>();
        lines.put(key, line);
        bans().change(lines);
        return;
      }
      List<String> lines =
          new ArrayList<>(Files.exists(file()) ? Files.readAllLines(file()) : List.of());
      lines.removeIf(one -> !one.startsWith("#") && bans().subjectOf(one).equals(key));
      if (line != null) {
        lines.add(line);
      }
      lines.add("# edited by hand " + nowNs);
      Files.write(file(), lines);
      access.reload();
    }
  }

  private void settle(List<Node> nodes) {
    for (int i = 0; i < 3; i++) {
      nodes.stream().filter(Node::isUp).forEach(node -> node.lists.agree());
      nowNs += 500_000_000;
      directory.tick();
    }
  }

  @Test
  void listsThatChangeAtRandomBecomeEqual() throws IOException {
    long seed = System.nanoTime();
    System.out.println("lists of seed " + seed);
    Random random = new Random(seed);
    List<Node> nodes = List.of(new Node("a"), new Node("b"), new Node("c"));
    Map<String, String> expected = new TreeMap<>();
    for (int i = 0; i < 120; i++) {
      Node node = nodes.get(random.nextInt(nodes.size()));
      switch (random.nextInt(8)) {
        case 0 -> {
          if (node.isUp()) {
            node.stop();
          } else {
            node.start();
          }
        }
        case 1 -> node.door.away(random.nextBoolean());
        default -> {
          // While others can't hear it, a server changes only what none of them does.
          boolean heard = nodes.stream().allMatch(Node::isUp) && random.nextBoolean();
          if (heard) {
            nodes.forEach(one -> one.door.away(false));
            settle(nodes);
          }
          int which = heard ? random.nextInt(SUBJECTS.size()) : nodes.indexOf(node);
          String subject = SUBJECTS.get(which);
          String line = random.nextInt(3) == 0 ? null : subject + " because " + i;
          node.change(subject, line, random.nextBoolean());
          String key = node.bans().subjectOf(subject);
          if (line == null) {
            expected.remove(key);
          } else {
            expected.put(key, line);
          }
          if (heard) {
            settle(nodes);
          }
        }
      }
    }
    List<Node> shuffled = new ArrayList<>(nodes);
    Collections.shuffle(shuffled, random);
    for (Node node : shuffled) {
      if (!node.isUp()) {
        node.start();
      }
      node.door.away(false);
    }
    settle(nodes);
    for (Node node : nodes) {
      assertEquals(expected, new TreeMap<>(node.bans().lines()), "seed " + seed);
    }
  }

  @Test
  void aBanThatWasLiftedWhileAServerWasDownStaysLifted() throws IOException {
    Node a = new Node("a");
    Node b = new Node("b");
    a.change("name mallory", "name mallory", false);
    settle(List.of(a, b));
    assertEquals(1, b.bans().lines().size());
    b.stop();
    a.change("name mallory", null, false);
    settle(List.of(a));
    b.start();
    settle(List.of(a, b));
    assertEquals(Map.of(), a.bans().lines());
    assertEquals(Map.of(), b.bans().lines());
  }

  @Test
  void aLineThatIsNoneIsLeftOut() throws IOException {
    Node a = new Node("a");
    directory.door().create("lists/admin/x", "name anybody", 0);
    directory.door().create("lists/bans/y", "rubbish", 0);
    settle(List.of(a));
    for (SharedList list : a.access.shared()) {
      assertTrue(list.lines().isEmpty(), list.name());
    }
  }
}
