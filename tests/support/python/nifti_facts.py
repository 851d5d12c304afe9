# SPDX-License-Identifier: Apache-2.0
"""What nibabel reads from a NIfTI file, as JSON.

`sform` and `qform` are turned to LPS (null where the code is 0); `sha256` is over the voxels in the
file's own type, little endian, x fastest.
"""
import hashlib
import json
import sys

import nibabel
import numpy

image = nibabel.load(sys.argv[1])
header = image.header
lps = numpy.diag([-1.0, -1.0, 1.0, 1.0])


def rows(affine):
    return None if affine is None else (lps @ affine).tolist()


voxels = numpy.asarray(image.dataobj.get_unscaled())
print(json.dumps({
    "size": list(voxels.shape),
    "type": str(header.get_data_dtype()),
    "intent": int(header["intent_code"]),
    "units": header.get_xyzt_units()[0],
    "sform": rows(image.get_sform(coded=True)[0]),
    "qform": rows(image.get_qform(coded=True)[0]),
    "pixdim": [float(v) for v in header["pixdim"][:4]],
    "description": bytes(header["descrip"]).rstrip(b"\0").decode(),
    "sha256": hashlib.sha256(voxels.tobytes(order="F")).hexdigest(),
}))
