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
/// A code of DICOM's own terminology, scheme DCM (PS3.16 annex D).
[[nodiscard]] CodedConcept dicomCode(const char* value, const char* meaning);
/// The UCUM code for the unit of the voxel values. Known are the units that DicomScan reports and
/// the terms that PET uses; of the latter, counts and the like have no UCUM unit and get an
/// annotation ("{counts}"). Any other unit becomes an annotation, with its words as meaning; "no
/// units" if there is none.
[[nodiscard]] CodedConcept unitCode(const QString& unit);
/// The code for the quantity that the voxel values measure, such as attenuation, standardised
/// uptake or MR signal intensity.
[[nodiscard]] CodedConcept quantityOf(const QString& unit, const QString& modality);

/// Builds the tree of content items of a structured report (PS3.3 C.17.3). Each function adds one
/// item below @p parent; those that return an item allow for items below it. Only for sources of
/// core/dicom.
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
    /// @param segment number of the referenced segment; 0: the whole object
    void image(DcmItem* parent, const CodedConcept& name, const char* relation,
        const std::string& sopClass, const QString& sopInstance, int segment) const;
    DcmItem* number(
        DcmItem* parent, const CodedConcept& name, double value, const CodedConcept& unit) const;
    /// A number with the way in which it was derived from the voxel values: mean, maximum …
    void derived(DcmItem* parent, const CodedConcept& quantity, double value,
        const CodedConcept& unit, const CodedConcept& derivation) const;
    /// Positions in the patient (SCOORD3D), LPS mm.
    /// @param type POINT, POLYLINE, POLYGON, ELLIPSE, ELLIPSOID
    void places(DcmItem* parent, const char* relation, const CodedConcept& name, const char* type,
        const std::vector<glm::dvec3>& placesLps, const QString& frameOfReferenceUid) const;

private:
    DcmItem* node(
        DcmItem* parent, const char* relation, const char* type, const CodedConcept& name) const;

    const ItemWriter& m_items;
};

} // namespace core
