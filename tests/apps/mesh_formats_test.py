# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes in VTU and glTF, written here by Python's own means: read alike in every form, or refused by name."""
import base64
import collections
import itertools
import json
import os
import re
import struct
import unittest
import zlib

from program import ProgramTest, small

# A tetrahedron whose faces run counterclockwise as seen from inside.
POINTS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 0.75)]
FACES = [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)]
NAMES = ["floor", "wall", "wall", "roof & ridge"]


def vtu(form="ascii", encoding="base64", header="UInt64", packed=False, order="<", reals="Float64", **changes):
    """The tetrahedron as VTU. A change replaces a text by another."""
    letters = {"Float64": "d", "Float32": "f", "Int64": "q", "Int32": "i", "UInt8": "B"}
    header_letter = {"UInt64": "Q", "UInt32": "I"}[header]
    appended = b""

    def encoded(raw):
        pack = lambda *numbers: struct.pack(order + header_letter * len(numbers), *numbers)
        as_text = base64.b64encode if form == "binary" or encoding == "base64" else lambda b: b
        if not packed:
            return as_text(pack(len(raw)) + raw)
        size = 16
        blocks = [raw[k:k + size] for k in range(0, len(raw), size)]
        deflated = [zlib.compress(block) for block in blocks]
        return (as_text(pack(len(blocks), size, len(raw) % size, *map(len, deflated)))
                + as_text(b"".join(deflated)))

    def array(type_name, name, numbers, more=""):
        nonlocal appended
        start = f'<DataArray type="{type_name}" Name="{name}"{more} format="{form}"'
        if form == "ascii":
            return start + ">" + " ".join(map(repr, numbers)) + "</DataArray>\n"
        data = encoded(struct.pack(order + letters[type_name] * len(numbers), *numbers))
        if form == "binary":
            return start + ">\n" + data.decode() + "\n</DataArray>\n"
        offset = len(appended)
        appended += data
        return start + f' offset="{offset}"/>\n'

    legend = ["floor", "wall", "roof &amp; ridge"]
    numbers = [0, 1, 1, 2]
    text = ('<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" byte_order="'
            + ("LittleEndian" if order == "<" else "BigEndian") + f'" header_type="{header}"'
            + (' compressor="vtkZLibDataCompressor"' if packed else "") + ">\n<UnstructuredGrid><FieldData>\n"
            + "".join(array("Int32", f"piece {k}: {name}", [k], ' NumberOfTuples="1"') for k, name in enumerate(legend))
            + f'</FieldData><Piece NumberOfPoints="{len(POINTS)}" NumberOfCells="{len(FACES) + 1}">\n<CellData>'
            + array("Int32", "piece", [9] + numbers) + "</CellData><Points>\n"
            + array(reals, "points", [x for p in POINTS for x in p], ' NumberOfComponents="3"') + "</Points><Cells>\n"
            + array("Int64", "connectivity", [3] + [c for f in FACES for c in f])
            + array("Int64", "offsets", [1 + 3 * k for k in range(len(FACES) + 1)])
            + array("UInt8", "types", [1] + [5] * len(FACES)) + "</Cells></Piece></UnstructuredGrid>\n")
    for old, new in changes.items():
        assert old in text
        text = text.replace(old, new)
    out = text.encode()
    if form == "appended":
        out += f'<AppendedData encoding="{encoding}">\n_'.encode() + appended + b"\n</AppendedData>\n"
    return out + b"</VTKFile>\n"


