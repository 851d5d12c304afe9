# SPDX-License-Identifier: Apache-2.0
"""A peer of Burin's export: writes a binary DICOM SEG of a mask with pydicom, each slice of a frame, as highdicom lays
them out, and prints how many milliseconds that took (reading the sources' headers included, Python's start not).

usage: seg_write.py SOURCE_FOLDER MASK OUT

MASK: a byte a voxel, x fastest, slices in the order of their positions.
"""
import pathlib
import sys
import time

import numpy
import pydicom
from pydicom.dataset import Dataset, FileMetaDataset
from pydicom.sequence import Sequence
from pydicom.uid import ExplicitVRLittleEndian, generate_uid

mask = numpy.fromfile(sys.argv[2], numpy.uint8)
begin = time.perf_counter()
sources = [
    pydicom.dcmread(path, stop_before_pixels=True)
    for path in sorted(pathlib.Path(sys.argv[1]).iterdir())]
sources.sort(key=lambda s: float(s.ImagePositionPatient[2]))
first = sources[0]
frames = mask.reshape(len(sources), first.Rows, first.Columns)


def code(value, scheme, meaning):
    item = Dataset()
    item.CodeValue, item.CodingSchemeDesignator, item.CodeMeaning = value, scheme, meaning
    return Sequence([item])


def reference(source):
    item = Dataset()
    item.ReferencedSOPClassUID = source.SOPClassUID
    item.ReferencedSOPInstanceUID = source.SOPInstanceUID
    return item


seg = Dataset()
seg.file_meta = FileMetaDataset()
seg.file_meta.TransferSyntaxUID = ExplicitVRLittleEndian
seg.file_meta.MediaStorageSOPClassUID = seg.SOPClassUID = "1.2.840.10008.5.1.4.1.1.66.4"
seg.file_meta.MediaStorageSOPInstanceUID = seg.SOPInstanceUID = generate_uid()
for name in ("PatientName", "PatientID", "PatientBirthDate", "PatientSex", "StudyInstanceUID",
             "FrameOfReferenceUID", "Rows", "Columns", "SpecificCharacterSet"):
    setattr(seg, name, getattr(first, name))
seg.Modality, seg.SeriesInstanceUID, seg.SeriesNumber = "SEG", generate_uid(), 1000
seg.SegmentationType, seg.SamplesPerPixel = "BINARY", 1
seg.PhotometricInterpretation = "MONOCHROME2"
seg.BitsAllocated, seg.BitsStored, seg.HighBit, seg.PixelRepresentation = 1, 1, 0, 0
segment = Dataset()
segment.SegmentNumber, segment.SegmentLabel = 1, "Skull"
segment.SegmentAlgorithmType, segment.SegmentAlgorithmName = "SEMIAUTOMATIC", "peer"
segment.SegmentedPropertyCategoryCodeSequence = code("123037004", "SCT", "Anatomical Structure")
segment.SegmentedPropertyTypeCodeSequence = code("89546000", "SCT", "Skull")
seg.SegmentSequence = Sequence([segment])
series = Dataset()
series.SeriesInstanceUID = first.SeriesInstanceUID
series.ReferencedInstanceSequence = Sequence([reference(source) for source in sources])
seg.ReferencedSeriesSequence = Sequence([series])
shared, measures, orientation = Dataset(), Dataset(), Dataset()
measures.PixelSpacing = first.PixelSpacing
orientation.ImageOrientationPatient = first.ImageOrientationPatient
shared.PixelMeasuresSequence = Sequence([measures])
shared.PlaneOrientationSequence = Sequence([orientation])
seg.SharedFunctionalGroupsSequence = Sequence([shared])
groups, kept = [], []
for index, source in enumerate(sources):
    if not frames[index].any():
        continue
    kept.append(frames[index])
    group, place, content, identified, derivation = (Dataset() for _ in range(5))
    place.ImagePositionPatient = source.ImagePositionPatient
    content.DimensionIndexValues = [1, index + 1]
    identified.ReferencedSegmentNumber = 1
    derivation.DerivationCodeSequence = code("113076", "DCM", "Segmentation")
    image = reference(source)
    image.PurposeOfReferenceCodeSequence = code(
        "121322", "DCM", "Source Image for Image Processing Operation")
    derivation.SourceImageSequence = Sequence([image])
    group.PlanePositionSequence = Sequence([place])
    group.FrameContentSequence = Sequence([content])
    group.SegmentIdentificationSequence = Sequence([identified])
    group.DerivationImageSequence = Sequence([derivation])
    groups.append(group)
seg.PerFrameFunctionalGroupsSequence = Sequence(groups)
seg.NumberOfFrames = len(groups)
bits = numpy.packbits(numpy.array(kept).ravel() != 0, bitorder="little").tobytes()
seg.PixelData = bits + b"\0" * (len(bits) % 2)
seg.is_little_endian, seg.is_implicit_VR = True, False
pydicom.dcmwrite(sys.argv[3], seg, write_like_original=False)
print((time.perf_counter() - begin) * 1000)
