package carom.server.thin.plain;

import carom.server.thin.GameClasses;
import carom.server.thin.GameClasses.GameClass;
import carom.server.thin.GameClasses.GameField;
import carom.server.thin.ThinServerMessage;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;

/**
 * Encodes messages as frames of KryoNet: four bytes of length, the number of a class of {@code
 * carom.plain}, and its fields, sorted by name. Lists that are too long for one frame go on in
 * further ones. One thread at a time.
 */
final class PlainEncoder {
  /**
   * Largest frame, bytes without the length: that of a client with {@code new Client(65536,
   * 65536)}, and some to spare.
   */
  static final int MAX_FRAME_BYTES = 60_000;

  /** Bytes of a class number, a list's length and small fields, at most. */
  private static final int HEAD_BYTES = 64;

  /** Pieces of a body that never moves in one message; the rest is another body at its place. */
  private static final int MOST_PARTS = 500;

  private final KryoOutput scratch = new KryoOutput();
  private GameClasses classes;
  private int matches;

  /** Writes the game's messages by classes that the client has; null by name. */
  void use(GameClasses ofGame) {
    classes = ofGame;
  }

  /** Returns the number of the newest match that was written, from 1; 0 before the first. */
  int matches() {
    return matches;
  }

  /** Appends a message to what is sent by TCP. */
  void encode(KryoOutput out, ThinServerMessage message) {
    if (message instanceof ThinServerMessage.Match m) {
      matches++;
      match(out, m);
    } else if (message instanceof ThinServerMessage.Roster m) {
      roster(out, m);
    } else if (message instanceof ThinServerMessage.Fields m) {
      List<List<ThinServerMessage.FieldValue>> pieces = pieces(m.values(), PlainEncoder::field);
      for (List<ThinServerMessage.FieldValue> piece : pieces) {
        int begin = begin(out, PlainIds.FIELDS);
        list(out, piece, PlainEncoder::field);
        end(out, begin);
      }
    } else if (message instanceof ThinServerMessage.Joints m) {
      List<List<ThinServerMessage.Joint>> pieces = pieces(m.joints(), PlainEncoder::joint);
      for (int i = 0; i < pieces.size(); i++) {
        int begin = begin(out, PlainIds.JOINTS);
        list(out, pieces.get(i), PlainEncoder::joint);
        out.whole(i);
        out.whole(pieces.size());
        end(out, begin);
      }
    } else if (message instanceof ThinServerMessage.Rooms m) {
      rooms(out, m);
    } else if (message instanceof ThinServerMessage.Best m) {
      int begin = begin(out, PlainIds.BEST);
      list(out, m.lists(), PlainEncoder::bestList); // at most 16 of 10: 12,000 bytes
      end(out, begin);
    } else if (message instanceof ThinServerMessage.Custom m) {
      GameClass own = classes == null ? null : classes.find(m.kind());
      int begin = begin(out, own == null ? PlainIds.CUSTOM : PlainIds.FIRST_OF_GAME + own.number());
      if (own == null) {
        out.text(m.kind());
        values(out, m.values());
      } else {
        ofGame(out, own, m.values());
      }
      end(out, begin);
    } else {
      small(out, message);
    }
  }

  private static void small(KryoOutput out, ThinServerMessage message) {
    int begin;
    if (message instanceof ThinServerMessage.Welcome m) {
      begin = begin(out, PlainIds.WELCOME);
      out.whole(m.rate());
      out.whole(m.secret());
      out.whole(m.tickRate());
      out.whole(m.version());
    } else if (message instanceof ThinServerMessage.Refused m) {
      begin = begin(out, PlainIds.REFUSED);
      out.text(m.reason());
      out.text(m.text());
    } else if (message instanceof ThinServerMessage.Goodbye m) {
      begin = begin(out, PlainIds.GOODBYE);
      out.text(m.reason());
      out.text(m.text());
    } else if (message instanceof ThinServerMessage.Redirect m) {
      begin = begin(out, PlainIds.REDIRECT);
      out.text(m.room());
      out.text(m.server());
      out.text(m.token());
    } else if (message instanceof ThinServerMessage.Standby m) {
      begin = begin(out, PlainIds.STANDBY);
      out.text(m.server());
    } else if (message instanceof ThinServerMessage.Scores m) {
      begin = begin(out, PlainIds.SCORES);
      wholes(out, m.scores());
    } else if (message instanceof ThinServerMessage.Chat m) {
      begin = begin(out, PlainIds.CHAT);
      out.whole(m.player());
      out.flag(m.team());
      out.text(m.text());
    } else if (message instanceof ThinServerMessage.Emote m) {
      begin = begin(out, PlainIds.EMOTE);
      out.text(m.emote());
      out.whole(m.player());
    } else if (message instanceof ThinServerMessage.Event m) {
      begin = begin(out, PlainIds.EVENT);
      out.whole(m.data());
      out.whole(m.first());
      out.whole(m.kind());
      out.whole(m.player());
      out.whole(m.second());
      out.real(m.strength());
      out.whole(m.tick());
      out.real(m.x());
      out.real(m.y());
    } else {
      return; // the classes of this version don't have it
    }
    end(out, begin);
  }

