package carom.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.protocol.InputDatagram;
import carom.net.snapshot.exact.NearState;
import carom.physics.rows.BodyRow;
import carom.physics.rows.RowKind;
import carom.server.config.ServerConfig;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.entity.Input;
import carom.sim.near.Neighbourhood;
import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/**
 * Goal: a client receives nothing about entities that {@link carom.sim.Game#audience} hides from
 * its player. Method: two teams that don't see each other play side by side on a whole server;
 * everything that a client decodes is searched for the others' bodies, inputs and events, and for
 * those of the own team, which must be there.
 */
class AudienceTest {
  private final TestGame game = new TestGame(3);
  private Rig rig;
  private FakeClient red;
  private FakeClient blue;
  private FakeClient mate;
  private boolean touched;

  @BeforeEach
  void begin() {
    game.teamsHide = true;
    rig = new Rig(ServerConfig.defaults(), game);
    red = join("red");
    blue = join("blue");
    mate = join("mate");
    rig.steps(30);
  }

  @AfterEach
  void end() {
    rig.close();
  }

  private FakeClient join(String name) {
    FakeClient client = rig.join(name);
    client.near = InputDatagram.NEAR_ALL;
    return client;
  }

  private HostEntity body(FakeClient client) {
    return rig.room.simulation().player(client.welcome.playerId()).entity();
  }

  /** Searches all that a client is told from now on; {@code seen} afterwards. */
  private final class Search {
    private final FakeClient client;
    private final int other;
    private boolean body;
    private boolean near;
    private boolean exact;
    private boolean input;
    private final int eventsBefore;

    Search(FakeClient client, FakeClient other) {
      this.client = client;
      this.other = other.welcome.playerId();
      eventsBefore = client.eventsBy.size();
      Runnable before = client.onDecoded;
      client.onDecoded =
          () -> {
            before.run();
            look();
          };
    }

    private void look() {
      HostEntity e = rig.room.simulation().player(other).entity();
      int key = Neighbourhood.key(e.id(), e.generation());
      body |= client.decoder.history(e.id()) != null && client.decoder.history(e.id()).alive();
      input |= client.own.relayed().has(other);
      if (client.decoder.hasOwn()) {
        look(client.decoder.own().near(), key);
      }
    }

    private void look(NearState told, int key) {
      for (int i = 0; i < told.count(); i++) {
        near |= told.key(i) == key;
      }
      for (int i = 0; told.updating() && i < told.partRows(); i++) {
        exact |= told.kind(i) == RowKind.BODY && told.rows().get(i, BodyRow.KEY) == key;
      }
    }

    private boolean event() {
      return client.eventsBy.subList(eventsBefore, client.eventsBy.size()).contains(other);
    }

    private String found() {
      return "body=" + body + " near=" + near + " exact=" + exact + " input=" + input + " event="
          + event();
    }

    void requireNothing() {
      assertFalse(body || near || exact || input || event(), found());
    }

    void requireAll() {
      assertTrue(body && near && input && event(), found());
    }
  }

  @Test
  void whoChangesTheTeamIsToldOfThoseWhoRestThere() {
    rig.steps(120);
    int resting = body(blue).id();
    assertFalse(knows(red, resting), "of another team");
    rig.room.simulation().player(red.welcome.playerId()).team(2);
    rig.steps(20);
    assertTrue(knows(red, resting), "of the own team");
  }

  private static boolean knows(FakeClient client, int id) {
    return client.decoder.history(id) != null && client.decoder.history(id).alive();
  }

  private void playTogether() {
    blue.input.move(-1, 0); // into red, who is pushed by what it can't see
    red.input.move(0.5f, 0);
    mate.input.move(-1, 0);
    for (int i = 0; i < 120; i++) {
      for (FakeClient client : rig.clients) {
        client.input.hold(Input.ACTION, i % 7 < 3);
      }
      rig.step();
      body(red)
          .body()
          .forEachContact((with, x, y, impulse) -> touched |= with.user() == body(blue));
    }
  }

