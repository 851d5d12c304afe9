// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/ExportFormats.h"

#include <QString>

namespace ui {

/// Returns the name of a format for lists and reports: "STL surface".
[[nodiscard]] QString exportFormatTitle(core::ExportFormat format);

/// Returns a sentence on what a file of the format holds.
[[nodiscard]] QString exportFormatSays(core::ExportFormat format);

} // namespace ui
