// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/document/Document.h"
#include "core/history/History.h"

#include <optional>

namespace core {

struct GrowCriteria;

/// The criteria of the last growth that stands, changes of its interval included; none: nothing has
/// grown.
[[nodiscard]] std::optional<GrowCriteria> recentCriteria(const History& history);

/// Whether later growths, which go on as the last one, would go on otherwise after this one, even
/// if it changes no voxel: its criteria are others, and seeds were sketched that may come in yet.
[[nodiscard]] bool bringsNewCriteria(const Edit& edit, const History& history);

/// Writes into a growth what it would else read in the history, so that it names all that decides
/// it: ResumeGrowth becomes the GrowSteps that it is, ChangeInterval gets all its criteria and says
/// whether it begins at the seeds. Other edits stay. Errors: InvalidField (nothing has grown).
[[nodiscard]] Result<void> nameWhatGrowthReads(
    Edit& edit, const History& history, const Document& document);

} // namespace core
