# SPDX-License-Identifier: Apache-2.0
"""What pydicom makes of a DICOM SEG of any type, as JSON.

usage: seg_pixels.py SEG

`frames`: per frame the segment (0: a label map has none), its place along z, and the sum and SHA-256 of its pixels,
a byte each.
"""
import hashlib
import json
import sys

import numpy
import pydicom

seg = pydicom.dcmread(sys.argv[1])
rows, columns, count = seg.Rows, seg.Columns, int(seg.NumberOfFrames)
data = numpy.frombuffer(seg.PixelData, numpy.uint8)
if seg.BitsAllocated == 1:
    data = numpy.unpackbits(data, bitorder="little")
frames = data[: count * rows * columns].reshape(count, rows, columns)


def code(item, name):
    return [
        [c.CodingSchemeDesignator, c.CodeValue, c.CodeMeaning] for c in item.get(name, [])]


described = []
for index, group in enumerate(seg.PerFrameFunctionalGroupsSequence):
    number = 0
    if "SegmentIdentificationSequence" in group:
        number = int(group.SegmentIdentificationSequence[0].ReferencedSegmentNumber)
    indices = group.FrameContentSequence[0].DimensionIndexValues
    described.append({
        "segment": number,
        "z": float(group.PlanePositionSequence[0].ImagePositionPatient[2]),
        "indices": [indices] if isinstance(indices, int) else list(indices),
        "source": str(
            group.DerivationImageSequence[0].SourceImageSequence[0].ReferencedSOPInstanceUID),
        "sum": int(frames[index].sum(dtype=numpy.int64)),
        "sha256": hashlib.sha256(frames[index].tobytes()).hexdigest(),
    })

print(json.dumps({
    "class": str(seg.SOPClassUID),
    "syntax": str(seg.file_meta.TransferSyntaxUID),
    "type": seg.SegmentationType,
    "fractionalType": seg.get("SegmentationFractionalType", ""),
    "full": int(seg.get("MaximumFractionalValue", 0)),
    "overlap": seg.SegmentsOverlap,
    "bits": [seg.BitsAllocated, seg.BitsStored, seg.HighBit],
    "patientName": str(seg.PatientName),
    "dimensions": [str(d.DimensionIndexPointer) for d in seg.DimensionIndexSequence],
    "segments": [{
        "number": int(s.SegmentNumber),
        "label": str(s.SegmentLabel),
        "algorithm": [s.SegmentAlgorithmType, s.get("SegmentAlgorithmName", "")],
        "lab": list(s.get("RecommendedDisplayCIELabValue", [])),
        "category": code(s, "SegmentedPropertyCategoryCodeSequence"),
        "type": code(s, "SegmentedPropertyTypeCodeSequence"),
        "modifier": code(
            s.SegmentedPropertyTypeCodeSequence[0], "SegmentedPropertyTypeModifierCodeSequence"),
        "region": code(s, "AnatomicRegionSequence"),
        "regionModifier": code(
            s.AnatomicRegionSequence[0], "AnatomicRegionModifierSequence")
        if "AnatomicRegionSequence" in s else [],
    } for s in seg.SegmentSequence],
    "frames": described,
}))
