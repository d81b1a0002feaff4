/**
 * The command {@code carom test}: plays a game with bots over usual networks in virtual time, and
 * says in plain words which rules the game breaks.
 *
 * <p>May use everything. Read first: {@link carom.testkit.trial.GameTest}, {@link
 * carom.testkit.trial.RepeatCheck}, {@link carom.testkit.trial.TestCommand}.
 */
package carom.testkit.trial;
