// The page that plays: the link, the world, the picture, and what stands around it.
// What others wrote, such as names, goes to the page as text only, never as HTML.

import {Thin} from './thin.js';
import {World} from './world.js';
import {Picture} from './picture.js';
import {Controls} from './controls.js';
import {Look} from './look.js';
import {Sounds} from './sounds.js';
import {drawQr} from './qr.js';
import {hex} from './painter.js';

const $ = id => document.getElementById(id);
const RATE = 60, ALIVE_MS = 250, MOST_LINES = 8, LINE_MS = 12_000, MOST_SCORES = 12, BEST_MS = 1000, TRUSTED = 2; // answers before an empty one counts
const SEAT = 'carom-seat'; // the secret of this tab's seat, so that a page that is loaded again goes on
const COLOURS = {OF_THE_GAME: 'as in the game', RED: 'red', ORANGE: 'orange', YELLOW: 'yellow', LIME: 'lime', GREEN: 'green', CYAN: 'cyan',
  BLUE: 'blue', VIOLET: 'violet', PINK: 'pink', BROWN: 'brown', WHITE: 'white'};
const EMOTES = {HELLO: 'Hello!', THANKS: 'Thanks!', NICE: 'Nice!', SORRY: 'Sorry!', LAUGH: 'Ha ha!', WOW: 'Wow!', GRR: 'Grr!', GO: 'Go, go!'};

const world = new World(), picture = new Picture($('game'), world), sounds = new Sounds();
let tickRate = 60, room = linked('room'), rooms = [], last = '', sentMs = 0, drawnMs = performance.now(), ready = false;

function linked(word) { return new URLSearchParams(location.hash.slice(1)).get(word) || ''; }

function node(tag, text, className) {
  const made = document.createElement(tag);
  made.textContent = text;
  if (className) made.className = className;
  return made;
}

function mark(rgb) {
  const made = node('i', '', 'mark');
  made.style.background = rgb >= 0 ? hex(rgb) : '#8fa0b5';
  return made;
}

const link = new Thin({
  welcome: value => { sessionStorage.setItem(SEAT, JSON.stringify({secret: value.secret, name: $('name').value})); tickRate = value.tickRate; link.say('rate', {perSecond: RATE}); link.say('rooms'); },
  match: value => {
    world.begin(value, tickRate);
    picture.begin(value);
    wear(value.game);
    room = value.room;
    if (!menuIsForced) showMenu(false);
    document.title = `${value.room} - Carom`;
    showStay();
    showLink();
  },
  snapshot: value => world.take(value, performance.now()),
  roster: ({players, gone}) => {
    for (const p of players) {
      if (!world.players.has(p.id) && world.players.size && p.id !== world.match.player) say(null, `${p.name} is here.`);
      world.players.set(p.id, p);
    }
    for (const id of gone) { const p = world.players.get(id); if (p) say(null, `${p.name} has left.`); world.players.delete(id); }
    showScores();
    showStay();
  },
  scores: ({scores}) => {
    for (let i = 0; i < scores.length; i += 3) Object.assign(world.players.get(scores[i]) || {}, {score: scores[i + 1], ping: scores[i + 2]});
    showScores();
  },
  fields: value => world.learn(value),
  joints: ({joints}) => { world.joints = joints; },
  events: ({events}) => events.forEach(event => {
    const look = world.match?.events[event.kind];
    if (!look) return;
    // Shown with the bodies that it happens to, which are drawn a little late.
    const waits = Math.max(0, (event.tick - world.shownTick(performance.now())) * 1000 / tickRate);
    setTimeout(() => {
      picture.flash(look, event, performance.now());
      sounds.play(look, event, picture.camera.x, picture.camera.y);
    }, Math.min(500, waits));
  }),
  chat: ({player, text, team}) => world.match ? say(world.players.get(player), text, team) : showState(text),
  emote: ({player, emote}) => picture.emote(player, EMOTES[emote] || emote, performance.now()),
  rooms: takeRooms,
  best: value => { best = value.lists; showBest(); },
  redirect: follow,
  state: showState,
  end,
});
let ticket = linked('ticket'); // that lets the player in here, once
let best = null, bestAsked = 0, fresh = true, menuIsForced = true, worn = '';
const usualKeys = $('keys').textContent;
picture.onBlow = (effects, x, y, share) => sounds.effects(effects, {x, y}, share, picture.camera.x, picture.camera.y);

