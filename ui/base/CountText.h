// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace ui {

/// A count with its digits in groups of three, as in the names of the history: 18204 → "18 204".
[[nodiscard]] QString countText(qlonglong count);

} // namespace ui
