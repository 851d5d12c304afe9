// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/write/SegParts.h"

#include "core/dicom/deidentify/Deidentifier.h"
#include "core/dicom/items/PatientHeader.h"
#include "core/dicom/write/MadeObject.h"
#include "core/dicom/write/SaveDicom.h"
#include "core/dicom/write/SegCompletion.h"
#include "core/repair/SeriesRepair.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmiod/cielabutil.h>

#include <algorithm>
#include <cmath>

namespace core {

SegCodes codesIn(const SegSettings& settings, int label, const CodedConcept& category)
{
    const auto found = settings.codes.find(label);
    SegCodes codes = found == settings.codes.end() ? SegCodes() : found->second;
    if (!codes.category.isSet())
        codes.category = category;
    return codes;
}

SegCodes segCodesOf(const SegContent& content, const Segment& segment)
{
    return codesIn(content.settings, segment.label, content.category);
}

Result<void> checkSegCodes(const Segment& segment, const SegCodes& codes)
{
    bool fits = fitsCodeSequence(segment.code) && fitsCodeSequence(codes.category);
    for (const CodedConcept* code : {&codes.modifier, &codes.region, &codes.regionModifier})
        fits = fits && (!code->isSet() || fitsCodeSequence(*code));
    if (fits)
        return {};
    return failure(ErrorCode::InvalidField, QStringLiteral("code"),
        Clause::saying("DICOM cannot hold the code of segment '%1': scheme and value take 1 "
                       "to 16 characters, the meaning 1 to 64",
            segment.name));
}

void putSegDetails(DcmItem* segment, const SegCodes& codes, const ItemWriter& items)
{
    const auto inner = [](DcmItem* item, const DcmTagKey& sequence) {
        DcmItem* found = nullptr;
        if (item != nullptr)
            item->findAndGetSequenceItem(sequence, found);
        return found;
    };
    if (codes.modifier.isSet())
        items.putCode(inner(segment, DCM_SegmentedPropertyTypeCodeSequence),
            DCM_SegmentedPropertyTypeModifierCodeSequence, codes.modifier);
    if (!codes.region.isSet())
        return;
    items.putCode(segment, DCM_AnatomicRegionSequence, codes.region);
    if (codes.regionModifier.isSet())
        items.putCode(inner(segment, DCM_AnatomicRegionSequence),
            DCM_AnatomicRegionModifierSequence, codes.regionModifier);
}

QString contentDescription(const SegContent& content)
{
    constexpr qsizetype longest = 64; // LO
    return content.repair.isEmpty()
        ? QStringLiteral("Segmentation")
        : (QStringLiteral("Repaired series: ") + content.repair).left(longest);
}

QString derivationDescription(const SegContent& content)
{
    const QString stamp = repairStamp(content.repair);
    return stamp.isEmpty() ? QStringLiteral("Segmentation")
                           : QStringLiteral("Segmentation. ") + stamp;
}

std::string algorithmTypeText(const SegSettings& settings)
{
    switch (settings.algorithm) {
    case SegAlgorithm::Manual:
        return "MANUAL";
    case SegAlgorithm::Automatic:
        return "AUTOMATIC";
    case SegAlgorithm::Semiautomatic:
        break;
    }
    return "SEMIAUTOMATIC";
}

std::string algorithmName(const SegSettings& settings)
{
    if (settings.algorithm == SegAlgorithm::Manual)
        return {};
    const std::string name = placeholder(singleValueText(settings.algorithmName, 64));
    return name.empty() ? "Burin" : name;
}

std::array<std::uint16_t, 3> cieLabOf(std::uint32_t rgb)
{
    double l = 0.0;
    double a = 0.0;
    double b = 0.0;
    IODCIELabUtil::rgb2Lab(l, a, b, double((rgb >> 16) & 255U) / 255.0,
        double((rgb >> 8) & 255U) / 255.0, double(rgb & 255U) / 255.0);
    IODCIELabUtil::lab2DicomLab(l, a, b, l, a, b);
    const auto word = [](double value) {
        return std::uint16_t(std::clamp(std::lround(value), 0L, 65535L));
    };
    return {word(l), word(a), word(b)};
}

int segSeriesNumber(const StudyIdentity& source)
{
    return madeSeriesNumber(1000, source);
}

Result<SegWritten> saveSeg(
    const QString& path, const SegContent& content, DcmFileFormat& format, ReportLines notes)
{
    if (content.deidentifier)
        content.deidentifier->apply(*format.getDataset());
    const Result<void> saved = saveDicom(format, path,
        content.settings.deflated ? UID_DeflatedExplicitVRLittleEndianTransferSyntax
                                  : UID_LittleEndianExplicitTransferSyntax);
    if (!saved)
        return tl::unexpected(saved.error());
    return SegWritten{std::move(notes)};
}

} // namespace core
