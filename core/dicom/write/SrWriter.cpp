// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/write/SrWriter.h"

#include "core/dicom/base/Dcmtk.h"
#include "core/dicom/base/NewUid.h"
#include "core/dicom/deidentify/Deidentifier.h"
#include "core/dicom/items/PatientHeader.h"
#include "core/dicom/objects/SegReader.h"
#include "core/dicom/source/ItemWriter.h"
#include "core/dicom/write/MadeObject.h"
#include "core/dicom/write/SaveDicom.h"
#include "core/dicom/write/SrMeasured.h"
#include "core/dicom/write/SrTree.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace core {

namespace {

bool holdsPlaces(const SrContent& content)
{
    return !content.measured.empty() && !content.identity.frameOfReferenceUid.isEmpty();
}

void describe(DcmDataset& set, const SrContent& content, const ItemWriter& items)
{
    // Only the first one may hold places of the patient.
    const char* sopClassUid =
        holdsPlaces(content) ? UID_Comprehensive3DSRStorage : UID_EnhancedSRStorage;
    describeMadeContent(&set,
        madeOf(content.identity, sopClassUid, "SR", 4000, QStringLiteral("Measurements")), items);
    items.put(&set, DCM_DeviceSerialNumber, "0");
    items.put(&set, DCM_CompletionFlag, "COMPLETE");
    items.put(&set, DCM_VerificationFlag, "UNVERIFIED");
    set.insertEmptyElement(DCM_ReferencedPerformedProcedureStepSequence);
    set.insertEmptyElement(DCM_PerformedProcedureCodeSequence);
}

/// The SEG and every image that it was drawn on.
void putEvidence(DcmDataset& set, const SegFile& seg, const SegSource& source,
    const std::string& study, const ItemWriter& items)
{
    DcmItem* evidence = items.append(&set, DCM_CurrentRequestedProcedureEvidenceSequence);
    items.put(evidence, DCM_StudyInstanceUID, study);
    DcmItem* own = items.append(evidence, DCM_ReferencedSeriesSequence);
    items.put(own, DCM_SeriesInstanceUID, seg.seriesUid);
    DcmItem* object = items.append(own, DCM_ReferencedSOPSequence);
    items.put(object, DCM_ReferencedSOPClassUID, UID_SegmentationStorage);
    items.put(object, DCM_ReferencedSOPInstanceUID, seg.sopInstanceUid);
    items.referAll(
        evidence, DCM_ReferencedSeriesSequence, DCM_ReferencedSOPSequence, source.slices);
}

void putSizes(DcmItem* item, const SrGroup& group, bool inVoxels, const SrTree& tree)
{
    const CodedConcept volume = schemeCode("SCT", "118565006", "Volume");
    if (inVoxels) {
        tree.number(item, volume, double(group.voxels), schemeCode("UCUM", "{voxels}", "voxels"));
        return;
    }
    tree.number(item, volume, group.volumeMl, schemeCode("UCUM", "cm3", "cubic centimeter"));
    tree.number(item, schemeCode("IBSI", "C0JK", "Surface Area of Mesh"), group.surfaceMm2,
        schemeCode("UCUM", "mm2", "square millimeter"));
    tree.number(item, schemeCode("IBSI", "QCFX", "Sphericity"), group.sphericity,
        schemeCode("UCUM", "1", "no units"));
    tree.number(item, schemeCode("IBSI", "L0JK", "Maximum 3D Diameter of a Mesh"), group.longestMm,
        schemeCode("UCUM", "mm", "millimeter"));
    tree.number(item, schemeCode("SCT", "103340004", "Short Axis"), group.acrossMm,
        schemeCode("UCUM", "mm", "millimeter"));
}

void putGroup(DcmItem* measurements, const SrContent& content, const SegFile& seg,
    std::size_t index, const QString& series, const SrTree& tree)
{
    const SrGroup& group = content.groups[index];
    DcmItem* item = tree.container(measurements, dicomCode("125007", "Measurement Group"));
    const QString name = singleValueText(group.segment.name, 64);
    tree.text(item, dicomCode("112039", "Tracking Identifier"),
        name.isEmpty() ? QStringLiteral("Segment") : name);
    tree.uid(item, "HAS OBS CONTEXT", dicomCode("112040", "Tracking Unique Identifier"), newUid());
    if (fitsCodeSequence(group.segment.code))
        tree.coded(item, "CONTAINS", dicomCode("121071", "Finding"), group.segment.code);
    tree.image(item, dicomCode("121191", "Referenced Segment"), "CONTAINS", UID_SegmentationStorage,
        seg.sopInstanceUid, int(index) + 1);
    tree.uid(item, "CONTAINS", dicomCode("121232", "Source series for segmentation"), series);
    putSizes(item, group, content.sizesInVoxels, tree);
    const CodedConcept quantity = quantityOf(content.unit, content.identity.modality);
    const auto value = [&](double number, const CodedConcept& derivation) {
        tree.derived(item, quantity, number, unitCode(content.unit), derivation);
    };
    value(group.mean, schemeCode("SCT", "373098007", "Mean"));
    value(group.deviation, schemeCode("SCT", "386136009", "Standard Deviation"));
    value(group.minimum, schemeCode("SCT", "255605001", "Minimum"));
    value(group.maximum, schemeCode("SCT", "56851009", "Maximum"));
    value(group.median, schemeCode("SCT", "373099004", "Median"));
    if (const auto& since = group.sinceImport) {
        if (!content.sizesInVoxels) {
            const CodedConcept cm3 = schemeCode("UCUM", "cm3", "cubic centimeter");
            tree.number(item, schemeCode("99BURIN", "IMPORT-ADDED", "Volume added since import"),
                since->addedMl, cm3);
            tree.number(item, schemeCode("99BURIN", "IMPORT-TAKEN", "Volume taken since import"),
                since->takenMl, cm3);
        }
        tree.number(item,
            schemeCode("99BURIN", "IMPORT-DICE", "Dice coefficient with the imported segment"),
            since->dice, schemeCode("UCUM", "1", "no units"));
    }
}

void putTree(DcmDataset& set, const SrContent& content, const SegFile& seg, const QString& series,
    const ItemWriter& items)
{
    const SrTree tree(items);
    items.put(&set, DCM_ValueType, "CONTAINER");
    items.putCode(
        &set, DCM_ConceptNameCodeSequence, dicomCode("126000", "Imaging Measurement Report"));
    items.put(&set, DCM_ContinuityOfContent, "SEPARATE");
    DcmItem* used = items.append(&set, DCM_ContentTemplateSequence);
    items.put(used, DCM_MappingResource, "DCMR");
    items.put(used, DCM_TemplateIdentifier, "1500");
    DcmItem* language = tree.coded(&set, "HAS CONCEPT MOD",
        dicomCode("121049", "Language of Content Item and Descendants"),
        schemeCode("RFC5646", "en", "English"));
    tree.coded(language, "HAS CONCEPT MOD", dicomCode("121046", "Country of Language"),
        schemeCode("ISO3166_1", "GB", "United Kingdom"));
    tree.coded(&set, "HAS OBS CONTEXT", dicomCode("121005", "Observer Type"),
        dicomCode("121007", "Device"));
    // What a program is has no UID of its own; this one names Burin, whichever its version.
    tree.uid(&set, "HAS OBS CONTEXT", dicomCode("121012", "Device Observer UID"),
        QStringLiteral("2.25.289176443096518024741958201837465102938"));
    tree.text(&set, dicomCode("121013", "Device Observer Name"), QStringLiteral("Burin"));
    tree.coded(&set, "HAS CONCEPT MOD", dicomCode("121058", "Procedure reported"),
        schemeCode("SCT", "363679005", "Imaging procedure"));
    DcmItem* library = tree.container(&set, dicomCode("111028", "Image Library"));
    static_cast<void>(library);
    DcmItem* measurements = tree.container(&set, dicomCode("126010", "Imaging Measurements"));
    for (std::size_t i = 0; i < content.groups.size(); ++i)
        putGroup(measurements, content, seg, i, series, tree);
    for (const Measured& measured : content.measured)
        putMeasured(measurements, measured,
            {.geometry = content.geometry,
                .frameOfReferenceUid = content.identity.frameOfReferenceUid,
                .series = series,
                .unit = content.unit,
                .modality = content.identity.modality},
            tree);
}

} // namespace

