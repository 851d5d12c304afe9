// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/export/common/ExportChoices.h"

#include <QString>

namespace ui {

/// "growth not finished": a clause beside the segment.
[[nodiscard]] QString exportRemarkText(core::ExportRemark remark);

} // namespace ui
