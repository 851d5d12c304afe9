// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/header/MultiframeHeader.h"

#include "core/dicom/header/FramesInARow.h"
#include "core/dicom/header/ImageMacros.h"
#include "core/dicom/header/ImageQuantity.h"
#include "core/dicom/header/PhaseAttributes.h"
#include "core/dicom/items/FunctionalGroups.h"
#include "core/dicom/items/SopClass.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>

namespace core {

namespace {

/// Which dimension index counts the slices of a stack; -1 if none is said to.
int inStackIndex(DcmDataset& set)
{
    DcmItem* dimension = nullptr;
    for (long at = 0; set.findAndGetSequenceItem(DCM_DimensionIndexSequence, dimension, at).good();
         ++at) {
        DcmElement* pointer = nullptr;
        DcmTagKey key;
        if (dimension->findAndGetElement(DCM_DimensionIndexPointer, pointer).good()
            && dynamic_cast<DcmAttributeTag*>(pointer) != nullptr
            && dynamic_cast<DcmAttributeTag*>(pointer)->getTagVal(key).good()
            && key == DCM_InStackPositionNumber)
            return int(at);
    }
    return -1;
}

bool isCut(const ImageHeader& whole, std::size_t frame)
{
    return whole.framesPresent && int(frame) >= *whole.framesPresent;
}

} // namespace

std::vector<ImageHeader> framesOf(
    DcmDataset& set, const QByteArray& characterSet, const ImageHeader& whole)
{
    std::vector<ImageHeader> frames{whole};
    if (whole.layout.samplesPerPixel != 1)
        return frames;
    if (haveFramesInARow(whole.sopClassUid) && !whole.isEnhanced)
        return framesInARow(set, characterSet, whole);
    if (whole.frames == 1 && !whole.isEnhanced)
        return frames;
    const FunctionalGroups groups(set);
    // What the file has of items bounds the work, not what it claims.
    const int count = whole.frames == 1 ? 1 : std::min(whole.frames, int(groups.count()));
    if (count < 1 || whole.frames > mostFrames) {
        frames.front().framesUnplaced = true;
        return frames;
    }
    const int slices = inStackIndex(set);
    const auto about = [&](const DcmTagKey& macro, std::size_t frame) {
        return HeaderAttributes(groups.holder(macro, frame), characterSet);
    };
    frames.assign(std::size_t(count), whole);
    for (std::size_t frame = 0; frame < frames.size(); ++frame) {
        ImageHeader& header = frames[frame];
        header.frame = int(frame);
        header.pixelsCut = isCut(whole, frame);
        readPosition(about(DCM_PlanePositionSequence, frame), header);
        readOrientation(about(DCM_PlaneOrientationSequence, frame), header);
        readMeasures(about(DCM_PixelMeasuresSequence, frame), header);
        if (!whole.modalityLut)
            readRescale(about(DCM_PixelValueTransformationSequence, frame), header);
        readWindow(about(DCM_FrameVOILUTSequence, frame), header);
        header.stackId = about(DCM_FrameContentSequence, frame).text(DCM_StackID);
        const HeaderAttributes kind = about(DCM_MRImageFrameTypeSequence, frame);
        const Clause quantity =
            imageQuantity(kind.text(DCM_FrameType), kind.text(DCM_ComplexImageComponent));
        if (!quantity.isEmpty())
            header.quantity = quantity;
        header.phases = readFramePhases(groups, frame, characterSet, whole.phases, slices);
    }
    if (count < whole.frames) {
        ImageHeader& others = frames.emplace_back(whole);
        others.frame = count;
        others.framesWithoutGroup = whole.frames - count;
        others.position.reset();
    }
    return frames;
}

} // namespace core
