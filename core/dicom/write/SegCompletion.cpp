// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/write/SegCompletion.h"

#include "core/dicom/items/PatientHeader.h"
#include "core/dicom/write/SegParts.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace core {

namespace {

void putText(DcmItem& item, const DcmTagKey& tag, const QString& text, ConditionChain& chain)
{
    chain(item.putAndInsertString(tag, text.toStdString().c_str()), "text");
}

/// The text that placeholder() stood in for.
void completeText(
    DcmDataset& dataset, const SegContent& content, const SegSource& source, ConditionChain& chain)
{
    for (DcmObject* object = source.header->nextInContainer(nullptr); object != nullptr;
         object = source.header->nextInContainer(object)) {
        auto* copy = static_cast<DcmElement*>(object->clone());
        chain(dataset.insert(copy, OFTrue), "patient and study");
    }
    putText(dataset, DCM_SeriesDescription, seriesDescription(content), chain);
    const auto putMeaning = [&](DcmItem& segment, const DcmTagKey& sequence, const QString& text) {
        DcmItem* code = nullptr;
        chain(segment.findAndGetSequenceItem(sequence, code), "code");
        if (code != nullptr)
            putText(*code, DCM_CodeMeaning, text, chain);
    };
    for (std::size_t i = 0; i < content.segments.size(); ++i) {
        const Segment& segment = content.segments[i];
        DcmItem* item = nullptr;
        chain(dataset.findAndGetSequenceItem(DCM_SegmentSequence, item, long(i)), "segment");
        if (item == nullptr)
            return;
        putText(*item, DCM_SegmentLabel, segmentLabel(segment), chain);
        putText(*item, DCM_TrackingID, segmentLabel(segment), chain);
        const SegCodes codes = segCodesOf(content, segment);
        putMeaning(*item, DCM_SegmentedPropertyCategoryCodeSequence, codes.category.meaning);
        putMeaning(*item, DCM_SegmentedPropertyTypeCodeSequence, segment.code.meaning);
        putSegDetails(item, codes, ItemWriter(chain));
        const QString algorithm = singleValueText(content.settings.algorithmName, 64);
        if (content.settings.algorithm != SegAlgorithm::Manual && !algorithm.isEmpty())
            putText(*item, DCM_SegmentAlgorithmName, algorithm, chain);
    }
}

void completeRest(
    DcmDataset& dataset, const SegContent& content, const SegSource& sources, ConditionChain& chain)
{
    chain(dataset.putAndInsertUint8Array(DCM_PixelData, content.pixels.data(),
              static_cast<unsigned long>(content.pixels.size())),
        "pixel data");
    chain(dataset.putAndInsertString(DCM_SegmentsOverlap, content.segmentsOverlap ? "YES" : "NO"),
        "segments overlap");
    DcmSequenceOfItems* frames = nullptr;
    dataset.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, frames);
    // 3.6.7 writes on without a word when a functional group is not valid.
    if (frames == nullptr || frames->card() != content.frames.size()) {
        chain(EC_IllegalCall, "functional groups of the frames");
        return;
    }
    auto frame = content.frames.begin();
    for (DcmObject* object = frames->nextInContainer(nullptr); object != nullptr;
         object = frames->nextInContainer(object), ++frame) {
        auto* item = dynamic_cast<DcmItem*>(object);
        DcmItem* derivation = nullptr;
        DcmItem* source = nullptr;
        if (item == nullptr
            || item->findAndGetSequenceItem(DCM_DerivationImageSequence, derivation).bad()
            || derivation->findAndGetSequenceItem(DCM_SourceImageSequence, source).bad()) {
            chain(EC_IllegalCall, "source image");
            return;
        }
        chain(source->putAndInsertString(DCM_SpatialLocationsPreserved, "YES"), "source image");
        const SegSlice& slice = sources.slices[std::size_t(frame->slice)];
        if (slice.multiFrame)
            chain(source->putAndInsertString(
                      DCM_ReferencedFrameNumber, std::to_string(slice.frame + 1).c_str()),
                "source frame");
    }
}

} // namespace

std::string placeholder(const QString& text)
{
    std::string plain;
    for (const QChar character : text)
        plain += character.unicode() < 128 ? char(character.unicode()) : '?';
    return plain;
}

std::unique_ptr<DcmDataset> placeholderHeader(DcmDataset& header)
{
    auto plain = std::make_unique<DcmDataset>(header);
    for (DcmObject* object = plain->nextInContainer(nullptr); object != nullptr;
         object = plain->nextInContainer(object)) {
        auto* element = static_cast<DcmElement*>(object);
        OFString value;
        element->getOFStringArray(value);
        element->putOFStringArray(placeholder(QString::fromStdString(value)));
    }
    return plain;
}

QString seriesDescription(const SegContent& content)
{
    return singleValueText(
        QStringLiteral("Segmentation ") + content.identity.seriesDescription, 64);
}

QString segmentLabel(const Segment& segment)
{
    const QString label = singleValueText(segment.name, 64);
    return label.isEmpty() ? QStringLiteral("Segment") : label;
}

void completeSeg(
    DcmDataset& dataset, const SegContent& content, const SegSource& source, ConditionChain& chain)
{
    completeText(dataset, content, source, chain);
    if (chain.good())
        completeRest(dataset, content, source, chain);
}

} // namespace core
