package carom.net.snapshot;

import carom.net.codec.Quantizer;
import carom.net.snapshot.exact.OwnState;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.FrameState;
import carom.net.snapshot.frame.WaitingInputs;
import java.util.ArrayList;
import java.util.List;

/**
 * A made-up world that feeds a {@link FrameRing}: bodies that rest, fly, fall, bounce, spawn, die,
 * change their owner, and slots that are used again. It remembers every tick, as the oracle.
 */
final class Scene {

  static final int PLAYERS = 256;
  static final int TICK_RATE = 60;
  static final int FIELDS = 9;

  /** Steps of a velocity per m/s. */
  private static final int SPEED_STEPS = 8;

  private static final int MAX_SPEED = 1 << 14;

  final FrameRing ring;
  final int slots;
  final Dice dice;
  final List<int[][]> past = new ArrayList<>();
  final int firstTick;
  int tick;

  // By slot: null = free, else generation, archetype, owner, x, y, angle, vx, vy, omega.
  int[][] bodies;
  final int[] generation;
  double spawnPercent = 2;
  double diePercent = 0.3;
  double wakePercent = 2;
  double stopPercent = 4;
  int gravity;

  Scene(int slots, int firstTick, long seed) {
    this.slots = slots;
    this.firstTick = firstTick;
    tick = firstTick - 1;
    ring = new FrameRing(slots);
    dice = new Dice(seed);
    bodies = new int[slots][];
    generation = new int[slots];
  }

  void spawn(int slot) {
    generation[slot] = (generation[slot] + 1) & 0xff;
    int limit = dice.percent(5) ? Quantizer.MAX_POSITION : 40 * Quantizer.POSITION_STEPS;
    bodies[slot] =
        new int[] {
          generation[slot],
          dice.percent(80) ? dice.below(60) : dice.below(65_536),
          dice.percent(70) ? -1 : dice.below(256),
          dice.between(-limit, limit),
          dice.between(-limit, limit),
          dice.below(1024),
          0,
          0,
          0
        };
    if (dice.percent(50)) {
      push(slot);
    }
  }

  void push(int slot) {
    int speed = dice.percent(3) ? MAX_SPEED : 10 * SPEED_STEPS;
    bodies[slot][6] = dice.between(-speed, speed);
    bodies[slot][7] = dice.between(-speed, speed);
    bodies[slot][8] = dice.between(-12, 12);
  }

  void step() {
    tick++;
    for (int slot = 0; slot < slots; slot++) {
      int[] body = bodies[slot];
      if (body == null) {
        if (dice.percent(spawnPercent)) {
          spawn(slot);
        }
      } else if (dice.percent(diePercent)) {
        bodies[slot] = null;
        if (dice.percent(30)) {
          spawn(slot);
        }
      } else {
        move(slot, body);
      }
    }
    capture();
  }

  private void move(int slot, int[] body) {
    boolean moving = (body[6] | body[7] | body[8]) != 0;
    if (!moving) {
      if (dice.percent(wakePercent)) {
        push(slot);
      }
      return;
    }
    if (dice.percent(stopPercent)) {
      body[6] = 0;
      body[7] = 0;
      body[8] = 0;
      return;
    }
    if (dice.percent(3)) {
      push(slot);
    }
    if (dice.percent(0.2)) {
      body[2] = dice.below(256);
    }
    body[7] -= gravity;
    body[3] =
        clamp(body[3] + body[6] * 64 / TICK_RATE + dice.between(-1, 1), Quantizer.MAX_POSITION);
    body[4] =
        clamp(body[4] + body[7] * 64 / TICK_RATE + dice.between(-1, 1), Quantizer.MAX_POSITION);
    body[5] = (body[5] + body[8] * 41 / TICK_RATE) & 1023;
    body[7] = clamp(body[7], MAX_SPEED);
  }

  private static boolean isStill(int[] body) {
    return (body[6] | body[7] | body[8]) == 0;
  }

  private static int clamp(int value, int max) {
    return Math.max(-max, Math.min(max, value));
  }

  void capture() {
    FrameState frame = ring.begin(tick);
    int[][] copy = new int[slots][];
    for (int slot = 0; slot < slots; slot++) {
      int[] b = bodies[slot];
      if (b != null) {
        frame.putQuantized(slot, b[0], b[1], b[2], b[3], b[4], b[5], isStill(b));
        copy[slot] = b.clone();
      }
    }
    for (int player = 0; player < PLAYERS; player++) {
      frame.putInput(player, input(player, tick));
      int waiting = (tick / 3 + 5 * player) % (WaitingInputs.MOST + 1);
      for (int ahead = 1; ahead <= waiting; ahead++) {
        ring.waiting().add(player, input(player, tick + ahead));
      }
    }
    ring.end();
    past.add(copy);
  }

  /** What a slot was at a tick: null when free. */
  int[] truth(int slot, int atTick) {
    return past.get(atTick - firstTick)[slot];
  }

  /** The input of a player at a tick, made up: held for a while, then another. */
  static long input(int player, int tick) {
    long held = tick / (1 + player % 9) * 0x9e3779b97f4a7c15L ^ player;
    return switch (player % 4) {
      case 0 -> held & 0x1f;
      case 1 -> held & 0xffff_0000L;
      case 2 -> held & FrameState.INPUT_MASK;
      default -> player;
    };
  }

  /** The exact own state a player would have at a tick, made up from the tick. */
  static void own(int tick, OwnState own) {
    if (tick % 200 < 20) {
      own.clearBody();
    } else {
      int still = tick % 100 < 40 ? tick - tick % 100 : tick;
      own.setBody(
          tick / 1000 % 300,
          tick / 1000 % 256,
          still * 0.137f,
          -still * 1.7e-3f,
          (float) Math.cos(still * 0.01),
          (float) Math.sin(still * 0.01),
          still % 7 - 3.3f,
          -0.0f,
          still % 3 == 0 ? Float.MIN_VALUE : 1e4f * still);
    }
    own.relayed().clear();
    for (int i = 0; i < tick / 30 % 32; i++) {
      own.relay((tick / 60 + 7 * i) % PLAYERS, tick / 60 * 60);
    }
    own.setWord(0, tick / 50);
    own.setWord(1, -1);
    own.setWord(2, Integer.MIN_VALUE + tick);
    own.setWord(3, 0);
  }
}
