package carom.server.web;

import carom.physics.geometry.Convex;
import carom.physics.geometry.Shape;
import carom.server.account.BestLists;
import carom.server.command.CommandRegistry;
import carom.server.command.Printable;
import carom.server.fleet.FleetFigures;
import carom.server.match.MatchInfo;
import carom.server.metrics.TurnStage;
import carom.server.room.BodyLook;
import carom.server.room.Room;
import carom.server.session.PlayerInfo;
import carom.sim.level.Level;
import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Locale;

/** The page's messages as text. Each is a JSON object whose field {@code t} says what it is. */
final class PageJson {
  private static final JsonFactory JSON = new JsonFactory();

  /** Seconds of all rooms together that a viewer is first told: a few megabytes of text. */
  private static final int MOST_ROWS = 64 * RoomHistory.ROWS;

  private PageJson() {}

  /** Writes the fields of a message. */
  private interface Fields {
    void write(JsonGenerator g) throws IOException;
  }

  private static String message(String type, Fields fields) {
    StringWriter text = new StringWriter();
    try (JsonGenerator g = JSON.createGenerator(text)) {
      g.writeStartObject();
      g.writeStringField("t", type);
      fields.write(g);
      g.writeEndObject();
    } catch (IOException e) {
      throw new UncheckedIOException("a text can't fail to be written", e);
    }
    return text.toString();
  }

  /** Returns the first message to a viewer, which is sent again once it may see more. */
  static String hello(PageConfig config, List<RoomHistory> rooms, boolean admin, boolean watches) {
    return message(
        "hello",
        g -> {
          g.writeStringField("title", config.title());
          g.writeBooleanField("admin", admin);
          g.writeBooleanField("watches", watches);
          if (!watches) {
            return;
          }
          g.writeArrayFieldStart("columns");
          for (String column : RoomHistory.columns()) {
            g.writeString(column);
          }
          g.writeEndArray();
          g.writeObjectFieldStart("stages");
          for (TurnStage stage : TurnStage.values()) {
            g.writeStringField(stage.name().toLowerCase(Locale.ROOT), stage.help());
          }
          g.writeEndObject();
          g.writeArrayFieldStart("rooms");
          for (RoomHistory history : rooms) {
            g.writeStartObject();
            writeRoom(g, history.room());
            g.writeArrayFieldStart("rows");
            for (float[] row : history.latest(MOST_ROWS / rooms.size())) {
              writeRow(g, row);
            }
            g.writeEndArray();
            g.writeEndObject();
          }
          g.writeEndArray();
        });
  }

  /** Returns what has happened in the last second. */
  static String second(List<RoomHistory> rooms) {
    return message(
        "second",
        g -> {
          g.writeArrayFieldStart("rooms");
          for (RoomHistory history : rooms) {
            g.writeStartObject();
            writeRoom(g, history.room());
            if (history.last() != null) {
              g.writeFieldName("row");
              writeRow(g, history.last());
            }
            g.writeEndObject();
          }
          g.writeEndArray();
        });
  }

