package carom.plain;

import com.esotericsoftware.kryo.Kryo;

/** Registers the messages between a Carom server and clients with stock KryoNet. */
public final class Plain {
  /** Version of these classes; the server refuses others. */
  public static final int VERSION = 1;

  private Plain() {}

  /**
   * Registers all messages, in the order that the server knows. Call it before other registrations,
   * on the Kryo of a new {@code Client}: {@code Plain.register(client.getKryo())}.
   */
  public static void register(Kryo kryo) {
    kryo.register(int[].class);
    kryo.register(float[].class);
    kryo.register(String[].class);
    kryo.register(Join.class);
    kryo.register(Controls.class);
    kryo.register(Controls[].class);
    kryo.register(Input.class);
    kryo.register(Chat.class);
    kryo.register(Emote.class);
    kryo.register(Choose.class);
    kryo.register(Rate.class);
    kryo.register(View.class);
    kryo.register(ListRooms.class);
    kryo.register(Value.class);
    kryo.register(Value[].class);
    kryo.register(Custom.class);
    kryo.register(Alive.class);
    kryo.register(Leave.class);
    kryo.register(Welcome.class);
    kryo.register(Refused.class);
    kryo.register(Part.class);
    kryo.register(Part[].class);
    kryo.register(Archetype.class);
    kryo.register(Archetype[].class);
    kryo.register(Ground.class);
    kryo.register(Ground[].class);
    kryo.register(EventLook.class);
    kryo.register(EventLook[].class);
    kryo.register(Gauge.class);
    kryo.register(Gauge[].class);
    kryo.register(Team.class);
    kryo.register(Team[].class);
    kryo.register(Kind.class);
    kryo.register(Kind[].class);
    kryo.register(Match.class);
    kryo.register(More.class);
    kryo.register(Body.class);
    kryo.register(Body[].class);
    kryo.register(Snapshot.class);
    kryo.register(Player.class);
    kryo.register(Player[].class);
    kryo.register(Roster.class);
    kryo.register(Scores.class);
    kryo.register(FieldValue.class);
    kryo.register(FieldValue[].class);
    kryo.register(Fields.class);
    kryo.register(Event.class);
    kryo.register(Room.class);
    kryo.register(Room[].class);
    kryo.register(Rooms.class);
    kryo.register(Redirect.class);
    kryo.register(Goodbye.class);
    kryo.register(Theme.class);
    kryo.register(Zone.class);
    kryo.register(Zone[].class);
    kryo.register(Joint.class);
    kryo.register(Joint[].class);
    kryo.register(Joints.class);
    kryo.register(ListBest.class);
    kryo.register(BestEntry.class);
    kryo.register(BestEntry[].class);
    kryo.register(BestList.class);
    kryo.register(BestList[].class);
    kryo.register(Best.class);
    kryo.register(Standby.class);
  }
}