Result<ReportLines> writeSr(const QString& path, const SrContent& content, const Progress& progress)
{
    readyDcmtk();
    const auto source = readSegSource(content.sources, content.keptHeaders.get(), progress);
    if (!source)
        return tl::unexpected(source.error());
    auto seg = readSeg(content.seg);
    if (!seg)
        return tl::unexpected(seg.error());
    DcmFileFormat format;
    DcmDataset& set = *format.getDataset();
    ConditionChain chain;
    const ItemWriter items(chain);
    takePatientAndStudy(set, *source->header, chain);
    set.findAndDeleteElement(DCM_FrameOfReferenceUID);
    OFString study;
    set.findAndGetOFString(DCM_StudyInstanceUID, study);
    describe(set, content, items);
    putEvidence(set, *seg, *source, study, items);
    putTree(set, content, *seg, QString::fromStdString(source->slices.front().seriesUid), items);
    if (!chain.good())
        return failure(ErrorCode::Internal, chain.failure());
    if (content.deidentifier)
        content.deidentifier->apply(set, {seg->sopInstanceUid, seg->seriesUid});
    if (const Result<void> saved = saveDicom(format, path, UID_LittleEndianExplicitTransferSyntax);
        !saved)
        return tl::unexpected(saved.error());
    return source->notes;
}

} // namespace core
