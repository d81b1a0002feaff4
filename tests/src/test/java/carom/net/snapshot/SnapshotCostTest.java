package carom.net.snapshot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.suite.Optimized;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;

/**
 * Goal: bytes and allocations stay where they are. Method: measured means with a baseline 100 ms
 * old, allocation counter.
 */
@Optimized("measures what is allocated")
class SnapshotCostTest {

  private static final int BODIES = 300;
  private static final int LAG = 6;

  private final FrameRing ring = new FrameRing(BODIES);
  private final SnapshotEncoder encoder = new SnapshotEncoder(ring, 1, 60);
  private final SnapshotDecoder decoder = new SnapshotDecoder(BODIES, 1, 0, 60);
  private final InputFeedback feedback = new InputFeedback();
  private final OwnState own = new OwnState();
  private final byte[] buffer = new byte[SnapshotEncoder.MAX_DATAGRAM_BYTES];
  private final float[] x = new float[BODIES];
  private final float[] y = new float[BODIES];
  private final float[] vx = new float[BODIES];
  private final float[] vy = new float[BODIES];
  private final float[] angle = new float[BODIES];
  private final float[] omega = new float[BODIES];
  private final int[] ackSequence = new int[LAG];
  private final long[] ackBits = new long[LAG];
  private final Dice dice = new Dice(17);
  private int tick;
  private long records;

  private float random(float range) {
    return dice.between(-10_000, 10_000) * range / 10_000;
  }

  private void scatter() {
    for (int i = 0; i < BODIES; i++) {
      x[i] = random(30);
      y[i] = 20 + random(20);
      vx[i] = random(8);
      vy[i] = random(8);
      omega[i] = random(5);
    }
  }

  /** Free flight with bounces on the ground, light damping, now and then a kick. */
  private void step(float gravity, double kickPercent) {
    float dt = 1 / 60f;
    for (int i = 0; i < BODIES; i++) {
      vy[i] -= gravity * dt;
      vx[i] *= 0.995f;
      vy[i] *= 0.995f;
      omega[i] *= 0.995f;
      if (dice.percent(kickPercent)) {
        vx[i] += random(5);
        vy[i] += random(5);
        omega[i] += random(4);
      }
      x[i] += vx[i] * dt;
      y[i] += vy[i] * dt;
      angle[i] += omega[i] * dt;
      if (y[i] < 0) {
        y[i] = 0;
        vy[i] = -0.8f * vy[i];
      }
    }
  }

  /** Sends one tick; answers its bytes. */
  private int tick() {
    tick++;
    FrameState frame = ring.begin(tick);
    for (int i = 0; i < BODIES; i++) {
      frame.put(i, 1, 3, -1, x[i], y[i], angle[i], vx[i], vy[i], omega[i]);
    }
    ring.end();
    int late = tick % LAG;
    if (tick > LAG) {
      encoder.receiveAck(ackSequence[late], ackBits[late]);
    }
    own.setBody(0, 1, x[0], y[0], 1, 0, vx[0], vy[0], omega[0]);
    feedback.present = true;
    encoder.begin(feedback, own, Integer.MAX_VALUE);
    int sum = 0;
    for (int n; (n = encoder.next(buffer)) > 0; ) {
      sum += n;
      DecodeStatus status = decoder.decode(buffer, 0, n);
      if (status != DecodeStatus.OK) {
        throw new AssertionError(status + " at tick " + tick);
      }
      records += decoder.touchedCount();
    }
    ackSequence[late] = decoder.ackSequence();
    ackBits[late] = decoder.ackBits();
    return sum;
  }

  private double bytesPerRecord(float gravity, double kickPercent) {
    scatter();
    for (int i = 0; i < 60; i++) {
      step(gravity, kickPercent);
      tick();
    }
    records = 0;
    long bytes = 0;
    for (int i = 0; i < 300; i++) {
      step(gravity, kickPercent);
      bytes += tick();
    }
    assertEquals(300 * BODIES, records);
    return (double) bytes / records;
  }

  @Test
  void flyingBodiesTakeFewBytes() {
    double flight = bytesPerRecord(0, 0);
    double gravity = bytesPerRecord(9.81f, 0);
    double topDown = bytesPerRecord(0, 1);
    String figures = "flight=" + flight + " gravity=" + gravity + " topDown=" + topDown;
    assertTrue(flight <= 3.2, figures);
    assertTrue(gravity <= 4.9, figures);
    assertTrue(topDown <= 3.9, figures);
  }

  @Test
  void restIsFree() {
    scatter();
    for (int i = 0; i < 20; i++) {
      tick();
    }
    records = 0;
    int bytes = tick();
    assertEquals(0, records);
    assertTrue(bytes <= 13, "bytes=" + bytes);
    assertTrue(encoder.nothingNew(own));
  }

  @Test
  void aSteadyTickAllocatesNothing() {
    com.sun.management.ThreadMXBean threads =
        (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
    scatter();
    for (int i = 0; i < 400; i++) {
      step(9.81f, 1);
      tick();
    }
    long least = Long.MAX_VALUE;
    for (int round = 0; round < 5; round++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int i = 0; i < 100; i++) {
        step(9.81f, 1);
        tick();
      }
      least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
    }
    assertEquals(0, least, "bytes in 100 ticks of capture, encode, decode");
  }
}
