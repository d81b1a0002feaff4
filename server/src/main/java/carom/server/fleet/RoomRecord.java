package carom.server.fleet;

import carom.net.protocol.ServerMessage;
import carom.server.config.RoomConfig;
import carom.server.session.RoomSkill;
import carom.text.Json;
import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The record of a room in the directory, by its owner. The claim and the listing are one record, so
 * that neither can be there without the other.
 *
 * @param server lease of the owner
 * @param follower lease of the server that has the room's state, 0 for none
 * @param leaving whether the owner gives the room up for its follower
 * @param load the part of their time that its ticks take, percent
 * @param lag how many ticks its follower may lack, in steps of {@value #LAG_STEP}, so that the
 *     record rests while the follower keeps up
 * @param parties those that have a member there, at most {@value #MAX_PARTIES}
 * @param accounts those that have a seat there, hashed, if the fleet limits their seats, at most
 *     {@value #MAX_ACCOUNTS}
 * @param skill of its players, or null if the game names none
 * @param settings the room's settings, with which another server can go on with it
 * @param entry what lists of rooms show
 */
record RoomRecord(
    long server,
    long follower,
    boolean leaving,
    int load,
    int lag,
    List<String> parties,
    List<String> accounts,
    RoomSkill skill,
    RoomConfig settings,
    ServerMessage.RoomEntry entry) {
  /** Begins the keys of rooms in the directory. */
  static final String PREFIX = "rooms/";

  /** Steps in which the lag is told, ticks. */
  static final int LAG_STEP = 30;

  /** Most parties of which a record tells, so that it stays small. */
  static final int MAX_PARTIES = 128;

  /** Most accounts of which a record tells, for the same reason. */
  static final int MAX_ACCOUNTS = 512;

  private static final int HASH_CHARACTERS = 11; // 66 bits

  static String key(String room) {
    return PREFIX + room;
  }

  /** Returns what stands for a longer text, such as an account in {@link #accounts}. */
  static String hashed(String text) {
    return HashedKey.of("", text).substring(0, HASH_CHARACTERS);
  }

  /** Returns what numbered rooms with the same settings have in common, 66 bits as text. */
  static String kind(RoomConfig settings) {
    return hashed(settings.game() + settings.levels() + settings.places());
  }

  /** Returns whether this is a numbered room of a kind. */
  boolean isOfKind(String kind) {
    return settings.name().chars().allMatch(Character::isDigit) && kind(settings).equals(kind);
  }

  /** Returns this record as that of a room that its owner gives up for a follower. */
  RoomRecord leaving(long forServer) {
    return new RoomRecord(
        server, forServer, true, load, lag, parties, accounts, skill, settings, entry);
  }

  /** Returns the record of a room that is claimed and not built yet. */
  static RoomRecord claimed(long server, RoomConfig settings) {
    return new RoomRecord(
        server,
        0,
        false,
        0,
        0,
        List.of(),
        List.of(),
        null,
        settings,
        new ServerMessage.RoomEntry(
            settings.name(), settings.game(), "", "", 0, 0, 0, settings.metadata()));
  }

  /** Returns whether the owner has built the room. */
  boolean isBuilt() {
    return !entry.level().isEmpty();
  }

  String toJson() {
    return FleetJson.write(
        json -> {
          json.writeNumberField("server", server);
          json.writeNumberField("follower", follower);
          json.writeBooleanField("leaving", leaving);
          json.writeNumberField("load", load);
          json.writeNumberField("lag", lag);
          json.writeStringField("room", settings.name());
          json.writeStringField("game", settings.game());
          writeList(json, "levels", settings.levels());
          if (!parties.isEmpty()) {
            writeList(json, "parties", parties);
          }
          if (!accounts.isEmpty()) {
            writeList(json, "accounts", accounts);
          }
          if (skill != null) {
            json.writeObjectFieldStart("skill");
            json.writeStringField("field", skill.field());
            json.writeNumberField("start", skill.start());
            json.writeNumberField("within", skill.within());
            json.writeNumberField("widening", skill.widening());
            json.writeNumberField("players", skill.players());
            json.writeNumberField("mean", skill.mean());
            json.writeEndObject();
          }
          json.writeNumberField("places", settings.places());
          json.writeStringField("seed", String.valueOf(settings.seed()));
          json.writeObjectFieldStart("info");
          for (Map.Entry<String, String> info : settings.metadata().entrySet()) {
            json.writeStringField(info.getKey(), info.getValue());
          }
          json.writeEndObject();
          json.writeStringField("plays", entry.game());
          json.writeStringField("level", entry.level());
          json.writeStringField("phase", entry.phase());
          json.writeNumberField("players", entry.players());
          json.writeNumberField("free", Math.max(0, entry.places() - entry.players()));
          json.writeNumberField("spectators", entry.spectators());
        });
  }

  private static void writeList(JsonGenerator json, String name, List<String> texts)
      throws IOException {
    json.writeArrayFieldStart(name);
    for (String text : texts) {
      json.writeString(text);
    }
    json.writeEndArray();
  }

  private static RoomSkill skill(Json json) throws IOException {
    return new RoomSkill(
        FleetJson.text(json, "field"),
        FleetJson.whole(json, "start"),
        FleetJson.whole(json, "within"),
        FleetJson.whole(json, "widening"),
        FleetJson.whole(json, "players"),
        FleetJson.whole(json, "mean"));
  }

  private static List<String> list(Json json, String name) {
    List<String> texts = new ArrayList<>();
    for (Json text :
        json.fields.containsKey(name) ? json.fields.get(name).items : List.<Json>of()) {
      texts.add(text.text);
    }
    return texts;
  }

  /**
   * Reads a record.
   *
   * @throws IOException if it is none; the message says why
   */
  static RoomRecord parse(String value) throws IOException {
    Json json = FleetJson.read(value);
    Map<String, String> info = new LinkedHashMap<>();
    Json infos = json.fields.get("info");
    if (infos != null) {
      infos.fields.forEach((key, text) -> info.put(key, text.text));
    }
    RoomConfig settings;
    try {
      settings =
          new RoomConfig(
              FleetJson.text(json, "room"),
              FleetJson.text(json, "game"),
              list(json, "levels"),
              FleetJson.whole(json, "places"),
              Long.parseLong(FleetJson.text(json, "seed")),
              info);
    } catch (IllegalArgumentException e) {
      throw new IOException("no room's record: " + e.getMessage(), e);
    }
    Json skill = json.fields.get("skill");
    int players = FleetJson.whole(json, "players");
    return new RoomRecord(
        FleetJson.number(json, "server"),
        FleetJson.number(json, "follower"),
        FleetJson.flag(json, "leaving"),
        FleetJson.whole(json, "load"),
        FleetJson.whole(json, "lag"),
        list(json, "parties"),
        list(json, "accounts"),
        skill == null ? null : skill(skill),
        settings,
        new ServerMessage.RoomEntry(
            settings.name(),
            FleetJson.text(json, "plays"),
            FleetJson.text(json, "level"),
            FleetJson.text(json, "phase"),
            players,
            players + FleetJson.whole(json, "free"),
            FleetJson.whole(json, "spectators"),
            info));
  }
}
