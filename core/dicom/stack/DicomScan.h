// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/dicom/stack/SliceStack.h"

#include <QStringList>

#include <vector>

namespace core {

/// A stack with its entry in the list of series.
struct ListedStack {
    SeriesEntry entry; ///< without a key
    QString seriesKey; ///< SeriesInstanceUID, or a name made from the header
    QString studyKey; ///< StudyInstanceUID, or a name made from the header
    SliceStack stack{};
};

/// What a set of DICOM files contains.
struct DicomScan {
    std::vector<ListedStack> stacks;
    std::vector<ForeignObject> foreign;
    std::vector<UnreadableFile> unreadable;
};

/// Reads the headers of @p files on all cores and sorts their images into stacks. Incomplete if @p
/// progress is cancelled.
[[nodiscard]] DicomScan scanDicom(const QStringList& files, const Progress& progress);

} // namespace core
