package carom.server.replication;

import carom.net.codec.Quantizer;
import carom.net.snapshot.frame.EventRecord;
import carom.net.snapshot.frame.EventRing;
import carom.server.thin.ThinNews;
import carom.server.thin.ThinServerMessage;
import carom.sim.near.Neighbourhood;
import java.util.Arrays;

/** A room's events as thin clients are told them, made once for all of them. The room's thread. */
final class ThinEvents {
  private static final int SIZE = 256; // a power of two; more than a tick has
  private static final long NONE = -1;

  private final EventRing events;
  private final ThinNews[] news = new ThinNews[SIZE];
  private final long[] number = new long[SIZE];

  ThinEvents(EventRing events) {
    this.events = events;
    Arrays.fill(number, NONE);
  }

  /** Returns a kept event, see {@link EventRing#holds}. */
  ThinNews at(long event) {
    int place = (int) event & SIZE - 1;
    if (number[place] != event) {
      number[place] = event;
      news[place] = new ThinNews(of(events.at(event)));
    }
    return news[place];
  }

  private static ThinServerMessage.Event of(EventRecord e) {
    return new ThinServerMessage.Event(
        e.kind,
        e.tick,
        Quantizer.positionOf(e.x),
        Quantizer.positionOf(e.y),
        e.strengthOf(),
        e.player,
        idOf(e.first),
        idOf(e.second),
        e.data);
  }

  private static int idOf(int key) {
    return key < 0 ? EventRecord.NONE : Neighbourhood.id(key);
  }
}
