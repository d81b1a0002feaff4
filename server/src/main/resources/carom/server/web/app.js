// The operator's page: one WebSocket, and what it says put in its place.
// What players wrote, such as names, goes to the page as text only, never as HTML.

import {Chart} from './charts.js';
import {hex} from './painter.js';
import {Scene} from './scene.js';

const $ = id => document.getElementById(id);
const MAX_LINES = 500;
const KEY = 'carom-token';

let socket = null;
let admin = false;
let waitMs = 500;
let asked = 0;
let columns = [];
const rooms = new Map();
const past = [];
let pastAt = 0;

const scene = new Scene($('scene'), look => {
  if (look === undefined) { $('follow').value = ''; sendGaze(); } else describe(look);
});

const charts = [
  {title: 'Tick time by stage', unit: 'ms', stacked: true, series: [
    {name: 'inputs', label: 'inputs', colour: 5}, {name: 'step', label: 'step', colour: 1},
    {name: 'capture', label: 'capture', colour: 3}, {name: 'snapshots', label: 'snapshots', colour: 2},
    {name: 'rest', label: 'rest', colour: 4}]},
  {title: 'Tick time', unit: 'ms', series: [
    {name: 'p50', label: 'median', colour: 3}, {name: 'p99', label: 'p99', colour: 2}, {name: 'max', label: 'longest', colour: 6}]},
  {title: 'Processor', unit: '% of a core', series: [{name: 'cpuPercent', label: 'whole server', colour: 1}]},
  {title: 'Memory', unit: 'MB', series: [
    {name: 'residentMb', label: 'resident', colour: 1, help: 'memory of the machine that the server takes'},
    {name: 'heapMb', label: 'heap', colour: 3, help: 'the part that Java objects take'}]},
  {title: 'Load', unit: '%', series: [
    {name: 'load_percent', label: 'of a tick\'s time, 95 %', colour: 1}, {name: 'pace_percent', label: 'pace of time', colour: 2},
    {name: 'narrowPercent', label: 'ticks with narrow views', colour: 4, help: 'players are told only of what they show'}]},
  {title: 'Bandwidth', unit: 'kbit/s', series: [
    {name: 'outKbit', label: 'out', colour: 1}, {name: 'inKbit', label: 'in', colour: 3}]},
  {title: 'Clients', unit: '', whole: true, series: [
    {name: 'players', label: 'players', colour: 1}, {name: 'spectators', label: 'spectators', colour: 4},
    {name: 'players_in_grace', label: 'expected back', colour: 2}]},
  {title: 'Corrections', unit: 'per s', whole: true, series: [
    {name: 'near_disagreements', label: 'predicted otherwise', colour: 2},
    {name: 'divergences_unexplained', label: 'without a reason', colour: 6}]},
  {title: 'Trouble', unit: 'per s', whole: true, series: [
    {name: 'ticks_late', label: 'ticks late', colour: 2}, {name: 'ticks_dropped', label: 'dropped', colour: 6},
    {name: 'snapshots_postponed', label: 'snapshots late', colour: 4},
    {name: 'inputs_missing', label: 'inputs missing', colour: 5}]},
  {title: 'Page', unit: 'ms', series: [{name: 'picture', label: 'pictures, of each tick', colour: 5}]},
].map(each => new Chart($('charts'), each));

function say(message) {
  if (socket && socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(message));
}

function connect() {
  const protocol = location.protocol === 'https:' ? 'wss:' : 'ws:';
  socket = new WebSocket(`${protocol}//${location.host}/live`);
  socket.binaryType = 'arraybuffer';
  socket.onopen = () => {
    waitMs = 500;
    state('connected', 'live');
    const secret = sessionStorage.getItem(KEY);
    if (secret) say({do: 'login', secret});
  };
  socket.onmessage = event => {
    if (typeof event.data !== 'string') return scene.take(event.data);
    const message = JSON.parse(event.data);
    const handle = handlers[message.t];
    if (handle) handle(message);
  };
  socket.onclose = event => {
    state(event.reason || 'no connection', 'lost');
    setTimeout(connect, waitMs);
    waitMs = Math.min(10000, 2 * waitMs);
  };
}

function state(text, kind) {
  $('state').textContent = text;
  $('state').className = kind;
}

function note(text) {
  $('note').textContent = text;
  $('note').hidden = !text;
}

