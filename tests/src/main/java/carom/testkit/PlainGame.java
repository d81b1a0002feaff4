package carom.testkit;

import carom.sim.Game;
import carom.sim.Simulation;
import carom.sim.entity.Input;
import carom.sim.entity.Player;

/** A game without rules. A test overrides what it is about. */
public class PlainGame implements Game {
  private final String name;
  private final String level;

  /** Creates a game whose level has its name. */
  public PlainGame(String name) {
    this(name, name);
  }

  /** Creates a game that is played on a level. */
  public PlainGame(String name, String level) {
    this.name = name;
    this.level = level;
  }

  @Override
  public final String name() {
    return name;
  }

  @Override
  public final String defaultLevel() {
    return level;
  }

  @Override
  public void setUp(Simulation s) {}

  @Override
  public void join(Simulation s, Player p) {}

  @Override
  public void input(Simulation s, Player p, Input in) {}
}
