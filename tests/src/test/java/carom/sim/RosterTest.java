package carom.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import carom.fixtures.PlainGame;
import carom.game.Games;
import carom.physics.Material;
import carom.physics.archive.ArchiveReader;
import carom.physics.archive.ArchiveWriter;
import carom.physics.geometry.Circle;
import carom.sim.entity.HostPlayer;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.field.Count;
import carom.sim.field.Field;
import carom.sim.field.PlayerRef;
import carom.sim.field.Scope;
import carom.sim.level.Archetype;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.message.BuiltInKinds;
import carom.sim.message.MessageKind;
import carom.sim.message.PlayerRole;
import carom.sim.outbox.Delivery;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Goal: teams, readiness and roles change as players ask and the game allows, bounded, and the game
 * doesn't see spectators. Method: players send messages to simulations without a network.
 */
final class RosterTest {
  /** Discs in two teams, at most three of them. Nobody leaves while the door is shut. */
  private static class Discs extends PlainGame {
    static final Count LIVES = Field.count("lives", 0, 9).startsAt(3);
    static final PlayerRef LEADER = Field.player("leader").of(Scope.MATCH);
    static final MessageKind WAVE = MessageKind.named("wave").fromClient();
    final List<String> calls = new ArrayList<>();
    String shut;
    Archetype disc;

    Discs() {
      super("discs", "arena");
    }

    @Override
    public List<Field<?>> fields() {
      return List.of(LIVES, LEADER);
    }

    @Override
    public int maxPlayers() {
      return 3;
    }

    @Override
    public List<String> teams() {
      return List.of("Red", "Blue");
    }

    @Override
    public void setUp(SetUp s) {
      disc = s.archetype(new ArchetypeDef("disc").shape(new Circle(0.5f), new Material(1, 0, 0)));
      s.message(WAVE);
    }

    @Override
    public void join(Match s, Player p) {
      calls.add("join " + p.id());
      s.team(p, s.teamSize(1) <= s.teamSize(2) ? 1 : 2);
      s.spawn(disc, p.id(), 0, 0, p);
    }

    @Override
    public void leave(Match s, Player p) {
      calls.add("leave " + p.id());
    }

    @Override
    public void input(Simulation s, Player p, Input in) {
      p.entity().applyForce(9 * in.moveX(), 9 * in.moveY());
    }

    @Override
    public void message(Match s, Player p, carom.sim.message.Message m) {
      calls.add(m.kind().name() + " " + p.id());
    }

    @Override
    public void teamChanged(Match s, Player p) {
      calls.add("team " + p.id() + " " + s.team(p));
    }

    @Override
    public String refuseRole(Match s, Player p, PlayerRole role) {
      return shut;
    }
  }

  private final Discs discs = new Discs();
  private final SimulationHost s = simulation(discs);

  private static SimulationHost simulation(Game game) {
    try {
      return new SimulationHost(game, Level.builtIn("arena"), 7, 60, Role.AUTHORITY);
    } catch (Exception e) {
      return fail(e);
    }
  }

  private void asksFor(HostPlayer p, PlayerRole role) {
    assertTrue(s.receive(p, BuiltInKinds.ROLE.of(role)));
    s.step();
  }

  private void asksFor(HostPlayer p, int team) {
    assertTrue(s.receive(p, BuiltInKinds.TEAM.of(team)));
    s.step();
  }

  private List<String> told() {
    List<String> lines = new ArrayList<>();
    s.outbox()
        .drainMessages(
            d -> {
              if (d.message().is(BuiltInKinds.SAID)) {
                assertEquals(Delivery.Recipients.ONE, d.recipients());
                lines.add(d.id() + ": " + d.message().text("text"));
              }
            });
    return lines;
  }

