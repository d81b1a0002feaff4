/**
 * A client of a Carom server that needs no window: it joins a game, samples inputs, predicts,
 * interpolates, and offers a read-only view of the result.
 *
 * <p>A program creates a {@link carom.client.GameClient} and calls its {@code update} once per
 * frame. The parts live in packages of their own, and data flows one way through them:
 *
 * <pre>
 * link ──► GameClient (inbox, decoder) ──► prediction ──► view ──► users
 *               │      clock, events                        ▲
 *               └──► stats                   interpolation ──┘
 *
 * above:  app (command line), bots, desktop (window), replay (recordings)
 * </pre>
 *
 * <p>What happens besides: {@link carom.client.EventReconciler} fires each event of a game once,
 * although the prediction may compute it several times and the server sends it, too; {@link
 * carom.client.MessageExchange} sends and receives messages of the game and chat; {@link
 * carom.client.PoolFollower} loads water and sand, and follows them with what the server tells.
 *
 * <p>Imports its subpackages {@code link}, {@code stats}, {@code clock}, {@code prediction} and
 * {@code view}, {@code carom.net..}, {@code carom.sim} and {@code carom.game}. One thread. Read
 * first: {@link carom.client.GameClient}, {@link carom.client.JoinedGame}, {@link
 * carom.client.ClientConfig}.
 */
package carom.client;
