package carom.lab.figures.wire;

import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.physics.Body;
import java.util.List;

/** Puts bodies of a scene into frames as a server does with entities. */
final class Frames {
  private static final int NO_OWNER = -1;

  private Frames() {}

  /** Captures the frame of a tick, with body n in slot n. */
  static void put(FrameRing ring, int tick, List<Body<String>> bodies) {
    FrameState frame = ring.begin(tick);
    for (int i = 0; i < bodies.size(); i++) {
      put(frame, i, bodies.get(i));
    }
    ring.end();
  }

  /** Puts one body into a frame under construction. */
  static void put(FrameState frame, int slot, Body<String> body) {
    frame.put(
        slot,
        1,
        1,
        NO_OWNER,
        body.x(),
        body.y(),
        body.angle(),
        body.velocityX(),
        body.velocityY(),
        body.angularVelocity());
  }
}