const KEYS = {
  sleeping: 'dashed: asleep', contacts: 'dots: contacts, a line as long as the impulse (log)', cells: 'frames: nodes of the KD-tree, red ones at the root',
};

/** Says what the overlays mean that are on. */
function showKey() {
  const texts = Object.keys(KEYS).filter(name => scene.show[name]).map(name => KEYS[name]);
  if (scene.show.priority) {
    texts.push($('follow').value === '' ? 'priority: follow a player to see it'
      : 'blue to red: priority that waits for ' + $('follow').selectedOptions[0].text);
  }
  $('key').textContent = texts.join(' · ');
  $('key').hidden = !texts.length;
}

function sendGaze() {
  showKey();
  const follow = $('follow').value;
  say({do: 'look', room: document.hidden ? '' : $('room').value, cells: scene.show.cells, contacts: scene.show.contacts,
    priority: scene.show.priority && follow !== '' ? Number(follow) : -1});
}

const handlers = {
  hello(message) {
    admin = message.admin;
    document.body.classList.toggle('is-admin', admin);
    document.body.classList.toggle('locked', !message.watches);
    $('title').textContent = document.title = message.title;
    $('login').hidden = admin;
    $('logout').hidden = !admin;
    note(message.watches ? '' : 'Log in to watch this server.');
    if (!message.watches) return;
    columns = message.columns;
    for (const [name, help] of Object.entries(message.stages)) charts[0].explain(name, help);
    rooms.clear();
    const chosen = $('room').value;
    $('room').replaceChildren();
    for (const room of message.rooms) {
      rooms.set(room.name, room);
      $('room').add(new Option(room.name, room.name));
    }
    if (rooms.has(chosen)) $('room').value = chosen;
    showRoom();
    sendGaze();
    if (admin) say({do: 'recordings'});
  },
  second(message) {
    for (const news of message.rooms) {
      const room = rooms.get(news.name);
      if (!room) continue;
      const rows = room.rows;
      Object.assign(room, news);
      if (news.row) rows.push(news.row);
      if (rows.length > 300) rows.shift();
    }
    showRoom();
    say({do: 'alive'});
  },
  fleet: showFleet,
  match(message) { scene.begin(message.bounds); $('body').hidden = true; },
  looks(message) { scene.learn(message.bodies); },
  players(message) { if (message.room === $('room').value) showPlayers(message.players); },
  best(message) { if (message.room === $('room').value) showBest(message.lists); },
  log(message) {
    for (const [time, level, text] of message.lines) {
      const line = document.createElement('div');
      line.className = level;
      const at = line.appendChild(document.createElement('time'));
      at.textContent = time;
      line.append(text);
      append($('log'), line);
    }
  },
  recordings(message) {
    const body = $('recordings').tBodies[0];
    body.replaceChildren();
    if (!message.files.length) cell(body.insertRow(), 'There are none. The command record begins one.', 'empty');
    for (const file of message.files) {
      const row = body.insertRow();
      cell(row, file.name);
      cell(row, size(file.bytes), 'num');
      cell(row, new Date(file.changed).toLocaleString(), 'wide');
      button(cell(row, '', 'actions'), 'Download', () => say({do: 'download', text: file.name}));
    }
  },
  download(message) { location.assign(message.address); },
  answer(message) {
    if (message.text) output(message.text, message.ok ? '' : 'bad');
  },
  words(message) {
    if (message.id !== asked) return;
    const words = message.words;
    if (words.length === 1) $('line').value = message.before + words[0] + ' ';
    $('words').textContent = words.length > 1 ? words.join('  ') : '';
  },
  refused(message) {
    note(message.why);
    if (!admin) sessionStorage.removeItem(KEY);
  },
};

function showRoom() {
  const room = rooms.get($('room').value);
  if (!room) {
    $('facts').textContent = 'This server has no rooms now.';
    return;
  }
  $('facts').textContent = room.failed ? 'This room has closed itself because of an error.'
    : `${room.game} · ${room.level} · ${room.taken} of ${room.places} places · tick ${room.tick}${room.paused ? ' · paused, as nobody plays' : ''}`;
  for (const chart of charts) chart.show(room.rows, columns);
}

function cell(row, text, kind) {
  const td = row.insertCell();
  td.textContent = text;
  if (kind) td.className = kind;
  return td;
}

