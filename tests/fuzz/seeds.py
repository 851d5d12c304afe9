#!/usr/bin/python3
"""Small real files for the fuzzers to begin with: seeds.py OUT [SHARED_DATA [EDITS [SESSIONS]]]

OUT/TARGET/… for every target of FuzzTargets.h. From pydicom's test files, the cases that fuzzing
found (tests/data/fuzz), what strangers may have made (sessions, archives, answers, masks,
differences, messages of decoders) and, where they are, the shared studies, of which volumes are
cropped to a few voxels. EDITS is what `burin edits --json` prints; SESSIONS a folder of small
sessions of this version (`burin run`), of which the differences are seeds, too. Needs
python3-pydicom and python3-nibabel.
"""
import gzip
import io
import json
import pathlib
import sqlite3
import struct
import sys
import tarfile
import tempfile
import zipfile
import zlib

import nibabel
import numpy
import pydicom

LARGEST = 48 * 1024
HERE = pathlib.Path(__file__).resolve().parent
out = pathlib.Path(sys.argv[1])
shared = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None


def put(target, name, content):
    folder = out / target
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name.replace("/", "_")).write_bytes(content)


def put_dicom(name, content):
    if not 0 < len(content) <= LARGEST:
        return
    try:
        kind = str(pydicom.dcmread(pydicom.filebase.DicomBytesIO(content), force=True,
                                   stop_before_pixels=True).get("SOPClassUID", ""))
    except Exception:  # what pydicom cannot read is a seed all the same
        kind = ""
    if kind.startswith("1.2.840.10008.5.1.4.1.1.66."):
        put("seg", name, content)
    if kind == "1.2.840.10008.5.1.4.1.1.481.3":
        put("rtstruct", name, content)
    put("dicom", name, content)


def dicom():
    for path in (pathlib.Path(pydicom.__file__).parent / "data" / "test_files").rglob("*"):
        if path.is_file() and path.suffix != ".py":
            put_dicom(path.name, path.read_bytes())
    if not shared:
        return
    taken = {}
    for path in sorted(shared.rglob("*")):
        if path.name.endswith(".tar.xz"):
            with tarfile.open(path) as archive:
                for member in archive:
                    # A few of every series: the rest of it is alike.
                    key = path.parent.name + str(pathlib.PurePath(member.name).parent)
                    if member.isfile() and member.size <= LARGEST and taken.get(key, 0) < 3:
                        taken[key] = taken.get(key, 0) + 1
                        put_dicom(path.parent.name + "_" + member.name,
                                  archive.extractfile(member).read())
        elif path.is_file() and path.parent.parent.name.startswith("edge_"):
            put_dicom(path.name, path.read_bytes())


