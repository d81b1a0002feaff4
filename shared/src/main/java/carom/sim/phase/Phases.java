package carom.sim.phase;

import java.util.Arrays;

/**
 * The phase of one simulation, and the calls that its phase or its role refuses. A phase within
 * another ends with the outer one going on:
 *
 * <pre>{@code
 * Phase outer = phases.begin(Phase.AFTER_STEP);
 * game.afterStep(simulation);
 * phases.end(outer);
 * }</pre>
 *
 * <p>One thread; allocates nothing while a simulation steps.
 *
 * @param <P> the class of players
 */
public final class Phases<P> {
  /** Is told when a phase begins and ends. */
  public interface Listener {
    /** Receives that a phase has begun. */
    void began(Phase phase);

    /** Receives that a phase ends. It is still the present one. An exception may skip this. */
    default void ended(Phase phase) {}
  }

  private final boolean decides;
  private final Listener[][] listeners = new Listener[Phase.values().length][0];
  private Phase now = Phase.SET_UP;
  private P player;
  private boolean inStep;

  /**
   * Creates the phases of a simulation that is being set up.
   *
   * @param decides whether its role is {@code AUTHORITY}, else {@code PREDICTION}
   */
  public Phases(boolean decides) {
    this.decides = decides;
  }

  /** Tells a listener of some phases from now on, after those that listen already. */
  public void listen(Listener listener, Phase... to) {
    for (Phase phase : to) {
      int i = phase.ordinal();
      listeners[i] = Arrays.copyOf(listeners[i], listeners[i].length + 1);
      listeners[i][listeners[i].length - 1] = listener;
    }
  }

  /** Returns the present phase. */
  public Phase now() {
    return now;
  }

  /** Returns the player whose input is applied; null in all other phases. */
  public P player() {
    return player;
  }

  /** Returns whether the simulation's role is {@code AUTHORITY}. */
  public boolean decides() {
    return decides;
  }

  /** Returns whether a step runs. */
  public boolean isInStep() {
    return inStep;
  }

  /** Notes that a step begins. */
  public void beginStep() {
    inStep = true;
  }

  /** Ends set-up, or a step with all its phases, also one in which something was thrown. */
  public void endStep() {
    inStep = false;
    player = null;
    now = Phase.BETWEEN_STEPS;
  }

  /**
   * Begins a phase.
   *
   * @return the phase within which it is, for {@link #end}
   */
  public Phase begin(Phase phase) {
    Phase outer = now;
    now = phase;
    for (Listener listener : listeners[phase.ordinal()]) {
      listener.began(phase);
    }
    return outer;
  }

  /** Begins the input of a player, as {@link #begin} does. */
  public Phase beginInput(P of) {
    player = of;
    return begin(Phase.INPUT);
  }

  /**
   * Ends the present phase.
   *
   * @param outer the one that goes on
   */
  public void end(Phase outer) {
    for (Listener listener : listeners[now.ordinal()]) {
      listener.ended(now);
    }
    player = now == Phase.INPUT ? null : player;
    now = outer;
  }

  /**
   * Throws in {@code Game.input}, which clients run, too.
   *
   * @param what the method that was called
   */
  public void requireOutsideInput(String what) {
    if (now == Phase.INPUT) {
      throw new IllegalStateException(
          what
              + " can't be called in Game.input, which clients run, too; call Player.spawn there"
              + " and set its velocity and fields, or do this in Game.beforeStep or"
              + " Game.afterStep");
    }
  }

  /**
   * Throws in {@code Game.forces}, which may change nothing but its body, and while the physics
   * step runs.
   *
   * @param what the method that was called
   */
  public void requireOutsidePhysics(String what) {
    requireOutsideForces(what);
    if (now == Phase.PHYSICS || now == Phase.COLLISION) {
      throw new IllegalStateException(
          what + " can't be called during the physics step; call it in Game.afterStep");
    }
  }

  /**
   * Throws unless the role is {@code AUTHORITY} and {@link #requireOutsidePhysics} allows it.
   *
   * @param what the method that was called
   */
  public void requireAuthority(String what) {
    require(true, what);
  }

  /**
   * Throws unless the role is {@code PREDICTION} and {@link #requireOutsidePhysics} allows it.
   *
   * @param what the method that was called
   */
  public void requirePrediction(String what) {
    require(false, what);
  }

  /**
   * Throws where clients compute, too, which aren't told.
   *
   * @param what what is asked for
   */
  public void requireTold(String what) {
    if (!decides || now.isPredicted() || now == Phase.FORCES) {
      throw new IllegalStateException(
          what
              + " can't be asked for by what clients compute, too, as they aren't told; keep what"
              + " you need of it in a field");
    }
  }

  /**
   * Throws in {@code Game.rules}, which may change fields and what moves by itself only.
   *
   * @param what the call, and on what
   */
  public void requireOutsideRules(String what) {
    if (now == Phase.RULES) {
      throw new IllegalStateException(
          what
              + " can't be called in Game.rules, which clients run, too: they know only some"
              + " entities, so it may write fields, move bodies of the level by Rules.move and"
              + " despawn what belongs to nobody; do this in Game.input, Game.forces or"
              + " Game.afterStep");
    }
  }

  private void require(boolean deciding, String what) {
    requireOutsideForces(what);
    requireOutsideRules(what);
    if (decides != deciding) {
      throw new IllegalStateException(
          what + " is for the " + role(deciding) + " role only, this is " + role(decides));
    }
    requireOutsidePhysics(what);
  }

  private void requireOutsideForces(String what) {
    if (now == Phase.FORCES) {
      throw new IllegalStateException(
          what
              + " can't be called in Game.forces, which clients run, too: they know only some"
              + " entities, and it may only push the body it is called for; do it in"
              + " Game.beforeStep or Game.afterStep");
    }
  }

  private static String role(boolean decides) {
    return decides ? "AUTHORITY" : "PREDICTION";
  }
}
