# Blender shows room.glb: from its own camera each thing covers the pixels that the traced room says, in the colors that
# it has there, and its lamps, its sun and its sky light it.
#   blender --background --factory-startup -t 1 --python-exit-code 1 --python blender_check.py -- STEM PICTURE.png
# Reads STEM.room.glb, STEM.instances.json with the things' ids, STEM.instances.png with the number of the thing in each
# pixel as gray, and STEM.colors.png with its color. Writes a small lit picture.
import json
import math
import os
import struct
import sys

import numpy

# The importer of Debian 12's Blender 3.4 asks for a name that Debian's NumPy 1.24 no longer has.
if 'bool' not in numpy.__dict__:
    numpy.bool = bool

import bpy
from mathutils import Vector

LEAST_IOU, LEAST_PIXELS = 0.99, 400  # of a thing: outlines of smaller ones are most of them
FARTHEST_COLOR = 0.02  # sRGB, 0 to 1: what a thing's mean color may differ by
LEAST_LIKENESS = 0.95  # correlation of the brightness within a thing that is patterned
PATTERNED = 0.06  # sRGB: standard deviation of such a thing's brightness
SIZE_ERROR_M = 0.01
# Their size_m is that of the opening, without frame and sill, or that of the whole ceiling.
PART_OF_THE_SHELL = ('door', 'window', 'skylight', 'recessed_lights')
LIT_WIDTH, LIT_SAMPLES = 160, 16  # enough to see whether there is light
LEAST_MEAN, LEAST_DEVIATION = 0.05, 0.04  # of the lit picture, 0 to 1

failed = False


def expect(ok, text):
    global failed
    failed = failed or not ok
    print(f"blender {bpy.app.version_string}: {'ok' if ok else 'FAILED'}: {name}: {text}")


def json_of_glb(path):
    with open(path, 'rb') as file:
        file.seek(12)
        return json.loads(file.read(struct.unpack('<I4x', file.read(8))[0]))


# As an array of rows, the lowest first, without any conversion of colors.
def pixels_of(path):
    image = bpy.data.images.load(path)
    width, height = image.size
    values = numpy.empty(width * height * 4, numpy.float32)
    image.pixels.foreach_get(values)
    bpy.data.images.remove(image)
    return values.reshape(height, width, 4)


def render(path, width, height, samples, file_format, bits):
    scene = bpy.context.scene
    scene.render.engine = 'CYCLES'
    scene.cycles.samples = samples
    scene.cycles.use_denoising = False
    scene.cycles.use_adaptive_sampling = False
    scene.render.resolution_x, scene.render.resolution_y = width, height
    scene.render.image_settings.file_format, scene.render.image_settings.color_depth = file_format, bits
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True)
    return pixels_of(path)


# What the centers of the pixels show, where every surface glows by itself; the outside is black.
def render_centers(path, width, height):
    bpy.context.scene.world = None
    cycles = bpy.context.scene.cycles
    cycles.pixel_filter_type, cycles.filter_width = 'BOX', 0.01
    cycles.max_bounces = 0
    return render(path, width, height, 1, 'OPEN_EXR', '32')


def glow(tree, color, strength):
    emission = tree.nodes.new('ShaderNodeEmission')
    for socket, source in ((emission.inputs['Color'], color), (emission.inputs['Strength'], strength)):
        if isinstance(source, bpy.types.NodeSocket):
            tree.links.new(source, socket)
        else:
            socket.default_value = source
    output = next((n for n in tree.nodes if n.type == 'OUTPUT_MATERIAL'), None)
    tree.links.new(emission.outputs[0], (output or tree.nodes.new('ShaderNodeOutputMaterial')).inputs['Surface'])


def check_import(gltf, numbers):
    things = {o['id']: o for o in bpy.data.objects if 'id' in o}
    expect(set(things) == set(numbers) - {'outside'} and all(o.name == i for i, o in things.items()),
           f'{len(things)} things, each named by its id')
    errors = []
    for thing in things.values():
        if 'size_m' in thing and thing['class'] not in PART_OF_THE_SHELL:
            side, up, front = thing['size_m']
            box = numpy.array(thing.bound_box)
            errors.append((numpy.abs(box.max(0) - box.min(0) - (side, front, up)).max(), thing.name))
    worst = max(errors)
    expect(worst[0] <= SIZE_ERROR_M, f'metres, z up: sizes within {worst[0]:.4f} m, {worst[1]}')
    materials = [m.name for m in bpy.data.materials]
    pictures = [i.name for i in bpy.data.images]
    expect(pictures and all(i.removesuffix(' picture') in materials for i in pictures),  # ' picture': that of a screen
           f'{len(pictures)} pictures, named as their materials')
    lamps = [o for o in bpy.data.objects if o.type == 'LIGHT']
    inside = [o.parent is None or
              all(low - 0.01 <= x <= high + 0.01 for x, low, high in
                  zip(o.location, *(f([Vector(c) for c in o.parent.bound_box], axis=0)
                                    for f in (numpy.min, numpy.max)))) for o in lamps]
    expect(len(lamps) == len(gltf['extensions']['KHR_lights_punctual']['lights']) and all(inside),
           f'{len(lamps)} lights, lamps amid their things')
    suns = [o for o in lamps if o.data.type == 'SUN']
    expect(all((o.matrix_world.to_3x3() @ Vector((0, 0, -1))).z < 0 for o in suns), f'suns that shine down: {len(suns)}')
    return things


