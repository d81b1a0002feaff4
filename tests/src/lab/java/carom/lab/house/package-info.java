/**
 * The report on the size of the house ({@code ./gradlew house}).
 *
 * <p>Imports nothing. Read first: {@link carom.lab.house.HouseMain}.
 */
package carom.lab.house;