/** Shows a game as its view declares it, as soon as that has arrived. */
async function wear(game) {
  if (game === worn) return;
  worn = game;
  take(null);
  const look = await Look.load(game);
  if (worn === game) take(look);

  function take(newLook) {
    picture.look = newLook;
    sounds.use(newLook);
    controls.use(newLook?.actions || []);
    $('keys').textContent = newLook?.actions.length ? `${controls.words()} · Enter: chat · Esc: menu. A gamepad and glass work too.` : usualKeys;
  }
}

/** Says how it stands with the link; empty when all is well. */
function showState(text) {
  $('state').textContent = text;
  $('state').hidden = !text;
}

/** Goes to another server, with the seat: whose page takes it from the link, as no other page can read this one's. */
function follow({server, room: there = room, token: ticket}) {
  sessionStorage.removeItem(SEAT);
  const words = {room: there, name: $('name').value, seat: link.secret, token: linked('token'), ticket, party: linked('party')};
  for (const word of Object.keys(words)) if (!words[word]) delete words[word];
  location.href = `${location.protocol}//${server}/play#${new URLSearchParams(words)}`;
}

/** Takes a part of the list of rooms. */
function takeRooms(value) {
  rooms = fresh ? value.rooms : [...rooms, ...value.rooms];
  fresh = value.left === 0;
  if (fresh) showRooms();
}

function end(text) {
  sessionStorage.removeItem(SEAT);
  world.begin(null, 60);
  menuIsForced = true;
  showMenu(true);
  $('why').textContent = text;
  $('why').hidden = false;
  $('passwordRow').hidden = !/password/i.test(text) && !$('password').value;
  $('stay').hidden = true;
  $('join').hidden = false;
  $('state').hidden = true;
  document.title = 'Carom';
}

function join(secret) {
  const name = $('name').value.trim();
  if (!name) return;
  localStorage.setItem('carom-name', name);
  sounds.wake();
  $('why').hidden = true;
  menuIsForced = false;
  $('state').textContent = 'Joining ...';
  $('state').hidden = false;
  link.join({name, room: room || undefined, party: linked('party') || undefined, password: $('password').value || undefined,
    token: linked('token') || undefined, secret}, ticket);
  ticket = '';
}

function showMenu(on) {
  $('menu').hidden = !on;
  turnToBest(false);
  if (on) { link.say('rooms'); showLink(); controls.release(); } else $('game').focus();
}

function showLink() {
  const url = new URL(location.href);
  url.hash = room ? new URLSearchParams({room}).toString() : '';
  $('link').value = url.href;
  drawQr($('code'), url.href);
}

function showRooms() {
  const list = $('rooms').querySelector('ul');
  list.replaceChildren(...rooms.map(r => {
    const item = node('li', ''), button = node('button', '', r.name === room ? 'here' : '');
    button.append(node('span', r.name), node('span', r.phase ? `${r.game}, ${r.phase}` : r.game), node('span', `${r.players} of ${r.places}`));
    button.onclick = () => {
      room = r.name;
      if (world.match) { link.say('choose', {room}); showMenu(false); } else { showRooms(); showLink(); }
    };
    item.append(button);
    return item;
  }));
  $('rooms').hidden = !rooms.length || !$('bestPage').hidden;
}

/** Shows the best lists instead of the menu, or the menu. */
function turnToBest(on) {
  $('bestPage').hidden = !on;
  bestAsked = 0;
  best = null;
  if (on) askForBest();
  for (const id of ['share', 'keys']) $(id).hidden = on;
  showRooms();
  showStay();
}

function askForBest() {
  bestAsked++;
  link.say('best');
  showBest();
}

