/**
 * Exact rows: bodies, joints, and what bodies learnt about each other by touching, as numbers that
 * are carried from one world to another. {@link carom.physics.World#readRows} reads them, {@link
 * carom.physics.World#writeRows} writes them.
 *
 * <p>What a row holds, and at which offset, is declared here and nowhere else:
 *
 * <pre>
 *            0     1                      8            9                15
 *          ┌─────┬──────────────────────┬────────────┬────────────────┬───────────┐
 *   BODY   │ KEY │ MOTION               │ SLEEP_TIME │ LOADS          │ ARCHETYPE │
 *          │     │ x y cos sin vx vy ω  │ or ASLEEP  │ impulse  force │           │
 *          └─────┴──────────────────────┴────────────┴────────────────┴───────────┘
 *           user   physics                                             user
 *
 *            0     1        3                          15               19           26       29
 *          ┌─────┬────────┬──────────────────────────┬────────────────┬────────────┬────────┐
 *   JOINT  │ KEY │ END_A  │ SETTINGS                 │ TURNS          │ IMPULSES   │ LOADS  │
 *          │     │  END_B │ flags, what games change │ a b last last  │ to start   │ fx fy t│
 *          └─────┴────────┴──────────────────────────┴────────────────┴────────────┴────────┘
 *           user   physics
 *
 *            0           2       3            4         6        8                 13      15
 *          ┌───────────┬───────┬────────────┬─────────┬────────┬─────────────────┬───────┐
 *   CONTACT│ END_A     │ PARTS │ POINTS_AND │ ID_0    │ NORMAL │ impulses to     │ TOTAL │
 *          │     END_B │       │ _FLAGS     │    ID_1 │ x y    │ start with      │ 0   1 │
 *          └───────────┴───────┴────────────┴─────────┴────────┴─────────────────┴───────┘
 *           integers                                   floats
 *
 *            0       1       2
 *          ┌───────┬───────┬───────────┐
 *   FIELDS │ PLACE │ CHUNK │ w0 ... w7 │
 *          └───────┴───────┴───────────┘
 *                   user
 *
 *   ExactRows:  BODY, BODY, BODY, ...         by ascending slot
 *               JOINT, JOINT, ...             by ascending slot
 *               CONTACT, CONTACT, ...         by ascending ends
 *               FIELDS, FIELDS, ...           by ascending place and chunk
 *
 *   Rows of mixed kinds, in one array with room for the longest kind:
 *               │BODY──────────     │JOINT──────────────│CONTACT────────    │CONTACT────────    │
 * </pre>
 *
 * <p>Another kind of row is another constant of {@link carom.physics.rows.RowKind} and a class of
 * its fields. Storage, hash and copies follow from that.
 *
 * <p>A leaf: may import {@code carom.physics.math} and nothing else, so that the code of snapshots,
 * which sees no world, may use it, too. Read first: {@link carom.physics.rows.ExactRows}, {@link
 * carom.physics.rows.BodyRow}, {@link carom.physics.rows.JointRow}, {@link
 * carom.physics.rows.ContactRow}.
 */
package carom.physics.rows;
