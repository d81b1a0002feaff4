/**
 * Games, levels and rigs for the project's own tests, beside the test kit that authors of games
 * use.
 *
 * <p>May use everything. Read first: {@link carom.testkit.PlainGame}, {@link carom.testkit.Levels}.
 */
package carom.testkit;
