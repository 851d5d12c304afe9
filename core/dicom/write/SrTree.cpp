// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/write/SrTree.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace core {

CodedConcept schemeCode(const char* scheme, const char* value, const char* meaning)
{
    return {.scheme = QLatin1String(scheme),
        .value = QLatin1String(value),
        .meaning = QLatin1String(meaning)};
}

CodedConcept dicomCode(const char* value, const char* meaning)
{
    return schemeCode("DCM", value, meaning);
}

namespace {

/// A unit that UCUM does not know, as it may stand between braces; a code has 16 characters.
QString annotation(const QString& unit)
{
    constexpr qsizetype most = 14;
    QString text;
    for (const QChar c : unit) {
        const bool isAllowed =
            c > u' ' && c <= u'~' && c != u'{' && c != u'}' && c != u'\\' && text.size() < most;
        if (isAllowed)
            text += c;
    }
    return text;
}

} // namespace

CodedConcept unitCode(const QString& unit)
{
    if (unit == QLatin1String("HU"))
        return schemeCode("UCUM", "[hnsf'U]", "Hounsfield unit");
    if (unit == QLatin1String("SUVbw"))
        return schemeCode("UCUM", "g/ml{SUVbw}", "Standardized Uptake Value body weight");
    if (unit == QLatin1String("SUVlbm"))
        return schemeCode("UCUM", "g/ml{SUVlbm}", "Standardized Uptake Value lean body mass");
    if (unit == QLatin1String("SUVibw"))
        return schemeCode("UCUM", "g/ml{SUVibw}", "Standardized Uptake Value ideal body weight");
    if (unit == QLatin1String("SUVbsa"))
        return schemeCode("UCUM", "cm2/ml{SUVbsa}", "Standardized Uptake Value body surface area");
    if (unit == QLatin1String("g/mL"))
        return schemeCode("UCUM", "g/ml", "gram per milliliter");
    if (unit == QLatin1String("Bq/mL") || unit == QLatin1String("BQML"))
        return schemeCode("UCUM", "Bq/ml", "Becquerels/milliliter");
    const QString note = annotation(unit);
    if (note.isEmpty() || unit == QLatin1String("NONE"))
        return schemeCode("UCUM", "1", "no units");
    return {.scheme = QStringLiteral("UCUM"),
        .value = QStringLiteral("{%1}").arg(note),
        .meaning = note};
}

CodedConcept quantityOf(const QString& unit, const QString& modality)
{
    if (unit == QLatin1String("HU"))
        return dicomCode("112031", "Attenuation Coefficient");
    if (unit == QLatin1String("SUVbw"))
        return dicomCode("126401", "SUVbw");
    if (unit == QLatin1String("SUVlbm"))
        return dicomCode("126402", "SUVlbm");
    if (unit == QLatin1String("SUVbsa"))
        return dicomCode("126403", "SUVbsa");
    if (unit == QLatin1String("SUVibw"))
        return dicomCode("126404", "SUVibw");
    if (unit == QLatin1String("g/mL") && modality == QLatin1String("PT"))
        return dicomCode("126400", "Standardized Uptake Value");
    if (modality == QLatin1String("MR"))
        return dicomCode("110852", "MR signal intensity");
    return schemeCode("99BURIN", "VALUE", "Value of the source images");
}

DcmItem* SrTree::container(DcmItem* parent, const CodedConcept& name) const
{
    DcmItem* item = node(parent, "CONTAINS", "CONTAINER", name);
    m_items.put(item, DCM_ContinuityOfContent, "SEPARATE");
    return item;
}

DcmItem* SrTree::coded(DcmItem* parent, const char* relation, const CodedConcept& name,
    const CodedConcept& value) const
{
    DcmItem* item = node(parent, relation, "CODE", name);
    m_items.putCode(item, DCM_ConceptCodeSequence, value);
    return item;
}

void SrTree::text(DcmItem* parent, const CodedConcept& name, const QString& value) const
{
    m_items.put(node(parent, "HAS OBS CONTEXT", "TEXT", name), DCM_TextValue, value);
}

void SrTree::uid(
    DcmItem* parent, const char* relation, const CodedConcept& name, const QString& value) const
{
    m_items.put(node(parent, relation, "UIDREF", name), DCM_UID, value);
}

void SrTree::image(DcmItem* parent, const CodedConcept& name, const char* relation,
    const std::string& sopClass, const QString& sopInstance, int segment) const
{
    DcmItem* reference =
        m_items.append(node(parent, relation, "IMAGE", name), DCM_ReferencedSOPSequence);
    m_items.put(reference, DCM_ReferencedSOPClassUID, sopClass);
    m_items.put(reference, DCM_ReferencedSOPInstanceUID, sopInstance);
    if (segment > 0)
        m_items.putWord(reference, DCM_ReferencedSegmentNumber, segment);
}

DcmItem* SrTree::number(
    DcmItem* parent, const CodedConcept& name, double value, const CodedConcept& unit) const
{
    DcmItem* item = node(parent, "CONTAINS", "NUM", name);
    DcmItem* measured = m_items.append(item, DCM_MeasuredValueSequence);
    m_items.put(measured, DCM_NumericValue, decimalString(value));
    m_items.putCode(measured, DCM_MeasurementUnitsCodeSequence, unit);
    return item;
}

void SrTree::derived(DcmItem* parent, const CodedConcept& quantity, double value,
    const CodedConcept& unit, const CodedConcept& derivation) const
{
    coded(number(parent, quantity, value, unit), "HAS CONCEPT MOD",
        dicomCode("121401", "Derivation"), derivation);
}

void SrTree::places(DcmItem* parent, const char* relation, const CodedConcept& name,
    const char* type, const std::vector<glm::dvec3>& placesLps,
    const QString& frameOfReferenceUid) const
{
    DcmItem* item = node(parent, relation, "SCOORD3D", name);
    m_items.put(item, DCM_GraphicType, type);
    m_items.putFloats(item, DCM_GraphicData, placesLps);
    m_items.put(item, DCM_ReferencedFrameOfReferenceUID, frameOfReferenceUid);
}

DcmItem* SrTree::node(
    DcmItem* parent, const char* relation, const char* type, const CodedConcept& name) const
{
    DcmItem* item = m_items.append(parent, DCM_ContentSequence);
    m_items.put(item, DCM_RelationshipType, relation);
    m_items.put(item, DCM_ValueType, type);
    m_items.putCode(item, DCM_ConceptNameCodeSequence, name);
    return item;
}

} // namespace core