def check_silhouettes(things, numbers, stem, out):
    wanted = numpy.rint(pixels_of(stem + '.instances.png')[:, :, 0] * 255).astype(int)
    height, width = wanted.shape
    number = bpy.data.materials.new('number')
    number.use_nodes = True
    number.node_tree.nodes.clear()
    glow(number.node_tree, (1, 1, 1, 1), number.node_tree.nodes.new('ShaderNodeObjectInfo').outputs['Object Index'])
    for i, thing in things.items():
        thing.pass_index = numbers[i]
    layer = bpy.context.view_layer
    layer.material_override = number
    seen = numpy.rint(render_centers(out + '.numbers.exr', width, height)[:, :, 0]).astype(int)
    layer.material_override = None
    compared = []
    for i, n in numbers.items():
        ours, theirs = wanted == n, seen == n
        if ours.sum() >= LEAST_PIXELS:
            compared.append(((ours & theirs).sum() / (ours | theirs).sum(), i))
    worst = min(compared)
    expect(len(compared) > 5 and worst[0] >= LEAST_IOU,
           f'{len(compared)} things where the traced room has them; the worst is {worst[1]}: IoU {worst[0]:.4f}; '
           f'{(wanted != seen).sum()} of {wanted.size} pixels differ')
    return wanted


def check_colors(numbers, wanted_numbers, stem, out):
    wanted = pixels_of(stem + '.colors.png')[:, :, :3]
    height, width = wanted_numbers.shape
    for material in bpy.data.materials:
        principled = next((n for n in material.node_tree.nodes if n.type == 'BSDF_PRINCIPLED'), None)
        if principled:
            color = principled.inputs['Base Color']
            glow(material.node_tree, color.links[0].from_socket if color.is_linked else color.default_value, 1)
    linear = render_centers(out + '.colors.exr', width, height)[:, :, :3]
    seen = numpy.where(linear <= 0.0031308, 12.92 * linear, 1.055 * numpy.maximum(linear, 1e-6) ** (1 / 2.4) - 0.055)
    distances, likenesses = [], []
    for i, n in numbers.items():
        mask = wanted_numbers == n
        if i == 'outside' or mask.sum() < LEAST_PIXELS:
            continue
        ours, theirs = wanted[mask], seen[mask]
        distances.append((numpy.abs(ours.mean(0) - theirs.mean(0)).max(), i))
        if ours.mean(1).std() >= PATTERNED:
            likenesses.append((numpy.corrcoef(ours.mean(1), theirs.mean(1))[0, 1], i))
    farthest, least = max(distances), min(likenesses)
    expect(len(distances) > 5 and farthest[0] <= FARTHEST_COLOR,
           f'{len(distances)} things in their colors; the farthest is {farthest[1]}: {farthest[0]:.3f}')
    expect(least[0] >= LEAST_LIKENESS,
           f'{len(likenesses)} patterned things; the least alike is {least[1]}: correlation {least[0]:.3f}')


def check_light(picture):
    scene = bpy.context.scene
    scene.world = bpy.data.worlds.new('sky')
    scene.world.use_nodes = True
    sky = [sum(c) / 2 for c in zip(scene['sky']['zenith'], scene['sky']['horizon'])]
    scene.world.node_tree.nodes['Background'].inputs['Color'].default_value = (*sky, 1)
    lit = render(picture, LIT_WIDTH, LIT_WIDTH * 3 // 4, LIT_SAMPLES, 'PNG', '8')[:, :, 1]
    expect(lit.mean() >= LEAST_MEAN and lit.std() >= LEAST_DEVIATION,
           f'the room is lit (mean {lit.mean():.2f}, deviation {lit.std():.2f})')


stem, picture = sys.argv[sys.argv.index('--') + 1:]
name = os.path.basename(stem) + '.room.glb'
out = os.path.splitext(picture)[0]
with open(stem + '.instances.json') as file:
    numbers = {i['id']: i['instance'] for i in json.load(file)}
bpy.ops.wm.read_factory_settings(use_empty=True)
# Lights and glowing surfaces in one unit; called so in later Blenders.
mode = 'export_import_convert_lighting_mode'
if mode not in bpy.ops.import_scene.gltf.get_rna_type().properties:
    mode = 'convert_lighting_mode'
bpy.ops.import_scene.gltf(filepath=stem + '.room.glb', **{mode: 'COMPAT'})
bpy.context.scene.camera = bpy.data.objects['camera']
things = check_import(json_of_glb(stem + '.room.glb'), numbers)
check_light(picture)
check_colors(numbers, check_silhouettes(things, numbers, stem, out), stem, out)
sys.exit(1 if failed else 0)
