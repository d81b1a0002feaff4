/**
 * Snapshots: the world as integers once per tick, and per session the difference to what that
 * client is known to have.
 *
 * <p>This package puts the sections of a datagram together, and takes them apart. {@code
 * ClientKnowledge} answers which entities are news for a client and against which tick they are
 * coded; {@code Selection} orders them by the priority that they have collected. The records, each
 * entity in sight, absolute or as the difference to a baseline, are coded here, too. Each section
 * is described by one method that writes and reads:
 *
 * <pre>
 *           ┌──────────────── only if it has an own section ───────────────┐
 * ┌────────┬─────────────┬────────────────┬──────────────────────────────┬────────┬────────┐
 * │ head   │ own section │ relayed inputs │ near: list, hash, update     │ events │ tables │ plain
 * │ Data-  │ OwnCodec    │ RelayCodec     │ NearCodec                    │ Event- │ Table- │ bits:
 * │ gram-  │ (exact)     │ (exact)        │ (exact)                      │ Codec  │ Codec  │ BitPass
 * │ Head   │             │                │                              │ (frame)│ (table)│
 * └────────┴─────────────┴────────────────┴──────────────────────────────┴────────┴────────┘
 *   zeros up to a whole byte
 * ┌─────────────────────┬───────────────────────────────────────────────────────────────┐
 * │ rows of near update │ records: kind, slot, ...    RecordCodec                       │ arith-
 * │ NearRowCodec        │ a run: its slots            SlotCodec                         │ metic:
 * │ (exact)             │        a delta for each     DeltaCodec, shared by Deltas      │ BitCoder
 * └─────────────────────┴───────────────────────────────────────────────────────────────┘
 * </pre>
 *
 * <p>{@code docs/protocol/DATAGRAMS.md} has the bytes and the rules. {@code frame} is what the
 * sections describe. All of it sees arrays and bytes, no worlds and no transport. Read first:
 * {@link carom.net.snapshot.SnapshotEncoder}, {@link carom.net.snapshot.SnapshotDecoder}, {@link
 * carom.net.snapshot.ClientKnowledge}, {@link carom.net.snapshot.Selection}, {@link
 * carom.net.snapshot.RecordCodec}.
 */
package carom.net.snapshot;
