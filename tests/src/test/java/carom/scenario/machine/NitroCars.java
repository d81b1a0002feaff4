package carom.scenario.machine;

import static carom.sim.field.Scope.PLAYER;

import carom.fixtures.Cars;
import carom.fixtures.PlainGame;
import carom.physics.Material;
import carom.physics.geometry.Box;
import carom.sim.Match;
import carom.sim.SetUp;
import carom.sim.Simulation;
import carom.sim.entity.Assembly;
import carom.sim.entity.Entity;
import carom.sim.entity.EntityJoint;
import carom.sim.entity.Input;
import carom.sim.entity.Player;
import carom.sim.event.Audience;
import carom.sim.field.Countdown;
import carom.sim.field.Field;
import carom.sim.field.Ratio;
import carom.sim.level.ArchetypeDef;
import carom.sim.level.Level;
import carom.sim.level.LevelException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/**
 * Two cars with nitro, as GAMES.md shows it: {@code input} reads and writes the nitro, which is
 * told to an audience of the test's choice. A full boost turns the wheels faster and pushes the
 * car; a zone fills the tank.
 */
public final class NitroCars extends PlainGame {
  public final Ratio nitro;
  public final Countdown reload;
  private final float tank;
  private Assembly car;

  /**
   * Creates a game whose nitro an audience is told.
   *
   * @param tank the nitro with which the first player begins, in percent
   */
  public NitroCars(Audience audience, int tank) {
    super(name(audience, tank));
    this.tank = tank / 100f;
    nitro = Field.ratio("nitro").of(PLAYER).to(audience).startsAt(1);
    reload = Field.countdown("reload").of(PLAYER).to(audience);
  }

  private static String name(Audience audience, int tank) {
    return "nitro" + audience + tank;
  }

  /** Returns a level of walls, crates and two spots near each other. */
  public static Level level(Audience audience, int tank) throws LevelException {
    String json =
        "{\"name\": \"n\", \"game\": \""
            + name(audience, tank)
            + "\", \"gravity\": [0, -10],"
            + " \"bounds\": {\"min\": [-20, -10], \"max\": [20, 20]},"
            + " \"spawns\": [{\"at\": [-3, 2]}, {\"at\": [3, 2]}],"
            + " \"statics\": [{\"at\": [0, -1], \"shape\": {\"type\": \"box\", \"width\": 40,"
            + " \"height\": 2}}, {\"at\": [-18, 5], \"shape\": {\"type\": \"box\", \"width\": 1,"
            + " \"height\": 14}, \"repeat\": {\"columns\": 2, \"step\": [36, 0]}}],"
            + " \"bodies\": [{\"at\": [-10, 0.5], \"look\": \"crate\", \"shape\": {\"type\":"
            + " \"box\", \"width\": 1, \"height\": 1}, \"repeat\": {\"columns\": 2, \"step\":"
            + " [20, 0]}}]}";
    return Level.parse("nitroCars.json", json.getBytes(StandardCharsets.UTF_8));
  }

  @Override
  public List<Field<?>> fields() {
    return List.of(nitro, reload);
  }

  @Override
  public void setUp(SetUp s) {
    Material metal = new Material(1, 0.4f, 0.1f);
    car = s.assembly(Cars.car(new ArchetypeDef("car").shape(new Box(1.4f, 0.3f), metal)));
  }

  @Override
  public void join(Match s, Player p) {
    Level.Spawn spot = s.level().spawns("player").get(p.id() % 2);
    p.set(nitro, p.id() == 0 ? tank : 1);
    s.spawn(car, spot.x(), spot.y(), 0, p);
  }

  @Override
  public void input(Simulation s, Player p, Input in) {
    Entity body = p.entity();
    boolean boost = in.held(Input.JUMP) && p.get(nitro) > 0;
    p.add(nitro, boost ? -0.01f : 0.001f);
    EntityJoint drive = p.entity().joint("drive");
    if (drive != null) {
      drive.setMotor((boost ? -40 : -20) * in.moveX(), 60);
    }
    if (boost) {
      body.applyForce(10 * in.moveX(), 0);
    }
    if (in.held(Input.SECOND) && p.get(reload) == 0) {
      p.set(reload, s.ticks(0.5f));
      body.applyImpulse(0, 3);
    }
  }
}