def volumes():
    cut = numpy.arange(5 * 4 * 3, dtype=numpy.int16).reshape(5, 4, 3)
    made = [("made", nibabel.Nifti1Image(cut, numpy.diag([1, 2, 3, 1])))]
    made.append(("floats", nibabel.Nifti1Image(cut.astype(numpy.float64), numpy.eye(4))))
    made.append(("second", nibabel.Nifti2Image(cut, numpy.eye(4))))
    made.append(("pair", nibabel.AnalyzeImage(cut, numpy.eye(4))))
    for path in sorted(shared.rglob("*.nii.gz")) if shared else []:
        image = nibabel.load(path)
        middle = [max(0, size // 2 - 3) for size in image.shape[:3]]
        made.append((path.name, image.slicer[tuple(slice(at, at + 6) for at in middle)]))
    for name, image in made:
        if hasattr(image, "to_bytes"):
            put("nifti", name + ".nii", image.to_bytes())
            put("niftigz", name + ".nii.gz", gzip.compress(image.to_bytes()))
    raw = cut.tobytes()
    header = ("NRRD0005\ntype: short\ndimension: 3\nspace: left-posterior-superior\n"
              "sizes: 5 4 3\nspace directions: (1,0,0) (0,1,0) (0,0,2)\n"
              "space origin: (0,0,0)\nkinds: domain domain domain\nendian: little\n")
    put("nrrd", "raw.nrrd", (header + "encoding: raw\n\n").encode() + raw)
    put("nrrd", "gzip.nrrd", (header + "encoding: gzip\n\n").encode() + gzip.compress(raw))
    put("nrrd", "hex.nrrd", (header + "encoding: hex\n\n").encode() + raw.hex().encode())
    text = " ".join(map(str, cut.flatten()))
    put("nrrd", "text.nrrd", (header + "encoding: text\n\n" + text).encode())
    segments = "".join(f"Segment{i}_{key}:={value}\n" for i in (0, 1) for key, value in
                       (("ID", f"S{i}"), ("Name", f"One {i}"), ("LabelValue", i + 1), ("Layer", 0),
                        ("Color", "0.5 0.2 0.1"), ("Extent", "0 4 0 3 0 2")))
    put("nrrd", "seg.nrrd", (header + segments + "encoding: raw\n\n").encode() + raw)
    for packed in (False, True):
        head = ("ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
                f"CompressedData = {packed}\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 0 0 0\n"
                "ElementSpacing = 1 1 2\nDimSize = 5 4 3\nElementType = MET_SHORT\n"
                "ElementDataFile = LOCAL\n").encode()
        put("metaimage", f"packed{packed}.mha", head + (gzip.compress(raw) if packed else raw))


def images():
    pixels = bytes(range(8 * 6))

    def chunk(name, data):
        return (struct.pack(">I", len(data)) + name + data
                + struct.pack(">I", zlib.crc32(name + data)))

    rows = b"".join(b"\0" + pixels[row * 8:row * 8 + 8] for row in range(6))
    put("images", "grey.png", b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", struct.pack(">IIBBBBB", 8, 6, 8, 0, 0, 0, 0))
        + chunk(b"pHYs", struct.pack(">IIB", 4000, 4000, 1))
        + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
    # Classic and BigTIFF, both byte orders, strips and tiles, each way of packing that is read.
    lzw = bytes([0x80, 0x00, 0x20, 0x10])
    for order, packing, data, tile in (("<", 1, pixels, 0), (">", 8, zlib.compress(pixels), 0),
                                       ("<", 5, lzw, 0), (">", 32773, b"\x2f" + pixels, 0),
                                       ("<", 1, bytes(256), 16)):
        entries = [(256, 8), (257, 6), (258, 8), (259, packing), (262, 1), (277, 1)]
        entries += [(322, tile), (323, tile), (324, 8), (325, len(data))] if tile else [
            (273, 8), (278, 6), (279, len(data))]
        directory = b"".join(struct.pack(order + "HHII", tag, 4, 1, value)
                             for tag, value in sorted(entries))
        put("images", f"packed{packing}{'tiles' if tile else ''}.tif",
            (b"II*\0" if order == "<" else b"MM\0*") + struct.pack(order + "I", 8 + len(data))
            + data + struct.pack(order + "H", len(entries)) + directory + bytes(4))


def meshes():
    put("mesh", "one.obj", b"o one\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    put("mesh", "one.ply", b"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
        b"property float y\nproperty float z\nelement face 1\n"
        b"property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    put("mesh", "one.stl", b"x" * 80 + b"\1\0\0\0" + bytes(50))
    put("mesh", "one.gltf", json.dumps({
        "asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5125, "count": 3, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36},
                        {"buffer": 0, "byteOffset": 36, "byteLength": 12}],
        "buffers": [{"byteLength": 48,
                     "uri": "data:application/octet-stream;base64," + "AAAA" * 16}]}).encode())


def recipes():
    view = {"eyeLps": [0, -400, 20], "targetLps": [0, 0, 20], "up": [0, 0, 1], "heightMm": 300,
            "orthographic": True}
    put("recipe", "readme.json", json.dumps({"edits": [
        {"edit": "addSegment", "name": "Skull", "color": "#e8dcc0",
         "code": ["SCT", "89546000", "Skull"]},
        {"edit": "drill", "view": view, "mask": {"shape": "circle", "radiusMm": 12}, "depthMm": 15,
         "surface": {"threshold": 300}, "samples": [[0, 20, 0.4, 0.0], [8, 24, 1.0, 0.2]]},
        {"edit": "seed", "segment": 1, "pointsLps": [[0, 70, 60]]},
        {"edit": "importMask", "file": "mask.nii", "as": "Skull"},
        {"edit": "grow", "lower": 300, "upper": 3071, "connectivity": 6, "steps": "toClosure"}],
        "export": [{"format": "dicom-seg", "file": "skull.dcm"},
                   {"format": "carved-volume", "file": "out", "fill": -1000}]}).encode())
    put("recipe", "walks.json", json.dumps(
        {"edits": [{"edit": "undo"}, {"edit": "redo"}, {"edit": "goTo", "seq": 0}]}).encode())
    # Every edit there is, with its fields: names are what a fuzzer does not guess.
    if len(sys.argv) > 3:
        put("recipe", "edits.json", pathlib.Path(sys.argv[3]).read_bytes())


def sessions():
    if len(sys.argv) <= 4:
        return
    for path in pathlib.Path(sys.argv[4]).glob("*.burin"):
        put("session", path.name, path.read_bytes())
        with sqlite3.connect(f"file:{path}?mode=ro", uri=True) as database:
            for (row,) in database.execute("SELECT DISTINCT row FROM delta").fetchall():
                pieces = database.execute(
                    "SELECT bytes FROM delta WHERE row=? ORDER BY piece", (row,))
                put("delta", f"{path.stem}-{row}", b"".join(piece for (piece,) in pieces))


# What strangers may put into a session, as in ForeignSessionTest.
STRANGE = {
    "trigger-keeps-no-row":
        "CREATE TRIGGER t BEFORE INSERT ON row BEGIN SELECT RAISE(IGNORE); END;",
    "trigger-takes-the-history":
        "CREATE TRIGGER t AFTER INSERT ON row BEGIN DELETE FROM row; DELETE FROM delta; END;",
    "trigger-fills-the-disk":
        "CREATE TRIGGER t AFTER INSERT ON state BEGIN INSERT INTO keyframe "
        "SELECT abs(random()), '', zeroblob(100000000); END;",
    "table-beside": "CREATE TABLE junk (b);",
    "view-in-place-of-a-table":
        "ALTER TABLE row RENAME TO row0; CREATE VIEW row AS SELECT * FROM row0;",
    "view-without-end":
        "DROP TABLE visited; CREATE VIEW visited AS WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL "
        "SELECT x+1 FROM c) SELECT x AS parent, x AS child FROM c WHERE x<0;",
    "generated-column":
        "DROP TABLE visited; CREATE TABLE visited (parent INTEGER PRIMARY KEY, "
        "child INTEGER NOT NULL AS (parent + 1));",
}


def strange_sessions(path):
    """Of one sound session, as (name, bytes), in small pages."""
    for name, script in STRANGE.items():
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder) / "copy.burin"
            copy.write_bytes(path.read_bytes())
            database = sqlite3.connect(copy)
            database.executescript(
                "PRAGMA legacy_alter_table=ON; PRAGMA page_size=512; VACUUM;" + script)
            database.close()
            yield name, copy.read_bytes()


def strangers():
    for path in sorted((HERE.parent / "data" / "gold").glob("*.burin")):
        for name, content in strange_sessions(path):
            put("session", f"{path.stem}-{name}", content)
    seed = '{"edits": [{"edit": "addSegment", "name": "A%s", "color": "#336699"%s}]}'
    put("recipe", "key-twice", (seed % ("", ', "name": "B"')).encode())
    put("recipe", "nul-in-a-name", (seed % ("\\u0000a", "")).encode())
    put("recipe", "name-that-is-not-utf8", (seed % ("\xe4", "")).encode("latin-1"))
    put("recipe", "nul-in-a-file", b'{"edits": [], "export": [{"format": "dicom-seg", '
        b'"file": "a\\u0000b.dcm"}]}')


def web():
    """What servers answer; the first byte of a multipart body says how it is cut on its way."""
    head = b"\x03preamble\r\n--a-b\r\n"
    put("multipart", "counted-and-searched",
        head + b"Content-Length: 12\r\n\r\n\r\n--a-b\r\nabc\r\n--a-b\r\n\r\n"
        b"x\r\n-\r\n--a-\r\r\n--a-b--\r\nan epilogue")
    put("multipart", "longer-than-all-memory",
        head + b"content-length:9223372036854775807\r\n\r\nabc\r\n--a-b--")
    put("multipart", "longer-than-all-numbers",
        head + b"Content-Length: 99999999999999999999\r\n\r\nabc\r\n--a-b--")
    put("multipart", "ends-within-a-boundary", head + b"\r\nabc\r\n--a-")
    put("multipart", "ends-before-it-begins", b"\x01--a-b--\r\n--a-b\r\n\r\nabc\r\n--a-b--")
    one = {"0020000D": {"vr": "UI", "Value": ["1.2.3"]},
           "00100010": {"vr": "PN", "Value": [{"Alphabetic": "M\u00fcller^J\u00f6rg"}]},
           "00080061": {"vr": "CS", "Value": ["CT", "MR"]},
           "00201208": {"vr": "IS", "Value": [3]}}
    put("webanswer", "names-and-numbers", json.dumps([one]).encode())
    put("webanswer", "values-of-other-forms", json.dumps(
        [{"0020000D": ["1.2"], "00100010": {"Value": {"Alphabetic": ["A"]}}, "00080018": 7,
          "00201208": {"Value": [1e308, [], None]}}, [], None, "1.2", [[one]]]).encode())
    put("webanswer", "nested-without-end", b"[" * 5000)
    put("webanswer", "half-of-it", json.dumps([one])[:90].encode())
    put("webanswer", "name-that-is-not-utf8",
        b'[{"00100010": {"Value": [{"Alphabetic": "M\xfcller"}]}}]')


def archives():
    def packed(*entries):
        buffer = io.BytesIO()
        with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
            for name, content in entries:
                archive.writestr(zipfile.ZipInfo(name), content)
        return buffer.getvalue()

    sound = packed(("a/one.txt", b"one"), ("two.txt", b"two"))
    put("archive", "sound-zip", sound)
    put("archive", "zip-that-climbs", packed(("../up.txt", b"up"), ("/abs.txt", b"abs"),
                                             ("a/../../b.txt", b"b"), ("same", b"1")))
    put("archive", "zip-cut-short", sound[:60])
    # Of the first entry: four gigabytes once it is unpacked.
    put("archive", "zip-that-says-gigabytes",
        sound[:22] + b"\xfe\xff\xff\xff" + sound[26:])
    buffer = io.BytesIO()
    with tarfile.open(fileobj=buffer, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for name, kind, link in (("one.txt", tarfile.REGTYPE, ""), ("link", tarfile.SYMTYPE, "/etc"),
                                 ("link/through.txt", tarfile.REGTYPE, ""),
                                 ("hard", tarfile.LNKTYPE, "/etc/hostname"),
                                 ("pipe", tarfile.FIFOTYPE, ""), ("null", tarfile.CHRTYPE, "")):
            info = tarfile.TarInfo(name)
            info.type, info.linkname = kind, link
            info.size = 3 if kind == tarfile.REGTYPE else 0
            archive.addfile(info, io.BytesIO(b"one") if info.size else None)
    put("archive", "tar-of-links-and-devices", buffer.getvalue()[:5 * 1024])
    first = bytearray(buffer.getvalue()[:1024])
    first[124:136] = b"\xff" * 12  # its size, in base 256: below zero
    first[148:156] = b" " * 8
    first[148:156] = b"%06o\0 " % sum(first[:512])
    put("archive", "tar-smaller-than-nothing", bytes(first))


def masks_of_strangers():
    """Headers whose voxels lie elsewhere, probabilities that are none, a surface's differences."""
    nrrd = ("NRRD0005\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\n"
            "sizes: 24 20 16\nspace directions: (1.5,0,0) (0,1.5,0) (0,0,2)\n"
            "space origin: (-10,-10,-10)\nencoding: raw\ndata file: %s\n")
    meta = ("ObjectType = Image\nNDims = 3\nBinaryData = True\nElementSpacing = 1.5 1.5 2\n"
            "Offset = -10 -10 -10\nDimSize = 24 20 16\nElementType = MET_UCHAR\n"
            "ElementDataFile = %s\n")
    for name, place in (("beside-it", "file.raw"), ("without-end", "/dev/zero"),
                        ("a-list-of-itself", "LIST\n%s\n%s"), ("numbered", "file%03d.raw 1 16 1"),
                        ("a-format-of-a-stranger", "%n%s%999999999d.raw 1 2 1"),
                        ("up-and-away", "../../../../../../etc/hostname")):
        put("nhdr", name, (nrrd % place.replace("%s", "file.nhdr")).encode())
        put("mhd", name, (meta % place.replace("%s", "file.mhd")).encode())
    values = numpy.tile(numpy.array([0, 0.25, 1, numpy.nan, numpy.inf, -numpy.inf, -1, 1e30],
                                    numpy.float32), 8).reshape(4, 4, 4)
    put("probability", "no-numbers",
        nibabel.Nifti1Image(values, numpy.diag([1.5, 1.5, 2, 1])).to_bytes())
    put("surfacestep", "nothing", b"MDL1" + bytes(8))
    put("surfacestep", "more-than-all", b"MDL1" + b"\xff" * 8)
    corner = struct.pack("<3d", 1, 2, 3) + struct.pack("<6I", 1, 2, 3, 1, 2, 3) + b"\0"
    put("surfacestep", "one-corner-comes",
        b"MDL1" + struct.pack("<II", 1, 0) + struct.pack("<IB", 5, 2) + corner)
    put("surfacestep", "a-corner-at-no-place", b"MDL1" + struct.pack("<II", 1, 0)
        + struct.pack("<IB", 5, 2) + struct.pack("<d", float("nan")) + corner[8:])


def encoded(**elements):
    """Explicit VR, little-endian: a list is a sequence, bytes are taken as they are."""
    whole = b""
    for tag, value in sorted((pydicom.datadict.tag_for_keyword(keyword), value)
                             for keyword, value in elements.items()):
        vr = pydicom.datadict.dictionary_VR(tag).split(" or ")[-1]
        if vr == "SQ":
            items = [encoded(**item) for item in value]
            value = b"".join(struct.pack("<HHI", 0xfffe, 0xe000, len(item)) + item for item in items)
        elif isinstance(value, int):
            value = (struct.pack("<H" if vr == "US" else "<I", value) if vr in ("US", "UL")
                     else str(value).encode())
        elif isinstance(value, str):
            value = value.encode()
        value += (b"\0" if vr == "UI" else b" ") * (len(value) % 2)
        whole += struct.pack("<HH2s", tag >> 16, tag & 0xffff, vr.encode())
        whole += (struct.pack("<HI", 0, len(value)) if vr in ("OB", "OW", "SQ")
                  else struct.pack("<H", len(value))) + value
    return whole


def part_10(**elements):
    meta = encoded(FileMetaInformationVersion=b"\0\1",
                   MediaStorageSOPClassUID=elements["SOPClassUID"],
                   MediaStorageSOPInstanceUID="1.2.3", TransferSyntaxUID="1.2.840.10008.1.2.1")
    return (bytes(128) + b"DICM" + encoded(FileMetaInformationGroupLength=len(meta)) + meta
            + encoded(SOPInstanceUID="1.2.3", PatientID="A", StudyInstanceUID="1.2.4",
                      SeriesInstanceUID="1.2.5", FrameOfReferenceUID="1.2.6", **elements))


def code(value, meaning):
    return [{"CodeValue": value, "CodingSchemeDesignator": "SCT", "CodeMeaning": meaning}]


def segmentations():
    """On the grid of smallVolume() in FuzzBytes.h."""
    columns, rows = 24, 20

    def frame(inside, value=1, bits=1):
        pixels = numpy.zeros((rows, columns), numpy.uint8)
        pixels[inside] = value
        return (numpy.packbits(pixels, bitorder="little") if bits == 1 else pixels).tobytes()

    def segmentation(name, pixels, frames, segments, **others):
        others = {"SOPClassUID": "1.2.840.10008.5.1.4.1.1.66.4", "SegmentationType": "BINARY",
                  "BitsAllocated": 1, "orientation": "1\\0\\0\\0\\1\\0", "spacing": "1.5\\1.5",
                  "NumberOfFrames": len(frames), "Rows": rows, "Columns": columns, **others}
        orientation, spacing = others.pop("orientation"), others.pop("spacing")
        put("seg", name, part_10(
            Modality="SEG", SamplesPerPixel=1, PixelRepresentation=0, PixelData=pixels,
            SegmentSequence=[
                {"SegmentNumber": number, "SegmentLabel": f"Segment {number}",
                 "SegmentAlgorithmType": "MANUAL", "RecommendedDisplayCIELabValue": b"\0\xc0" * 3,
                 "SegmentedPropertyCategoryCodeSequence": code("123037004", "Anatomical Structure"),
                 "SegmentedPropertyTypeCodeSequence": code("10200004", "Liver")}
                for number in segments],
            SharedFunctionalGroupsSequence=[
                {"PlaneOrientationSequence": [{"ImageOrientationPatient": orientation}],
                 "PixelMeasuresSequence": [{"PixelSpacing": spacing, "SliceThickness": "2"}]}],
            PerFrameFunctionalGroupsSequence=[
                {"PlanePositionSequence": [{"ImagePositionPatient": place}],
                 "SegmentIdentificationSequence": [{"ReferencedSegmentNumber": number}]}
                for number, place in frames],
            **others))

    box, beside = numpy.s_[5:12, 6:15], numpy.s_[8:16, 9:20]
    low, high = "-10\\-10\\-4", "-10\\-10\\-2"
    one = frame(box)
    segmentation("two-that-overlap", one + one + frame(beside), [(1, low), (1, high), (2, high)],
                 [1, 2])
    segmentation("between-pixels-and-slices", one + one, [(1, "-9.3\\-8\\-5"), (1, "-9\\-8\\1.3")],
                 [1], spacing="0.7\\2.1")
    segmentation("fractional", frame(box, 200, 8), [(1, low)], [1], SegmentationType="FRACTIONAL",
                 BitsAllocated=8, MaximumFractionalValue=255)
    segmentation("label-map", frame(box, 2, 8) + frame(beside, 1, 8), [(1, low), (1, high)],
                 [0, 1, 2], SOPClassUID="1.2.840.10008.5.1.4.1.1.66.7", SegmentationType="LABELMAP",
                 BitsAllocated=8)
    segmentation("one-number-twice", one + one, [(1, low), (1, low)], [1, 1])
    segmentation("frames-of-no-segment", one + one, [(65535, low), (0, high)], [0, 7])
    segmentation("fewer-pixels-than-frames", one, [(1, low), (1, high)], [1])
    segmentation("gigabytes-in-a-few-bytes", one, [(1, low)], [1], Rows=65535, Columns=65535)
    segmentation("frames-without-end", one, [(1, low)], [1], NumberOfFrames=2147483647)
    segmentation("along-no-direction", one, [(1, low)], [1], orientation="0\\0\\0\\0\\0\\0")
    segmentation("longer-than-all-directions", one, [(1, low)], [1],
                 orientation="1e200\\0\\0\\0\\1e200\\0")
    segmentation("frames-farther-apart-than-numbers-can-tell", one + one,
                 [(1, "-1e308\\-10\\-4"), (1, "1e308\\-10\\-2")], [1])
    segmentation("a-frame-at-no-place", one + one, [(1, low), (1, "1e308\\1e308\\-2")], [1],
                 orientation="0.6\\0.8\\0\\-0.8\\0.6\\0", spacing="0.01\\0.01")
    segmentation("pixels-smaller-than-all", one, [(1, low)], [1], spacing="1e-308\\1e-308")


def contours():
    def square(kind, z, first, last, **others):
        corners = ((first, first), (last, first), (last, last), (first, last))
        return {"ContourGeometricType": kind, "NumberOfContourPoints": 4,
                "ContourData": "\\".join(f"{x}\\{y}\\{z}" for x, y in corners), **others}

    def regions(name, *rois, **others):
        listed = [{"ROINumber": number, "ROIName": f"Region {number}",
                   "ReferencedFrameOfReferenceUID": "1.2.6"} for number, _ in rois]
        put("rtstruct", name, part_10(**{
            "SOPClassUID": "1.2.840.10008.5.1.4.1.1.481.3", "Modality": "RTSTRUCT",
            "ReferencedFrameOfReferenceSequence": [
                {"FrameOfReferenceUID": "1.2.6", "RTReferencedStudySequence": [
                    {"RTReferencedSeriesSequence": [
                        {"ContourImageSequence": [{"ReferencedSOPInstanceUID": "1.2.7"}]}]}]}],
            "StructureSetROISequence": listed,
            "ROIContourSequence": [
                {"ReferencedROINumber": number, "ROIDisplayColor": "255\\0\\128",
                 "ContourSequence": items} for number, items in rois],
            "RTROIObservationsSequence": [
                {"ObservationNumber": 1, "ReferencedROINumber": rois[0][0],
                 "RTROIIdentificationCodeSequence": code("10200004", "Liver")}], **others}))

    closed = "CLOSED_PLANAR"
    regions("a-hole-and-others",
            (1, [square(closed, -4, -5, 12), square(closed, -4, 0, 6), square(closed, -2, -5, 12)]),
            (2, [square("CLOSEDPLANAR_XOR", 0, -8, 3), square("OPEN_PLANAR", 2, -8, 3),
                 {"ContourGeometricType": "POINT", "ContourData": "1\\2\\3"}]))
    regions("between-slices", (1, [square(closed, -4.7, -5, 12), square(closed, -4.2, -5, 12),
                                   square(closed, 7.1, -5, 12)]))
    regions("numbers-that-are-none", (1, [square(closed, -4, -5, "1e999")]))
    regions("two-numbers-a-point", (1, [{"ContourGeometricType": closed, "ContourData": "1\\2"}]))
    regions("surrounds-nothing",
            (1, [square(closed, -4, 3, 3), {"ContourGeometricType": closed,
                                            "ContourData": "\\".join(["1\\1\\-4", "9\\9\\-4"] * 3)}]),
            (2, []))
    regions("regions-of-one-number", (1, [square(closed, -4, -5, 12)]),
            (1, [square(closed, -4, 0, 9, NumberOfContourPoints=2147483647)]))
    regions("contours-of-none", (-2147483648, [square(closed, -4, -5, 12)]),
            StructureSetROISequence=[], RTROIObservationsSequence=[])
    regions("farther-than-numbers-can-tell",
            (1, [square(closed, "-1e300", -5, 12), square(closed, "1e300", -5, 12),
                 square(closed, -4, -5, 12)]))
    regions("corners-beyond-all-pixels", (1, [square(closed, -4, "-1e300", "1e300")]))


def differences():
    """What the rows of sessions hold, of 3 x 3 x 3 bricks (core/session/README.md): plain, as
    fuzzDelta packs it, and streams of zstd that nobody would write."""
    coverage, labels, words, overwritten = 1, 2, 3, 4
    seed = 0x80002000  # that was sketched, admitted in the first generation

    def head(*entries, along=(3, 3), count=None):
        return b"BDL3" + struct.pack("<3I", *along, len(entries) if count is None else count) + b"".join(
            struct.pack("<4BI", field, 0, form, 0, brick) for field, form, brick in entries)

    def mask(*voxels):
        bits = bytearray(512)
        for voxel in voxels:
            bits[voxel // 8] |= 1 << voxel % 8
        return bytes(bits)

    def kept(*differences):
        return b"".join(bytes(word >> 8 * byte & 255 for word in differences) for byte in range(4))

    two = head((coverage, 1, 0), (coverage, 1, 26))
    sound = two + mask(0, 17, 4095) + mask(7) + b"\1\2\xff" + b"\x80"
    put("delta", "coverage-of-two-bricks", sound)
    put("delta", "more-behind-its-end", sound + b"\0")
    put("delta", "cut-within-a-mask", sound[:700])
    # A seed on the border of two bricks, and the voxels beside it that follow from it.
    put("delta", "growth-over-a-border",
        head((labels, 1, 0), (labels, 1, 1), (words, 2, 0), (words, 2, 1), (overwritten, 1, 1))
        + mask(1102, 1103) + mask(1088) + mask(1088) + b"\3\3" + b"\3" + b"\5"
        + b"\2" + b"\0" + b"\0\0" + kept(seed))
    put("delta", "growth-without-a-seed", head((words, 1, 13)) + mask(1, 2) + b"\0" + b"\3\3")
    put("delta", "growth-after-the-last-generation",
        head((words, 1, 13)) + mask(1, 2) + b"\1" + b"\3" + kept(~(262143 << 13 | 3 << 5) & 0xffffffff))
    put("delta", "words-that-do-not-follow",
        head((words, 1, 26)) + mask(*range(64)) + b"\xff" * 8 + kept(*[seed, 0xffffffff, 1, 0] * 16))
    put("delta", "words-beside-no-labels", head((labels, 1, 0), (words, 2, 1)) + mask(5) + b"\3\1"
        + kept(seed))
    put("delta", "one-brick-twice", head((coverage, 1, 3), (coverage, 1, 3)) + mask(1) * 2 + b"\1\1")
    put("delta", "more-bricks-than-there-are", head((coverage, 1, 0), count=0xffffffff) + mask(1))
    put("delta", "a-brick-that-there-is-not", head((coverage, 1, 27)) + mask(1) + b"\1")
    put("delta", "bricks-of-another-volume",
        head((coverage, 1, 0), along=(0xffffffff, 0)) + mask(1) + b"\1")

    def block(kind, size, content, last=0):
        return struct.pack("<I", last | kind << 1 | size << 3)[:3] + content

    raw, repeated = 0, 1
    begin = head((coverage, 1, 0))
    stream = (b"\x28\xb5\x2f\xfd\0\x38" + block(raw, len(begin), begin)
              + block(repeated, 512, b"\xff") + block(repeated, 4096, b"\7", last=1))
    put("delta", "stream-of-repeats", stream)
    put("delta", "stream-of-two-frames", stream + stream)
    put("delta", "stream-that-unpacks-to-megabytes",
        stream[:-4] + block(repeated, 1 << 17, b"\7") * 64 + stream[-4:])
    put("delta", "stream-with-a-window-of-terabytes", stream[:5] + b"\xff" + stream[6:])
    put("delta", "stream-cut-short", stream[:-5])


def decoders():
    """What a decoder and its program tell each other (core/fence/FenceProtocol.h)."""
    magic, done, refused = 0x464e4345, 1, 2
    ready = struct.pack("<II", magic, 1)

    def reply(verdict, sentence=b"", number=1, size=None, begin=magic):
        return struct.pack("<4I240s", begin, number, verdict, len(sentence) if size is None else size,
                           sentence)

    def replies(name, *messages):
        put("decoderreply", name, b"".join(struct.pack("<H", len(one)) + one for one in messages))

    replies("done", ready, reply(done))
    replies("done-and-more", ready, reply(done), reply(refused, b"twice"))
    replies("refused", ready, reply(refused, "damaged <b>\u00fc".encode()))
    replies("refused-without-a-word", ready, reply(refused))
    replies("letters-that-are-not-printed",
            ready, reply(refused, "a\0b\n\x1b[0m\u202e\ufeff\U0001d11e\ue000".encode() + b"\xff\xc3"))
    replies("more-lines-than-one", ready, reply(refused, "a\u2028b\u2029c".encode()))
    replies("cut-within-a-letter", ready, reply(refused, b"a" + "\u00fc".encode() * 119 + b"\xc3"))
    replies("sentence-longer-than-its-place", ready, reply(refused, b"a" * 240, size=241))
    replies("sentence-without-end", ready, reply(refused, b"a" * 240, size=0xffffffff))
    replies("done-of-another-request", ready, reply(done, number=2))
    replies("verdict-that-there-is-not", ready, reply(77))
    replies("of-another-program", ready, reply(done, begin=7))
    replies("shorter-than-a-reply", ready, reply(done)[:-1])
    replies("longer-than-a-reply", ready, reply(done) + b"\0" * 4096)
    replies("ready-and-gone", ready)
    replies("done-before-it-is-ready", reply(done), ready)
    replies("ready-in-halves", ready[:4], ready[4:])

    def request(name, memory, input_bytes, output_at, output_bytes, parameters=b"", size=None,
                begin=magic, content=b"\1\2\3"):
        put("decoderrequest", name, struct.pack(
            "<IIQQQQI128s4x", begin, 1, memory, input_bytes, output_at, output_bytes,
            len(parameters) if size is None else size, parameters) + content)

    request("sound", 8192, 3, 4096, 4096)
    request("nothing-at-all", 0, 0, 0, 0)
    request("refused", 8192, 3, 4096, 4096, b"damaged pixel data")
    request("thrown", 8192, 3, 4096, 4096, b"!thrown in a decoder")
    request("thrown-without-a-word", 8192, 3, 4096, 4096, b"!")
    request("no-memory", 8192, 3, 4096, 4096, b"?")
    request("sentence-that-is-cut-within-a-letter", 8192, 3, 4096, 4096, b"a" + b"\xff" * 127)
    request("output-over-the-input", 8192, 4097, 4096, 4096)
    request("output-beyond-the-memory", 8192, 3, 4096, 4097)
    request("output-beyond-all-numbers", 8192, 3, 2 ** 64 - 4096, 8192)
    request("more-than-all-memory", 2 ** 64 - 1, 3, 4096, 2 ** 64 - 4097)
    request("more-parameters-than-there-is-place", 8192, 3, 4096, 4096, size=129)
    request("parameters-without-end", 8192, 3, 4096, 4096, size=0xffffffff)
    request("of-another-program", 8192, 3, 4096, 4096, begin=7)


def found():
    for path in (HERE.parent / "data" / "fuzz").glob("*/*"):
        put(path.parent.name, path.name, path.read_bytes())


for step in (dicom, volumes, images, meshes, recipes, sessions, strangers, web, archives,
             masks_of_strangers, segmentations, contours, differences, decoders, found):
    step()
for folder in sorted(out.iterdir()):
    print(f"{folder.name}: {len(list(folder.iterdir()))}")
