// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/header/PhaseAttributes.h"

#include "core/dicom/items/FunctionalGroups.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <QStringList>

namespace core {

namespace {

enum class Kind { Number, Time, Label };

struct Phase {
    DcmTagKey key; ///< in a single-frame object
    DcmTagKey macro; ///< what holds it of a frame
    DcmTagKey frameKey;
    Clause name;
    const char* unit = "";
    Kind kind = Kind::Number;
};

const DcmTagKey none(0, 0);

/// The order of DICOM.md 1.3: what names a phase first, what merely differs with it last.
const std::vector<Phase>& table()
{
    static const std::vector<Phase> phases{
        {DCM_TemporalPositionIdentifier, DCM_FrameContentSequence, DCM_TemporalPositionIndex,
            Clause::saying("temporal position")},
        {DCM_NominalPercentageOfCardiacPhase, DCM_CardiacSynchronizationSequence,
            DCM_NominalPercentageOfCardiacPhase, Clause::saying("cardiac phase"), "%"},
        {DCM_TriggerTime, DCM_CardiacSynchronizationSequence, DCM_NominalCardiacTriggerDelayTime,
            Clause::saying("trigger time"), "ms"},
        {DCM_EchoNumbers, none, none, Clause::saying("echo")},
        {DCM_EchoTime, DCM_MREchoSequence, DCM_EffectiveEchoTime, Clause::saying("echo time"),
            "ms"},
        {DCM_DiffusionBValue, DCM_MRDiffusionSequence, DCM_DiffusionBValue,
            Clause::saying("b-value"), "s/mm²"},
        {DCM_DiffusionGradientOrientation, DCM_MRDiffusionSequence,
            DCM_DiffusionGradientOrientation, Clause::saying("gradient"), "", Kind::Label},
        {DCM_ImageType, DCM_MRImageFrameTypeSequence, DCM_FrameType, Clause::saying("image type"),
            "", Kind::Label},
        {DCM_InversionTime, none, none, Clause::saying("inversion time"), "ms"},
        {DCM_FlipAngle, none, none, Clause::saying("flip angle"), "°"},
        {DCM_AcquisitionNumber, DCM_FrameContentSequence, DCM_FrameAcquisitionNumber,
            Clause::saying("acquisition"), "", Kind::Label},
        {DCM_AcquisitionDateTime, DCM_FrameContentSequence, DCM_FrameAcquisitionDateTime,
            Clause::saying("acquired at"), "", Kind::Time},
        {DCM_AcquisitionTime, none, none, Clause::saying("acquired at"), "", Kind::Time},
        {DCM_ContentTime, DCM_FrameContentSequence, DCM_FrameReferenceDateTime,
            Clause::saying("time"), "", Kind::Time},
        {none, none, none, Clause::saying("dimension index"), "", Kind::Label},
    };
    return phases;
}

DcmItem* macroOf(const FunctionalGroups& groups, const Phase& phase, std::size_t frame)
{
    if (phase.macro == none)
        return nullptr;
    DcmItem* macro = groups.find(phase.macro, frame);
    for (const DcmTagKey& other : {DCM_CTImageFrameTypeSequence, DCM_PETFrameTypeSequence}) {
        if (macro == nullptr && phase.frameKey == DCM_FrameType)
            macro = groups.find(other, frame);
    }
    DcmItem* inner = nullptr;
    if (macro != nullptr && phase.frameKey == DCM_DiffusionGradientOrientation)
        return macro->findAndGetSequenceItem(DCM_DiffusionGradientDirectionSequence, inner).good()
            ? inner
            : nullptr;
    return macro;
}

/// The frame's dimension indices without the one that only counts slices.
QString dimensionIndices(const FunctionalGroups& groups, std::size_t frame, int inStackIndex)
{
    DcmItem* content = groups.find(DCM_FrameContentSequence, frame);
    QStringList kept;
    Uint32 index = 0;
    for (unsigned long at = 0; content != nullptr
         && content->findAndGetUint32(DCM_DimensionIndexValues, index, at).good();
         ++at) {
        if (int(at) != inStackIndex)
            kept.append(QString::number(index));
    }
    return kept.join(QLatin1Char('-'));
}

/// "103045.120000" → "10:30:45.12"; a date before it is left out.
QString clockText(QString time)
{
    const qsizetype point = time.indexOf(QLatin1Char('.'));
    const qsizetype whole = point < 0 ? time.size() : point;
    if (whole >= 14)
        time.remove(0, 8);
    else if (whole != 6)
        return time;
    if (time.contains(QLatin1Char('.'))) {
        while (time.endsWith(QLatin1Char('0')))
            time.chop(1);
        if (time.endsWith(QLatin1Char('.')))
            time.chop(1);
    }
    return QStringLiteral("%1:%2:%3").arg(time.left(2), time.mid(2, 2), time.mid(4));
}

} // namespace

std::size_t phaseAttributeCount()
{
    return table().size();
}

Clause phaseText(std::size_t attribute, const QString& value)
{
    const Phase& phase = table().at(attribute);
    QString text = phase.kind == Kind::Time ? clockText(value) : value;
    if (*phase.unit != '\0')
        text += QLatin1Char(' ') + QString::fromUtf8(phase.unit);
    return Clause::saying("%1 %2", phase.name, text);
}

bool phaseHasOrder(std::size_t attribute)
{
    return table().at(attribute).kind != Kind::Label;
}

std::vector<QString> readPhases(const HeaderAttributes& from)
{
    std::vector<QString> values;
    for (const Phase& phase : table())
        values.push_back(phase.key == none ? QString() : from.text(phase.key));
    return values;
}

std::vector<QString> readFramePhases(const FunctionalGroups& groups, std::size_t frame,
    const QByteArray& characterSet, std::vector<QString> whole, int inStackIndex)
{
    for (std::size_t index = 0; index < whole.size(); ++index) {
        const Phase& phase = table()[index];
        if (DcmItem* macro = macroOf(groups, phase, frame)) {
            const QString own = HeaderAttributes(*macro, characterSet).text(phase.frameKey);
            if (!own.isEmpty())
                whole[index] = own;
        }
    }
    whole.back() = dimensionIndices(groups, frame, inStackIndex);
    return whole;
}

} // namespace core