/** Shows the lists; the first answers are empty where the server has yet to ask its store. */
function showBest() {
  const lists = (best || []).flatMap(({field, own, entries}) => {
    const list = node('ol', '');
    list.append(...entries.map(({name, value}, i) => {
      const item = node('li', '', i === own ? 'own' : '');
      item.append(node('span', value), i === own ? `${name}  (you)` : name);
      return item;
    }));
    return [node('h2', field), list];
  });
  const why = bestAsked <= TRUSTED ? 'Asking the server ...' : 'Nobody is listed: this game keeps nothing that lasts, or nobody has gained it yet.';
  $('bestPage').querySelector('div').replaceChildren(...lists.length ? lists : [node('p', why)]);
}

/** Shows what the player may choose while playing. */
function showStay() {
  const me = world.players.get(world.match?.player);
  $('stay').hidden = !world.match || !$('bestPage').hidden;
  $('join').hidden = !!world.match;
  if (!world.match) return;
  $('teams').replaceChildren(...world.match.teams.map((team, i) => {
    const button = node('button', '');
    button.append(mark(team.rgb), ` ${team.name}`);
    button.disabled = me?.team === i + 1;
    button.onclick = () => { link.say('choose', {team: i + 1}); showMenu(false); };
    return button;
  }));
  $('watch').textContent = me?.spectator ? 'Play' : 'Watch';
  ready = !!me?.ready;
  $('ready').textContent = ready ? 'Not ready' : 'Ready';
}

function say(player, text, team) {
  const item = node('li', '');
  if (player) item.append(mark(colourOf(player)), node('b', `${player.name}${team ? ' (team)' : ''}: `));
  item.append(text);
  $('lines').append(item);
  while ($('lines').children.length > MOST_LINES) $('lines').firstChild.remove();
  setTimeout(() => item.remove(), LINE_MS);
}

function colourOf(player) {
  const team = world.match?.teams[player.team - 1];
  return team ? team.rgb : player.rgb;
}

function showScores() {
  const all = [...world.players.values()].sort((a, b) => a.spectator - b.spectator || b.score - a.score || a.id - b.id);
  const own = all.findIndex(p => p.id === world.match?.player);
  const shown = all.slice(0, own >= MOST_SCORES ? MOST_SCORES - 1 : MOST_SCORES);
  if (own >= MOST_SCORES) shown.push(all[own]);
  $('scores').replaceChildren(...shown.map(p => {
    const item = node('li', '', p.id === world.match?.player ? 'own' : p.spectator ? 'watches' : ''), name = node('span', '');
    name.append(mark(colourOf(p)), p.name);
    item.append(name, node('span', p.spectator ? 'watches' : p.score));
    return item;
  }));
}

function time(ticks) {
  const s = Math.max(0, Math.ceil(ticks / tickRate));
  return `${Math.floor(s / 60)}:${String(s % 60).padStart(2, '0')}`;
}

/** Writes gauges, clock and phase from the fields that the server told. */
function showGauges() {
  const match = world.match, top = [], bars = [], lines = picture.look?.hud.length ? picture.look.hud : null;
  if (match) {
    for (const gauge of match.gauges) {
      const value = gauge.scope === 'match' ? world.field('match', 0, gauge.field) : world.field('player', match.player, gauge.field);
      if (gauge.kind === 'TEAM_SCORE') {
        match.teams.forEach((team, i) => top.push([team.rgb, `${team.name} ${world.field('match', 0, `${gauge.field}[${i + 1}]`) ?? 0}`]));
      } else if (value === undefined) continue;
      else if (gauge.kind === 'CLOCK') top.push([null, time(value - world.tick)]);
      else if (lines) continue;
      else if (gauge.kind === 'NUMBER') top.push([null, `${gauge.label} ${value}`]);
      else if (gauge.kind === 'BAR') bars.push({id: 'bars', label: gauge.label, share: (value - gauge.least) / (gauge.most - gauge.least)});
    }
    top.push(...phase());
    for (const line of lines || []) ownLine(line, match, top, bars);
  }
  for (const bar of bars) if (bar.share !== undefined) bar.share = Math.round(100 * Math.max(0, Math.min(1, bar.share)));
  const text = JSON.stringify([top, bars]);
  if (text === last) return;
  last = text;
  $('gauges').replaceChildren(...top.map(([rgb, words]) => { const made = node('span', ''); if (rgb !== null) made.append(mark(rgb)); made.append(words); return made; }));
  for (const id of ['bars', 'barsMiddle', 'barsRight']) $(id).replaceChildren(...bars.filter(bar => bar.id === id).map(barNode));
}

