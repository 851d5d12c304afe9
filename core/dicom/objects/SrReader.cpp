// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/objects/SrReader.h"

#include "core/dicom/base/DicomFile.h"
#include "core/dicom/base/DicomText.h"
#include "core/dicom/base/TextsToUtf8.h"
#include "core/dicom/source/PatientAndPlane.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace core {

namespace {

QString codeIn(const ItemReader& item, const DcmTagKey& sequence)
{
    return item.item(sequence).text(DCM_CodeValue);
}

/// Of a number, or of the group itself; numbers of one group lie at the same places.
void readPlaces(const ItemReader& item, SrFileGroup& group)
{
    if (item.text(DCM_ValueType) != QLatin1String("SCOORD3D"))
        return;
    group.graphicType = item.text(DCM_GraphicType);
    group.graphicData = item.floats(DCM_GraphicData);
    group.frameOfReferenceUid = item.text(DCM_ReferencedFrameOfReferenceUID);
}

void readNumber(const ItemReader& item, SrFileGroup& group)
{
    QString name = codeIn(item, DCM_ConceptNameCodeSequence);
    for (int i = 0; i < item.itemCount(DCM_ContentSequence); ++i) {
        const ItemReader child = item.item(DCM_ContentSequence, i);
        if (codeIn(child, DCM_ConceptNameCodeSequence) == QLatin1String("121401"))
            name = codeIn(child, DCM_ConceptCodeSequence);
        readPlaces(child, group);
    }
    const std::string text =
        item.item(DCM_MeasuredValueSequence).text(DCM_NumericValue).toStdString();
    if (const auto number = dicomNumber(text))
        group.numbers[name] = *number;
}

SrFileGroup readGroup(const ItemReader& item)
{
    SrFileGroup group;
    for (int i = 0; i < item.itemCount(DCM_ContentSequence); ++i) {
        const ItemReader child = item.item(DCM_ContentSequence, i);
        const QString name = codeIn(child, DCM_ConceptNameCodeSequence);
        const ItemReader reference = child.item(DCM_ReferencedSOPSequence);
        readPlaces(child, group);
        if (child.text(DCM_ValueType) == QLatin1String("NUM")) {
            readNumber(child, group);
        } else if (name == QLatin1String("112039")) {
            group.name = child.text(DCM_TextValue);
        } else if (name == QLatin1String("121191")) {
            group.segUid = reference.text(DCM_ReferencedSOPInstanceUID);
            group.segmentNumber = reference.integer(DCM_ReferencedSegmentNumber).value_or(0);
        } else if (name == QLatin1String("121232")) {
            group.sourceSeriesUid = child.text(DCM_UID);
        }
    }
    return group;
}

} // namespace

Result<SrFile> readSr(const QString& path)
{
    DcmDataset set;
    if (const Result<void> header = DicomFile::readHeader(path, set); !header)
        return tl::unexpected<Error>(header.error());
    SrFile report;
    report.patient = readHeaderPatient(set);
    textsToUtf8(set);
    const ItemReader reader(&set);
    if (codeIn(reader, DCM_ConceptNameCodeSequence) != QLatin1String("126000"))
        return failure(ErrorCode::UnsupportedFormat, path, Clause::saying("no measurement report"));
    report.studyUid = reader.text(DCM_StudyInstanceUID);
    const ItemReader evidence = reader.item(DCM_CurrentRequestedProcedureEvidenceSequence);
    for (int i = 0; i < evidence.itemCount(DCM_ReferencedSeriesSequence); ++i) {
        const ItemReader series = evidence.item(DCM_ReferencedSeriesSequence, i);
        for (int k = 0; k < series.itemCount(DCM_ReferencedSOPSequence); ++k)
            report.evidence +=
                series.item(DCM_ReferencedSOPSequence, k).text(DCM_ReferencedSOPInstanceUID);
    }
    for (int i = 0; i < reader.itemCount(DCM_ContentSequence); ++i) {
        const ItemReader part = reader.item(DCM_ContentSequence, i);
        if (codeIn(part, DCM_ConceptNameCodeSequence) != QLatin1String("126010"))
            continue;
        for (int k = 0; k < part.itemCount(DCM_ContentSequence); ++k)
            report.groups.push_back(readGroup(part.item(DCM_ContentSequence, k)));
    }
    return report;
}

} // namespace core
