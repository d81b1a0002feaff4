package carom.sim;

import carom.sim.entity.HostEntity;
import carom.sim.entity.HostPlayer;
import carom.sim.phase.Findings;
import carom.sim.phase.Phases;

/**
 * Finds games whose {@code Game.input} reads overlaps that clients can't know: of sensors that they
 * don't simulate, and of the level's, which are no part of exact states. One thread; allocates for
 * a finding only.
 */
final class OverlapUse {
  private final Phases<HostPlayer> phases;
  private final Findings findings;

  /** Creates it; what it finds goes to a list. */
  public OverlapUse(Phases<HostPlayer> phases, Findings findings) {
    this.phases = phases;
    this.findings = findings;
  }

  /** Receives an overlap that the game asked for. */
  public void read(HostEntity asked, HostEntity other) {
    HostPlayer player = phases.player();
    if (player == null || asked == null || other == null) {
      return;
    }
    HostEntity sensor = asked.archetype().sensor() ? asked : other;
    boolean isSimulated = sensor.ownerId() == player.id() || sensor.archetype().area() != null;
    String id = "overlaps " + sensor.archetype().index();
    if (isSimulated || !findings.isNew(id)) {
      return;
    }
    String name = sensor.archetype().name();
    findings.add(
        id,
        sensor.isLevel()
            ? "input reads overlaps with the level's sensor \""
                + name
                + "\" by Body.forEachOverlap, which a client with a new exact state knows a tick"
                + " later; ask Simulation.isInside, which both sides compute alike."
            : "input reads overlaps with entity "
                + sensor.id()
                + " ("
                + name
                + ") by Body.forEachOverlap, a sensor that clients don't simulate, so they can't"
                + " predict what follows; use Game.entered and left.");
  }
}
