// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/dicom/stack/SliceStack.h"

#include <QStringList>

#include <vector>

namespace core {

/// A stack and how it is listed.
struct ListedStack {
    SeriesEntry entry; ///< without a key
    QString seriesKey; ///< SeriesInstanceUID, or a name made from the header
    QString studyKey; ///< StudyInstanceUID, or a name made from the header
    SliceStack stack{};
};

struct DicomScan {
    std::vector<ListedStack> stacks;
    std::vector<ForeignObject> foreign;
    std::vector<UnreadableFile> unreadable;
};

/// Reads the headers of @p files on all cores and sorts what they hold.
/// Stopped early, incomplete, if @p progress is cancelled.
[[nodiscard]] DicomScan scanDicom(const QStringList& files, const Progress& progress);

} // namespace core
