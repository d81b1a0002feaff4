package carom.net.snapshot.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import carom.net.codec.BitMeter;
import carom.net.codec.BitPass;
import carom.net.codec.Quantizer;
import carom.net.codec.SectionCheck;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** The events section: written, measured and read alike. */
class EventCodecTest {
  private static final int TICK = 5_000;

  private final Random random = new Random(72);
  private final EventCodec codec = new EventCodec();

  /** All events of a section. */
  private static final class Section {
    int sequence;
    int outstanding;
    int count;
    final int[] places = new int[EventCodec.WINDOW];
    final EventRecord[] events = new EventRecord[EventCodec.WINDOW];

    Section() {
      for (int i = 0; i < events.length; i++) {
        events[i] = new EventRecord();
      }
    }
  }

  private void code(BitPass c, Section s) {
    codec.begin(c, TICK, s.sequence, s.outstanding);
    s.sequence = codec.sequence();
    s.outstanding = codec.outstanding();
    int written = c.isReading() ? 0 : s.count;
    s.count = 0;
    if (s.outstanding == 0) {
      return;
    }
    boolean more;
    do {
      more = s.count < written;
      int at = Math.min(s.count, EventCodec.WINDOW - 1);
      more = codec.next(c, more, s.places[at], s.events[at]);
      if (more) {
        s.places[s.count++] = codec.place();
      }
    } while (more);
  }

  private Section section() {
    Section s = new Section();
    s.outstanding = random.nextInt(4) == 0 ? 0 : 1 + random.nextInt(512);
    s.sequence = s.outstanding == 0 ? 0 : random.nextInt(1 << 16);
    int tick = random.nextInt(TICK);
    double density = random.nextDouble();
    for (int place = 0; place < Math.min(s.outstanding, EventCodec.WINDOW); place++) {
      if (random.nextDouble() < density && s.count < 5) {
        s.places[s.count] = place;
        fill(s.events[s.count++], tick);
        tick += random.nextBoolean() ? 0 : random.nextInt(TICK + 1 - tick);
      }
    }
    return s;
  }

  private void fill(EventRecord e, int tick) {
    e.kind = random.nextInt(256);
    e.tick = tick;
    e.player = random.nextBoolean() ? EventRecord.NONE : random.nextInt(1_024);
    e.first = entity();
    e.second = entity();
    e.place((float) (100 * random.nextGaussian()), (float) (1e5 * random.nextGaussian()));
    e.strength(random.nextBoolean() ? 0 : (float) (10 * random.nextGaussian()));
    e.data = random.nextInt() >> random.nextInt(32);
  }

  private int entity() {
    return switch (random.nextInt(3)) {
      case 0 -> EventRecord.NONE;
      case 1 -> random.nextInt(1 << 16);
      default -> random.nextInt(1 << 24);
    };
  }

  private static String text(Section s) {
    StringBuilder out = new StringBuilder(s.sequence + " " + s.outstanding);
    for (int i = 0; i < s.count; i++) {
      EventRecord e = s.events[i];
      out.append('\n').append(s.places[i]).append(": ").append(e.kind).append(' ').append(e.tick);
      out.append(' ').append(e.player).append(' ').append(e.first).append(' ').append(e.second);
      out.append(' ').append(e.x).append(' ').append(e.y).append(' ').append(e.strength);
      out.append(' ').append(e.data);
    }
    return out.toString();
  }

  @Test
  void whatIsWrittenIsMeasuredAndRead() {
    SectionCheck<Section> check =
        new SectionCheck<>(this::code, this::section, EventCodecTest::text);
    for (int i = 0; i < 200; i++) {
      check.check(section());
    }
    check.hostile(random, 2_000);
  }

  @Test
  void theLargestEventTakesNoMoreThanIsSetAsideForIt() {
    EventRecord e = new EventRecord();
    e.kind = 255;
    e.player = 1_023;
    e.first = (1 << 24) - 1;
    e.second = e.first;
    e.x = Quantizer.MAX_POSITION;
    e.y = -Quantizer.MAX_POSITION;
    e.strength(Float.MAX_VALUE);
    e.data = Integer.MIN_VALUE;
    BitMeter meter = new BitMeter();
    codec.begin(meter, Integer.MAX_VALUE, 0, 512);
    int before = meter.bits();
    assertTrue(codec.next(meter, true, EventCodec.WINDOW - 1, e));
    assertTrue(meter.bits() - before <= EventCodec.MAX_BITS, "bits=" + (meter.bits() - before));
    before = meter.bits();
    codec.next(meter, false, 0, e);
    assertEquals(EventCodec.END_BITS, meter.bits() - before);
  }
}
