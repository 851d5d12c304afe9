# SPDX-License-Identifier: Apache-2.0
"""What pydicom makes of a DICOM SEG of any type beside its source images, as JSON.

usage: seg_facts.py SEG SOURCE_FOLDER

Every frame is put where its own position says, on the grid that the referenced images of the folder
span when they are sorted by their own positions along row x column. `sha256` per segment is over that grid, one
byte a voxel, x fastest: 0 or 1, or the share of a fractional one. A label map is taken apart.
"""
import hashlib
import json
import sys

import numpy
import pydicom

import source_images

seg = pydicom.dcmread(sys.argv[1])
referenced = {
    instance.ReferencedSOPInstanceUID
    for series in seg.ReferencedSeriesSequence
    for instance in series.ReferencedInstanceSequence
}
sources = source_images.referred(sys.argv[2], referenced)

rows, columns, count = seg.Rows, seg.Columns, int(seg.NumberOfFrames)
stored = numpy.frombuffer(seg.PixelData, numpy.uint8)
if seg.BitsAllocated == 1:
    stored = numpy.unpackbits(stored, bitorder="little")
frames = stored[: count * rows * columns].reshape(count, rows, columns)
is_map = seg.SegmentationType == "LABELMAP"
volumes = {
    int(s.SegmentNumber): numpy.zeros((len(sources), rows, columns), numpy.uint8)
    for s in seg.SegmentSequence if int(s.SegmentNumber) > 0
}
shared = seg.SharedFunctionalGroupsSequence[0]
order = []
for index, group in enumerate(seg.PerFrameFunctionalGroupsSequence):
    def macro(name):
        return (getattr(group, name) if name in group else getattr(shared, name))[0]

    position = numpy.array(macro("PlanePositionSequence").ImagePositionPatient, float)
    distances = [
        numpy.abs(position - numpy.array(s.ImagePositionPatient, float)).max() for s in sources
    ]
    k = int(numpy.argmin(distances))
    source = sources[k]
    assert distances[k] == 0.0, "position"
    assert list(macro("PlaneOrientationSequence").ImageOrientationPatient) == list(
        source.ImageOrientationPatient), "orientation"
    assert list(macro("PixelMeasuresSequence").PixelSpacing) == list(source.PixelSpacing), "spacing"
    reference = group.DerivationImageSequence[0].SourceImageSequence[0]
    assert reference.ReferencedSOPInstanceUID == source.SOPInstanceUID, "reference"
    indices = group.FrameContentSequence[0].DimensionIndexValues
    if is_map:
        assert indices == k + 1, "indices"
        order.append(k)
        assert set(numpy.unique(frames[index])) <= {0, *volumes}, "labels"
        for number, volume in volumes.items():
            volume[k] = frames[index] == number
        continue
    number = int(group.SegmentIdentificationSequence[0].ReferencedSegmentNumber)
    assert list(indices) == [number, k + 1], "indices"
    order.append((number, k))
    volumes[number][k] = frames[index]

assert order == sorted(order), "frame order"
assert seg.PatientID == sources[0].PatientID
assert str(seg.PatientName) == str(sources[0].PatientName), (seg.PatientName, sources[0].PatientName)
assert seg.StudyInstanceUID == sources[0].StudyInstanceUID
print(json.dumps({
    "frames": count,
    "emptyFrames": int((frames.reshape(count, -1).sum(1) == 0).sum()),
    "bytes": len(seg.PixelData),
    "overlap": seg.SegmentsOverlap,
    "patientName": str(seg.PatientName),
    "patientSex": str(seg.PatientSex or ""),
    "frameOfReference": getattr(seg, "FrameOfReferenceUID", ""),
    "referenced": len(referenced),
    "labels": [str(s.SegmentLabel) for s in seg.SegmentSequence],
    "algorithms": [[s.SegmentAlgorithmType, s.get("SegmentAlgorithmName", "")] for s in seg.SegmentSequence],
    "codes": [
        [s.SegmentedPropertyTypeCodeSequence[0].CodingSchemeDesignator,
         s.SegmentedPropertyTypeCodeSequence[0].CodeValue,
         s.SegmentedPropertyTypeCodeSequence[0].CodeMeaning] for s in seg.SegmentSequence],
    "lab": [list(s.get("RecommendedDisplayCIELabValue", [])) for s in seg.SegmentSequence],
    "uids": [str(seg.SOPInstanceUID), str(seg.SeriesInstanceUID)],
    "sha256": [
        hashlib.sha256(volumes[n].tobytes()).hexdigest() for n in sorted(volumes)],
}))