/** Adds a line of the game's look: a bar, a number, a time or icons, at its place. */
function ownLine(line, match, top, bars) {
  const look = picture.look, body = world.own?.id ?? -1, number = look.number(world, line.value, match.player, body);
  if (line.condition && !look.number(world, line.condition, match.player, body)) return;
  const id = {BOTTOM: 'barsMiddle', BOTTOM_RIGHT: 'barsRight'}[line.place] || 'bars', seconds = line.value.type === 'COUNTDOWN' ? number / tickRate : number;
  const shown = line.kind === 'WORD' ? look.word(world, line.value, match.player, body) : line.kind === 'TIME' ? `${figure(line, seconds)} s` : figure(line, number);
  const text = `${line.label} ${shown}`;
  if (line.kind === 'BAR') bars.push({id, label: line.label, share: look.share(line.value, number), rgb: line.rgb});
  else if (line.kind === 'ICONS') bars.push({id, icon: look.from + line.label, count: Math.max(0, Math.min(12, Math.round(number)))});
  else if (line.place.startsWith('TOP')) top.push([null, text]);
  else bars.push({id, text});
}

/** Returns a number or a time as the look wants it; looks of older games have no scale. */
function figure({kind, scale = 1, decimals = 0}, value) {
  return decimals ? (scale * value).toFixed(decimals) : kind === 'TIME' ? Math.ceil(scale * value) : Math.round(scale * value);
}

function barNode({label, share, rgb, icon, count, text}) {
  if (text !== undefined) return node('span', text, 'plain');
  const made = node('span', '', icon ? 'icons' : '');
  if (icon) {
    for (let i = 0; i < count; i++) made.append(Object.assign(new Image(), {src: icon, alt: ''}));
    return made;
  }
  const fill = document.createElement('b');
  fill.style.width = `${share}%`;
  if (rgb >= 0) fill.style.background = hex(rgb);
  made.append(fill, node('em', label));
  return made;
}

/** Returns what the clock of a match says: it waits, counts down, is played, or is over. */
function phase() {
  const at = name => world.field('match', 0, name);
  if (at('clockBegun') === undefined && at('clockPlaying') === undefined && at('clockOver') === undefined) return [];
  if (!at('clockBegun')) return [[null, 'waiting for players']];
  if (at('clockPlaying') > world.tick) return [[null, `begins in ${Math.ceil((at('clockPlaying') - world.tick) / tickRate)}`]];
  if (at('clockOver') > world.tick) return at('clockOver') < 1e8 ? [[null, time(at('clockOver') - world.tick)]] : [];
  const team = world.match.teams[at('clockTeam') - 1], winner = world.players.get(at('clockWinner'));
  return [[null, team ? `${team.name} wins` : winner ? `${winner.name} wins` : 'a draw']];
}

const controls = new Controls($('game'), {
  left: $('moveStick'), right: $('aimStick'), buttons: $('buttons'),
}, () => $('menu').hidden && $('chat').hidden && document.activeElement?.tagName !== 'INPUT', () => { $('glass').hidden = false; sounds.wake(); });

function frame() {
  requestAnimationFrame(frame);
  const nowMs = performance.now(), seconds = Math.min(0.1, (nowMs - drawnMs) / 1000);
  drawnMs = nowMs;
  link.watch();
  const input = controls.read((x, y) => picture.toWorld(x, y), picture.ownPose);
  const text = input.map(v => v.toFixed(2)).join();
  if (world.match && (text !== lastInput || nowMs - sentMs > ALIVE_MS)) {
    lastInput = text;
    sentMs = nowMs;
    link.input(...input);
  }
  picture.draw(world.shownTick(nowMs), nowMs, seconds, controls.aim);
  const place = world.match && !picture.showsAll() && picture.look?.minimap;
  $('minimap').hidden = !place;
  if (place) { $('minimap').className = place; picture.drawMinimap($('minimap')); }
  showGauges();
}
let lastInput = '';

setInterval(() => { if (world.match) { link.say('alive'); sendView(); } }, 2000);

