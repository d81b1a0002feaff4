package carom.server.replication;

import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.table.JointWords;
import carom.net.snapshot.table.RowAudience;
import carom.physics.Body;
import carom.physics.Joint;
import carom.sim.entity.HostEntity;

/** Says which joints one client is told: those of which it sees both bodies. The room's thread. */
final class JointAudience implements RowAudience {
  private final FrameCapture capture;
  private final SessionView view;

  JointAudience(FrameCapture capture, SessionView view) {
    this.capture = capture;
    this.view = view;
  }

  @Override
  public long inSight(int table, int block, long keys) {
    long seen = 0;
    for (long rest = keys; rest != 0; rest &= rest - 1) {
      long bit = Long.lowestOneBit(rest);
      seen |= sees((block << 6) + Long.numberOfTrailingZeros(rest)) ? bit : 0;
    }
    return seen;
  }

  @Override
  public int of(int table, int key) {
    return JointWords.KNOWS;
  }

  /** Returns whether the client sees both bodies of a joint. That a joint is gone is no secret. */
  private boolean sees(int index) {
    Joint<HostEntity> joint = capture.joints().get(index);
    return joint == null || (sees(joint.bodyA()) && sees(joint.bodyB()));
  }

  private boolean sees(Body<HostEntity> body) {
    HostEntity e = body == null ? null : body.user();
    FrameState frame = capture.frames().newest();
    return e == null || e.isLevel() || view.sees(frame, e.id(), true);
  }
}
