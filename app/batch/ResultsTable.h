// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/batch/StudyJob.h"

#include <vector>

namespace app {

/// Returns the table of a batch's results from the records on disk, as CSV (RFC 4180). It has a
/// line for each study, and a column for each number about a segment that a recipe has exported as
/// CSV statistics ("Bone volumeMl"); segments that share a name are told apart by their label
/// ("Bone (2) volumeMl"). "attempts" counts those of earlier batches, too, since the study was last
/// done. Results that differ from what the task asks for (whyOther()) have the state "other", the
/// reason as failure, and no numbers.
[[nodiscard]] QByteArray resultsTable(const std::vector<StudyTask>& tasks);

/// Whether a file, of which this is the beginning, can be such a table.
[[nodiscard]] bool isResultsTable(const QByteArray& text);

} // namespace app