  /** Returns the fleet as it is now. */
  static String fleet(FleetFigures.Report fleet) {
    return message(
        "fleet",
        g -> {
          g.writeNumberField("lease", round(fleet.leaseS()));
          g.writeBooleanField("directory", fleet.directoryUp());
          g.writeArrayFieldStart("servers");
          for (FleetFigures.ServerRow server : fleet.servers()) {
            g.writeStartObject();
            g.writeStringField("name", Printable.text(server.name()));
            g.writeStringField("address", Printable.text(server.address()));
            g.writeBooleanField("self", server.isSelf());
            g.writeBooleanField("draining", server.draining());
            g.writeNumberField("load", server.load());
            g.writeNumberField("rooms", server.rooms());
            g.writeNumberField("follows", server.follows());
            g.writeNumberField("players", server.players());
            g.writeEndObject();
          }
          g.writeEndArray();
          g.writeNumberField("all", fleet.allRooms());
          g.writeNumberField("step", FleetFigures.LAG_STEP);
          g.writeArrayFieldStart("rooms");
          for (FleetFigures.RoomRow room : fleet.rooms()) {
            g.writeStartObject();
            g.writeStringField("name", room.name());
            g.writeStringField("game", Printable.text(room.game()));
            g.writeStringField("level", Printable.text(room.level()));
            g.writeStringField("owner", Printable.text(room.owner()));
            g.writeNumberField("claim", room.claim());
            g.writeStringField("follower", Printable.text(room.follower()));
            g.writeNumberField("lag", room.lag());
            g.writeBooleanField("exact", room.isLagExact());
            g.writeNumberField("players", room.players());
            if (room.skill() != null) {
              g.writeNumberField("skill", room.skill());
            }
            g.writeNumberField("places", room.places());
            g.writeEndObject();
          }
          g.writeEndArray();
          g.writeArrayFieldStart("news");
          for (FleetFigures.Happening happening : fleet.happenings()) {
            g.writeStartArray();
            g.writeNumber(round(happening.ageS()));
            g.writeString(Printable.text(happening.text()));
            g.writeEndArray();
          }
          g.writeEndArray();
        });
  }

  private static double round(double value) {
    return Math.round(value * 1_000.0) / 1_000.0;
  }

  private static void writeRoom(JsonGenerator g, Room room) throws IOException {
    MatchInfo match = room.match();
    g.writeStringField("name", room.name());
    g.writeStringField("game", match.game());
    g.writeStringField("level", match.level().level().name());
    g.writeNumberField("tick", room.tick());
    g.writeNumberField("taken", room.seats().takenCount());
    g.writeNumberField("places", room.seats().count());
    g.writeBooleanField("failed", room.hasFailed());
    g.writeBooleanField("paused", room.isPaused());
  }

  private static void writeRow(JsonGenerator g, float[] row) throws IOException {
    g.writeStartArray();
    for (float value : row) {
      if (Float.isNaN(value)) {
        g.writeNull();
      } else {
        g.writeNumber(round(value));
      }
    }
    g.writeEndArray();
  }

  /** Returns a match and its ground; the viewer forgets all bodies. */
  static String match(Room room, MatchInfo match) {
    Level level = match.level().level();
    return message(
        "match",
        g -> {
          g.writeStringField("room", room.name());
          g.writeNumberField("rate", room.tickRateHz());
          g.writeArrayFieldStart("bounds");
          g.writeNumber(level.bounds().minX());
          g.writeNumber(level.bounds().minY());
          g.writeNumber(level.bounds().maxX());
          g.writeNumber(level.bounds().maxY());
          g.writeEndArray();
        });
  }

  /** Bodies that a viewer doesn't know yet. */
  static String looks(List<BodyLook> looks) {
    return message(
        "looks",
        g -> {
          g.writeArrayFieldStart("bodies");
          for (BodyLook look : looks) {
            g.writeStartObject();
            g.writeNumberField("slot", look.slot());
            g.writeNumberField("entity", look.entity());
            g.writeNumberField("owner", look.owner());
            g.writeStringField("kind", look.kind());
            g.writeStringField("type", look.type().name().toLowerCase(Locale.ROOT));
            g.writeNumberField("rgb", look.rgb());
            g.writeBooleanField("sensor", look.sensor());
            g.writeArrayFieldStart("parts");
            for (Shape shape : look.shapes()) {
              for (Convex part : shape.parts()) {
                writePart(g, part);
              }
            }
            g.writeEndArray();
            g.writeEndObject();
          }
          g.writeEndArray();
        });
  }

  /** Writes the radius and the corners: one of a circle, two of a capsule or segment. */
  private static void writePart(JsonGenerator g, Convex part) throws IOException {
    g.writeStartArray();
    g.writeNumber(part.radius());
    for (int i = 0; i < part.vertexCount(); i++) {
      g.writeNumber(part.vertexX(i));
      g.writeNumber(part.vertexY(i));
    }
    g.writeEndArray();
  }