def gltf(mode=4, indices=5123, node=None, binary=True, **changes):
    """The tetrahedron as glTF, a mesh a name, its corners apart as exporters have them."""
    groups = {}
    for face, name in zip(FACES, NAMES):
        groups.setdefault(name, []).append(face)
    data, views, accessors, meshes, nodes = b"", [], [], [], []

    def accessor(raw, component, count, kind):
        nonlocal data
        data += b"\0" * (-len(data) % 4)
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(raw)})
        data += raw
        accessors.append({"bufferView": len(views) - 1, "componentType": component, "count": count, "type": kind})
        return len(accessors) - 1

    letter = {5121: "B", 5123: "H", 5125: "I"}
    for name, faces in groups.items():
        corners = [POINTS[c] for face in faces for c in face]
        place = accessor(struct.pack("<" + "fff" * len(corners), *itertools.chain(*corners)), 5126, len(corners), "VEC3")
        primitive = {"attributes": {"POSITION": place}, "mode": mode, "material": 0}
        if indices:
            numbers = range(len(corners))
            primitive["indices"] = accessor(struct.pack(f"<{len(corners)}{letter[indices]}", *numbers), indices,
                                            len(corners), "SCALAR")
        meshes.append({"primitives": [primitive]})
        nodes.append({"name": name, "mesh": len(meshes) - 1})
    if node is not None:
        nodes.append({"children": list(range(len(nodes))), **node})
    document = {"asset": {"version": "2.0"}, "scene": 0,
                "scenes": [{"nodes": [len(nodes) - 1] if node is not None else list(range(len(nodes)))}],
                "nodes": nodes, "meshes": meshes, "materials": [{"name": "paint"}], "accessors": accessors,
                "bufferViews": views, "buffers": [{"byteLength": len(data)}]}
    if not binary:
        document["buffers"][0]["uri"] = ("data:application/octet-stream;base64," + base64.b64encode(data).decode())
    document.update(changes)
    text = json.dumps(document).encode()
    if not binary:
        return text
    chunk = lambda kind, raw, fill: struct.pack("<II", len(raw) + -len(raw) % 4, kind) + raw + fill * (-len(raw) % 4)
    body = chunk(0x4E4F534A, text, b" ") + chunk(0x004E4942, data, b"\0")
    return struct.pack("<III", 0x46546C67, 2, 12 + len(body)) + body


