package carom.client.look;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.client.bots.Bot;
import carom.client.view.ClientView;
import carom.client.view.ClientView.Drawn;
import carom.game.Games;
import carom.net.transport.Impairment;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.server.config.ServerConfig;
import carom.sim.Game;
import carom.sim.Match;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Entity;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Choice;
import carom.sim.field.EntityRef;
import carom.sim.field.Field;
import carom.sim.field.PlayerRef;
import carom.sim.field.Scope;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.testkit.SimulatedClient;
import carom.testkit.Stepper;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.BiFunction;
import org.junit.jupiter.api.Test;

/** What a view shows by fields, of each kind, scope and audience. */
class ShownValueTest {
  private enum Mood {
    QUITE_CALM,
    ALARM
  }

  private static final PlayerRef TURN = Field.player("turn").of(Scope.MATCH).to(Audience.ALL);
  private static final PlayerRef NOBODY = Field.player("nobody").of(Scope.MATCH).to(Audience.ALL);
  private static final EntityRef BALL = Field.entity("ball").of(Scope.MATCH).to(Audience.ALL);
  private static final EntityRef GONE = Field.entity("gone").of(Scope.MATCH).to(Audience.ALL);
  private static final Choice<Mood> MOOD =
      Field.choice("mood", Mood.class).of(Scope.MATCH).to(Audience.ALL);

  private static final List<BiFunction<String, Field<?>, HudItem>> LINES =
      List.of(HudItem::bar, HudItem::number, HudItem::time, HudItem::icons, HudItem::word);

  private final long seed = Long.getLong("carom.seed", new Random().nextLong());
  private final Random random = new Random(seed);

  /** Declares fields and sets some of them. */
  private static final class Fields implements Game {
    private final List<Field<?>> fields;
    private Archetype disc;
    private Entity removed;

    Fields(List<Field<?>> fields) {
      this.fields = fields;
    }

    @Override
    public String name() {
      return "shown";
    }

    @Override
    public String defaultLevel() {
      return "shown";
    }

    @Override
    public List<Field<?>> fields() {
      return fields;
    }

    @Override
    public void setUp(SetUp s) {
      disc = s.archetype(new ArchetypeDef("disc").shape(new Circle(0.5f), Material.DEFAULT));
    }

    @Override
    public void begin(Match m) {
      m.set(BALL, m.spawn(disc, 0, 0));
      removed = m.spawn(disc, 2, 0);
      m.set(GONE, removed);
      m.set(MOOD, Mood.ALARM);
    }

    @Override
    public void join(Match m, Player p) {
      m.spawn(disc, -2, p.id(), 0, p);
      m.set(TURN, p);
    }

    @Override
    public void input(Simulation s, Player p, Input in) {}

    @Override
    public void afterStep(Match m) {
      if (m.tick() == 60) {
        removed.despawn();
        m.spawn(disc, 4, 0); // takes over the id, sooner or later
      }
    }
  }

  private static Stepper world(List<Field<?>> fields) {
    Games.add(() -> new Fields(fields));
    String json =
        "{\"name\": \"Shown\", \"game\": \"shown\", \"gravity\": [0, 0],"
            + " \"bounds\": {\"min\": [-9, -9], \"max\": [9, 9]}}";
    try {
      return Stepper.of(Level.parse("shown.json", json.getBytes(UTF_8)), ServerConfig.defaults());
    } catch (LevelException e) {
      throw new AssertionError(e);
    }
  }

  private static SimulatedClient play(Stepper world) {
    SimulatedClient ann = world.join("Ann", Impairment.NONE, new Bot(1));
    world.join("Bob", Impairment.NONE, new Bot(2));
    world.run(3);
    return ann;
  }

  @Test
  void aFieldThatMeansSomebodySaysWho() {
    List<Field<?>> fields = List.of(TURN, NOBODY, BALL, GONE, MOOD);
    try (Stepper world = world(fields)) {
      ClientView view = play(world).view();
      assertEquals("Bob", HudItem.word("turn", TURN).value().word(view, -1, null));
      assertEquals("", HudItem.word("turn", NOBODY).value().word(view, -1, null));
      assertEquals("alarm", HudItem.word("mood", MOOD).value().word(view, -1, null));
      assertEquals("Bob", view.playerName(view.match().get(TURN).id()));
      assertNull(view.match().get(NOBODY));
      Drawn ball = view.find(view.match().get(BALL));
      assertNotNull(ball);
      assertEquals(0, ball.x(), 0.01);
      assertNull(view.find(view.match().get(GONE)));
      assertNull(view.find(view.match().get(TURN)), "a player is no entity");
      assertNull(view.find(null));
    }
  }

  /** A line is refused by its field's name when the view is set up, or can be drawn. */
  @Test
  void whatIsNotRefusedCanBeShown() {
    List<Field<?>> fields = new ArrayList<>(List.of(TURN, NOBODY, BALL, GONE, MOOD));
    for (int i = 0; i < 60; i++) {
      fields.add(randomField("f" + i));
    }
    int refused = 0;
    try (Stepper world = world(fields)) {
      ClientView view = play(world).view();
      Drawn own = view.own();
      for (Field<?> field : fields) {
        for (BiFunction<String, Field<?>, HudItem> line : LINES) {
          HudItem item;
          try {
            item = line.apply("label", field);
          } catch (IllegalArgumentException e) {
            refused++;
            assertTrue(e.getMessage().contains(field.path()), e.getMessage());
            continue;
          }
          for (Drawn body : new Drawn[] {own, null}) {
            int player = body == null ? -1 : body.ownerId();
            if (item.kind() == HudItem.Kind.WORD) {
              assertNotNull(item.value().word(view, player, body));
            }
            float share = item.value().share(view, player, body);
            assertTrue(share >= 0 && share <= 1, () -> field.path() + " seed=" + seed);
          }
        }
      }
    }
    assertTrue(refused > 60, "too few lines were refused: " + refused);
    assertThrows(IllegalArgumentException.class, () -> HudItem.number("turn", TURN));
    HudItem.number("mood", MOOD).whileSet(TURN).whileSet(BALL);
  }

  private Field<?> randomField(String name) {
    Field<?> field =
        switch (random.nextInt(8)) {
          case 0 -> Field.count(name, -5, 9);
          case 1 -> Field.flag(name);
          case 2 -> Field.choice(name, Mood.class);
          case 3 -> Field.ratio(name);
          case 4 -> Field.real(name);
          case 5 -> Field.countdown(name);
          case 6 -> Field.entity(name);
          default -> Field.player(name);
        };
    Scope[] scopes = {Scope.MATCH, Scope.PLAYER, Scope.ENTITY};
    Audience[] audiences = {Audience.ALL, Audience.NEAR, Audience.OWNER, Audience.NOBODY};
    return field
        .of(scopes[random.nextInt(3)])
        .to(audiences[random.nextInt(4)])
        .times(1 + random.nextInt(2));
  }
}
