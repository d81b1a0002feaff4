/**
 * The content of a simulation besides its physics: entities, the joints between them, the players
 * who own some of them, and the input of each player. Joints have keys and definitions by which
 * clients mirror them; assemblies are several bodies and joints that belong together. The poses of
 * the last quarter of a second are kept for lag compensation. Areas, such as water and wind, of the
 * level and carried by entities, act on bodies; both roles compute it.
 *
 * <p>Games use {@link carom.sim.entity.HostEntity}, {@link carom.sim.entity.HostPlayer} and {@link
 * carom.sim.entity.Input}. The tables and their saved states are for {@code carom.sim}, which hands
 * none of them out.
 *
 * <p>Allowed imports: {@code carom.physics..} and the packages of {@code carom.sim} that know no
 * entity. Read first: {@link carom.sim.entity.HostEntity}, {@link carom.sim.entity.HostPlayer},
 * {@link carom.sim.entity.EntityTable}.
 */
package carom.sim.entity;
