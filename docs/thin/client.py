"""A thin client of Carom in fifty lines: joins, steers, sees its body move, chats, leaves.

pip install websockets;  python client.py ws://localhost:8080/thin Ann
"""
import json
import sys
import time
from websockets.sync.client import connect

address, name = sys.argv[1:3]
bodies, players, me, tick, count = {}, {}, -1, -1, 0


def say(kind, **values):
    link.send(json.dumps({kind: values}))


def told(kind, value):
    global me, tick
    if kind == "match":  # the first, or the next
        me, tick = value["player"], -1
        bodies.clear()
        players.clear()
        print(f"{value['game']} in {value['level']}, room {value['room']}, I am {me}")
    elif kind == "snapshot":
        tick = value["tick"]
        for id, x, y, angle, *new in value["bodies"]:
            owner = new[1] if new else bodies[id]["owner"]
            bodies[id] = {"x": x, "y": y, "angle": angle, "owner": owner}
        for id in value["gone"]:
            bodies.pop(id, None)
    elif kind == "roster":
        players.update((p["id"], p["name"]) for p in value["players"])
    elif kind == "chat":
        print(f"{players.get(value['player'], 'server')}: {value['text']}")
    elif kind in ("refused", "goodbye"):
        sys.exit(f"{kind}: {value['text']}")


with connect(address) as link:
    say("join", name=name)
    end, path = None, []
    while end is None or time.monotonic() < end:
        (kind, value), = json.loads(link.recv(timeout=10)).items()
        told(kind, value)
        if kind == "snapshot":
            end = end or time.monotonic() + 3  # plays for 3 s
            count += 1
            say("input", count=count, seen=tick, inputs=[[0, 1, 0, 0]])  # to the right
            if count == 20:
                say("chat", text="hello from Python")
            path += [b["x"] for b in bodies.values() if b["owner"] == me]
    print(f"moved from {path[0]:.2f} to {path[-1]:.2f}" if path else "no body")
    say("leave")
