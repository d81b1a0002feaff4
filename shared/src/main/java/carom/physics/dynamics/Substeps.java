package carom.physics.dynamics;

import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.Settings;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.domain.DomainPhases;
import carom.physics.dynamics.joint.JointSolver;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.joint.RevoluteLanes;
import carom.physics.dynamics.pairs.PairFinder;
import carom.physics.dynamics.parallel.ParallelFor;
import carom.physics.dynamics.solver.ContactLanes;
import carom.physics.dynamics.solver.ContactSolver;
import carom.physics.dynamics.solver.SolverBodies;
import carom.physics.profile.StageListener;
import carom.physics.profile.StepStage;

/**
 * The part of a step in which velocities and positions change: {@code substeps} times velocities
 * are integrated, joints and contacts solved with bias, positions integrated, joints and contacts
 * solved again without (relax); then contacts bounce, and what came out is written back.
 */
final class Substeps {
  /** The active bodies as the solvers see them. */
  final SolverBodies solverBodies;

  private final Settings settings;
  private final BodyStore bodies;
  private final ContactTable contacts;
  private final JointStore joints;
  private final ContactSolver contactSolver;
  private final JointSolver jointSolver;
  private final ParallelFor parallel;
  private final DomainPhases phases = new DomainPhases();

  /** Null, unless somebody measures. */
  private StageListener stages;

  /** Moves the active bodies; contacts and joints are given their impulses. */
  Substeps(
      Settings settings,
      BodyStore bodies,
      ActiveBodies active,
      ContactTable contacts,
      JointStore joints,
      PairFinder pairs,
      ParallelFor parallel) {
    this.settings = settings;
    this.bodies = bodies;
    this.contacts = contacts;
    this.joints = joints;
    this.parallel = parallel;
    solverBodies = new SolverBodies(active, pairs, parallel);
    contactSolver = new ContactSolver(ContactLanes.FOUND, parallel);
    jointSolver = new JointSolver(RevoluteLanes.FOUND, parallel);
  }

  /** Sets who is told of the stages, null for nobody. */
  void stageListener(StageListener listener) {
    stages = listener;
  }

  /** Does all substeps of a step of some seconds. */
  void run(float dt) {
    int substeps = settings.substeps();
    float h = dt / substeps;
    begins(StepStage.PREPARE);
    solverBodies.begin(bodies, settings, h, contacts);
    contactSolver.prepare(contacts, bodies, solverBodies, settings, h);
    phases.divide(solverBodies.domains.count(), parallel.workers());
    solverBodies.load(phases);
    contactSolver.pack(phases);
    begins(StepStage.JOINTS);
    if (joints.count() > 0) {
      phases.run(); // joints look at loaded bodies
    }
    jointSolver.prepare(joints, bodies, settings, h, solverBodies);
    boolean jointsToo = jointSolver.count() > 0;
    for (int i = 0; i < substeps; i++) {
      boolean warm = i > 0 && !settings.explicitEuler() && contactSolver.blocks() > 0;
      begins(StepStage.INTEGRATE);
      solverBodies.integrateVelocities(phases, warm);
      if (jointsToo) {
        beforeJoints();
        jointSolver.warmStart();
        afterJoints();
      }
      if (!warm) {
        begins(StepStage.WARM);
        contactSolver.warmStart(phases);
      }
      if (jointsToo) {
        beforeJoints();
        jointSolver.push();
        afterJoints();
      }
      begins(StepStage.SOLVE);
      contactSolver.push(phases);
      begins(StepStage.INTEGRATE);
      solverBodies.integratePositions(phases);
      if (jointsToo) {
        beforeJoints();
        jointSolver.relax();
        afterJoints();
      }
      begins(StepStage.RELAX);
      contactSolver.relax(phases);
    }
    begins(StepStage.BOUNCE);
    phases.run(); // only now it is known who bounces
    contactSolver.restitution(phases);
    begins(StepStage.FINISH);
    contactSolver.store(phases);
    jointSolver.store(); // reads poses as they were, and nothing that contacts store
    solverBodies.store(phases);
    phases.run();
  }

  /** What joints do must not be repeated as the contacts' share of the next substep. */
  private void beforeJoints() {
    phases.run();
    begins(StepStage.JOINTS);
    if (contactSolver.blocks() > 0) {
      solverBodies.beforeJoints();
    }
  }

  private void afterJoints() {
    if (contactSolver.blocks() > 0) {
      solverBodies.afterJoints();
    }
  }

  /** Somebody who measures stages has each of them end before the next one begins. */
  private void begins(StepStage stage) {
    if (stages != null) {
      phases.run();
      stages.begins(stage);
    }
  }
}
