// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/write/SegWriter.h"

#include "core/dicom/base/Dcmtk.h"
#include "core/dicom/base/NewUid.h"
#include "core/dicom/items/PatientHeader.h"
#include "core/dicom/source/SegSource.h"
#include "core/dicom/write/SegCompletion.h"
#include "core/dicom/write/SegParts.h"

#include <QCoreApplication>
#include <QDateTime>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmfg/fgderimg.h>
#include <dcmtk/dcmfg/fgfracon.h>
#include <dcmtk/dcmfg/fgpixmsr.h>
#include <dcmtk/dcmfg/fgplanor.h>
#include <dcmtk/dcmfg/fgplanpo.h>
#include <dcmtk/dcmseg/segdoc.h>
#include <dcmtk/dcmseg/segment.h>

#include <algorithm>
#include <array>
#include <memory>
#include <set>

namespace core {

namespace {

std::string programVersion()
{
    const QString version = QCoreApplication::applicationVersion();
    return version.isEmpty() ? "development" : version.toStdString();
}

CodeSequenceMacro codeOf(const CodedConcept& coded)
{
    return {placeholder(coded.value), placeholder(coded.scheme), placeholder(coded.meaning)};
}

DcmSegTypes::E_SegmentAlgoType algorithmOf(const SegSettings& settings)
{
    switch (settings.algorithm) {
    case SegAlgorithm::Manual:
        return DcmSegTypes::SAT_MANUAL;
    case SegAlgorithm::Automatic:
        return DcmSegTypes::SAT_AUTOMATIC;
    case SegAlgorithm::Semiautomatic:
        break;
    }
    return DcmSegTypes::SAT_SEMIAUTOMATIC;
}

Result<void> addSegments(DcmSegmentation& seg, const SegContent& content, ConditionChain& chain)
{
    for (const Segment& segment : content.segments) {
        const SegCodes codes = segCodesOf(content, segment);
        if (const Result<void> valid = checkSegCodes(segment, codes); !valid)
            return valid;
        const std::string label = placeholder(segmentLabel(segment));
        DcmSegment* made = nullptr;
        chain(DcmSegment::create(made, label, codeOf(codes.category), codeOf(segment.code),
                  algorithmOf(content.settings), algorithmName(content.settings)),
            "segment");
        if (made == nullptr)
            return {};
        const std::array<std::uint16_t, 3> lab = cieLabOf(segment.rgb);
        chain(made->setRecommendedDisplayCIELabValue(lab[0], lab[1], lab[2]), "colour");
        chain(made->setTrackingID(label), "tracking ID");
        chain(made->setTrackingUID(newUid().toStdString()), "tracking UID");
        Uint16 number = 0;
        chain(seg.addSegment(made, number), "segment");
    }
    return {};
}

bool sameOrientation(const SegSource& source)
{
    return std::all_of(source.slices.begin(), source.slices.end(), [&](const SegSlice& slice) {
        return slice.orientation == source.slices.front().orientation;
    });
}

bool sameMeasures(const SegSource& source)
{
    return std::all_of(source.slices.begin(), source.slices.end(), [&](const SegSlice& slice) {
        return slice.spacing == source.slices.front().spacing
            && slice.sliceThickness == source.slices.front().sliceThickness;
    });
}

std::unique_ptr<FGPlaneOrientationPatient> orientationOf(const SegSlice& slice)
{
    const auto& o = slice.orientation;
    return std::unique_ptr<FGPlaneOrientationPatient>(
        FGPlaneOrientationPatient::createMinimal(o[0], o[1], o[2], o[3], o[4], o[5]));
}

std::unique_ptr<FGPixelMeasures> measuresOf(
    const SegSlice& slice, double sliceDistanceMm, ConditionChain& chain)
{
    auto measures = std::make_unique<FGPixelMeasures>();
    chain(measures->setPixelSpacing(slice.spacing[0] + "\\" + slice.spacing[1]), "pixel spacing");
    // Even slices: frames lie side by side, whatever thickness was measured (DESIGN page
    // DICOM, 2.4).
    if (sliceDistanceMm > 0.0) {
        const std::string distance = decimalString(sliceDistanceMm);
        chain(measures->setSpacingBetweenSlices(distance), "spacing between slices");
        chain(measures->setSliceThickness(distance), "slice thickness");
    } else if (!slice.sliceThickness.empty()) {
        chain(measures->setSliceThickness(slice.sliceThickness), "slice thickness");
    }
    return measures;
}

void addFrames(
    DcmSegmentation& seg, const SegContent& content, const SegSource& source, ConditionChain& chain)
{
    const bool sharedOrientation = sameOrientation(source);
    const bool sharedMeasures = content.sliceDistanceMm > 0.0
        ? std::all_of(source.slices.begin(), source.slices.end(),
            [&](const SegSlice& slice) { return slice.spacing == source.slices.front().spacing; })
        : sameMeasures(source);
    if (sharedOrientation)
        chain(seg.addForAllFrames(*orientationOf(source.slices.front())), "orientation");
    if (sharedMeasures)
        chain(
            seg.addForAllFrames(*measuresOf(source.slices.front(), content.sliceDistanceMm, chain)),
            "pixel measures");

    const std::string derivationText = derivationDescription(content).toStdString();
    // dcmseg packs these pixels; ours take their place afterwards.
    std::vector<Uint8> blank(std::size_t(content.rows) * std::size_t(content.columns), 0);
    for (const SegContent::Frame& frame : content.frames) {
        const SegSlice& slice = source.slices[std::size_t(frame.slice)];
        const auto number = Uint16(frame.segment + 1);
        OFVector<FGBase*> groups;

        const std::unique_ptr<FGPlanePosPatient> position(FGPlanePosPatient::createMinimal(
            slice.position[0], slice.position[1], slice.position[2]));
        groups.push_back(position.get());
        FGFrameContent indices;
        chain(indices.setDimensionIndexValues(number, 0), "dimension index");
        chain(indices.setDimensionIndexValues(Uint32(frame.slice + 1), 1), "dimension index");
        groups.push_back(&indices);

        ImageSOPInstanceReferenceMacro* made = nullptr;
        chain(ImageSOPInstanceReferenceMacro::create(slice.sopClassUid, slice.sopInstanceUid, made),
            "source image");
        if (made == nullptr)
            return;
        const std::unique_ptr<ImageSOPInstanceReferenceMacro> reference(made);
        OFVector<ImageSOPInstanceReferenceMacro> references;
        references.push_back(*reference);
        const std::unique_ptr<FGDerivationImage> derivation(
            DcmSegmentation::createDerivationImageFG(references, derivationText));
        if (derivation)
            groups.push_back(derivation.get());
        else
            chain(EC_IllegalCall, "source image");

        std::unique_ptr<FGPlaneOrientationPatient> orientation;
        if (!sharedOrientation) {
            orientation = orientationOf(slice);
            groups.push_back(orientation.get());
        }
        std::unique_ptr<FGPixelMeasures> measures;
        if (!sharedMeasures) {
            measures = measuresOf(slice, content.sliceDistanceMm, chain);
            groups.push_back(measures.get());
        }
        chain(seg.addFrame(blank.data(), number, groups), "frame");
        if (!chain.good())
            return;
    }
}

void addReferences(DcmSegmentation& seg, const SegContent& content, const SegSource& source,
    const std::string& studyUid, ConditionChain& chain)
{
    IODReferences references;
    std::set<std::string> named;
    for (const SegSlice& slice : source.slices) {
        if (!named.insert(slice.sopInstanceUid).second)
            continue;
        auto* reference = new IODImageReference(content.identity.patientId.toStdString(), studyUid,
            slice.seriesUid, slice.sopInstanceUid, slice.sopClassUid);
        reference->m_Level = IODReference::LEVEL_INSTANCE;
        if (!references.add(reference)) {
            delete reference;
            chain(EC_IllegalCall, "reference to a source image");
        }
    }
    const std::size_t added = seg.getCommonInstanceReference().addReferences(references, studyUid);
    if (added != named.size())
        chain(EC_IllegalCall, "references to the source images");
}

void describe(DcmSegmentation& seg, const SegContent& content, const SegSource& source,
    const QDateTime& now, ConditionChain& chain)
{
    const std::string date = now.toString(QStringLiteral("yyyyMMdd")).toStdString();
    const std::string time = now.toString(QStringLiteral("HHmmss")).toStdString();
    auto& common = seg.getSOPCommon();
    chain(common.setSpecificCharacterSet("ISO_IR 192"), "character set");
    chain(common.setSOPInstanceUID(newUid().toStdString()), "SOP Instance UID");
    chain(common.setInstanceCreationDate(date), "date");
    chain(common.setInstanceCreationTime(time), "time");
    auto& series = seg.getSeries();
    chain(series.setSeriesInstanceUID(newUid().toStdString()), "Series Instance UID");
    chain(
        series.setSeriesNumber(std::to_string(segSeriesNumber(content.identity))), "series number");
    chain(series.setSeriesDate(date), "date");
    chain(series.setSeriesTime(time), "time");
    chain(
        series.setSeriesDescription(placeholder(seriesDescription(content))), "series description");
    if (!source.bodyPart.empty())
        chain(series.setBodyPartExamined(source.bodyPart), "body part");
    if (!source.lossyCompression.empty())
        chain(seg.setLossyImageCompressionFlag(source.lossyRatio, source.lossyMethod), "lossy");

    const std::string organization = newUid().toStdString();
    auto& dimensions = seg.getDimensions();
    chain(dimensions.addDimensionIndex(DCM_ReferencedSegmentNumber, organization,
              DCM_SegmentIdentificationSequence, "ReferencedSegmentNumber"),
        "dimension");
    chain(dimensions.addDimensionIndex(DCM_ImagePositionPatient, organization,
              DCM_PlanePositionSequence, "ImagePositionPatient"),
        "dimension");
}

} // namespace

Result<SegWritten> writeSeg(
    const QString& path, const SegContent& content, const Progress& progress)
{
    readyDcmtk();
    constexpr std::size_t longestElement = 0xFFFFFFFE;
    if (content.pixels.size() > longestElement)
        return failure(ErrorCode::UnsupportedFormat, path,
            Clause::saying(
                "its frames fill more than 4 GiB; export the segments in several files"));
    auto source = readSegSource(content.sources, content.keptHeaders.get(), progress);
    if (!source)
        return tl::unexpected(source.error());

    const std::string version = programVersion();
    const IODGeneralEquipmentModule::EquipmentInfo equipment("Burin", "Burin", "0", version);
    const ContentIdentificationMacro identification(
        "1", "SEGMENTATION", contentDescription(content).toStdString(), "");
    DcmSegmentation* made = nullptr;
    ConditionChain chain;
    if (content.type == SegContent::Type::Fractional)
        chain(DcmSegmentation::createFractionalSegmentation(made, Uint16(content.rows),
                  Uint16(content.columns), DcmSegTypes::SFT_OCCUPANCY, 255, equipment,
                  identification),
            "segmentation");
    else
        chain(DcmSegmentation::createBinarySegmentation(
                  made, Uint16(content.rows), Uint16(content.columns), equipment, identification),
            "segmentation");
    if (made == nullptr)
        return failure(ErrorCode::Internal, chain.failure());
    const std::unique_ptr<DcmSegmentation> seg(made);
    chain(seg->importFromSourceImage(*placeholderHeader(*source->header)), "patient and study");
    OFString studyUid;
    source->header->findAndGetOFString(DCM_StudyInstanceUID, studyUid);
    // dcmseg wants a frame of reference, PS3.3 does not where frames name their source. Where the
    // slices have none, or none in common, the object has none.
    const bool ownFrame = content.identity.frameOfReferenceUid.isEmpty()
        || !source->header->tagExists(DCM_FrameOfReferenceUID);
    if (ownFrame)
        chain(seg->getFrameOfReference().setFrameOfReferenceUID(newUid().toStdString()), "frame");

    const QDateTime now = QDateTime::currentDateTime();
    describe(*seg, content, *source, now, chain);
    if (auto added = addSegments(*seg, content, chain); !added)
        return tl::unexpected(added.error());
    if (chain.good())
        addFrames(*seg, content, *source, chain);
    if (chain.good())
        addReferences(*seg, content, *source, studyUid, chain);
    if (!chain.good())
        return failure(ErrorCode::Internal, chain.failure());
    if (progress.cancelled())
        return failure(ErrorCode::Cancelled);

    // Both compare every frame with every other; what they would find, the check afterwards does.
    seg->setCheckFGOnWrite(OFFalse);
    seg->setCheckDimensionsOnWrite(OFFalse);
    DcmFileFormat format;
    DcmDataset& dataset = *format.getDataset();
    chain(seg->writeDataset(dataset), "data set");
    if (chain.good())
        completeSeg(dataset, content, *source, chain);
    if (!chain.good())
        return failure(ErrorCode::Internal, chain.failure());
    if (ownFrame) {
        dataset.findAndDeleteElement(DCM_FrameOfReferenceUID);
        dataset.findAndDeleteElement(DCM_PositionReferenceIndicator);
    }
    return saveSeg(path, content, format, source->notes);
}

} // namespace core
