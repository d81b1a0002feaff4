package carom.client.look;

/** Something that an event or a blow sets off in the picture or to the ear. */
public sealed interface Effect permits Particles, Reaction, Shake, SlowMotion, SoundFile {}
