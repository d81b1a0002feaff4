/**
 * A large fleet of toy rooms in virtual time, and what it asks of its directory. Read first: {@link
 * carom.lab.fleet.FleetSoak}, {@link carom.lab.fleet.ToyFleet}.
 */
package carom.lab.fleet;