class MeshFormats(ProgramTest):
    def surface(self, name, content):
        self.write(name, content)
        return json.loads(self.expect(0, "surface", name, "--json", "-"))

    def check(self, name, content, scale=1, materials=False):
        found = self.surface(name, content)
        self.assertEqual(found["triangles"], 4)
        self.assertTrue(found["closed"])
        # A group of two planes makes two pieces, wall_1 and wall_2.
        names = {re.sub("_[0-9]$", "", piece["name"]) for piece in found["pieces"]}
        self.assertEqual(names, {n + ("/paint" if materials else "") for n in NAMES})
        areas = collections.Counter()
        for piece in found["pieces"]:
            areas[re.sub("_[0-9]$", "", piece["name"]).split("/")[0]] += piece["area"]
        self.assertAlmostEqual(areas["floor"], 0.5 * scale**2, delta=1e-6 * scale**2)
        self.assertAlmostEqual(areas["wall"], 0.75 * scale**2, delta=1e-6 * scale**2)

    def refused(self, name, content):
        done = self.run_program("surface", self.write(name, content))
        self.assertEqual(done.returncode, 2, done.stderr)
        return done.stderr.decode()

    def test_every_form_of_a_vtu_is_read_alike(self):
        self.check("a.vtu", vtu())
        for form, encoding in [("binary", "base64"), ("appended", "base64"), ("appended", "raw")]:
            for header, packed, order, reals in itertools.product(["UInt32", "UInt64"], [False, True], "<>",
                                                                  ["Float64", "Float32"]):
                with self.subTest(form=form, encoding=encoding, header=header, packed=packed, order=order, reals=reals):
                    self.check("b.vtu", vtu(form, encoding, header, packed, order, reals))

    def test_what_a_vtu_must_not_have_is_named(self):
        for content, words in [
                (vtu(**{"UnstructuredGrid\"": "PolyData\""}), ["line 2", "PolyData", "no unstructured grid"]),
                (vtu("appended", packed=True).replace(b"vtkZLib", b"vtkLZ4"), ["vtkLZ4DataCompressor", "ZLib"]),
                (vtu(**{">1 5 5 5 5<": ">1 5 5 10 5<"}), ["cell 3", '"10"', "type of a cell"]),
                (vtu(**{">3 0 1 2": ">3 0 1 4"}), ["cell 1", '"4"', "point that is not there"]),
                (vtu(**{"NumberOfPoints=\"4\"": "NumberOfPoints=\"5\""}), ["15 coordinates"]),
                (vtu(**{"</Points>": ""}), ["is no XML", "mismatched tag"]),
                (vtu(**{"<?xml version=\"1.0\"?>": "<?xml version=\"1.0\"?><!DOCTYPE a [<!ENTITY b \"c\">]>"})
                 .replace(b">1 5 5 5 5<", b">1 5 5 5<"), ["4 types"]),
                (vtu("appended", "raw")[:-60] + b"</AppendedData></VTKFile>", ["cut off"]),
                (re.sub(rb"(<Points>.*?)AAAA", rb"\1AA!A", vtu("binary", packed=True), count=1, flags=re.DOTALL),
                 ["no base64"]),
        ]:
            with self.subTest(words):
                said = self.refused("bad.vtu", content)
                for word in words:
                    self.assertIn(word, said)

    def test_gltf_is_read_with_its_names_and_places(self):
        for binary, indices in itertools.product([True, False], [None, 5121, 5123, 5125]):
            with self.subTest(binary=binary, indices=indices):
                name = "a.glb" if binary else "a.gltf"
                self.check(name, gltf(indices=indices, binary=binary), materials=True)
        turned = {"rotation": [0, 0, 0.6, 0.8], "translation": [1, 2, 3], "scale": [2, 2, 2]}
        self.check("turned.glb", gltf(node=turned), scale=2, materials=True)
        # A mirror turns the order of the corners, and the front stays where it was.
        mirrored = self.surface("mirror.glb", gltf(node={"scale": [-1, 1, 1]}))
        plain = self.surface("plain.glb", gltf())
        self.assertEqual(mirrored["orientation"], plain["orientation"])
        self.assertEqual(plain["orientation"]["counterclockwise_from"], "inside")
        # Strips and fans, here of a triangle each.
        for mode in (5, 6):
            self.surface("strip.glb", gltf(mode=mode))

    def test_what_is_not_read_of_gltf_is_named(self):
        other_file = json.loads(gltf(binary=False))
        other_file["buffers"][0]["uri"] = "mesh.bin"
        sparse = json.loads(gltf(binary=False))
        sparse["accessors"][0]["sparse"] = {"count": 1}
        loop = json.loads(gltf(binary=False))
        loop["nodes"][0]["children"] = [0]
        both = json.loads(gltf(binary=False))
        both["nodes"][0].update(scale=[2, 2, 2], matrix=[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])
        beyond = json.loads(gltf(binary=False))
        beyond["accessors"][0]["count"] = 4000
        for content, words in [
                (gltf(extensionsRequired=["KHR_draco_mesh_compression"]), ["KHR_draco_mesh_compression", "not read"]),
                (gltf(asset={"version": "1.0"}), ["/asset/version"]),
                (json.dumps(other_file), ["/buffers/0/uri", "another file"]),
                (json.dumps(sparse), ["/accessors/0", "sparse"]),
                (json.dumps(loop), ["/nodes/0", "two parents"]),
                (json.dumps(both), ["/nodes/0/scale", "beside a matrix"]),
                (json.dumps(beyond), ["/accessors/0", "reaches beyond its view"]),
                (gltf(mode=1), ["no vertices"]),
                (gltf()[:200], ["more than is left"]),
                (b"{", ["no JSON"])]:
            with self.subTest(words):
                said = self.refused("bad.gltf", content)
                for word in words:
                    self.assertIn(word, said)

    def test_a_large_vtu_is_compressed_and_says_the_same(self):
        self.write("problem.json", small(surface={"name": "cube"}, triangulation={"levels": [5]}, reflectivity="0",
                                         basis={"family": "inset", "degree": 0}, solution="1 + x"))
        self.expect(0, "solve", "problem.json", "--vtu", "u.vtu", "--nodes", "u.csv", "--quiet")
        with open(self.path("u.vtu"), "rb") as file:
            content = file.read()
        self.assertIn(b"vtkZLibDataCompressor", content)
        found = json.loads(self.expect(0, "surface", "u.vtu", "--json", "-"))
        self.assertEqual(found["triangles"], 12 * 4**5)
        self.assertEqual({piece["name"] for piece in found["pieces"]},
                         {"west", "east", "south", "north", "floor", "ceiling"})
        # The radiosity, unpacked by Python.
        offset = int(content.split(b'Name="radiosity" format="appended" offset="')[1].split(b'"')[0])
        data = content.split(b"\n_", 1)[1][offset:]
        head = struct.unpack("<QQQ", base64.b64decode(data[:32]))
        sizes = struct.unpack(f"<{head[0]}Q", base64.b64decode(data[:4 * -(-(24 + 8 * head[0]) // 3)])[24:])
        data = data[4 * -(-(24 + 8 * head[0]) // 3):]
        packed = base64.b64decode(data[:4 * -(-sum(sizes) // 3)])
        plain = b""
        for size in sizes:
            plain, packed = plain + zlib.decompress(packed[:size]), packed[size:]
        values = struct.unpack(f"<{len(plain) // 8}d", plain)
        self.assertEqual(len(values), 3 * 12 * 4**5)
        self.assertTrue(all(1 <= value <= 2 for value in values))
        self.assertLess(os.path.getsize(self.path("u.vtu")), len(values) * 20)


if __name__ == "__main__":
    unittest.main()