/** Tells what is shown, which matters in levels that are larger than a view. */
function sendView() {
  const c = picture.camera, aspect = $('game').clientWidth / $('game').clientHeight;
  link.say('view', {x: c.x, y: c.y, halfWidth: c.height * aspect / 2 + 4, halfHeight: c.height / 2 + 4});
}

$('join').onsubmit = e => { e.preventDefault(); join(); };
$('menuButton').onclick = () => showMenu($('menu').hidden || !world.match);
$('back').onclick = () => showMenu(false);
$('best').onclick = () => turnToBest(true);
$('bestBack').onclick = () => turnToBest(false);
setInterval(() => { if (!$('bestPage').hidden) askForBest(); }, BEST_MS);
$('leave').onclick = () => { link.leave(); end('You have left.'); };
$('watch').onclick = () => { link.say('choose', {role: world.players.get(world.match.player)?.spectator ? 'PLAYER' : 'SPECTATOR'}); showMenu(false); };
$('ready').onclick = () => { link.say('choose', {ready: !ready}); showMenu(false); };
$('sound').onclick = () => { sounds.mute(!sounds.muted); showSound(); };
$('full').onclick = () => document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen?.();
$('copy').onclick = async () => {
  try { await navigator.clipboard.writeText($('link').value); } catch { $('link').select(); document.execCommand('copy'); }
  $('copy').textContent = 'Copied';
  setTimeout(() => { $('copy').textContent = 'Copy'; }, 1500);
};
$('colour').append(...Object.entries(COLOURS).map(([value, label]) => Object.assign(node('option', label), {value})));
$('colour').onchange = () => link.say('choose', {colour: $('colour').value});
$('emotes').append(...Object.entries(EMOTES).map(([name, text]) => {
  const button = node('button', text);
  button.onclick = () => { link.say('emote', {emote: name}); showMenu(false); };
  return button;
}));
function showSound() { $('sound').textContent = sounds.muted ? 'Sound: off' : 'Sound: on'; }
function openChat(on) { $('chat').hidden = !on; if (on) { controls.release(); $('line').focus(); } else { $('line').value = ''; $('game').focus(); } }
$('chatButton').onclick = () => openChat($('chat').hidden);
$('chat').onsubmit = e => {
  e.preventDefault();
  const text = $('line').value.trim();
  if (text) link.say('chat', {text});
  openChat(false);
};
addEventListener('keydown', e => {
  if (e.key === 'Escape') { if (!$('chat').hidden) openChat(false); else if (world.match) showMenu($('menu').hidden); }
  else if (e.key === 'Enter' && $('menu').hidden && $('chat').hidden && world.match) { openChat(true); e.preventDefault(); }
  else if (/^Digit[1-8]$/.test(e.code) && $('menu').hidden && $('chat').hidden && world.match) link.say('emote', {emote: Object.keys(EMOTES)[e.code[5] - 1]});
  else if (e.code === 'KeyM' && $('menu').hidden && $('chat').hidden) { sounds.mute(!sounds.muted); showSound(); }
});
addEventListener('pointerdown', () => sounds.wake());
addEventListener('keydown', () => sounds.wake(), {once: true});
addEventListener('hashchange', () => { room = linked('room'); if (world.match && room && room !== world.match.room) link.say('choose', {room}); });
if (matchMedia('(pointer: coarse)').matches) $('glass').hidden = false;
$('name').value = localStorage.getItem('carom-name') || `Player ${1 + Math.floor(Math.random() * 99)}`;
showSound();
showLink();
showStay();
if (linked('name')) { // this page goes on for one of another server
  $('name').value = linked('name');
  sessionStorage.setItem(SEAT, JSON.stringify({secret: linked('seat') || undefined, name: linked('name')}));
  const words = new URLSearchParams(location.hash.slice(1));
  for (const word of ['name', 'seat', 'ticket']) words.delete(word); // which are this player's alone
  history.replaceState(null, '', `#${words}`);
}
const seat = JSON.parse(sessionStorage.getItem(SEAT) || 'null');
if (seat) {
  $('name').value = seat.name;
  join(seat.secret);
} else {
  Thin.rooms(takeRooms);
  $('name').select();
}
requestAnimationFrame(frame);

/** For tests and the curious. */
window.caromPlay = {world, picture, link, controls};