function size(bytes) {
  return bytes < 1048576 ? Math.ceil(bytes / 1024) + ' kB' : (bytes / 1048576).toFixed(1) + ' MB';
}

function button(parent, text, action, kind) {
  const made = document.createElement('button');
  made.type = 'button';
  made.textContent = text;
  made.addEventListener('click', action);
  if (kind) made.className = kind;
  parent.append(made);
  return made;
}

const percent = value => value === undefined ? '–' : (100 * value).toFixed(1) + ' %';

/** Shows a table for each field that accounts keep and all may know. */
function showBest(lists) {
  $('best').hidden = lists.length === 0;
  $('best').querySelector('.scroll').replaceChildren(...lists.map(list => {
    const table = document.createElement('table');
    table.createCaption().textContent = list.field;
    for (const [name, value] of list.rows) {
      const row = table.insertRow();
      row.insertCell().textContent = name;
      const cell = row.insertCell();
      cell.className = 'num';
      cell.textContent = value;
    }
    return table;
  }));
}

function showPlayers(players) {
  const follow = $('follow'), chosen = follow.value;
  scene.names = new Map(players.map(player => [player.id, player.name]));
  scene.teams = new Map(players.filter(player => player.team > 0).map(player => [player.id, player.team]));
  scene.chosen = new Map(players.filter(player => player.rgb !== undefined).map(player => [player.id, hex(player.rgb)]));
  const wanted = ['', ...players.map(player => String(player.id))];
  const names = ['nobody', ...players.map(player => player.name)];
  if (document.activeElement !== follow
      && [...follow.options].map(o => o.value + o.text).join() !== wanted.map((v, i) => v + names[i]).join()) {
    follow.replaceChildren(...wanted.map((value, i) => new Option(names[i], value)));
    follow.value = wanted.includes(chosen) ? chosen : '';
    if (follow.value !== chosen) followPlayer('');
  }
  $('count').textContent = players.length;
  const body = $('players').tBodies[0];
  const kept = new Map([...body.rows].map(row => [row.dataset.key, row]));
  const rows = players.map(player => {
    const key = player.id + ' ' + player.name + ' ' + admin;
    const row = kept.get(key) || newRow(player, key);
    const values = [player.name, player.state, player.team < 0 ? '–' : player.team, player.score,
      player.ms ? player.ms + ' ms' : '–', percent(player.loss), player.kbit === undefined ? '–' : player.kbit.toFixed(0),
      percent(player.right), player.address || ''];
    values.forEach((value, i) => { if (row.cells[i].textContent !== String(value)) row.cells[i].textContent = value; });
    row.cells[0].style.setProperty('--mark', scene.playerColour(player.id));
    row.cells[4].classList.toggle('bad', player.ms > 250);
    row.cells[5].classList.toggle('bad', player.loss > 0.05);
    row.cells[7].classList.toggle('bad', player.right < 0.9);
    row.classList.toggle('followed', String(player.id) === $('follow').value);
    return row;
  });
  if (!rows.length) {
    const row = document.createElement('tr');
    cell(row, 'Nobody plays.', 'empty').colSpan = 10;
    rows.push(row);
  }
  if (rows.length !== body.rows.length || rows.some((row, i) => row !== body.rows[i])) body.replaceChildren(...rows);
}

function newRow(player, key) {
  const row = document.createElement('tr');
  row.dataset.key = key;
  for (const kind of ['', 'wide', 'wide num', 'num', 'num', 'num', 'wide num', 'num', 'wide admin']) cell(row, '', kind);
  const actions = cell(row, '', 'actions');
  const follow = () => followPlayer(String(player.id) === $('follow').value ? '' : String(player.id));
  row.cells[0].addEventListener('click', follow);
  button(actions, 'Follow', follow, 'follow');
  if (admin) {
    button(actions, 'Kick', () => sure('kick', player), 'danger');
    button(actions, 'Ban', () => sure('ban', player), 'danger');
  }
  return row;
}

function followPlayer(id) {
  $('follow').value = id;
  scene.follow = id === '' ? null : Number(id);
  if (id !== '' && scene.camera.scale < 12) scene.camera.scale = 24;
  sendGaze();
}

