// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/history/History.h"
#include "core/titles/RowTitle.h"

#include <QString>

namespace ui {

/// What a row of the history says, in the window's language; untranslated it is what
/// core::canonicalName() gives, except where a name contains "%1" and the segment or layer is
/// moved.
[[nodiscard]] QString textOf(const core::RowTitle& title);

/// What a row says; the name that is stored of it where it has no title.
[[nodiscard]] QString nameOf(const core::HistoryRow& row);

} // namespace ui
