// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"
#include "core/titles/RowTitle.h"

#include <QString>

namespace ui {

/// The title of a row of the history in the window's language; untranslated it is what
/// core::canonicalName() gives, except where a name contains "%1" and the segment or layer is
/// moved.
[[nodiscard]] QString textOf(const core::RowTitle& title);

/// The title of a row in the window's language, or its stored name if it has no title.
[[nodiscard]] QString nameOf(const core::HistoryRow& row);

} // namespace ui
