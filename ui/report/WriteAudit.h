// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/sessionfile/AuditReport.h"

#include <QString>

namespace ui {

/// Why a report cannot have this name; empty if it can: it ends in .html, .htm or .pdf.
[[nodiscard]] QString auditNameProblem(const QString& path);

/// Writes the report; the file is there once it is whole. Fonts are needed for .pdf, no window; any
/// thread. Errors: FileExists (unless @p replaceExisting), FileUnwritable.
[[nodiscard]] core::Result<void> writeAudit(
    const core::AuditReport& report, const QString& path, bool replaceExisting);

} // namespace ui
