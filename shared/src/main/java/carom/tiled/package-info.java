/**
 * Maps of the editor Tiled as levels: {@code .tmx} and {@code .tmj} files, and their tilesets. It
 * is written from the formats' documentation.
 *
 * <pre>
 *   bytes ─► XmlTree, JsonTree ─► TiledNode ─► TiledImport ─► level file ─► CheckedLevel
 *                                                │    ▲                          │
 *                                 TileLayer ◄────┘    └── what it refuses is ◄───┘
 *                                 TileOutlines            dropped and named
 *                                 TileObject
 * </pre>
 *
 * <p>Allowed imports: {@code carom.sim.level}, {@code carom.text}, the JDK's XML.
 *
 * <p>Read first: {@link carom.tiled.TiledImport}, {@link carom.tiled.TileOutlines}, {@link
 * carom.tiled.TiledNode}.
 */
package carom.tiled;