  @Test
  void aPlayerIsReadyWhenItSaysSoAndAllAreWhenEachIs() {
    assertFalse(s.allReady());
    HostPlayer ann = s.join("Ann");
    HostPlayer bob = s.join("Bob");
    s.receive(ann, BuiltInKinds.READY.of(true));
    s.step();
    assertTrue(ann.isReady());
    assertFalse(s.allReady());
    s.receive(bob, BuiltInKinds.READY.of(true));
    s.step();
    assertTrue(s.allReady());
    s.receive(ann, BuiltInKinds.READY.of(false));
    s.step();
    assertFalse(ann.isReady());
  }

  @Test
  void aSpectatorIsHiddenFromTheGameAndHasNothing() {
    HostPlayer ann = s.join("Ann");
    HostPlayer bob = s.join("Bob");
    ann.score(5);
    ann.ready(true);
    ann.set(Discs.LIVES, 1);
    s.set(Discs.LEADER, ann);
    asksFor(ann, PlayerRole.SPECTATOR);
    assertEquals(List.of("join 0", "join 1", "leave 0"), discs.calls);
    assertNull(s.player(0));
    assertSame(ann, s.participant(0));
    assertNull(ann.entity());
    assertFalse(ann.isAlive());
    assertFalse(ann.isReady());
    assertEquals(HostPlayer.NO_TEAM, ann.team());
    assertEquals(0, ann.score());
    assertEquals(3, ann.get(Discs.LIVES));
    assertNull(s.get(Discs.LEADER));
    assertEquals(1, s.playerCount());
    for (int id = 0; id < s.entityCapacity(); id++) {
      assertTrue(s.entity(id) == null || s.entity(id).ownerId() != 0, "entity " + id);
    }
    bob.ready(true);
    assertTrue(s.allReady(), "spectators needn't be ready");
  }

  @Test
  void aSpectatorThatPlaysAgainJoinsAnew() {
    HostPlayer ann = s.join("Ann");
    asksFor(ann, PlayerRole.SPECTATOR);
    asksFor(ann, PlayerRole.PLAYER);
    assertEquals(List.of("join 0", "leave 0", "join 0"), discs.calls);
    assertSame(ann, s.player(0));
    assertNotNull(ann.entity());
    assertEquals(1, ann.team());
  }

  @Test
  void theGameMayRefuseARoleInWords() {
    HostPlayer ann = s.join("Ann");
    discs.shut = "Not during the final";
    asksFor(ann, PlayerRole.SPECTATOR);
    assertFalse(ann.isSpectator());
    assertEquals(List.of("0: Not during the final"), told());
  }

  @Test
  void whoComesToAFullGameWatchesUntilThereIsAPlace() {
    HostPlayer[] players = {s.join("Ann"), s.join("Bob"), s.join("Cid"), s.join("Dan")};
    assertTrue(players[3].isSpectator());
    assertEquals(3, s.playerCount());
    assertEquals(List.of("3: All 3 places are taken: you watch"), told());
    asksFor(players[3], PlayerRole.PLAYER);
    assertTrue(players[3].isSpectator());
    assertEquals(List.of("3: All 3 places are taken: you watch"), told());
    asksFor(players[0], PlayerRole.SPECTATOR);
    asksFor(players[3], PlayerRole.PLAYER);
    assertNotNull(players[3].entity());
    assertEquals(List.of(), told());
    s.leave(players[0]);
    assertEquals(1, discs.calls.stream().filter("leave 0"::equals).count(), "left once, not twice");
    assertNull(s.participant(0));
  }

  @Test
  void aPlayerMayNotMakeTeamsUnequal() {
    HostPlayer ann = s.join("Ann"); // Red
    HostPlayer bob = s.join("Bob"); // Blue
    asksFor(ann, 2);
    assertEquals(1, ann.team());
    assertEquals(List.of("0: Blue has more players than Red"), told());
    HostPlayer cid = s.join("Cid"); // Red
    asksFor(cid, 2);
    assertEquals(2, cid.team());
    asksFor(cid, 2);
    assertEquals(List.of(), told());
    assertEquals(1, discs.calls.stream().filter("team 2 2"::equals).count());
    assertEquals(2, bob.team());
  }