  @Test
  void hiddenPlayersAreToldOfInNoWayAndTheOwnTeamIs() {
    Search redOfBlue = new Search(red, blue);
    Search blueOfRed = new Search(blue, red);
    Search mateOfBlue = new Search(mate, blue);
    FakeClient late = join("late"); // blue's
    Search lateOfRed = new Search(late, red);
    Search redOfMate = new Search(red, mate);
    Search lateOfBlue = new Search(late, blue);
    playTogether();
    assertTrue(touched, "red and blue touch");
    redOfBlue.requireNothing();
    blueOfRed.requireNothing();
    mateOfBlue.requireNothing();
    lateOfRed.requireNothing();
    redOfMate.requireAll();
    lateOfBlue.requireAll();
    for (FakeClient client : rig.clients) {
      assertEquals(0, client.undecodable);
    }
  }

  /**
   * Blue hides for a while, presses a button and lets it go again. What red is told afterwards must
   * not reach back into that time, whatever its client does meanwhile.
   */
  private void hideBlue(Runnable meanwhile, Runnable afterwards) {
    final int id = blue.welcome.playerId();
    rig.room.simulation().player(id).team(1);
    rig.steps(60);
    assertTrue(red.own.relayed().has(id));
    Set<Long> told = new HashSet<>();
    red.onDecoded =
        () -> {
          for (int tick = red.decoder.newestTick() - 16;
              tick < red.decoder.newestTick() + 8;
              tick++) {
            if (red.decoder.inputs().knows(id, tick)) {
              told.add(red.decoder.inputs().at(id, tick));
            }
          }
        };
    meanwhile.run();
    rig.steps(2);
    rig.room.simulation().player(id).team(2);
    blue.input.hold(Input.ACTION, true);
    final long secret = blue.input.pack();
    rig.steps(6);
    blue.input.hold(Input.ACTION, false);
    rig.steps(4); // those on the way are consumed
    rig.room.simulation().player(id).team(1);
    afterwards.run();
    rig.steps(3);
    red.sends = true;
    red.acks = true;
    rig.steps(60);
    assertFalse(told.contains(secret), told::toString);
    assertTrue(red.own.relayed().has(id), "shown again");
  }

  @Test
  void whatIsDoneInHidingIsNotToldAfterwardsEither() {
    hideBlue(() -> red.sends = false, () -> {});
  }

  @Test
  void norIsItToldToWhoLooksAwayMeanwhile() {
    hideBlue(
        () -> {
          red.near = InputDatagram.NEAR_NONE;
          red.acks = false;
        },
        () -> red.near = InputDatagram.NEAR_ALL);
  }

  @Test
  void norIsItToldToWhoHasNoBodyMeanwhile() {
    SimulationHost s = rig.room.simulation();
    HostEntity before = body(red);
    hideBlue(
        () -> {
          red.acks = false;
          s.despawn(before);
        },
        () -> s.spawn(s.archetype("ball"), 0, -20, 0, s.player(red.welcome.playerId())));
  }

  @Test
  void aGameMayTellInputsWithTheirTicksOnly() {
    for (boolean ahead : new boolean[] {false, true}) {
      game.relaysAhead = ahead;
      boolean[] early = new boolean[1];
      red.onDecoded =
          () ->
              early[0] |=
                  red.decoder.inputs().newestTick(mate.welcome.playerId())
                      > red.decoder.newestTick();
      for (int i = 0; i < 20; i++) {
        mate.input.hold(Input.ACTION, i % 2 == 0);
        rig.step();
      }
      assertEquals(ahead, early[0]);
    }
  }

  @Test
  void whoHidesIsOutOfSightAtOnceAndBackWhenShown() {
    rig.room.simulation().player(blue.welcome.playerId()).team(1);
    rig.steps(60);
    Search shown = new Search(red, blue);
    playTogether();
    shown.requireAll();
    assertTrue(shown.exact || red.decoder.own().near().count() > 0, shown.found());
    rig.room.simulation().player(blue.welcome.playerId()).team(2);
    rig.steps(10); // what changed sides leaves sight with a record of its own
    Search hidden = new Search(red, blue);
    playTogether();
    hidden.requireNothing();
    rig.room.simulation().player(blue.welcome.playerId()).team(1);
    rig.steps(10);
    Search again = new Search(red, blue);
    playTogether();
    again.requireAll();
  }
}
