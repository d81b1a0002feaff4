# A thin client of Carom for Godot 4: put it on a Node2D. Arrow keys steer, space jumps.
extends Node2D

@export var address := "ws://localhost:8080/thin"
@export var player_name := "Godot"

var link := WebSocketPeer.new()
var joined := false
var game := {}        # the last match
var players := {}     # id -> what the roster says
var bodies := {}      # id -> {kind, owner, poses}
var secret := ""
var tick_rate := 60.0
var rate := 30.0
var count := 0
var newest := -1
var heard := 0.0      # seconds
var clock := 0.0      # the tick shown


func _ready() -> void:
	link.inbound_buffer_size = 1 << 20
	link.connect_to_url(address)


func say(kind: String, values: Dictionary) -> void:
	link.send_text(JSON.stringify({kind: values}))


func _process(delta: float) -> void:
	link.poll()
	if link.get_ready_state() != WebSocketPeer.STATE_OPEN:
		return
	if not joined:
		joined = true
		say("join", {"name": player_name})
	while link.get_available_packet_count() > 0:
		var message: Dictionary = JSON.parse_string(link.get_packet().get_string_from_utf8())
		for kind in message:
			told(kind, message[kind])
	if newest < 0:
		return
	count += 1
	var move := Input.get_vector("ui_left", "ui_right", "ui_down", "ui_up")
	var buttons := 1 if Input.is_action_pressed("ui_accept") else 0
	say("input", {"count": count, "seen": newest, "inputs": [[buttons, move.x, move.y, 0]]})
	var due := newest + (now() - heard) * tick_rate - 2 * tick_rate / rate  # two snapshots late
	clock += delta * tick_rate
	clock = due if absf(due - clock) > tick_rate else lerpf(clock, due, minf(1, delta / 0.3))
	queue_redraw()


func now() -> float:
	return Time.get_ticks_usec() / 1e6


func told(kind: String, value: Dictionary) -> void:
	match kind:
		"welcome":
			secret = value.secret
			tick_rate = value.tickRate
			rate = value.rate
		"match":
			game = value
			bodies.clear()
			players.clear()
			newest = -1
		"roster":
			for player in value.players:
				players[int(player.id)] = player
		"snapshot":
			for id in value.gone:
				bodies.erase(int(id))
			for b in value.bodies:
				var id := int(b[0])
				if b.size() > 4:  # new, or it jumped
					bodies[id] = {"kind": int(b[4]), "owner": int(b[5]), "poses": []}
				var poses: Array = bodies[id].poses
				if not poses.is_empty() and poses[-1][0] < newest:
					var last: Array = poses[-1]
					poses.append([newest, last[1], last[2]])  # it stood still until then
				poses.append([int(value.tick), Vector2(b[1], b[2]), float(b[3])])
			newest = int(value.tick)
			heard = now()
		"chat":
			print(value.text)
		"refused", "goodbye":
			print(value.text)


func _draw() -> void:
	if game.is_empty():
		return
	var b: Array = game.bounds
	var size := get_viewport_rect().size
	var scale_by := minf(size.x / (b[2] - b[0]), size.y / (b[3] - b[1]))
	var middle := Vector2(b[0] + b[2], b[1] + b[3]) / 2
	var flip := Transform2D(Vector2(scale_by, 0), Vector2(0, -scale_by), size / 2)
	var view := flip * Transform2D(0, -middle)
	for g in game.ground:
		paint(view * Transform2D(g.angle, Vector2(g.x, g.y)), g.kind, int(g.kind.rgb))
	for body in bodies.values():
		var poses: Array = body.poses
		while poses.size() > 1 and poses[1][0] <= clock:
			poses.pop_front()
		var p: Array = poses[0]
		var q: Array = poses[1] if poses.size() > 1 else p
		var f := 0.0 if p == q else maxf(0, (clock - p[0]) / (q[0] - p[0]))
		var place: Vector2 = p[1].lerp(q[1], f)
		var kind: Dictionary = game.archetypes[body.kind]
		var rgb := int(kind.rgb)
		if kind.look == "PLAYER" and players.has(body.owner) and players[body.owner].rgb >= 0:
			rgb = int(players[body.owner].rgb)
		paint(view * Transform2D(lerp_angle(p[2], q[2], f), place), kind, rgb)


func paint(at: Transform2D, kind: Dictionary, rgb: int) -> void:
	draw_set_transform_matrix(at)
	var color := Color.hex((rgb << 8) | 0xff)
	for part in kind.parts:
		var corners := PackedVector2Array()
		for i in range(0, part.corners.size(), 2):
			corners.append(Vector2(part.corners[i], part.corners[i + 1]))
		if corners.size() >= 3:
			draw_colored_polygon(corners, color)
		elif corners.size() == 2:
			draw_line(corners[0], corners[1], color, 2 * part.radius)
		if corners.size() < 3:
			for corner in corners:
				draw_circle(corner, part.radius, color)
