/**
 * Fuzzing guided by coverage: what reads bytes of others, driven by Jazzer (<code>./gradlew fuzz
 * </code>), and the corpus that it found, replayed as ordinary tests. See
 * docs/server/RELIABILITY.md.
 */
package carom.fuzz;
