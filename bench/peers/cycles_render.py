"""Renders a room that bench_noise exported, in Blender's Cycles: run as `blender -b --factory-startup -P cycles_render.py -- DIR HEIGHT SAMPLES SEED OUT`."""
import array, json, math, resource, sys
import bpy
from mathutils import Vector

folder, height, samples, seed, out = sys.argv[sys.argv.index("--") + 1:]
height, samples, seed = int(height), int(samples), int(seed)
room = json.load(open(f"{folder}/room.json"))


def floats(path):
    values = array.array("f")
    with open(path, "rb") as file:
        values.frombytes(file.read())
    return values


corners = floats(f"{folder}/triangles.f32")

bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene


def material(albedo, emission):
    m = bpy.data.materials.new("m")
    m.use_nodes = True
    nodes, links = m.node_tree.nodes, m.node_tree.links
    nodes.clear()
    result = nodes.new("ShaderNodeOutputMaterial")
    diffuse = nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (*albedo, 1)
    last = diffuse.outputs[0]
    if max(emission) > 0:
        glow, both = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeAddShader")
        top = max(emission)
        glow.inputs["Color"].default_value = (*(e / top for e in emission), 1)
        glow.inputs["Strength"].default_value = top
        links.new(diffuse.outputs[0], both.inputs[0])
        links.new(glow.outputs[0], both.inputs[1])
        last = both.outputs[0]
    links.new(last, result.inputs["Surface"])
    return m


for part in room["meshes"]:
    n = part["triangles"]
    if n == 0:
        continue
    first = 9 * part["first"]
    places = [corners[i:i + 3] for i in range(first, first + 9 * n, 3)]
    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata(places, [], [(i, i + 1, i + 2) for i in range(0, 3 * n, 3)])
    mesh.materials.append(material(part["albedo"], part["emission"]))
    scene.collection.objects.link(bpy.data.objects.new("mesh", mesh))

# The sky, window portals that guide Cycles to it, and the sun.
sky_height = room["sky_height"]
sky = bpy.data.images.new("sky", 2 * sky_height, sky_height, float_buffer=True, is_data=True)
sky.pixels.foreach_set(floats(f"{folder}/sky.f32"))
world = bpy.data.worlds.new("world")
scene.world = world
world.use_nodes = True
texture = world.node_tree.nodes.new("ShaderNodeTexEnvironment")
texture.image = sky
texture.interpolation = "Linear"
world.node_tree.links.new(texture.outputs["Color"], world.node_tree.nodes["Background"].inputs["Color"])
for portal in room["portals"]:
    corner, u, v = (Vector(portal[k]) for k in ("corner", "u", "v"))
    light = bpy.data.lights.new("portal", "AREA")
    light.shape, light.size, light.size_y = "RECTANGLE", u.length, v.length
    light.cycles.is_portal = True
    placed = bpy.data.objects.new("portal", light)
    z = -u.cross(v).normalized()  # an area light shines along -z: into the room
    x = u.normalized()
    y = z.cross(x)
    placed.matrix_world = [[x[i], y[i], z[i], (corner + u / 2 + v / 2)[i]] for i in range(3)] + [[0, 0, 0, 1]]
    scene.collection.objects.link(placed)
irradiance = room["sun_irradiance"]
if max(irradiance) > 0:
    light = bpy.data.lights.new("sun", "SUN")
    light.energy, light.angle = max(irradiance), 0.016
    light.color = [c / max(irradiance) for c in irradiance]
    placed = bpy.data.objects.new("sun", light)
    placed.rotation_mode = "QUATERNION"
    placed.rotation_quaternion = Vector(room["sun_direction"]).to_track_quat("Z", "Y")
    scene.collection.objects.link(placed)

camera = bpy.data.cameras.new("camera")
camera.type = "PANO"
camera.cycles.panorama_type = "EQUIRECTANGULAR"
camera.clip_start = 1e-4
eye = bpy.data.objects.new("camera", camera)
eye.rotation_euler = (math.pi / 2, 0, 0)
scene.collection.objects.link(eye)
scene.camera = eye

scene.render.engine = "CYCLES"
c = scene.cycles
c.device, c.samples, c.seed = "CPU", samples, seed
c.use_adaptive_sampling = c.use_denoising = False
c.pixel_filter_type = "BOX"
c.filter_width = 1
c.max_bounces = c.diffuse_bounces = 48
c.sample_clamp_direct = c.sample_clamp_indirect = 0
c.use_fast_gi = False
scene.render.threads_mode, scene.render.threads = "FIXED", 1
scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 2 * height, height, 100
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"
scene.render.filepath = out + ".exr"
used = lambda: sum(resource.getrusage(resource.RUSAGE_SELF)[:2])
start = used()
bpy.ops.render.render(write_still=True)
cost = used() - start

picture = bpy.data.images.load(out + ".exr")
pixels = list(picture.pixels)
channels = len(pixels) // (2 * height * height)
rows = array.array("f")
for y in reversed(range(height)):  # Blender counts rows from below
    for x in range(2 * height):
        at = channels * (y * 2 * height + x)
        rows.extend(pixels[at:at + 3])
with open(out, "wb") as file:
    rows.tofile(file)
print("CYCLES " + json.dumps({"samples": samples, "cpu_s": cost}))
