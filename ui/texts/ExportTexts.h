// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/ExportChoices.h"

#include <QString>

namespace ui {

/// Returns a remark that stands beside a segment in the export dialog: "growth not finished".
[[nodiscard]] QString exportRemarkText(core::ExportRemark remark);

} // namespace ui
