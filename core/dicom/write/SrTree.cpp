// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/write/SrTree.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <iterator>

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

/// A unit as volumes name it, and its code in UCUM.
struct NamedUnit {
    const char* name;
    const char* code;
    const char* meaning;
};

constexpr NamedUnit namedUnits[] = {
    {"HU", "[hnsf'U]", "Hounsfield unit"},
    {"SUVbw", "g/ml{SUVbw}", "Standardized Uptake Value body weight"},
    {"SUVlbm", "g/ml{SUVlbm}", "Standardized Uptake Value lean body mass"},
    {"SUVibw", "g/ml{SUVibw}", "Standardized Uptake Value ideal body weight"},
    {"SUVbsa", "cm2/ml{SUVbsa}", "Standardized Uptake Value body surface area"},
    {"g/mL", "g/ml", "gram per milliliter"},
    {"Bq/mL", "Bq/ml", "Becquerels/milliliter"},
    // The defined terms of Units (0054,1001), PS3.3 C.8.9.1.1.3, as context group 84 codes them.
    {"CNTS", "{counts}", "Counts"},
    {"NONE", "1", "no units"},
    {"CM2", "cm2", "Centimeter**2"},
    {"CM2ML", "cm2/ml", "Centimeter**2/milliliter"},
    {"PCNT", "%", "Percent"},
    {"CPS", "{counts}/s", "Counts per second"},
    {"BQML", "Bq/ml", "Becquerels/milliliter"},
    {"MGMINML", "mg/min/ml", "Milligrams/minute/milliliter"},
    {"UMOLMINML", "umol/min/ml", "Micromole/minute/milliliter"},
    {"MLMING", "ml/min/g", "Milliliter/minute/gram"},
    {"MLG", "ml/g", "Milliliter/gram"},
    {"1CM", "/cm", "/Centimeter"},
    {"UMOLML", "umol/ml", "Micromole/milliliter"},
    {"PROPCNTS", "{propcounts}", "Proportional to counts"},
    {"PROPCPS", "{propcounts}/s", "Proportional to counts per second"},
    {"MLMINML", "ml/min/ml", "Milliliter/minute/milliliter"},
    {"MLML", "ml/ml", "Milliliter/milliliter"},
    {"GML", "g/ml", "gram per milliliter"},
    {"STDDEV", "{stddev}", "Standard deviations"},
};

/// A unit that is no term, as it may stand between braces in UCUM; a code has 16 characters.
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

/// A unit in its own words, as far as one value may hold them.
QString meaningOf(QString unit)
{
    constexpr qsizetype most = 64;
    unit.removeIf([](QChar c) { return c == u'\\' || c.category() == QChar::Other_Control; });
    return unit.trimmed().left(most);
}

} // namespace

CodedConcept unitCode(const QString& unit)
{
    const auto* const found = std::find_if(std::begin(namedUnits), std::end(namedUnits),
        [&unit](const NamedUnit& one) { return unit == QLatin1String(one.name); });
    if (found != std::end(namedUnits))
        return schemeCode("UCUM", found->code, found->meaning);
    const QString note = annotation(unit);
    if (note.isEmpty())
        return schemeCode("UCUM", "1", "no units");
    return {.scheme = QStringLiteral("UCUM"),
        .value = QStringLiteral("{%1}").arg(note),
        .meaning = meaningOf(unit)};
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
