// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/report/AuditTexts.h"

namespace ui {

/// The audit report as one self-contained HTML page; when it is printed rows are not broken.
[[nodiscard]] QString auditHtml(const AuditTexts& texts);

} // namespace ui
