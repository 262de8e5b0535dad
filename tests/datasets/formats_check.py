#!/usr/bin/env python3
"""Exports of a set against the set, read by what knows only the format: tarfile, COCO's panoptic format as published,
Structured3D's and Hugging Face's layouts. Python's own library alone.

usage: formats_check.py SET EXPORT...   (an export's kind is told by its name's beginning)
"""
import json
import pathlib
import struct
import sys
import tarfile
import zlib


def png(data):
    """Width, height, and rows of pixels as tuples, of an 8 or 16-bit PNG without interlacing."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        assert struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0] == zlib.crc32(kind + body)
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", body[:10])
        if kind == b"IDAT":
            packed += body
        at += 12 + length
    channels, size = {0: 1, 2: 3}[color], depth // 8
    step, raw, before, rows = channels * size, zlib.decompress(packed), None, []
    for y in range(height):
        begin = y * (width * step + 1)
        kind, line = raw[begin], bytearray(raw[begin + 1:begin + 1 + width * step])
        before = before or bytearray(len(line))
        for i in range(len(line)):
            a, b, c = (line[i - step] if i >= step else 0), before[i], (before[i - step] if i >= step else 0)
            p = a + b - c
            paeth = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
            line[i] = (line[i] + [0, a, b, (a + b) // 2, paeth][kind]) & 255
        before = line
        values = [int.from_bytes(line[i:i + size], "big") for i in range(0, len(line), size)]
        rows.append([tuple(values[i:i + channels]) for i in range(0, len(values), channels)])
    return width, height, rows


class Set:
    def __init__(self, folder):
        self.folder = folder
        self.settings = json.loads((folder / "dataset.json").read_text())
        self.pictures = {}
        for line in (folder / "index.txt").read_text().split():
            about = json.loads((folder / line).read_text())
            self.pictures[about["picture"]] = about
        assert len(self.pictures) == self.settings["count"]

    def data(self, number, channel):
        shard = self.folder / f"shard-{number // self.settings['settings']['shard']:05}"
        return (shard / self.pictures[number][channel]).read_bytes()

    def check_splits(self, splits):
        """Every picture once, every room in one split."""
        assert sorted(n for numbers in splits.values() for n in numbers) == sorted(self.pictures)
        room_in = {}
        for split, numbers in splits.items():
            for n in numbers:
                assert room_in.setdefault(self.pictures[n]["room"], split) == split


def check_webdataset(made, out):
    splits = {}
    for archive in sorted(out.glob("*.tar")):
        split = archive.name.split("-")[0]
        samples = {}
        with tarfile.open(archive, "r:") as tar:
            assert tar.format in (tarfile.USTAR_FORMAT, tarfile.GNU_FORMAT, tarfile.PAX_FORMAT)
            keys = []
            for member in tar:
                assert member.isreg() and member.mtime == 0 and member.uid == member.gid == 0 and member.mode == 0o644
                key, _, extension = member.name.partition(".")
                if not keys or keys[-1] != key:
                    keys.append(key)
                samples.setdefault(key, {})[extension] = tar.extractfile(member).read()
        assert len(keys) == len(samples), "a sample's files must follow each other"
        assert archive.read_bytes()[-1024:] == bytes(1024) and archive.stat().st_size % 10240 == 0
        for key, sample in samples.items():
            about = json.loads(sample["json"])
            number = about["picture"]
            assert key == f"{number:08}" and about == made.pictures[number]
            for channel in ("color", "range", "normal", "class", "instance", "albedo", "shading", "flow"):
                assert sample[channel + "." + about[channel].rsplit(".", 1)[1]] == made.data(number, channel), channel
            assert json.loads(sample["room.json"])["room"]
            splits.setdefault(split, []).append(number)
    made.check_splits(splits)


def check_coco(made, out):
    splits = {}
    for file in sorted((out / "annotations").glob("panoptic_*.json")):
        split = file.stem.split("_")[1]
        coco = json.loads(file.read_text())
        assert set(coco) == {"info", "licenses", "images", "annotations", "categories"}
        categories = {c["id"]: c for c in coco["categories"]}
        assert len(categories) == len(coco["categories"]) == 40
        assert all(set(c) >= {"id", "name", "supercategory", "isthing", "color"} for c in coco["categories"])
        images = {i["id"]: i for i in coco["images"]}
        assert len(images) == len(coco["images"]) == len(coco["annotations"])
        assert all(i["license"] in [x["id"] for x in coco["licenses"]] for i in coco["images"])
        for annotation in coco["annotations"]:
            image = images[annotation["image_id"]]
            number = image["id"]
            assert (out / split / image["file_name"]).read_bytes() == made.data(number, "color")
            # The PNGs lie in a folder with the JSON's name.
            width, height, rows = png((file.with_suffix("") / annotation["file_name"]).read_bytes())
            assert (width, height) == (image["width"], image["height"])
            classes = png(made.data(number, "class"))[2]
            found = {}
            for y, row in enumerate(rows):
                for x, (r, g, b) in enumerate(row):
                    segment = r + 256 * g + 65536 * b
                    assert (segment == 0) == (classes[y][x][0] == 0), "only the outside is void"
                    if segment:
                        area, boxes, labels = found.setdefault(segment, [0, [x, y, x, y], set()])
                        found[segment][0] = area + 1
                        boxes[:] = [min(boxes[0], x), min(boxes[1], y), max(boxes[2], x), max(boxes[3], y)]
                        labels.add(classes[y][x][0])
            infos = {s["id"]: s for s in annotation["segments_info"]}
            assert set(infos) == set(found) and len(infos) == len(annotation["segments_info"])
            for segment, (area, (left, top, right, bottom), labels) in found.items():
                info = infos[segment]
                assert info["area"] == area and info["iscrowd"] == 0
                assert info["bbox"] == [left, top, right - left + 1, bottom - top + 1]
                assert labels == {info["category_id"]} and info["category_id"] in categories
            stuff = [s["category_id"] for s in infos.values() if not categories[s["category_id"]]["isthing"]]
            assert len(stuff) == len(set(stuff)), "one segment for each category that is no thing"
            splits.setdefault(split, []).append(number)
    made.check_splits(splits)


def check_structured3d(made, out):
    lists = [out / f"{split}.txt" for split in ("train", "val", "test")]
    splits = {file.stem: file.read_text().split() for file in lists if file.exists()}
    numbers = {s: [] for s in splits}
    for split, scenes in splits.items():
        for scene in scenes:
            assert json.loads((out / scene / "room.json").read_text())["room"]
            for room in (out / scene / "2D_rendering").iterdir():
                number = int(room.name)
                numbers[split].append(number)
                full = room / "panorama" / "full"
                assert len((room / "panorama" / "camera_xyz.txt").read_text().split()) == 3
                assert png((full / "depth.png").read_bytes())[2] == png(made.data(number, "range"))[2]
                colors = png((full / "semantic.png").read_bytes())[2]
                classes = png(made.data(number, "class"))[2]
                pairs = {(c, k) for a, b in zip(colors, classes) for c, (k,) in zip(a, b)}
                assert len({c for c, _ in pairs}) == len({k for _, k in pairs}) == len(pairs), "a color a class"
                instances = png((full / "instance.png").read_bytes())[2]
                ours = png(made.data(number, "instance"))[2]
                assert all(i == (o or 65535) for a, b in zip(instances, ours) for (i,), (o,) in zip(a, b))
                assert (full / "albedo.png").read_bytes() == made.data(number, "albedo")
                assert png((full / "rgb_rawlight.png").read_bytes())[:2] == (96, 48)
    made.check_splits(numbers)


def check_huggingface(made, out):
    card = (out / "README.md").read_text()
    assert card.startswith("---\n") and "license: cc-by-4.0\n" in card.split("---\n")[1]
    splits = {}
    for folder in sorted((out / "data").iterdir()):
        assert f"path: data/{folder.name}/**" in card
        rows = [json.loads(line) for line in (folder / "metadata.jsonl").read_text().splitlines()]
        assert len({tuple(row) for row in rows}) == 1, "all lines have the same columns"
        for row in rows:
            number = row["picture"]
            assert (folder / row["file_name"]).read_bytes() == made.data(number, "color")
            for channel in ("range", "normal", "class", "instance", "albedo"):
                assert (folder / row[channel + "_file_name"]).read_bytes() == made.data(number, channel)
            for channel in ("shading", "flow"):
                assert (out / row[channel]).read_bytes() == made.data(number, channel)
            assert json.loads((out / row["room_document"]).read_text())["room"]
            splits.setdefault(folder.name, []).append(number)
    made.check_splits(splits)


CHECKS = {"webdataset": check_webdataset, "twos": check_webdataset, "coco": check_coco,
          "structured3d": check_structured3d, "huggingface": check_huggingface}

made = Set(pathlib.Path(sys.argv[1]))
for name in sys.argv[2:]:
    CHECKS[next(kind for kind in CHECKS if name.startswith(kind))](made, pathlib.Path(name))
    print(name, "is as the format says")
