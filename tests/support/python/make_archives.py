# SPDX-License-Identifier: Apache-2.0
"""Writes archives of a folder, sound and hostile, as other programs would.

make_archives.py FOLDER OUT
"""
import io
import pathlib
import sys
import tarfile
import zipfile

folder = pathlib.Path(sys.argv[1])
out = pathlib.Path(sys.argv[2])
files = sorted(path for path in folder.rglob("*") if path.is_file())

with zipfile.ZipFile(out / "study.zip", "w", zipfile.ZIP_DEFLATED) as archive:
    for path in files:
        archive.write(path, "Müller^Ünal/série 1/" + str(path.relative_to(folder)))
    archive.writestr("Müller^Ünal/readme.txt", "made by a test")

with tarfile.open(out / "study.tar.gz", "w:gz") as archive:
    for path in files:
        archive.add(path, "images/" + str(path.relative_to(folder)))

# Names that lead elsewhere, twice the same, with backslashes; a link to outside.
with zipfile.ZipFile(out / "climbs.zip", "w") as archive:
    for name in ("../../up.txt", "/abs.txt", "..\\back.txt", "a/../../b.txt", "./", "..", "same", "same"):
        archive.writestr(name, name)
with tarfile.open(out / "links.tar", "w") as archive:
    link = tarfile.TarInfo("link")
    link.type = tarfile.SYMTYPE
    link.linkname = str(out)
    archive.addfile(link)
    inside = tarfile.TarInfo("link/through.txt")
    inside.size = 4
    archive.addfile(inside, io.BytesIO(b"bad\n"))
    device = tarfile.TarInfo("null")
    device.type = tarfile.CHRTYPE
    archive.addfile(device)

# More than a gigabyte of nothing in a few megabytes.
with zipfile.ZipFile(out / "bomb.zip", "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
    with archive.open("zeros", "w", force_zip64=True) as entry:
        block = bytes(1 << 20)
        for _ in range(1100):
            entry.write(block)

(out / "empty.zip").write_bytes(b"PK\x05\x06" + bytes(18))
whole = (out / "study.zip").read_bytes()
(out / "cut.zip").write_bytes(whole[: len(whole) // 2])
# The general purpose flag of the first entry says that it is encrypted, in both of its headers.
locked = bytearray(whole)
locked[6] |= 1
central = locked.find(b"PK\x01\x02")
locked[central + 8] |= 1
(out / "locked.zip").write_bytes(bytes(locked))
(out / "other.zip").write_bytes(b"PK\x03\x04 and then nothing of the kind")
