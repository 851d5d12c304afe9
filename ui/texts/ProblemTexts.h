// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/ProblemSentence.h"

#include <QString>

namespace ui {

/// Returns a problem of a volume in the user's language. A text that was read from a session file
/// stays in the English in which the file stores it.
[[nodiscard]] QString problemText(const core::ProblemSentence& sentence);

} // namespace ui
