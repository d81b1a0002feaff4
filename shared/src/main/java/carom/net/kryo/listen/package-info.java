/** How a server listens for TCP connections in KryoNet's place. */
package carom.net.kryo.listen;
