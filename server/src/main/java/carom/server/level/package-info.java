/**
 * The commands of {@code carom level}: check a level file, draw it, make one of a Tiled map. They
 * need no server and no display.
 *
 * <p>Allowed imports: see {@code ArchitectureTest}; images of the JDK ({@code java.awt}).
 *
 * <p>Read first: {@link carom.server.level.LevelCommand}, {@link carom.server.level.LevelCheck},
 * {@link carom.server.level.LevelPicture}.
 */
package carom.server.level;
