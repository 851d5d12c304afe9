// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sources/PacsSource.h"

#include <vector>

namespace ui {

/// The user's named sources of studies, in the user's order; a setting. Passwords and tokens are
/// not stored: those that were typed are known only while the program runs.
[[nodiscard]] std::vector<core::PacsSource> pacsSources();
void setPacsSources(const std::vector<core::PacsSource>& sources);

} // namespace ui
