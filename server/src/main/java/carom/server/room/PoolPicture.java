package carom.server.room;

/**
 * The particles of a pool at one tick. Nobody changes it, its array included.
 *
 * @param rgb their colour, 0xRRGGBB
 * @param spacing distance between resting neighbours, m
 * @param xy the centres, m: x0, y0, x1, y1, ...
 */
@SuppressWarnings("ArrayRecordComponent") // Never compared; nobody changes it.
public record PoolPicture(int rgb, float spacing, float[] xy) {}
