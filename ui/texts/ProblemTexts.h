// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/ProblemSentence.h"

#include <QString>

namespace ui {

/// What is said of a problem of a volume. A text that was read from a session file stays in the
/// English in which it is kept there.
[[nodiscard]] QString problemText(const core::ProblemSentence& sentence);

} // namespace ui
