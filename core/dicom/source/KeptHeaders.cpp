// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/source/KeptHeaders.h"

#include "core/dicom/items/ItemReader.h"
#include "core/dicom/items/SopClass.h"
#include "core/dicom/source/VisitSourceFiles.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcostrmb.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <array>

namespace core {

namespace {

const std::array<DcmTagKey, 32> keptTags{DCM_SpecificCharacterSet, DCM_SOPClassUID,
    DCM_SOPInstanceUID, DCM_PatientName, DCM_PatientID, DCM_PatientBirthDate, DCM_PatientSex,
    DCM_PatientAge, DCM_PatientSize, DCM_PatientWeight, DCM_StudyInstanceUID, DCM_StudyDate,
    DCM_StudyTime, DCM_ReferringPhysicianName, DCM_StudyID, DCM_AccessionNumber,
    DCM_StudyDescription, DCM_SeriesInstanceUID, DCM_FrameOfReferenceUID, DCM_BodyPartExamined,
    DCM_ImagePositionPatient, DCM_ImageOrientationPatient, DCM_PixelSpacing, DCM_SliceThickness,
    DCM_NumberOfFrames, DCM_Rows, DCM_Columns, DCM_LossyImageCompression,
    DCM_LossyImageCompressionRatio, DCM_LossyImageCompressionMethod,
    DCM_SharedFunctionalGroupsSequence, DCM_PerFrameFunctionalGroupsSequence};

const std::array<DcmTagKey, 3> keptMacros{
    DCM_PlanePositionSequence, DCM_PlaneOrientationSequence, DCM_PixelMeasuresSequence};

/// What says where frames in a row lie.
const std::array<DcmTagKey, 4> keptOfRows{DCM_ImageType, DCM_SpacingBetweenSlices,
    DCM_GridFrameOffsetVector, DCM_DetectorInformationSequence};

void keepRow(DcmDataset& dataset, DcmDataset& kept)
{
    for (const DcmTagKey& tag : keptOfRows)
        dataset.findAndInsertCopyOfElement(tag, &kept);
    DcmItem* detector = nullptr;
    for (long i = 0;
         kept.findAndGetSequenceItem(DCM_DetectorInformationSequence, detector, i).good(); ++i) {
        for (unsigned long element = detector->card(); element > 0; --element) {
            const DcmTagKey tag = detector->getElement(element - 1)->getTag();
            if (tag != DCM_ImagePositionPatient && tag != DCM_ImageOrientationPatient)
                delete detector->remove(element - 1);
        }
    }
}

/// The functional groups say where a frame lies, and much else.
void trimGroups(DcmItem& dataset, const DcmTagKey& groups)
{
    DcmItem* group = nullptr;
    for (long i = 0; dataset.findAndGetSequenceItem(groups, group, i).good(); ++i) {
        for (unsigned long element = group->card(); element > 0; --element) {
            const DcmTagKey tag = group->getElement(element - 1)->getTag();
            if (std::find(keptMacros.begin(), keptMacros.end(), tag) == keptMacros.end())
                delete group->remove(element - 1);
        }
    }
}

QByteArray bytesOf(DcmDataset& dataset)
{
    constexpr E_TransferSyntax syntax = EXS_LittleEndianExplicit;
    QByteArray bytes(qsizetype(dataset.calcElementLength(syntax, EET_ExplicitLength)) + 1024, 0);
    DcmOutputBufferStream stream(bytes.data(), offile_off_t(bytes.size()));
    dataset.transferInit();
    const bool written = dataset.write(stream, syntax, EET_ExplicitLength, nullptr).good();
    dataset.transferEnd();
    void* begin = nullptr;
    offile_off_t length = 0;
    stream.flushBuffer(begin, length);
    return written ? bytes.left(qsizetype(length)) : QByteArray();
}

} // namespace

Result<KeptHeaders> keepHeaders(const std::vector<SourceSlice>& slices, const Progress& progress)
{
    KeptHeaders headers;
    const Result<void> visited = visitSourceFiles(slices, nullptr, progress,
        [&headers](const QString& file, DcmDataset& dataset,
            const std::vector<std::size_t>&) -> Result<void> {
            DcmDataset kept;
            for (const DcmTagKey& tag : keptTags)
                dataset.findAndInsertCopyOfElement(tag, &kept);
            if (haveFramesInARow(ItemReader(&dataset).text(DCM_SOPClassUID)))
                keepRow(dataset, kept);
            trimGroups(kept, DCM_SharedFunctionalGroupsSequence);
            trimGroups(kept, DCM_PerFrameFunctionalGroupsSequence);
            const QByteArray bytes = bytesOf(kept);
            if (bytes.isEmpty())
                return failure(ErrorCode::Internal, Clause::saying("header of %1", file));
            headers[file] = bytes;
            return {};
        });
    if (!visited)
        return tl::unexpected(visited.error());
    return headers;
}

} // namespace core
