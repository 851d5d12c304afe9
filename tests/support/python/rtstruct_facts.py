# SPDX-License-Identifier: Apache-2.0
"""What pydicom makes of an RTSTRUCT beside its source images, as JSON.

usage: rtstruct_facts.py RTSTRUCT SOURCE_FOLDER

Each contour is filled on the grid of the image that it names: a pixel is inside where a ray from its
centre crosses the contour an odd number of times; contours of one image are joined by exclusive or.
`sha256` per ROI is over the images sorted along row x column, one byte a voxel, x fastest.
"""
import hashlib
import json
import sys

import numpy
import pydicom

import source_images

rt = pydicom.dcmread(sys.argv[1])
frame = rt.ReferencedFrameOfReferenceSequence[0]
series = frame.RTReferencedStudySequence[0].RTReferencedSeriesSequence[0]
referenced = {image.ReferencedSOPInstanceUID for image in series.ContourImageSequence}
sources = source_images.referred(sys.argv[2], referenced)
assert all(s.SeriesInstanceUID == series.SeriesInstanceUID for s in sources), "series"
slice_of = {s.SOPInstanceUID: k for k, s in enumerate(sources)}
rows, columns = sources[0].Rows, sources[0].Columns
y, x = numpy.mgrid[0:rows, 0:columns].astype(float)
farthest = 0.0


def filled(points, source):
    global farthest
    row, column = numpy.split(numpy.array(source.ImageOrientationPatient, float), 2)
    spacing = [float(v) for v in source.PixelSpacing]
    offset = points - numpy.array(source.ImagePositionPatient, float)
    farthest = max(farthest, float(numpy.abs(offset @ numpy.cross(row, column)).max()))
    px, py = offset @ row / spacing[1], offset @ column / spacing[0]
    inside = numpy.zeros((rows, columns), bool)
    for i in range(len(px)):
        j = (i + 1) % len(px)
        if py[i] == py[j]:
            continue
        spans = (py[i] > y) != (py[j] > y)
        inside ^= spans & (x < (px[j] - px[i]) * (y - py[i]) / (py[j] - py[i]) + px[i])
    return inside


facts = []
contours_of = {int(c.ReferencedROINumber): c for c in rt.ROIContourSequence}
for roi in rt.StructureSetROISequence:
    volume = numpy.zeros((len(sources), rows, columns), bool)
    item = contours_of[int(roi.ROINumber)]
    most = 0
    for contour in item.ContourSequence:
        assert contour.ContourGeometricType == "CLOSED_PLANAR"
        points = numpy.array(contour.ContourData, float).reshape(-1, 3)
        assert len(points) == contour.NumberOfContourPoints, "points"
        most = max(most, len(points))
        k = slice_of[contour.ContourImageSequence[0].ReferencedSOPInstanceUID]
        volume[k] ^= filled(points, sources[k])
    facts.append({
        "name": str(roi.ROIName),
        "color": [int(v) for v in item.ROIDisplayColor],
        "contours": len(item.ContourSequence),
        "mostPoints": most,
        "sha256": hashlib.sha256(volume.astype(numpy.uint8).tobytes()).hexdigest(),
    })

assert rt.PatientID == sources[0].PatientID
assert str(rt.PatientName) == str(sources[0].PatientName)
assert rt.StudyInstanceUID == sources[0].StudyInstanceUID
print(json.dumps({
    "rois": facts,
    "offPlaneMm": farthest,
    "frameOfReference": str(frame.FrameOfReferenceUID),
    "referenced": len(referenced),
    "uids": [str(rt.SOPInstanceUID), str(rt.SeriesInstanceUID)],
}))
