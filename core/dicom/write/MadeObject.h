// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/dicom/items/ConditionChain.h"
#include "core/dicom/source/ItemWriter.h"
#include "core/volume/Volume.h"

class DcmDataset;

namespace core {

/// What an object is that Burin makes, and of which series.
struct MadeObject {
    const char* sopClassUid = nullptr;
    const char* modality = nullptr;
    int seriesNumber = 0;
    QString seriesDescription; ///< cut to what DICOM holds
};

/// When it was made, as DICOM writes it.
struct MadeAt {
    QString date;
    QString time;
};

/// The number of a series made from another one: beside it in a list, and of no scanner's own.
/// @param from 1000 for SEG, 3000 for RTSTRUCT …
[[nodiscard]] int madeSeriesNumber(int from, const StudyIdentity& source);

/// The attributes that all of them begin with: a new instance, the only one of a new series, made
/// now, by this program (PS3.3 C.12.1, C.7.3.1, C.7.5.1).
MadeAt describeMadeObject(DcmItem* item, const MadeObject& object, const ItemWriter& items);
/// The same of one that says when its series and its content were made, too.
void describeMadeContent(DcmItem* item, const MadeObject& object, const ItemWriter& items);

/// Copies what cleanPatientHeader() left of a source, and what every object must have besides.
void takePatientAndStudy(DcmDataset& set, DcmDataset& header, ConditionChain& chain);

} // namespace core
