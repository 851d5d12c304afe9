// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/source/ItemWriter.h"
#include "core/document/Document.h"

#include <QString>

#include <glm/glm.hpp>

#include <string>
#include <vector>

class DcmItem;

namespace core {

[[nodiscard]] CodedConcept schemeCode(const char* scheme, const char* value, const char* meaning);
/// One of DICOM's own (PS3.16 annex D).
[[nodiscard]] CodedConcept dicomCode(const char* value, const char* meaning);
/// UCUM of the values' unit; where the source does not say, that there is none.
[[nodiscard]] CodedConcept unitCode(const QString& unit);
/// What the values are of.
[[nodiscard]] CodedConcept quantityOf(const QString& unit, const QString& modality);

/// Builds the tree of content items of a structured report. Only for sources of core/dicom.
class SrTree {
public:
    explicit SrTree(const ItemWriter& items)
        : m_items(items)
    {
    }

    DcmItem* container(DcmItem* parent, const CodedConcept& name) const;
    DcmItem* coded(DcmItem* parent, const char* relation, const CodedConcept& name,
        const CodedConcept& value) const;
    void text(DcmItem* parent, const CodedConcept& name, const QString& value) const;
    void uid(DcmItem* parent, const char* relation, const CodedConcept& name,
        const QString& value) const;
    /// @param segment 0: the whole object
    void image(DcmItem* parent, const CodedConcept& name, const char* relation,
        const std::string& sopClass, const QString& sopInstance, int segment) const;
    DcmItem* number(
        DcmItem* parent, const CodedConcept& name, double value, const CodedConcept& unit) const;
    /// A value of the source with how it was derived: mean, maximum …
    void derived(DcmItem* parent, const CodedConcept& quantity, double value,
        const CodedConcept& unit, const CodedConcept& derivation) const;
    /// Places of the patient, LPS mm. @param type POINT, POLYLINE, POLYGON, ELLIPSE, ELLIPSOID
    void places(DcmItem* parent, const char* relation, const CodedConcept& name, const char* type,
        const std::vector<glm::dvec3>& placesLps, const QString& frameOfReferenceUid) const;

private:
    DcmItem* node(
        DcmItem* parent, const char* relation, const char* type, const CodedConcept& name) const;

    const ItemWriter& m_items;
};

} // namespace core
