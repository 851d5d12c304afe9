// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sources/PacsSource.h"

#include <vector>

namespace ui {

/// The user's named sources of studies, in his order; a setting. Passwords and tokens are none:
/// those that were typed are known while the program runs.
[[nodiscard]] std::vector<core::PacsSource> pacsSources();
void setPacsSources(const std::vector<core::PacsSource>& sources);

} // namespace ui
