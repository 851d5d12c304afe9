// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/source/SegSource.h"

#include "core/dicom/items/PatientHeader.h"
#include "core/dicom/source/VisitSourceFiles.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace core {

namespace {

/// The item that holds a frame's macro: per frame, else shared, else the object itself.
DcmItem* macroItem(DcmItem& dataset, const DcmTagKey& macro, int frame)
{
    DcmItem* group = nullptr;
    DcmItem* item = nullptr;
    if (dataset.findAndGetSequenceItem(DCM_PerFrameFunctionalGroupsSequence, group, frame).good()
        && group->findAndGetSequenceItem(macro, item).good())
        return item;
    if (dataset.findAndGetSequenceItem(DCM_SharedFunctionalGroupsSequence, group).good()
        && group->findAndGetSequenceItem(macro, item).good())
        return item;
    return &dataset;
}

/// Value @p index of a decimal string: its text if that is valid, else the number written anew.
bool decimalText(DcmItem& item, const DcmTagKey& tag, unsigned long index, std::string& text)
{
    OFString value;
    if (item.findAndGetOFString(tag, value, index).bad() || value.empty())
        return false;
    if (DcmDecimalString::checkStringValue(value, "1").good()) {
        text = value;
        return true;
    }
    Float64 number = 0.0;
    if (item.findAndGetFloat64(tag, number, index).bad() || !std::isfinite(number))
        return false;
    text = decimalString(number);
    return true;
}

template <std::size_t N>
bool decimalTexts(DcmItem& item, const DcmTagKey& tag, std::array<std::string, N>& texts)
{
    for (std::size_t i = 0; i < N; ++i) {
        if (!decimalText(item, tag, i, texts[i]))
            return false;
    }
    return true;
}

std::string plainText(DcmItem& item, const DcmTagKey& tag)
{
    OFString value;
    item.findAndGetOFString(tag, value);
    return value;
}

/// @returns what is missing or wrong; empty if nothing is
Clause readSlice(DcmItem& dataset, int frame, SegSlice& slice)
{
    slice.frame = frame;
    slice.multiFrame = dataset.tagExists(DCM_NumberOfFrames)
        && std::atoi(plainText(dataset, DCM_NumberOfFrames).c_str()) > 1;
    slice.sopClassUid = plainText(dataset, DCM_SOPClassUID);
    slice.sopInstanceUid = plainText(dataset, DCM_SOPInstanceUID);
    slice.seriesUid = plainText(dataset, DCM_SeriesInstanceUID);
    const std::array<std::pair<const char*, const std::string*>, 3> uids{
        {{"SOP Class UID", &slice.sopClassUid}, {"SOP Instance UID", &slice.sopInstanceUid},
            {"Series Instance UID", &slice.seriesUid}}};
    for (const auto& uid : uids) {
        if (uid.second->empty() || DcmUniqueIdentifier::checkStringValue(*uid.second, "1").bad())
            return Clause::saying("it has no valid %1", QLatin1String(uid.first));
    }

    DcmItem& measures = *macroItem(dataset, DCM_PixelMeasuresSequence, frame);
    if (!decimalTexts(*macroItem(dataset, DCM_PlanePositionSequence, frame),
            DCM_ImagePositionPatient, slice.position))
        return Clause::saying("it has no Image Position (Patient)");
    if (!decimalTexts(*macroItem(dataset, DCM_PlaneOrientationSequence, frame),
            DCM_ImageOrientationPatient, slice.orientation))
        return Clause::saying("it has no Image Orientation (Patient)");
    if (!decimalTexts(measures, DCM_PixelSpacing, slice.spacing))
        return Clause::saying("it has no Pixel Spacing");
    decimalText(measures, DCM_SliceThickness, 0, slice.sliceThickness);
    return {};
}

/// What the SEG takes from the first slice's header. @return why it cannot; empty if it can
Clause readCommon(DcmDataset& dataset, SegSource& source)
{
    auto header = cleanPatientHeader(dataset, source.notes);
    if (!header)
        return header.error();
    source.header = std::move(*header);
    source.bodyPart = plainText(dataset, DCM_BodyPartExamined);
    if (DcmCodeString::checkStringValue(source.bodyPart, "1").bad())
        source.bodyPart.clear();
    return {};
}

void readLossyCompression(DcmDataset& dataset, SegSource& source)
{
    if (plainText(dataset, DCM_LossyImageCompression) != "01")
        return;
    source.lossyCompression = "01";
    OFString values;
    if (dataset.findAndGetOFStringArray(DCM_LossyImageCompressionRatio, values).good()
        && DcmDecimalString::checkStringValue(values, "1-n").good())
        source.lossyRatio = values;
    if (dataset.findAndGetOFStringArray(DCM_LossyImageCompressionMethod, values).good()
        && DcmCodeString::checkStringValue(values, "1-n").good())
        source.lossyMethod = values;
}

} // namespace

SegSource::SegSource() = default;
SegSource::SegSource(SegSource&&) noexcept = default;
SegSource& SegSource::operator=(SegSource&&) noexcept = default;
SegSource::~SegSource() = default;

std::string decimalString(double value)
{
    std::array<char, 64> text{};
    for (int precision = 17; precision > 0; --precision) {
        const auto end = std::to_chars(
            text.data(), text.data() + text.size(), value, std::chars_format::general, precision);
        if (end.ptr - text.data() <= 16)
            return {text.data(), end.ptr};
    }
    return "0";
}

Result<SegSource> readSegSource(
    const std::vector<SourceSlice>& sources, const KeptHeaders* kept, const Progress& progress)
{
    SegSource source;
    source.slices.resize(sources.size());
    const Result<void> visited = visitSourceFiles(sources, kept, progress,
        [&](const QString& file, DcmDataset& dataset,
            const std::vector<std::size_t>& held) -> Result<void> {
            for (const std::size_t k : held) {
                const Clause missing = readSlice(dataset, sources[k].frame, source.slices[k]);
                if (!missing.isEmpty())
                    return failure(ErrorCode::UnsupportedFormat, file,
                        Clause::saying(
                            "%1; no DICOM object can refer to it, NIfTI can be exported instead",
                            missing));
            }
            if (std::find(held.begin(), held.end(), std::size_t(0)) != held.end()) {
                if (const Clause reason = readCommon(dataset, source); !reason.isEmpty())
                    return failure(ErrorCode::UnsupportedFormat, file, reason);
            }
            readLossyCompression(dataset, source);
            return {};
        });
    if (!visited)
        return tl::unexpected(visited.error());
    return source;
}

} // namespace core
