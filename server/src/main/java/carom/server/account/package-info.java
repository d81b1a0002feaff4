/**
 * The values that accounts keep from stay to stay: fields of games that are {@code of(ACCOUNT)}.
 *
 * <p>A room reads nothing: a player brings the values at the join, and the room notes what they
 * become. {@link carom.server.account.AccountService} has a thread of its own for the database, so
 * no tick waits for it. Read first: {@link carom.server.account.Stay}, {@link
 * carom.server.account.AccountService}, {@link carom.server.account.AccountStore}.
 *
 * <p>May import the simulation's fields, {@code carom.physics.archive} and {@code
 * carom.net.protocol}.
 */
package carom.server.account;
