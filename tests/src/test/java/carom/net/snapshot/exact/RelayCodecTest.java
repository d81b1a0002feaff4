package carom.net.snapshot.exact;

import static org.junit.jupiter.api.Assertions.assertEquals;

import carom.net.codec.BitPass;
import carom.net.codec.SectionCheck;
import carom.net.snapshot.frame.FrameRing;
import carom.net.snapshot.frame.PlayerSet;
import carom.net.snapshot.frame.WaitingInputs;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Relayed inputs: written, measured and read alike. */
class RelayCodecTest {
  private static final int TICKS = 40;
  private static final int PLAYERS = 300;

  private final Random random = new Random(75);
  private final RelayCodec codec = new RelayCodec();
  private FrameRing ring;
  private int window;
  private PlayerSet known;
  private PlayerSet players;
  private OwnState own;
  private RelayedInputs held;

  /** What one side has of the section: by player, the inputs up to the last that waits. */
  private static final class Inputs {
    final long[] read = new long[RelayCodec.maxInputs()];
    final byte[] past = new byte[1_024];
    final byte[] waiting = new byte[1_024];
    boolean isRead;
  }

  private long next(long input) {
    return switch (random.nextInt(12)) {
      case 0 -> random.nextLong() >>> 16;
      case 1 -> input ^ 1L << random.nextInt(5);
      case 2 -> input ^ 1L << random.nextInt(48);
      default -> input;
    };
  }

  private void set() {
    ring = new FrameRing(4);
    held = new RelayedInputs();
    window = RelayCodec.window(random.nextInt(RelayCodec.MAX_WINDOW + 4));
    known = players();
    players = players();
    own = new OwnState();
    for (int p = players.next(0); p >= 0; p = players.next(p + 1)) {
      own.relay(p, TICKS - random.nextInt(Math.min(TICKS, RelayCodec.MAX_WINDOW + 4)));
    }
    long[] input = new long[PLAYERS];
    for (int tick = 1; tick <= TICKS; tick++) {
      var frame = ring.begin(tick);
      for (int p = players.next(0); p >= 0; p = players.next(p + 1)) {
        input[p] = p % 3 == 0 ? 7 : next(input[p]);
        frame.putInput(p, input[p]);
        if (tick <= TICKS - window) {
          held.put(p, tick, input[p]);
        }
      }
      ring.end();
    }
    for (int p = players.next(0); p >= 0; p = players.next(p + 1)) {
      for (int n = random.nextInt(WaitingInputs.MOST + 1); n > 0; n--) {
        input[p] = p % 3 == 0 ? 7 : next(input[p]);
        ring.waiting().add(p, input[p]);
      }
    }
  }

  private PlayerSet players() {
    PlayerSet set = new PlayerSet();
    for (int n = random.nextInt(RelayCodec.MAX_PLAYERS + 1); n > 0; n--) {
      set.add(random.nextBoolean() ? random.nextInt(12) : random.nextInt(PLAYERS));
    }
    return set;
  }

  private void code(BitPass c, Inputs inputs) {
    if (c.isReading()) {
      inputs.isRead = true;
      codec.read(c, held, TICKS, window, known, players, inputs.read, inputs.past, inputs.waiting);
    } else {
      codec.write(c, ring, window, known, own);
    }
  }

  /** All inputs of all players; an unchanged player's last one stands for those that wait. */
  private String text(Inputs inputs) {
    StringBuilder out = new StringBuilder();
    int at = 0;
    for (int p = players.next(0); p >= 0; p = players.next(p + 1)) {
      int all = TICKS - own.relayedSince(p) + 1;
      int since = all <= RelayCodec.MAX_WINDOW ? all : 1;
      boolean isKnown = window > 0 && known.has(p) && own.relayedSince(p) <= TICKS - window;
      int told = isKnown ? window : since;
      int ticks = inputs.isRead ? inputs.past[p] : told;
      int waiting = inputs.isRead ? inputs.waiting[p] : ring.waiting().count(p);
      out.append('\n').append(p).append(':');
      long last = 0;
      for (int i = 0; i < ticks + WaitingInputs.MOST; i++) {
        if (i < ticks + waiting) {
          int tick = TICKS - ticks + 1 + i;
          last = inputs.isRead ? inputs.read[at + i] : inputAt(p, tick);
        }
        out.append(' ').append(last);
      }
      at += ticks + waiting;
    }
    return out.toString();
  }

  private long inputAt(int player, int tick) {
    return tick <= TICKS ? ring.at(tick).input(player) : ring.waiting().at(player, tick - TICKS);
  }

  @Test
  void whatIsWrittenIsMeasuredAndRead() {
    SectionCheck<Inputs> check = new SectionCheck<>(this::code, Inputs::new, this::text);
    for (int i = 0; i < 60; i++) {
      set();
      check.check(new Inputs());
      check.hostile(random, 20);
    }
  }

  @Test
  void whoIsRelayedIsWrittenMeasuredAndRead() {
    SectionCheck<PlayerSet> check =
        new SectionCheck<>(RelayCodec::players, this::players, RelayCodecTest::list);
    for (int i = 0; i < 200; i++) {
      check.check(players());
    }
    assertEquals(5, check.check(new PlayerSet()));
    check.hostile(random, 500);
  }

  private static String list(PlayerSet players) {
    StringBuilder out = new StringBuilder();
    for (int p = players.next(0); p >= 0; p = players.next(p + 1)) {
      out.append(' ').append(p);
    }
    return out.toString();
  }
}
