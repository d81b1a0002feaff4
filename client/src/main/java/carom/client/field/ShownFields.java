package carom.client.field;

/** The source of a picture's fields: a server, or a recording. */
public interface ShownFields {
  /** Returns the fields of the match, brought up to date. */
  FieldView match();

  /**
   * Returns the fields of a player, brought up to date.
   *
   * @param id 0..1,023
   */
  FieldView player(int id);

  /**
   * Returns the fields of an entity, brought up to date.
   *
   * @param id the entity's id in the view, which may be that of a provisional one
   */
  FieldView entity(int id, int generation);
}
