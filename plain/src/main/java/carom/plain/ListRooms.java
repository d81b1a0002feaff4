package carom.plain;

/** Asks which rooms there are; {@link Rooms} answers. It may come before {@link Join}. */
public final class ListRooms {
  /** Creates one to be filled in. */
  public ListRooms() {}
}