  /** Appends KryoNet's own message that tells the number of the connection. */
  static void registerTcp(KryoOutput out, int id) {
    int begin = begin(out, PlainIds.REGISTER_TCP);
    out.whole(id);
    end(out, begin);
  }

  /** Appends KryoNet's own message that ends its {@code connect}. */
  static void registerUdp(KryoOutput out, int id) {
    int begin = begin(out, PlainIds.REGISTER_UDP);
    out.whole(id);
    end(out, begin);
  }

  /** Appends KryoNet's own question how long the way is, or the answer. */
  static void ping(KryoOutput out, int id, boolean isReply) {
    int begin = begin(out, PlainIds.PING);
    out.whole(id);
    out.flag(isReply);
    end(out, begin);
  }

  private static int begin(KryoOutput out, int id) {
    int place = out.length();
    out.fixed(0);
    out.count(id);
    return place;
  }

  private static void end(KryoOutput out, int begin) {
    out.fixedAt(begin, out.length() - begin - 4);
  }

  private void match(KryoOutput out, ThinServerMessage.Match m) {
    List<ThinServerMessage.Ground> ground = new ArrayList<>();
    m.ground().forEach(g -> cut(g, ground));
    scratch.truncate(0);
    matchTail(scratch, m, 0);
    int tail = scratch.length() + HEAD_BYTES;
    List<List<ThinServerMessage.Archetype>> kinds = new ArrayList<>();
    List<List<ThinServerMessage.Ground>> grounds = new ArrayList<>();
    int used = fill(m.archetypes(), PlainEncoder::archetype, kinds, tail);
    while (grounds.size() < kinds.size() - 1) {
      grounds.add(List.of());
    }
    fill(ground, PlainEncoder::ground, grounds, used);
    while (kinds.size() < grounds.size()) {
      kinds.add(List.of());
    }
    int begin = begin(out, PlainIds.MATCH);
    list(out, kinds.get(0), PlainEncoder::archetype);
    reals(out, m.bounds());
    list(out, m.events(), PlainEncoder::eventLook);
    out.text(m.game());
    list(out, m.gauges(), PlainEncoder::gauge);
    reals(out, m.gravity());
    list(out, grounds.get(0), PlainEncoder::ground);
    matchEnd(out, m, kinds.size() - 1);
    end(out, begin);
    for (int i = 1; i < kinds.size(); i++) {
      int more = begin(out, PlainIds.MORE);
      list(out, kinds.get(i), PlainEncoder::archetype);
      list(out, grounds.get(i), PlainEncoder::ground);
      end(out, more);
    }
  }

  /** Writes all but the long lists, to know the size. */
  private void matchTail(KryoOutput out, ThinServerMessage.Match m, int more) {
    reals(out, m.bounds());
    list(out, m.events(), PlainEncoder::eventLook);
    out.text(m.game());
    list(out, m.gauges(), PlainEncoder::gauge);
    reals(out, m.gravity());
    matchEnd(out, m, more);
  }