  @Test
  void anUnknownTeamIsRefused() {
    HostPlayer ann = s.join("Ann");
    asksFor(ann, 0);
    asksFor(ann, 3);
    asksFor(ann, 255);
    assertEquals(1, ann.team());
    assertEquals(
        List.of(
            "0: There is no team 0, only 1 to 2",
            "0: There is no team 3, only 1 to 2",
            "0: There is no team 255, only 1 to 2"),
        told());
    asksFor(ann, PlayerRole.SPECTATOR);
    asksFor(ann, 1);
    assertEquals(List.of("0: Spectators have no team: ask to play first"), told());
  }

  @Test
  void aSpectatorChatsButTheGameGetsNoMessageOfIt() {
    HostPlayer ann = s.join("Ann");
    s.join("Bob");
    s.receive(ann, Discs.WAVE.of());
    asksFor(ann, PlayerRole.SPECTATOR);
    s.receive(ann, Discs.WAVE.of());
    s.receive(ann, BuiltInKinds.SAY.of(false, "hello there"));
    s.receive(ann, BuiltInKinds.READY.of(true));
    s.step();
    assertEquals(1, discs.calls.stream().filter("wave 0"::equals).count());
    List<String> said = new ArrayList<>();
    s.outbox().drainMessages(d -> said.add(d.message().text("text")));
    assertEquals(List.of("hello there"), said);
    assertFalse(ann.isReady());
  }

  @Test
  void aRoleCanNotChangeInLeave() {
    SimulationHost s2 =
        simulation(
            new Discs() {
              @Override
              public void leave(Match s, Player p) {
                s.role(p, PlayerRole.SPECTATOR);
              }
            });
    HostPlayer ann = s2.join("Ann");
    assertThrows(IllegalStateException.class, () -> s2.role(ann, PlayerRole.SPECTATOR));
  }

  @Test
  void rolesAndReadinessAreSavedHashedAndWritten() {
    HostPlayer ann = s.join("Ann");
    HostPlayer bob = s.join("Bob");
    s.step();
    long playing = s.stateHash();
    SimState before = s.save(null);
    bob.ready(true);
    assertNotEquals(playing, s.stateHash());
    s.role(ann, PlayerRole.SPECTATOR);
    long watching = s.stateHash();
    SimState after = s.save(null);
    ArchiveWriter archive = new ArchiveWriter();
    after.write(archive);
    s.restore(before);
    assertEquals(playing, s.stateHash());
    assertFalse(bob.isReady());
    assertNotNull(s.player(0).entity());
    s.restore(after);
    assertEquals(watching, s.stateHash());
    assertNull(s.player(0));
    SimulationHost other = simulation(new Discs());
    byte[] bytes = java.util.Arrays.copyOf(archive.array(), archive.length());
    other.restore(other.read(new ArchiveReader(bytes)));
    assertEquals(watching, other.stateHash());
    assertTrue(other.participant(0).isSpectator());
    assertTrue(other.player(1).isReady());
  }

  @Test
  void arenaChangesTheDiscWithTheTeamAndKeepsTeamsBalanced() throws Exception {
    SimulationHost arena =
        new SimulationHost(Games.create("arena"), Level.builtIn("arena"), 1, 60, Role.AUTHORITY);
    HostPlayer ann = arena.join("Ann");
    arena.join("Bob");
    HostPlayer cid = arena.join("Cid");
    assertEquals(1, cid.team());
    arena.receive(cid, BuiltInKinds.TEAM.of(2));
    arena.receive(ann, BuiltInKinds.TEAM.of(2));
    arena.step();
    assertEquals(2, ann.team(), "asked first: messages go by player id");
    assertEquals(1, cid.team());
    assertEquals(2, ann.entity().tag());
  }
}
