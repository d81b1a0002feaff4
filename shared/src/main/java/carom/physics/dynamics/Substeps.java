package carom.physics.dynamics;

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
    solverBodies.load(bodies, settings, h);
    contactSolver.prepare(contacts, bodies, solverBodies, settings, h);
    begins(StepStage.JOINTS);
    jointSolver.prepare(joints, bodies, settings, h, solverBodies);
    boolean jointsToo = jointSolver.count() > 0;
    for (int i = 0; i < substeps; i++) {
      boolean warm = i > 0 && !settings.explicitEuler() && contactSolver.blocks() > 0;
      begins(StepStage.INTEGRATE);
      solverBodies.integrateVelocities(warm);
      if (jointsToo) {
        beforeJoints();
        jointSolver.warmStart();
        afterJoints();
      }
      if (!warm) {
        begins(StepStage.WARM);
        contactSolver.warmStart();
      }
      if (jointsToo) {
        beforeJoints();
        jointSolver.push();
        afterJoints();
      }
      begins(StepStage.SOLVE);
      contactSolver.push();
      begins(StepStage.INTEGRATE);
      solverBodies.integratePositions();
      if (jointsToo) {
        beforeJoints();
        jointSolver.relax();
        afterJoints();
      }
      begins(StepStage.RELAX);
      contactSolver.relax();
    }
    begins(StepStage.BOUNCE);
    contactSolver.restitution();
    begins(StepStage.FINISH);
    contactSolver.store();
    jointSolver.store();
    solverBodies.store();
  }

  /** What joints do must not be repeated as the contacts' share of the next substep. */
  private void beforeJoints() {
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

  private void begins(StepStage stage) {
    if (stages != null) {
      stages.begins(stage);
    }
  }
}
