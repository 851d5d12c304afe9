// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/batch/StudyJob.h"

#include <vector>

namespace app {

/// The table of a batch's results, from the records on disk: a line for each study, with a column
/// for each number about a segment that a recipe exports as CSV statistics ("Bone volumeMl").
/// @return CSV as in RFC 4180
[[nodiscard]] QByteArray resultsTable(const std::vector<StudyTask>& tasks);

} // namespace app
