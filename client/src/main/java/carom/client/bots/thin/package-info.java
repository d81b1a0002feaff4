/**
 * Thin clients without a window, which are told what there is: by the JDK's WebSocket, or by the
 * real KryoNet 2.22 with its Kryo 2.24, in a class loader of its own.
 *
 * <p>Read first: {@link carom.client.bots.thin.ThinDoor}, {@link
 * carom.client.bots.thin.ThinPicture}.
 */
package carom.client.bots.thin;
