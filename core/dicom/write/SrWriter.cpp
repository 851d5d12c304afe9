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

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace core {

namespace {

CodedConcept code(const char* scheme, const char* value, const char* meaning)
{
    return {.scheme = QLatin1String(scheme),
        .value = QLatin1String(value),
        .meaning = QLatin1String(meaning)};
}

CodedConcept dcm(const char* value, const char* meaning)
{
    return code("DCM", value, meaning);
}

/// Builds the tree of content items.
class Tree {
public:
    explicit Tree(const ItemWriter& items)
        : m_items(items)
    {
    }

    DcmItem* container(DcmItem* parent, const CodedConcept& name) const
    {
        DcmItem* item = node(parent, "CONTAINS", "CONTAINER", name);
        m_items.put(item, DCM_ContinuityOfContent, "SEPARATE");
        return item;
    }
    DcmItem* coded(DcmItem* parent, const char* relation, const CodedConcept& name,
        const CodedConcept& value) const
    {
        DcmItem* item = node(parent, relation, "CODE", name);
        m_items.putCode(item, DCM_ConceptCodeSequence, value);
        return item;
    }
    void text(DcmItem* parent, const CodedConcept& name, const QString& value) const
    {
        m_items.put(node(parent, "HAS OBS CONTEXT", "TEXT", name), DCM_TextValue, value);
    }
    void uid(
        DcmItem* parent, const char* relation, const CodedConcept& name, const QString& value) const
    {
        m_items.put(node(parent, relation, "UIDREF", name), DCM_UID, value);
    }
    void image(DcmItem* parent, const CodedConcept& name, const char* relation,
        const std::string& sopClass, const QString& sopInstance, int segment) const
    {
        DcmItem* reference =
            m_items.append(node(parent, relation, "IMAGE", name), DCM_ReferencedSOPSequence);
        m_items.put(reference, DCM_ReferencedSOPClassUID, sopClass);
        m_items.put(reference, DCM_ReferencedSOPInstanceUID, sopInstance);
        if (segment > 0)
            m_items.putWord(reference, DCM_ReferencedSegmentNumber, segment);
    }
    DcmItem* number(
        DcmItem* parent, const CodedConcept& name, double value, const CodedConcept& unit) const
    {
        DcmItem* item = node(parent, "CONTAINS", "NUM", name);
        DcmItem* measured = m_items.append(item, DCM_MeasuredValueSequence);
        m_items.put(measured, DCM_NumericValue, decimalString(value));
        m_items.putCode(measured, DCM_MeasurementUnitsCodeSequence, unit);
        return item;
    }

private:
    DcmItem* node(
        DcmItem* parent, const char* relation, const char* type, const CodedConcept& name) const
    {
        DcmItem* item = m_items.append(parent, DCM_ContentSequence);
        m_items.put(item, DCM_RelationshipType, relation);
        m_items.put(item, DCM_ValueType, type);
        m_items.putCode(item, DCM_ConceptNameCodeSequence, name);
        return item;
    }

    const ItemWriter& m_items;
};

/// UCUM of the values' unit; where the source does not say, that there is none.
CodedConcept unitCode(const QString& unit)
{
    if (unit == QLatin1String("HU"))
        return code("UCUM", "[hnsf'U]", "Hounsfield unit");
    if (unit.startsWith(QLatin1String("SUV")) || unit == QLatin1String("g/mL"))
        return code("UCUM", "g/ml{SUVbw}", "Standardized Uptake Value body weight");
    if (unit == QLatin1String("Bq/mL") || unit == QLatin1String("BQML"))
        return code("UCUM", "Bq/ml", "Becquerels/milliliter");
    return code("UCUM", "1", "no units");
}

/// What the values are of.
CodedConcept quantityOf(const SrContent& content)
{
    if (content.unit == QLatin1String("HU"))
        return dcm("112031", "Attenuation Coefficient");
    if (content.unit.startsWith(QLatin1String("SUV")))
        return dcm("126400", "Standardized Uptake Value");
    if (content.identity.modality == QLatin1String("MR"))
        return dcm("110852", "MR signal intensity");
    return code("99BURIN", "VALUE", "Value of the source images");
}

void describe(DcmDataset& set, const SrContent& content, const ItemWriter& items)
{
    describeMadeContent(&set,
        {.sopClassUid = UID_EnhancedSRStorage,
            .modality = "SR",
            .seriesNumber = madeSeriesNumber(4000, content.identity),
            .seriesDescription =
                QStringLiteral("Measurements ") + content.identity.seriesDescription},
        items);
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

void putGroup(DcmItem* measurements, const SrContent& content, const SegFile& seg,
    std::size_t index, const QString& series, const Tree& tree)
{
    const SrGroup& group = content.groups[index];
    DcmItem* item = tree.container(measurements, dcm("125007", "Measurement Group"));
    const QString name = singleValueText(group.segment.name, 64);
    tree.text(item, dcm("112039", "Tracking Identifier"),
        name.isEmpty() ? QStringLiteral("Segment") : name);
    tree.uid(item, "HAS OBS CONTEXT", dcm("112040", "Tracking Unique Identifier"), newUid());
    if (fitsCodeSequence(group.segment.code))
        tree.coded(item, "CONTAINS", dcm("121071", "Finding"), group.segment.code);
    tree.image(item, dcm("121191", "Referenced Segment"), "CONTAINS", UID_SegmentationStorage,
        seg.sopInstanceUid, int(index) + 1);
    tree.uid(item, "CONTAINS", dcm("121232", "Source series for segmentation"), series);
    tree.number(item, code("SCT", "118565006", "Volume"), group.volumeMl,
        code("UCUM", "cm3", "cubic centimeter"));
    tree.number(item, code("IBSI", "C0JK", "Surface Area of Mesh"), group.surfaceMm2,
        code("UCUM", "mm2", "square millimeter"));
    tree.number(
        item, code("IBSI", "QCFX", "Sphericity"), group.sphericity, code("UCUM", "1", "no units"));
    tree.number(item, code("IBSI", "L0JK", "Maximum 3D Diameter of a Mesh"), group.longestMm,
        code("UCUM", "mm", "millimeter"));
    const auto value = [&](double number, const CodedConcept& derivation) {
        DcmItem* measured = tree.number(item, quantityOf(content), number, unitCode(content.unit));
        tree.coded(measured, "HAS CONCEPT MOD", dcm("121401", "Derivation"), derivation);
    };
    value(group.mean, code("SCT", "373098007", "Mean"));
    value(group.deviation, code("SCT", "386136009", "Standard Deviation"));
    value(group.minimum, code("SCT", "255605001", "Minimum"));
    value(group.maximum, code("SCT", "56851009", "Maximum"));
    value(group.median, code("SCT", "373099004", "Median"));
    if (const auto& since = group.sinceImport) {
        const CodedConcept cm3 = code("UCUM", "cm3", "cubic centimeter");
        tree.number(item, code("99BURIN", "IMPORT-ADDED", "Volume added since import"),
            since->addedMl, cm3);
        tree.number(item, code("99BURIN", "IMPORT-TAKEN", "Volume taken since import"),
            since->takenMl, cm3);
        tree.number(item,
            code("99BURIN", "IMPORT-DICE", "Dice coefficient with the imported segment"),
            since->dice, code("UCUM", "1", "no units"));
    }
}

void putTree(DcmDataset& set, const SrContent& content, const SegFile& seg, const QString& series,
    const ItemWriter& items)
{
    const Tree tree(items);
    items.put(&set, DCM_ValueType, "CONTAINER");
    items.putCode(&set, DCM_ConceptNameCodeSequence, dcm("126000", "Imaging Measurement Report"));
    items.put(&set, DCM_ContinuityOfContent, "SEPARATE");
    DcmItem* used = items.append(&set, DCM_ContentTemplateSequence);
    items.put(used, DCM_MappingResource, "DCMR");
    items.put(used, DCM_TemplateIdentifier, "1500");
    DcmItem* language = tree.coded(&set, "HAS CONCEPT MOD",
        dcm("121049", "Language of Content Item and Descendants"),
        code("RFC5646", "en", "English"));
    tree.coded(language, "HAS CONCEPT MOD", dcm("121046", "Country of Language"),
        code("ISO3166_1", "GB", "United Kingdom"));
    tree.coded(&set, "HAS OBS CONTEXT", dcm("121005", "Observer Type"), dcm("121007", "Device"));
    // What a program is has no UID of its own; this one names Burin, whichever its version.
    tree.uid(&set, "HAS OBS CONTEXT", dcm("121012", "Device Observer UID"),
        QStringLiteral("2.25.289176443096518024741958201837465102938"));
    tree.text(&set, dcm("121013", "Device Observer Name"), QStringLiteral("Burin"));
    tree.coded(&set, "HAS CONCEPT MOD", dcm("121058", "Procedure reported"),
        code("SCT", "363679005", "Imaging procedure"));
    DcmItem* library = tree.container(&set, dcm("111028", "Image Library"));
    static_cast<void>(library);
    DcmItem* measurements = tree.container(&set, dcm("126010", "Imaging Measurements"));
    for (std::size_t i = 0; i < content.groups.size(); ++i)
        putGroup(measurements, content, seg, i, series, tree);
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