/** Says what is known of a body that was clicked. */
function describe(look) {
  $('body').hidden = !look;
  if (!look) return;
  const owner = look.owner >= 0 ? ` of ${scene.names.get(look.owner) || 'player ' + look.owner}` : '';
  $('body').textContent = `${look.kind || 'body'}${owner} · ${look.entity < 0 ? 'part of the level' : 'entity ' + look.entity} · ${look.type}`;
  if (look.owner >= 0) {
    $('body').style.borderLeft = '4px solid ' + scene.playerColour(look.owner);
    button($('body'), 'Follow', () => followPlayer(String(look.owner)));
  } else {
    $('body').style.borderLeft = '';
  }
  const follow = $('follow').value;
  if (admin && look.entity >= 0) {
    button($('body'), 'Fields', () => run(`fields entity ${look.entity} @${$('room').value}`));
    if (follow !== '') button($('body'), 'Why', () => run(`why #${follow} ${look.entity} @${$('room').value}`));
  }
}

/** Asks before something that players notice; parts are what the dialog shows besides the question. */
function ask(question, verb, parts, then) {
  const dialog = $('sure');
  $('sure-title').textContent = question;
  $('sure-ok').textContent = verb;
  for (const part of ['time', 'why', 'to', 'text']) $('sure-' + part).hidden = !parts.includes(part);
  dialog.returnValue = '';
  dialog.onclose = () => { if (dialog.returnValue === 'ok') then(); };
  dialog.showModal();
}

/** Asks before a player is removed. The room is the line's last word, so that no reason can name another. */
function sure(what, player) {
  const verb = what === 'ban' ? 'Ban' : 'Kick';
  $('sure-reason').value = '';
  ask(`${verb} ${player.name}?`, verb, what === 'ban' ? ['time', 'why'] : ['why'], () => {
    const reason = $('sure-reason').value.replaceAll('"', "'").trim();
    const time = what === 'ban' ? ' ' + $('sure-time').querySelector('select').value : '';
    run(`${what} #${player.id}${time}${reason ? ` "${reason}"` : ''} @${$('room').value}`);
  });
}

/** Puts rows of values into a table, and keeps the rows that stay, so that their buttons can be clicked. */
function fill(table, items, kinds, values, actions) {
  const body = $(table).tBodies[0];
  const kept = new Map([...body.rows].map(row => [row.dataset.key, row]));
  const rows = items.map(item => {
    const key = item.name + ' ' + admin;
    let row = kept.get(key);
    if (!row) {
      row = document.createElement('tr');
      row.dataset.key = key;
      for (const kind of kinds) cell(row, '', kind);
      const place = cell(row, '', 'actions');
      if (admin) actions(place, item);
    }
    values(item).forEach((value, i) => { if (row.cells[i].textContent !== String(value)) row.cells[i].textContent = value; });
    return row;
  });
  if (rows.length !== body.rows.length || rows.some((row, i) => row !== body.rows[i])) body.replaceChildren(...rows);
  return rows;
}

let fleet = null;

function showFleet(message) {
  fleet = message;
  $('fleet').hidden = false;
  const byName = (a, b) => a.name.localeCompare(b.name, undefined, {numeric: true});
  const more = message.all - message.rooms.length;
  $('fleet-state').textContent = `${message.servers.length} servers, ${message.all} rooms${more ? ` (${more} not shown)` : ''} · `
    + (message.directory ? `lease ${message.lease.toFixed(1)} s` : 'the directory doesn\'t answer');
  $('fleet-state').classList.toggle('bad', !message.directory);
  const servers = message.servers.sort(byName);
  fill('fleet-servers', servers, ['', '', 'num', 'num', 'wide num', 'num'],
    s => [s.name + (s.self ? ' (this one)' : ''), s.draining ? 'draining' : 'up', s.load + ' %', s.rooms, s.follows, s.players],
    (place, s) => {
      button(place, 'Drain', () => drain(s.name), 'danger');
      button(place, 'Undrain', () => run(`fleet undrain "${s.name}"`));
    })
    .forEach((row, i) => {
      row.cells[0].title = 'Players reach it at ' + servers[i].address;
      row.cells[1].classList.toggle('bad', servers[i].draining);
      for (const made of row.querySelectorAll('button')) made.hidden = servers[i].draining !== (made.textContent === 'Undrain');
    });
  const rooms = message.rooms.sort(byName);
  const lag = r => !r.follower ? '–' : r.exact ? r.lag : r.lag ? `≥ ${r.lag}` : `< ${message.step}`;
  fill('fleet-rooms', rooms, ['', 'wide', 'num', 'wide num', '', 'wide num', 'wide', 'wide num'],
    r => [r.name, r.level ? `${r.game} · ${r.level}` : r.game, `${r.players}/${r.places}`, r.skill ?? '–', r.owner || 'gone', r.claim, r.follower || 'none yet', lag(r)],
    (place, r) => button(place, 'Move', () => move(r.name), 'danger'))
    .forEach((row, i) => row.cells[6].classList.toggle('bad', rooms[i].lag >= message.step));
  $('fleet-news').replaceChildren(...message.news.map(([age, text]) => {
    const line = document.createElement('li');
    line.className = /^lost|is lost$|doesn't answer$/.test(text) ? 'WARN' : '';
    const at = line.appendChild(document.createElement('time'));
    at.textContent = new Date(Date.now() - 1000 * age).toLocaleTimeString();
    line.append(text);
    return line;
  }));
}

