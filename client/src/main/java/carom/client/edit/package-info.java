/**
 * The editor of levels without its window. A level is edited as its text: {@code LevelSource}
 * changes single values of it, so all else stays as it was written. The reader of levels judges
 * each state and gives the shapes; the schema of levels gives the forms and says which values are
 * points.
 *
 * <pre>
 *  mouse ──► Gestures ──► LevelEditor ──► LevelSource (text)
 *  forms ──► Form ────────────┘  │
 *                                └──► CheckedLevel ──► Sketch, problems
 * </pre>
 *
 * <p>Imports {@code carom.game}, {@code carom.sim..}, {@code carom.physics..} and {@code
 * carom.text}. Read first: {@link carom.client.edit.LevelEditor}, {@link
 * carom.client.edit.LevelSource}, {@link carom.client.edit.Gestures}.
 */
package carom.client.edit;