  /**
   * Returns the players of a room.
   *
   * @param addresses whether the viewer may know where they are
   */
  static String players(Room room, List<PlayerRates.Rate> rates, boolean addresses) {
    return message(
        "players",
        g -> {
          g.writeStringField("room", room.name());
          g.writeArrayFieldStart("players");
          for (PlayerRates.Rate rate : rates) {
            PlayerInfo info = rate.player().info();
            g.writeStartObject();
            g.writeNumberField("id", info.id());
            g.writeStringField("name", info.name());
            g.writeStringField("state", info.state());
            g.writeNumberField("team", info.team());
            g.writeNumberField("score", info.score());
            if (info.rgb() >= 0) {
              g.writeNumberField("rgb", info.rgb());
            }
            g.writeNumberField("ms", rate.player().link().roundTripMs());
            writeKnown(g, "kbit", rate.kbitPerSecond());
            writeKnown(g, "loss", rate.loss());
            writeKnown(g, "right", rate.right());
            if (addresses) {
              g.writeStringField("address", info.remote());
            }
            g.writeEndObject();
          }
          g.writeEndArray();
        });
  }

  /** Returns the best lists of the game of a room. */
  static String best(Room room, List<BestLists.Table> tables) {
    return message(
        "best",
        g -> {
          g.writeStringField("room", room.name());
          g.writeArrayFieldStart("lists");
          for (BestLists.Table table : tables) {
            g.writeStartObject();
            g.writeStringField("field", table.field());
            g.writeArrayFieldStart("rows");
            for (BestLists.Line line : table.rows()) {
              g.writeStartArray();
              g.writeString(Printable.text(line.name()));
              g.writeString(line.value());
              g.writeEndArray();
            }
            g.writeEndArray();
            g.writeEndObject();
          }
          g.writeEndArray();
        });
  }

  private static void writeKnown(JsonGenerator g, String name, double value) throws IOException {
    if (!Double.isNaN(value)) {
      g.writeNumberField(name, Math.round(value * 1e4) / 1e4);
    }
  }

  /** Lines of the log. */
  static String log(List<LogTail.Line> lines) {
    return message(
        "log",
        g -> {
          g.writeArrayFieldStart("lines");
          for (LogTail.Line line : lines) {
            g.writeStartArray();
            g.writeString(line.time());
            g.writeString(line.level());
            g.writeString(Printable.text(line.text()));
            g.writeEndArray();
          }
          g.writeEndArray();
        });
  }

  /** Returns the recordings that can be downloaded. */
  static String recordings(List<Downloads.Recording> recordings) {
    return message(
        "recordings",
        g -> {
          g.writeArrayFieldStart("files");
          for (Downloads.Recording file : recordings) {
            g.writeStartObject();
            g.writeStringField("name", file.name());
            g.writeNumberField("bytes", file.bytes());
            g.writeNumberField("changed", file.changedMs());
            g.writeEndObject();
          }
          g.writeEndArray();
        });
  }

  /** Returns where to download a recording. */
  static String download(String address) {
    return message("download", g -> g.writeStringField("address", address));
  }

  /** Returns the answer to a command. */
  static String answer(long id, CommandRegistry.Answer answer) {
    return message(
        "answer",
        g -> {
          g.writeNumberField("id", id);
          g.writeBooleanField("ok", answer.ok());
          g.writeStringField("text", answer.text());
        });
  }

  /**
   * Words that may stand at the end of a line, in quotes where they need them.
   *
   * @param before the line before the word that they complete
   */
  static String words(long id, String before, List<String> words) {
    return message(
        "words",
        g -> {
          g.writeNumberField("id", id);
          g.writeStringField("before", before);
          g.writeArrayFieldStart("words");
          for (String word : words) {
            g.writeString(Printable.text(word));
          }
          g.writeEndArray();
        });
  }

  /** Returns why a viewer may not do what it wants. */
  static String refused(String why) {
    return message("refused", g -> g.writeStringField("why", why));
  }
}