/** Asks before a room moves, and where to. */
function move(room) {
  const owner = fleet.rooms.find(r => r.name === room)?.owner;
  const others = fleet.servers.filter(s => s.name !== owner && !s.draining).map(s => s.name);
  $('sure-to').querySelector('select').replaceChildren(new Option('the best server', ''), ...others.map(name => new Option(name)));
  $('sure-text').textContent = 'Its players go along and notice a moment at most.';
  ask(`Move room ${room}?`, 'Move', ['to', 'text'], () => {
    const to = $('sure-to').querySelector('select').value;
    run(`fleet move "${room}"${to ? ` "${to}"` : ''}`);
  });
}

/** Asks before a server loses all its rooms. */
function drain(server) {
  $('sure-text').textContent = 'All its rooms move to other servers, with their players. It takes no more until you undrain it.';
  ask(`Drain ${server}?`, 'Drain', ['text'], () => run(`fleet drain "${server}"`));
}

function append(parent, line) {
  const atEnd = parent.scrollHeight - parent.scrollTop - parent.clientHeight < 30;
  parent.append(line);
  while (parent.childElementCount > MAX_LINES) parent.firstElementChild.remove();
  if (atEnd) parent.scrollTop = parent.scrollHeight;
}

function output(text, kind) {
  const line = document.createElement('div');
  line.textContent = text;
  line.className = kind;
  append($('output'), line);
}

function run(line) {
  output('> ' + line, 'asked');
  say({do: 'run', id: ++asked, text: line});
}

$('login').addEventListener('submit', event => {
  event.preventDefault();
  const secret = $('secret').value.trim();
  $('secret').value = '';
  sessionStorage.setItem(KEY, secret);
  note('');
  say({do: 'login', secret});
});
$('logout').addEventListener('click', () => { sessionStorage.removeItem(KEY); location.reload(); });
$('run').addEventListener('submit', event => {
  event.preventDefault();
  const line = $('line').value.trim();
  if (!line) return;
  past.push(line);
  pastAt = past.length;
  $('line').value = $('words').textContent = '';
  run(line);
});
$('line').addEventListener('keydown', event => {
  if (event.key === 'Tab' && $('line').value && !event.shiftKey) {
    event.preventDefault();
    say({do: 'complete', id: ++asked, text: $('line').value});
  } else if ((event.key === 'ArrowUp' || event.key === 'ArrowDown') && past.length) {
    pastAt = Math.max(0, Math.min(past.length, pastAt + (event.key === 'ArrowUp' ? -1 : 1)));
    $('line').value = past[pastAt] || '';
    event.preventDefault();
  }
});
$('room').addEventListener('change', () => {
  scene.reset();
  followPlayer('');
  showPlayers([]);
  showRoom();
});
$('follow').addEventListener('change', () => followPlayer($('follow').value));
$('fit').addEventListener('click', () => { followPlayer(''); scene.fit(); });
$('refresh').addEventListener('click', () => say({do: 'recordings'}));
for (const name of Object.keys(scene.show)) {
  $(name).addEventListener('change', () => { scene.show[name] = $(name).checked; sendGaze(); });
}
document.addEventListener('visibilitychange', sendGaze);
window.addEventListener('resize', () => charts.forEach(chart => chart.draw()));
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => charts.forEach(chart => chart.draw()));
Object.defineProperty(window, 'caromScene', {value: scene}); // for tests and the curious
connect();
