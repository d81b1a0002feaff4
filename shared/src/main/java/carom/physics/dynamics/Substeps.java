package carom.physics.dynamics;

import carom.physics.dynamics.body.ActiveBodies;
import carom.physics.dynamics.body.BodyStore;
import carom.physics.dynamics.body.ShapeTable;
import carom.physics.dynamics.contact.ContactTable;
import carom.physics.dynamics.domain.DomainPhases;
import carom.physics.dynamics.domain.SolverBodies;
import carom.physics.dynamics.joint.JointStore;
import carom.physics.dynamics.jointsolver.JointSolver;
import carom.physics.dynamics.jointsolver.RevoluteLanes;
import carom.physics.dynamics.jointtree.JointTrees;
import carom.physics.dynamics.pairs.PairFinder;
import carom.physics.dynamics.solver.ContactLanes;
import carom.physics.dynamics.solver.ContactSolver;
import carom.physics.dynamics.solver.TreeContacts;
import carom.physics.dynamics.store.ParallelFor;
import carom.physics.profile.StageListener;
import carom.physics.profile.StepStage;
import carom.physics.settings.Settings;

/**
 * The part of a step in which velocities and positions change.
 *
 * <pre>
 *   prepare    colours, blocks; bodies are loaded; contacts and joints are packed
 *   substep    impacts                       blows with restitution, if anything approaches fast
 *              integrate velocities          v += h a; contacts start warm by the last substep
 *    n times   joints: warm start            the impulses of the last substep
 *              contacts: warm start          first substep only
 *              joints: biased impulses       errors go away
 *              contacts: biased impulses     overlap goes away
 *              trees: biased impulses        their contacts, then their joints once more
 *              integrate positions           x += h v
 *              joints, contacts: relax       rigid, without bias: the speed of the bias goes
 *              trees: relax                  their contacts, then their joints once more
 *   finish     store                         velocities, poses and impulses
 * </pre>
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

  /** Listens to stages; null unless they are measured. */
  private StageListener stages;

  /** Makes the part for the bodies, contacts and joints of a world. */
  Substeps(
      Settings settings,
      BodyStore bodies,
      ActiveBodies active,
      ContactTable contacts,
      JointStore joints,
      PairFinder pairs,
      ShapeTable parts,
      ParallelFor parallel) {
    this.settings = settings;
    this.bodies = bodies;
    this.contacts = contacts;
    this.joints = joints;
    this.parallel = parallel;
    solverBodies = new SolverBodies(active, pairs, parallel);
    contactSolver = new ContactSolver(ContactLanes.FOUND, parallel, parts);
    jointSolver = new JointSolver(RevoluteLanes.FOUND, parallel);
  }

  /** Sets the listener of the stages, null for none. */
  void stageListener(StageListener listener) {
    stages = listener;
  }

  /** Does all substeps of a step of some seconds. */
  void run(float dt) {
    int substeps = settings.substeps();
    float h = dt / substeps;
    begins(StepStage.PREPARE);
    solverBodies.begin(bodies, settings, h, contacts);
    JointTrees trees = jointSolver.find(joints, bodies);
    contactSolver.prepare(contacts, bodies, solverBodies, trees, settings, h);
    phases.divide(solverBodies.domains.count(), parallel.workers());
    solverBodies.load(phases);
    contactSolver.pack(phases);
    begins(StepStage.JOINTS);
    if (joints.count() > 0) {
      phases.run(); // joints look at loaded bodies
    }
    jointSolver.prepare(joints, bodies, settings, h, solverBodies);
    TreeContacts treeContacts = contactSolver.ofTrees(contacts, jointSolver.treeResponse());
    jointSolver.measureTrees();
    boolean jointsToo = jointSolver.count() > 0;
    boolean bounces = contactSolver.bounces(phases, contacts.mightBounce());
    for (int i = 0; i < substeps; i++) {
      // Joints are enough: contacts far away mustn't change how jointed bodies are rounded.
      boolean warm =
          i > 0 && !settings.explicitEuler() && (jointsToo || contactSolver.blocks() > 0);
      begins(StepStage.BOUNCE);
      if (bounces) {
        phases.run(); // an impact is decided with the velocities of all
        contactSolver.solveImpacts(phases);
      }
      begins(StepStage.INTEGRATE);
      solverBodies.integrateVelocities(phases, warm);
      if (!warm) {
        begins(StepStage.WARM);
        contactSolver.warmStart(phases);
      }
      if (jointsToo) {
        beforeJoints();
        if (treeContacts.any()) {
          treeContacts.warmStart();
          afterJoints();
          beforeJoints();
        }
        jointSolver.warmStart(solverBodies);
        afterJoints();
      }
      if (jointsToo) {
        beforeJoints();
        jointSolver.applyBiasedImpulses(solverBodies);
        afterJoints();
      }
      begins(StepStage.SOLVE);
      contactSolver.applyBiasedImpulses(phases);
      if (jointsToo && jointSolver.settles()) {
        beforeJoints();
        treeContacts.applyBiasedImpulses();
        jointSolver.settle(solverBodies);
        afterJoints();
      }
      limit(dt, true);
      begins(StepStage.INTEGRATE);
      solverBodies.integratePositions(phases);
      if (jointsToo) {
        beforeJoints();
        jointSolver.relax(solverBodies);
        afterJoints();
      }
      begins(StepStage.RELAX);
      contactSolver.relax(phases);
      if (treeContacts.any()) {
        beforeJoints();
        treeContacts.relax();
        jointSolver.absorb();
        afterJoints();
      }
      limit(dt, false);
    }
    if (jointsToo) {
      phases.run();
      jointSolver.limit(solverBodies, contacts, dt, false, true);
    }
    begins(StepStage.FINISH);
    contactSolver.store(phases);
    jointSolver.store(); // reads poses as they were, and nothing that contacts store
    solverBodies.store(phases);
    phases.run();
  }

  /** Takes what springs have got by bodies that were put back out of the motion of these. */
  void payStretch() {
    if (jointSolver.count() > 0 && solverBodies.putBackCount() > 0) {
      jointSolver.payStretch(solverBodies);
    }
  }

  /**
   * Ends the phases so far, and remembers velocities: the changes by joints aren't the contacts'.
   */
  private void beforeJoints() {
    phases.run();
    begins(StepStage.JOINTS);
    solverBodies.rememberVelocities();
  }

  private void afterJoints() {
    solverBodies.afterJoints();
  }

  /** Takes energy away from what joints in trouble hold together, if there is more than can be. */
  private void limit(float dt, boolean moves) {
    if (jointSolver.anyTroubled()) {
      beforeJoints();
      jointSolver.limit(solverBodies, contacts, dt, moves, false);
      afterJoints();
    }
  }

  /** Begins a stage. Where stages are measured, each ends before the next one begins. */
  private void begins(StepStage stage) {
    if (stages != null) {
      phases.run();
      stages.begins(stage);
    }
  }
}
