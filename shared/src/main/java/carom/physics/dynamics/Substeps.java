package carom.physics.dynamics;

import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.Settings;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.joint.JointSolver;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.joint.PinLanes;
import carom.physics.dynamics.pairs.PairFinder;
import carom.physics.dynamics.parallel.Crew;
import carom.physics.dynamics.parallel.Lockstep;
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
  private final Crew crew;
  private final Lockstep lockstep = new Lockstep();

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
      Crew crew) {
    this.settings = settings;
    this.bodies = bodies;
    this.contacts = contacts;
    this.joints = joints;
    this.crew = crew;
    solverBodies = new SolverBodies(active, pairs, crew);
    contactSolver = new ContactSolver(ContactLanes.find(), crew);
    jointSolver = new JointSolver(PinLanes.find(), crew);
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
    crew.divide(lockstep, solverBodies.domains.count());
    solverBodies.load(lockstep);
    contactSolver.pack(lockstep);
    begins(StepStage.JOINTS);
    if (joints.count() > 0) {
      lockstep.run(); // joints look at loaded bodies
    }
    jointSolver.prepare(joints, bodies, settings, h, solverBodies);
    boolean jointsToo = jointSolver.count() > 0;
    for (int i = 0; i < substeps; i++) {
      boolean warm = i > 0 && !settings.explicitEuler() && contactSolver.blocks() > 0;
      begins(StepStage.INTEGRATE);
      solverBodies.integrateVelocities(lockstep, warm);
      if (jointsToo) {
        beforeJoints();
        jointSolver.warmStart();
        afterJoints();
      }
      if (!warm) {
        begins(StepStage.WARM);
        contactSolver.warmStart(lockstep);
      }
      if (jointsToo) {
        beforeJoints();
        jointSolver.push();
        afterJoints();
      }
      begins(StepStage.SOLVE);
      contactSolver.push(lockstep);
      begins(StepStage.INTEGRATE);
      solverBodies.integratePositions(lockstep);
      if (jointsToo) {
        beforeJoints();
        jointSolver.relax();
        afterJoints();
      }
      begins(StepStage.RELAX);
      contactSolver.relax(lockstep);
    }
    begins(StepStage.BOUNCE);
    lockstep.run(); // only now it is known who bounces
    contactSolver.restitution(lockstep);
    begins(StepStage.FINISH);
    contactSolver.store(lockstep);
    jointSolver.store(); // reads poses as they were, and nothing that contacts store
    solverBodies.store(lockstep);
    lockstep.run();
  }

  /** What joints do must not be repeated as the contacts' share of the next substep. */
  private void beforeJoints() {
    lockstep.run();
    begins(StepStage.JOINTS);
    if (contactSolver.blocks() > 0) {
      solverBodies.mark();
    }
  }

  private void afterJoints() {
    if (contactSolver.blocks() > 0) {
      solverBodies.except();
    }
  }

  /** Somebody who measures stages has each of them end before the next one begins. */
  private void begins(StepStage stage) {
    if (stages != null) {
      lockstep.run();
      stages.begins(stage);
    }
  }
}
