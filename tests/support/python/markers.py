# SPDX-License-Identifier: Apache-2.0
"""Which texts a file holds, as it lies there or once it is inflated.

usage: markers.py FILE TEXT...

Whatever begins like a gzip stream anywhere in the file is inflated, and the data set of a deflated DICOM file.
"""
import sys
import zlib

with open(sys.argv[1], "rb") as file:
    raw = file.read()
bodies = [raw]
start = raw.find(b"\x1f\x8b\x08")
while start >= 0:
    try:
        bodies.append(zlib.decompressobj(31).decompress(raw[start:]))
    except zlib.error:
        pass
    start = raw.find(b"\x1f\x8b\x08", start + 1)
if raw[128:132] == b"DICM" and b"1.2.840.10008.1.2.1.99" in raw[:1000]:
    length = int.from_bytes(raw[140:144], "little")
    bodies.append(zlib.decompressobj(-15).decompress(raw[144 + length:]))
    assert len(bodies[-1]) > 1000, "nothing was inflated"
for text in sys.argv[2:]:
    for form in (text.encode(), text.encode("utf-16-le")):
        if any(form in body for body in bodies):
            print(text)
            break
