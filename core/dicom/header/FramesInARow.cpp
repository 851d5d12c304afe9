// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/header/FramesInARow.h"

#include "core/dicom/header/ImageMacros.h"
#include "core/dicom/items/SopClass.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <optional>

namespace core {

namespace {

/// Where nothing but one number says how many there are: no more than that number can cost.
constexpr int mostUnlisted = 4096;

/// Millimetres along the normal, per frame.
using Offsets = std::optional<std::vector<double>>;

/// PS3.3 C.8.8.3.2: the vector begins with zero, or with the place of the first frame.
Offsets doseOffsets(const HeaderAttributes& from, int frames)
{
    std::vector<double> offsets = from.numbers(DCM_GridFrameOffsetVector);
    if (offsets.empty() && frames == 1)
        return std::vector<double>{0.0};
    if (offsets.size() != std::size_t(frames))
        return std::nullopt;
    const double first = offsets.front();
    for (double& offset : offsets)
        offset -= first;
    return offsets;
}

/// PS3.3 C.8.4.8.1: frame by frame the number of its slice, from 1. What counts otherwise leaves
/// open from which of its frames the position is.
bool countsSlices(const HeaderAttributes& from, int frames)
{
    const std::vector<double> slices = from.numbers(DCM_SliceVector);
    if (slices.empty())
        return frames <= mostUnlisted;
    if (slices.size() != std::size_t(frames))
        return false;
    for (std::size_t frame = 0; frame < slices.size(); ++frame) {
        if (slices[frame] != double(frame + 1))
            return false;
    }
    return true;
}

/// Slices, and neither projections nor slices at several phases of a heart.
bool isReconstructed(const ImageHeader& whole)
{
    return whole.imageType.value(2) == QLatin1String("RECON TOMO");
}

/// PS3.3 C.8.4.15: the sign of the distance says on which side of the first slice the others lie.
Offsets sliceOffsets(const HeaderAttributes& from, const ImageHeader& whole)
{
    if (whole.frames == 1)
        return std::vector<double>{0.0};
    const double distance = from.number(DCM_SpacingBetweenSlices).value_or(0.0);
    if (!isReconstructed(whole) || !countsSlices(from, whole.frames) || distance == 0.0)
        return std::nullopt;
    std::vector<double> offsets;
    for (int frame = 0; frame < whole.frames; ++frame)
        offsets.push_back(distance * frame);
    return offsets;
}

/// The detector has the plane of nuclear medicine, in older files the data set.
void readDetectorPlane(DcmDataset& set, const QByteArray& characterSet, ImageHeader& header)
{
    DcmItem* detector = nullptr;
    if (set.findAndGetSequenceItem(DCM_DetectorInformationSequence, detector, 0).bad())
        return;
    const HeaderAttributes from(*detector, characterSet);
    readPosition(from, header);
    readOrientation(from, header);
}

} // namespace

std::vector<ImageHeader> framesInARow(
    DcmDataset& set, const QByteArray& characterSet, const ImageHeader& whole)
{
    const HeaderAttributes from(set, characterSet);
    const bool dose = isDose(whole.sopClassUid);
    ImageHeader first = whole;
    Offsets offsets;
    if (whole.frames <= mostFrames)
        offsets = dose ? doseOffsets(from, whole.frames) : sliceOffsets(from, whole);
    if (!offsets) {
        first.framesUnplaced = true;
        return {first};
    }
    // Of a projection that plane is the detector's own.
    if (!dose && isReconstructed(whole))
        readDetectorPlane(set, characterSet, first);
    // The doses of several beams in one series are no points in time.
    if (dose && whole.frames > 1)
        first.stackId = whole.sopInstanceUid;
    std::vector<ImageHeader> frames(offsets->size(), first);
    for (std::size_t frame = 0; frame < frames.size(); ++frame) {
        ImageHeader& header = frames[frame];
        header.frame = int(frame);
        if (whole.frames > 1)
            header.pixelsCut = whole.framesPresent && int(frame) >= *whole.framesPresent;
        if (header.position && header.plane)
            *header.position += offsets->at(frame) * header.plane->normal();
    }
    return frames;
}

} // namespace core
