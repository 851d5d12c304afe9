# SPDX-License-Identifier: Apache-2.0
"""What pydicom makes of a DICOM SEG beside its source images, as JSON.

usage: seg_facts.py SEG SOURCE_FOLDER

Every frame is put where its own position says, on the grid that the referenced images of the folder
span when they are sorted by their own positions along row x column. `sha256` per segment is over that grid, one
byte a voxel, x fastest.
"""
import hashlib
import json
import pathlib
import sys

import numpy
import pydicom

seg = pydicom.dcmread(sys.argv[1])
referenced = {
    instance.ReferencedSOPInstanceUID
    for series in seg.ReferencedSeriesSequence
    for instance in series.ReferencedInstanceSequence
}
sources = []
for path in sorted(pathlib.Path(sys.argv[2]).rglob("*")):
    if path.is_file():
        try:
            header = pydicom.dcmread(path, stop_before_pixels=True)
        except pydicom.errors.InvalidDicomError:
            continue
        if header.get("SOPInstanceUID") in referenced:
            sources.append(header)

assert len(sources) == len(referenced), "referenced images"
orientation = numpy.array(sources[0].ImageOrientationPatient, float)
normal = numpy.cross(orientation[:3], orientation[3:])
sources.sort(key=lambda s: float(normal @ numpy.array(s.ImagePositionPatient, float)))

rows, columns, count = seg.Rows, seg.Columns, int(seg.NumberOfFrames)
bits = numpy.unpackbits(numpy.frombuffer(seg.PixelData, numpy.uint8), bitorder="little")
frames = bits[: count * rows * columns].reshape(count, rows, columns)
volumes = {
    int(s.SegmentNumber): numpy.zeros((len(sources), rows, columns), numpy.uint8)
    for s in seg.SegmentSequence
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
    number = int(group.SegmentIdentificationSequence[0].ReferencedSegmentNumber)
    assert list(group.FrameContentSequence[0].DimensionIndexValues) == [number, k + 1], "indices"
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
    "algorithms": [[s.SegmentAlgorithmType, s.SegmentAlgorithmName] for s in seg.SegmentSequence],
    "codes": [
        [s.SegmentedPropertyTypeCodeSequence[0].CodingSchemeDesignator,
         s.SegmentedPropertyTypeCodeSequence[0].CodeValue,
         s.SegmentedPropertyTypeCodeSequence[0].CodeMeaning] for s in seg.SegmentSequence],
    "lab": [list(s.RecommendedDisplayCIELabValue) for s in seg.SegmentSequence],
    "uids": [str(seg.SOPInstanceUID), str(seg.SeriesInstanceUID)],
    "sha256": [
        hashlib.sha256(volumes[n].tobytes()).hexdigest() for n in sorted(volumes)],
}))
