/**
 * The fields of a game as a client knows them: of the own player as predicted, of all others as the
 * server told last.
 *
 * <p>Read first: {@link carom.client.field.ShownFields}, {@link carom.client.field.RemoteFields},
 * {@link carom.client.field.FieldView}.
 */
package carom.client.field;
