package carom.testkit;

import carom.game.Games;
import carom.physics.Material;
import carom.physics.geometry.Circle;
import carom.sim.Game;
import carom.sim.Simulation;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.field.Countdown;
import carom.sim.field.Field;
import carom.sim.level.Appearance;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import carom.sim.message.Message;
import carom.sim.message.MessageKind;
import java.nio.charset.StandardCharsets;
import java.util.List;

/**
 * A game for tests: two teams of discs, 400 m apart. A player who holds {@link Input#SECOND} dies
 * and is back after {@link #OUT_SECONDS}. Players buy things reliably and point at places
 * unreliably, and the server answers in the same way.
 */
public final class DuelGame implements Game {
  /** Time without a body after a death, seconds. */
  public static final float OUT_SECONDS = 6;

  /** Distance of the teams from the middle, metres. */
  public static final float APART = 200;

  /** A purchase, reliable. */
  public static final MessageKind BUY =
      MessageKind.named("buy").fromClient().count("item", 0, 31).text("note", 40);

  /** The answer to a purchase, reliable. */
  public static final MessageKind SOLD =
      MessageKind.named("sold").fromServer().count("item", 0, 31).text("note", 40);

  /** A place that a player points at, unreliable. */
  public static final MessageKind POINT =
      MessageKind.named("point").fromClient().unreliable().atMost(60).count("number", 0, 9_999);

  /** The place that a player points at, for all, unreliable. */
  public static final MessageKind POINTED =
      MessageKind.named("pointed").fromServer().unreliable().count("number", 0, 9_999);

  private static final Countdown OUT = Field.countdown("out");

  private Archetype disc;

  /** Creates the game. */
  public DuelGame() {}

  /** Adds the game to those that are found by name, and returns a level for it. */
  public static Level level() {
    Games.add(DuelGame::new);
    String json =
        """
        {"name": "Duel", "game": "duel", "gravity": [0, 0],
         "bounds": {"min": [-250, -50], "max": [250, 50]}}
        """;
    try {
      return Level.parse("duel", json.getBytes(StandardCharsets.UTF_8));
    } catch (LevelException e) {
      throw new AssertionError(e);
    }
  }

  @Override
  public String name() {
    return "duel";
  }

  @Override
  public String defaultLevel() {
    return "duel";
  }

  @Override
  public List<Field<?>> fields() {
    return List.of(OUT);
  }

  @Override
  public List<String> teams() {
    return List.of("West", "East");
  }

  @Override
  public boolean ownColours() {
    return false;
  }

  @Override
  public void setUp(Simulation s) {
    disc =
        s.archetypes()
            .add(
                new ArchetypeDef("disc")
                    .shape(new Circle(0.5f), new Material(1, 0, 0))
                    .appearance(Appearance.of(0x4da3ff, Appearance.Look.PLAYER)));
    s.messageKinds().add(BUY);
    s.messageKinds().add(SOLD);
    s.messageKinds().add(POINT);
    s.messageKinds().add(POINTED);
  }

  @Override
  public void join(Simulation s, Player p) {
    p.team(s.teamSize(1) <= s.teamSize(2) ? 1 : 2);
    giveBody(s, p);
  }

  private void giveBody(Simulation s, Player p) {
    s.spawn(disc, p.team() == 1 ? -APART : APART, 3 * p.id(), 0, p);
  }

  @Override
  public void teamChanged(Simulation s, Player p) {
    s.despawn(p.body());
    giveBody(s, p);
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    p.body().body().seekVelocity(5 * in.moveX(), 5 * in.moveY(), 10);
  }

  @Override
  public void message(Simulation s, Player p, Message m) {
    if (m.is(BUY)) {
      s.send(SOLD.of(m.count("item"), m.text("note"))).to(p);
    } else if (m.is(POINT)) {
      s.send(POINTED.of(m.count("number"))).toAll();
    }
  }

  @Override
  public void beforeStep(Simulation s) {
    for (int id = 0; id < s.playerCapacity(); id++) {
      Player p = s.player(id);
      if (p != null && !p.isAlive() && p.get(OUT) == 0) {
        giveBody(s, p);
      }
    }
  }

  @Override
  public void afterStep(Simulation s) {
    for (int id = 0; id < s.playerCapacity(); id++) {
      Player p = s.player(id);
      if (p != null && p.isAlive() && p.input().held(Input.SECOND)) {
        s.despawn(p.body());
        p.set(OUT, s.ticks(OUT_SECONDS));
      }
    }
  }
}
