// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace ui {

/// 18204 → "18 204", as the history's names have it.
[[nodiscard]] QString countText(qlonglong count);

} // namespace ui
