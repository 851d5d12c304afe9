// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/report/AuditTexts.h"

namespace ui {

/// The report as one page of HTML that needs no other file; printed, it keeps rows whole.
[[nodiscard]] QString auditHtml(const AuditTexts& texts);

} // namespace ui
