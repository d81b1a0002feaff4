package carom.client.desktop.game;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.sim.spawn.Origin;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;

/**
 * Goal: an effect's memory follows the number of entities, whatever their ids are. Method: frames
 * with random entities, among them ids of predicted spawns, beside a plain map.
 */
final class SeenEntitiesTest {
  private static final class Note extends SeenEntities.Seen {}

  private final SeenEntities<Note> entities = new SeenEntities<>(Note::new);

  @Test
  void anEntityIsKnownWhileEachFrameHasIt() {
    long seed = Long.getLong("carom.seed", System.nanoTime());
    System.out.println("SeenEntitiesTest seed=" + seed);
    Random random = new Random(seed);
    Map<List<Integer>, Note> known = new HashMap<>();
    Set<Note> made = new HashSet<>();
    int most = 0;
    for (int frame = 0; frame < 2_000; frame++) {
      entities.nextFrame();
      Map<List<Integer>, Note> shown = new HashMap<>();
      for (int i = random.nextInt(40); i > 0; i--) {
        int id =
            switch (random.nextInt(3)) {
              case 0 -> random.nextInt(30);
              case 1 -> Origin.of(random.nextInt(30), random.nextInt(2));
              default -> random.nextInt() & Integer.MAX_VALUE;
            };
        List<Integer> entity = List.of(id, random.nextInt(2));
        Note note = entities.see(id, entity.get(1));
        boolean before = known.containsKey(entity) || shown.containsKey(entity);
        assertEquals(!before, note.isNew(), entity.toString());
        if (known.containsKey(entity)) {
          assertSame(known.get(entity), note);
        }
        shown.put(entity, note);
        made.add(note);
      }
      assertEquals(shown.size(), new HashSet<>(shown.values()).size(), "each has its own");
      most = Math.max(most, entities.size());
      known = shown;
    }
    assertTrue(made.size() <= most, "made=" + made.size() + " most=" + most);
  }
}