  private void matchEnd(KryoOutput out, ThinServerMessage.Match m, int more) {
    out.text(m.level());
    list(out, m.messages(), PlainEncoder::kind);
    out.whole(more);
    out.whole(matches);
    out.whole(m.player());
    out.text(m.room());
    list(out, m.teams(), PlainEncoder::team);
    out.flag(true); // the theme isn't null
    out.whole(m.theme().background());
    out.whole(m.theme().grid());
    out.whole(m.theme().sky());
    out.whole(m.tick());
    list(out, m.zones(), PlainEncoder::zone);
  }

  private static void cut(ThinServerMessage.Ground g, List<ThinServerMessage.Ground> to) {
    List<ThinServerMessage.Part> parts = g.kind().parts();
    if (parts.size() <= MOST_PARTS) {
      to.add(g);
      return;
    }
    for (int i = 0; i < parts.size(); i += MOST_PARTS) {
      ThinServerMessage.Archetype k = g.kind();
      List<ThinServerMessage.Part> some = parts.subList(i, Math.min(parts.size(), i + MOST_PARTS));
      to.add(
          new ThinServerMessage.Ground(
              g.x(),
              g.y(),
              g.angle(),
              new ThinServerMessage.Archetype(
                  k.name(), k.rgb(), k.outline(), k.look(), k.sensor(), some)));
    }
  }

  private void roster(KryoOutput out, ThinServerMessage.Roster m) {
    List<List<ThinServerMessage.Participant>> pieces = pieces(m.players(), PlainEncoder::player);
    for (int i = 0; i < pieces.size(); i++) {
      int begin = begin(out, PlainIds.ROSTER);
      wholes(out, i == 0 ? m.gone() : List.of());
      list(out, pieces.get(i), PlainEncoder::player);
      end(out, begin);
    }
  }

  private void rooms(KryoOutput out, ThinServerMessage.Rooms m) {
    List<List<ThinServerMessage.Room>> pieces = pieces(m.rooms(), PlainEncoder::room);
    int left = m.left() + m.rooms().size();
    for (List<ThinServerMessage.Room> piece : pieces) {
      left -= piece.size();
      int begin = begin(out, PlainIds.ROOMS);
      out.whole(left);
      list(out, piece, PlainEncoder::room);
      end(out, begin);
    }
  }

  /** Cuts a list so that each piece fits into a frame; an empty list is one piece. */
  private <T> List<List<T>> pieces(List<T> all, BiConsumer<KryoOutput, T> writer) {
    List<List<T>> pieces = new ArrayList<>();
    fill(all, writer, pieces, HEAD_BYTES + 8_192);
    return pieces;
  }

  /**
   * Fills frames with a list, beginning with the last frame that there is.
   *
   * @param used bytes used of that
   * @return bytes used of the frame that is then the last
   */
  private <T> int fill(
      List<T> all, BiConsumer<KryoOutput, T> writer, List<List<T>> pieces, int used) {
    int size = used;
    List<T> piece = new ArrayList<>();
    pieces.add(piece);
    for (T item : all) {
      scratch.truncate(0);
      writer.accept(scratch, item);
      int more = scratch.length() + 1;
      if (size + more > MAX_FRAME_BYTES) {
        piece = new ArrayList<>();
        pieces.add(piece);
        size = HEAD_BYTES;
      }
      piece.add(item);
      size += more;
    }
    return size;
  }

  private static <T> void list(KryoOutput out, List<T> all, BiConsumer<KryoOutput, T> writer) {
    out.count(all.size() + 1);
    for (int i = 0; i < all.size(); i++) {
      out.flag(true); // it isn't null
      writer.accept(out, all.get(i));
    }
  }

  private static void wholes(KryoOutput out, List<Integer> all) {
    out.count(all.size() + 1);
    all.forEach(value -> out.whole((int) value));
  }

  private static void reals(KryoOutput out, List<Float> all) {
    out.count(all.size() + 1);
    all.forEach(out::real);
  }

  private static void archetype(KryoOutput out, ThinServerMessage.Archetype a) {
    out.text(a.look());
    out.text(a.name());
    out.whole(a.outline());
    int most = Math.min(MOST_PARTS, a.parts().size()); // of a body that moves there are fewer
    list(out, a.parts().subList(0, most), PlainEncoder::part);
    out.whole(a.rgb());
    out.flag(a.sensor());
  }

