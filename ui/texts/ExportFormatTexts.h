// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/ExportFormats.h"

#include <QString>

namespace ui {

/// "STL surface": the name of a format in a list and in reports.
[[nodiscard]] QString exportFormatTitle(core::ExportFormat format);

/// What a file of the format holds, in one sentence.
[[nodiscard]] QString exportFormatSays(core::ExportFormat format);

} // namespace ui
