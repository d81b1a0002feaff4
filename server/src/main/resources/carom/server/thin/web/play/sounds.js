// Sounds of the game's look, or short ones computed on the spot, as the window has them; none before the player has pressed something.

const SECONDS = {KNOCK: 0.14, HOP: 0.14, WHOOSH: 0.3, ZAP: 0.25, CHIME: 0.4, DROP: 0.5, FANFARE: 1};
const MUSIC = 0.3, NEAR = 9, APART = 0.045, FAINTEST = 0.03;

export class Sounds {
  constructor() {
    this.muted = localStorage.getItem('carom-muted') === '1';
    this.last = {};
    this.look = null;
    this.clips = new Map();
  }

  /** Lets sounds be heard; browsers allow it after a press only. */
  wake() {
    const Audio = window.AudioContext || window.webkitAudioContext;
    if (!this.audio && Audio) this.audio = new Audio();
    this.audio?.resume();
    this.fetch();
  }

  /** Takes the sound files and the music of a game's look; null for none. */
  use(look) {
    this.look = look;
    this.clips.clear();
    this.song?.stop();
    this.song = null;
    this.fetch();
  }

  /** Reads the files of the look, once there is something to play them. */
  fetch() {
    const look = this.look;
    if (!this.audio || !look || this.clips.size) return;
    for (const file of look.soundFiles) {
      this.clips.set(file, null);
      fetch(look.from + file).then(answer => answer.arrayBuffer()).then(bytes => this.audio.decodeAudioData(bytes)).then(clip => {
        if (this.look !== look) return;
        this.clips.set(file, clip);
        if (file === look.music) this.startMusic(clip);
      }).catch(() => {}); // a browser that can't play it is silent
    }
  }

  startMusic(clip) {
    const gain = this.audio.createGain();
    this.song = this.audio.createBufferSource();
    Object.assign(this.song, {buffer: clip, loop: true});
    this.songGain = gain.gain;
    gain.gain.value = this.muted ? 0 : MUSIC;
    this.song.connect(gain).connect(this.audio.destination);
    this.song.start();
  }

  /** Plays the sound files among some effects, as loud as `share` of their cause, heard from (x, y); returns whether there are any. */
  effects(effects, at, share, x, y) {
    const sounds = (effects || []).filter(e => e.kind === 'SOUND');
    for (const sound of sounds) {
      const file = sound.files[Math.floor(Math.random() * sound.files.length)], clip = this.clips.get(file);
      if (!clip || this.muted || this.audio.state !== 'running') continue;
      const dx = at.x - x, dy = at.y - y, loud = sound.volume * Math.max(0.08, share) / (1 + (dx * dx + dy * dy) / (NEAR * NEAR)), now = this.audio.currentTime;
      if (loud < FAINTEST || now - (this.last[file] ?? -1) < APART) continue;
      this.last[file] = now;
      const source = this.audio.createBufferSource(), gain = this.audio.createGain(), pan = this.audio.createStereoPanner();
      source.buffer = clip;
      source.playbackRate.value = sound.pitch[0] + (sound.pitch[1] - sound.pitch[0]) * Math.random();
      gain.gain.value = 0.6 * loud;
      pan.pan.value = Math.max(-0.8, Math.min(0.8, dx / 18));
      source.connect(gain).connect(pan).connect(this.audio.destination);
      source.start(now);
    }
    return sounds.length > 0;
  }

  mute(muted) {
    this.muted = muted;
    localStorage.setItem('carom-muted', muted ? '1' : '0');
    if (this.song) this.songGain.value = muted ? 0 : MUSIC;
  }

  /** Plays an event's sound: louder when it is hard and near, from the side it comes from. */
  play(look, event, x, y) {
    const seconds = SECONDS[look.sound], hardness = look.fullStrength ? Math.min(1, event.strength / look.fullStrength) : 1;
    if (this.effects(this.look?.events[look.name], event, hardness, x, y)) return;
    if (!seconds || this.muted || this.audio?.state !== 'running') return;
    const near = NEAR + 2 * look.radius, dx = event.x - x, dy = event.y - y;
    const loud = Math.max(0.08, hardness) / (1 + (dx * dx + dy * dy) / (near * near));
    const now = this.audio.currentTime;
    if (loud < FAINTEST || now - (this.last[look.sound] ?? -1) < APART) return;
    this.last[look.sound] = now;
    const gain = this.audio.createGain(), pan = this.audio.createStereoPanner();
    pan.pan.value = Math.max(-0.8, Math.min(0.8, dx / 18));
    gain.gain.setValueAtTime(0, now);
    gain.gain.linearRampToValueAtTime(0.35 * loud, now + 0.003);
    gain.gain.exponentialRampToValueAtTime(0.001, now + seconds);
    gain.connect(pan).connect(this.audio.destination);
    if (look.sound === 'WHOOSH') return this.noise(gain, now, seconds);
    const tone = this.audio.createOscillator();
    tone.type = look.sound === 'ZAP' || look.sound === 'FANFARE' ? 'sawtooth' : 'sine';
    const pitch = tone.frequency;
    switch (look.sound) {
      case 'KNOCK': pitch.setValueAtTime(430, now); pitch.exponentialRampToValueAtTime(170, now + 0.05); break;
      case 'HOP': pitch.setValueAtTime(260, now); pitch.linearRampToValueAtTime(620, now + seconds); break;
      case 'ZAP': pitch.setValueAtTime(1640, now); pitch.exponentialRampToValueAtTime(160, now + 0.2); break;
      case 'CHIME': pitch.setValueAtTime(988, now); pitch.setValueAtTime(1319, now + 0.08); break;
      case 'DROP': pitch.setValueAtTime(420, now); pitch.exponentialRampToValueAtTime(94, now + seconds); break;
      default: [392, 523, 659, 784].forEach((hz, i) => pitch.setValueAtTime(hz, now + 0.15 * i));
    }
    tone.connect(gain);
    tone.start(now);
    tone.stop(now + seconds);
  }

  noise(gain, now, seconds) {
    const rate = this.audio.sampleRate, buffer = this.audio.createBuffer(1, rate * seconds, rate), wave = buffer.getChannelData(0);
    for (let i = 0, low = 0; i < wave.length; i++) wave[i] = (low += 0.15 * (2 * Math.random() - 1 - low)) * 3;
    const source = this.audio.createBufferSource();
    source.buffer = buffer;
    source.connect(gain);
    source.start(now);
  }
}