  private static void part(KryoOutput out, ThinServerMessage.Part p) {
    reals(out, p.corners());
    out.real(p.radius());
  }

  private static void ground(KryoOutput out, ThinServerMessage.Ground g) {
    out.real(g.angle());
    out.flag(true); // the kind isn't null
    archetype(out, g.kind());
    out.real(g.x());
    out.real(g.y());
  }

  private static void eventLook(KryoOutput out, ThinServerMessage.EventLook e) {
    out.real(e.fullStrength());
    out.text(e.label());
    out.text(e.name());
    out.real(e.radius());
    out.whole(e.rgb());
    out.text(e.sound());
  }

  private static void gauge(KryoOutput out, ThinServerMessage.Gauge g) {
    out.text(g.field());
    out.text(g.kind());
    out.text(g.label());
    out.real(g.least());
    out.real(g.most());
    out.text(g.scope());
  }

  private static void team(KryoOutput out, ThinServerMessage.Team t) {
    out.text(t.name());
    out.whole(t.rgb());
  }

  private static void zone(KryoOutput out, ThinServerMessage.Zone z) {
    out.real(z.maxX());
    out.real(z.maxY());
    out.real(z.minX());
    out.real(z.minY());
    out.text(z.name());
    out.whole(z.rgb());
  }

  private static void joint(KryoOutput out, ThinServerMessage.Joint j) {
    out.real(j.ax());
    out.real(j.ay());
    out.real(j.bx());
    out.real(j.by());
    out.whole(j.first());
    out.whole(j.second());
    out.text(j.type());
  }

  private static void kind(KryoOutput out, ThinServerMessage.Kind k) {
    out.count(k.arguments().size() + 1);
    k.arguments().forEach(out::text);
    out.text(k.from());
    out.text(k.name());
  }

  private static void player(KryoOutput out, ThinServerMessage.Participant p) {
    out.flag(p.alive());
    out.whole(p.id());
    out.text(p.name());
    out.whole(p.ping());
    out.flag(p.ready());
    out.whole(p.rgb());
    out.whole(p.score());
    out.flag(p.spectator());
    out.whole(p.team());
  }

  private static void room(KryoOutput out, ThinServerMessage.Room r) {
    out.text(r.game());
    values(out, r.info());
    out.text(r.level());
    out.text(r.name());
    out.text(r.phase());
    out.whole(r.places());
    out.whole(r.players());
  }

  private static void bestList(KryoOutput out, ThinServerMessage.BestList b) {
    list(out, b.entries(), PlainEncoder::bestEntry);
    out.text(b.field());
    out.whole(b.own());
  }

  private static void bestEntry(KryoOutput out, ThinServerMessage.BestEntry e) {
    out.text(e.name());
    out.text(e.value());
  }

  private static void field(KryoOutput out, ThinServerMessage.FieldValue f) {
    out.whole(f.id());
    out.text(f.name());
    out.text(f.scope());
    value(out, f.value());
  }

  private static void ofGame(KryoOutput out, GameClass own, Map<String, ?> values) {
    for (GameField field : own.sorted()) {
      Object value = values.get(field.argument().name());
      switch (field.argument().type()) {
        case COUNT, PLAYER, ENTITY -> out.whole((int) value);
        case FLAG -> out.flag((boolean) value);
        case REAL -> out.real((float) value);
        case TEXT -> out.text((String) value);
        case CHOICE -> out.count(1 + field.constants().indexOf(value));
      }
    }
  }

  private static void values(KryoOutput out, Map<String, ?> values) {
    out.count(values.size() + 1);
    values.forEach(
        (name, value) -> {
          out.flag(true); // it isn't null
          out.text(name);
          value(out, value);
        });
  }

  private static void value(KryoOutput out, Object value) {
    if (value == null) {
      out.count(PlainIds.NULL);
    } else if (value instanceof Boolean flag) {
      out.count(PlainIds.BOOLEAN);
      out.flag(flag);
    } else if (value instanceof Integer whole) {
      out.count(PlainIds.INT);
      out.whole(whole);
    } else if (value instanceof Number number) {
      out.count(PlainIds.FLOAT);
      out.real(number.floatValue());
    } else {
      out.count(PlainIds.STRING);
      out.text(value.toString());
    }
  }
}
