# SPDX-License-Identifier: Apache-2.0
"""The images of a folder that an object refers to, for the scripts beside this."""
import pathlib

import numpy
import pydicom


def referred(folder, uids):
    """Their headers, sorted by their own positions along row x column."""
    found = []
    for path in sorted(pathlib.Path(folder).rglob("*")):
        if path.is_file():
            try:
                header = pydicom.dcmread(path, stop_before_pixels=True)
            except pydicom.errors.InvalidDicomError:
                continue
            if header.get("SOPInstanceUID") in uids:
                found.append(header)
    assert len(found) == len(uids), "referenced images"
    orientation = numpy.array(found[0].ImageOrientationPatient, float)
    normal = numpy.cross(orientation[:3], orientation[3:])
    return sorted(found, key=lambda s: float(normal @ numpy.array(s.ImagePositionPatient, float)))
