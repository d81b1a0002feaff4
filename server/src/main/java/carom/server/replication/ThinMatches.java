package carom.server.replication;

import carom.physics.Body;
import carom.physics.geometry.Convex;
import carom.physics.geometry.Shape;
import carom.server.thin.ThinServerMessage;
import carom.server.thin.ThinServerMessage.Archetype;
import carom.server.thin.ThinServerMessage.EventLook;
import carom.server.thin.ThinServerMessage.Gauge;
import carom.server.thin.ThinServerMessage.Ground;
import carom.server.thin.ThinServerMessage.Joint;
import carom.server.thin.ThinServerMessage.Kind;
import carom.server.thin.ThinServerMessage.Part;
import carom.server.thin.ThinServerMessage.Team;
import carom.server.thin.ThinServerMessage.Theme;
import carom.server.thin.ThinServerMessage.Zone;
import carom.sim.SimulationHost;
import carom.sim.entity.HostEntity;
import carom.sim.event.EventKind;
import carom.sim.field.Field;
import carom.sim.field.Ratio;
import carom.sim.level.Appearance;
import carom.sim.level.Area;
import carom.sim.level.Level;
import carom.sim.message.MessageKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.IntPredicate;

/** Describes a match to thin clients, which have neither its level nor its game. */
final class ThinMatches {
  private ThinMatches() {}

  /** Returns the description for a player; the room's thread, once per link and match. */
  static ThinServerMessage.Match of(SimulationHost s, int player, String room) {
    Level.Bounds bounds = s.level().bounds();
    return new ThinServerMessage.Match(
        player,
        s.tick(),
        room,
        s.game().name(),
        s.level().name(),
        List.of(bounds.minX(), bounds.minY(), bounds.maxX(), bounds.maxY()),
        List.of(s.level().gravityX(), s.level().gravityY()),
        theme(s.level().theme()),
        zones(s.level()),
        archetypes(s),
        ground(s),
        events(s),
        gauges(s),
        teams(s),
        messages(s));
  }

  private static Theme theme(Level.Theme theme) {
    return new Theme(theme.background(), theme.sky(), theme.grid());
  }

  private static List<Zone> zones(Level level) {
    List<Zone> all = new ArrayList<>();
    for (Area area : level.areas()) {
      all.add(new Zone("", area.minX(), area.minY(), area.maxX(), area.maxY(), area.rgb()));
    }
    for (Level.Zone zone : level.zones()) {
      all.add(
          new Zone(zone.name(), zone.minX(), zone.minY(), zone.maxX(), zone.maxY(), zone.rgb()));
    }
    return all;
  }

  /**
   * Returns the joints of which a client sees both bodies.
   *
   * @param sees tells whether the client sees an entity
   */
  static ThinServerMessage.Joints joints(SimulationHost s, IntPredicate sees) {
    List<Joint> all = new ArrayList<>();
    for (int i = 0; i < s.joints().limit(); i++) {
      carom.physics.Joint<HostEntity> joint = s.joints().get(i);
      if (joint == null || !sees(joint.bodyA(), sees) || !sees(joint.bodyB(), sees)) {
        continue;
      }
      all.add(
          new Joint(
              joint.type().name(),
              entity(joint.bodyA()),
              entity(joint.bodyB()),
              localX(joint.bodyA(), joint.anchorAX(), joint.anchorAY()),
              localY(joint.bodyA(), joint.anchorAX(), joint.anchorAY()),
              localX(joint.bodyB(), joint.anchorBX(), joint.anchorBY()),
              localY(joint.bodyB(), joint.anchorBX(), joint.anchorBY())));
    }
    return new ThinServerMessage.Joints(all);
  }

  /** Returns the entity that a thin client knows a body by, or -1 for what never moves. */
  private static int entity(Body<HostEntity> body) {
    HostEntity e = body == null ? null : body.user();
    return e == null || e.isLevel() ? -1 : e.id();
  }

  private static boolean sees(Body<HostEntity> body, IntPredicate sees) {
    return entity(body) < 0 || sees.test(entity(body));
  }

  private static float localX(Body<HostEntity> body, float x, float y) {
    return entity(body) < 0 ? x : body.cos() * (x - body.x()) + body.sin() * (y - body.y());
  }

  private static float localY(Body<HostEntity> body, float x, float y) {
    return entity(body) < 0 ? y : body.cos() * (y - body.y()) - body.sin() * (x - body.x());
  }

  private static List<Archetype> archetypes(SimulationHost s) {
    List<Archetype> all = new ArrayList<>();
    for (int i = 0; i < s.archetypes().size(); i++) {
      all.add(archetype(s.archetypes().get(i)));
    }
    return all;
  }

  private static Archetype archetype(carom.sim.level.Archetype kind) {
    List<Part> parts = new ArrayList<>();
    kind.shapes().forEach(shape -> addParts(shape, parts));
    Appearance look = kind.appearance();
    return new Archetype(
        kind.name(), look.rgb(), look.outlineRgb(), look.look().name(), kind.sensor(), parts);
  }

  private static void addParts(Shape shape, List<Part> to) {
    for (Convex part : shape.parts()) {
      List<Float> corners = new ArrayList<>(2 * part.vertexCount());
      for (int i = 0; i < part.vertexCount(); i++) {
        corners.add(part.vertexX(i));
        corners.add(part.vertexY(i));
      }
      to.add(new Part(part.radius(), corners));
    }
  }

  private static List<Ground> ground(SimulationHost s) {
    List<Ground> all = new ArrayList<>();
    for (int slot = 0; slot < s.world().slotCount(); slot++) {
      Body<HostEntity> body = s.world().body(slot);
      if (body != null && body.user() != null && body.user().isLevel()) {
        all.add(new Ground(body.x(), body.y(), body.angle(), archetype(body.user().archetype())));
      }
    }
    return all;
  }

  private static List<EventLook> events(SimulationHost s) {
    List<EventLook> all = new ArrayList<>();
    for (int i = 0; i < s.eventKinds().size(); i++) {
      EventKind kind = s.eventKinds().get(i);
      all.add(
          new EventLook(
              kind.name(),
              kind.rgb(),
              kind.radius(),
              kind.label(),
              kind.sound().name(),
              kind.fullStrength()));
    }
    return all;
  }

  private static List<Gauge> gauges(SimulationHost s) {
    List<Gauge> all = new ArrayList<>();
    for (carom.sim.field.Gauge gauge : s.game().gauges()) {
      Field<?> field = gauge.field();
      boolean ratio = field instanceof Ratio;
      all.add(
          new Gauge(
              gauge.kind().name(),
              gauge.label(),
              field.scope().holder().name().toLowerCase(Locale.ROOT),
              field.name(),
              ratio ? 0 : field.min(),
              ratio ? 1 : field.max()));
    }
    return all;
  }

  private static List<Team> teams(SimulationHost s) {
    List<Team> all = new ArrayList<>();
    for (int i = 0; i < s.game().teams().size(); i++) {
      all.add(new Team(s.game().teams().get(i), s.game().teamRgb(i + 1)));
    }
    return all;
  }

  private static List<Kind> messages(SimulationHost s) {
    List<Kind> all = new ArrayList<>();
    for (MessageKind kind : s.messageKinds().own()) {
      String from =
          switch (kind.direction()) {
            case FROM_CLIENT -> "client";
            case FROM_SERVER -> "server";
            case BOTH -> "both";
          };
      all.add(new Kind(kind.name(), from, kind.argumentLines()));
    }
    return all;
  }
}
