package carom.client.bots;

import carom.sim.entity.Input;

/** A brain that plays as well as a strength says, and changes its mind from time to time. */
abstract class GradedBrain implements BotBrain {
  private static final int MOOD_TICKS = 60; // at most, beyond the least

  private final String game;
  private Strength strength;
  private int changeAt;

  /**
   * Creates a brain.
   *
   * @param game that it plays
   * @param strength null for one that the bot's random numbers choose
   */
  GradedBrain(String game, Strength strength) {
    this.game = game;
    this.strength = strength;
  }

  @Override
  public final String game() {
    return game;
  }

  @Override
  public final void strength(Strength newStrength) {
    strength = newStrength;
  }

  @Override
  public final void decide(Senses s, Input out) {
    if (s.view().level() == null || !s.view().knowsFields()) {
      return;
    }
    if (strength == null) {
      strength = Strength.values()[s.random().nextInt(Strength.values().length)];
    }
    play(s, strength, out);
  }

  /** Decides the input of one tick, once the level and the fields of the match are known. */
  abstract void play(Senses s, Strength strength, Input out);

  /**
   * Returns whether it is time for another mood: of the side to go to, or of how much a shot
   * misses.
   *
   * @param least ticks that a mood lasts
   */
  final boolean changesMind(Senses s, int least) {
    boolean isDue = s.tick() >= changeAt || changeAt - s.tick() > least + MOOD_TICKS; // a match
    if (isDue) {
      changeAt = s.tick() + least + s.random().nextInt(MOOD_TICKS);
    }
    return isDue;
  }
}
