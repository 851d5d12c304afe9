// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/items/ConditionChain.h"
#include "core/dicom/source/ItemWriter.h"
#include "core/volume/Volume.h"

class DcmDataset;

namespace core {

/// The kind and series of an object that Burin makes.
struct MadeObject {
    const char* sopClassUid = nullptr;
    const char* modality = nullptr;
    int seriesNumber = 0;
    QString seriesDescription; ///< shortened to what DICOM allows
};

/// The time of creation in DICOM's form.
struct MadeAt {
    QString date;
    QString time;
};

/// The number of a series that is derived from another one: close to it in a list, and not used by
/// scanners.
/// @param from 1000 for SEG, 3000 for RTSTRUCT …
[[nodiscard]] int madeSeriesNumber(int from, const StudyIdentity& source);

/// An object whose series is numbered and described after the series from which it was made.
/// @param from as for madeSeriesNumber()
/// @param what the kind of the series, placed before the source's description: "Contours"
[[nodiscard]] MadeObject madeOf(const StudyIdentity& source, const char* sopClassUid,
    const char* modality, int from, const QString& what);

/// Writes the attributes with which all such objects begin: a new instance, the only one of a new
/// series, made now by this program (PS3.3 C.12.1, C.7.3.1, C.7.5.1).
MadeAt describeMadeObject(DcmItem* item, const MadeObject& object, const ItemWriter& items);
/// The same for an object that also states when its series and content were made.
void describeMadeContent(DcmItem* item, const MadeObject& object, const ItemWriter& items);

/// Copies what cleanPatientHeader() kept of a source, and adds what every object must have.
void takePatientAndStudy(DcmDataset& set, DcmDataset& header, ConditionChain& chain);

} // namespace core
