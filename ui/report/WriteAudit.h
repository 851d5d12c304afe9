// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/sessionfile/AuditReport.h"

#include <QString>

namespace ui {

struct AuditSegments;

/// Why a report cannot have this file name; empty if it can. It must end in .html, .htm or .pdf.
[[nodiscard]] QString auditNameProblem(const QString& path);

/// Writes the report; the file appears only when it is complete. For .pdf fonts are needed, but no
/// window; any thread. Errors: FileExists (unless @p replaceExisting), FileUnwritable.
/// @param segments null: the report says nothing of them
[[nodiscard]] core::Result<void> writeAudit(const core::AuditReport& report, const QString& path,
    bool replaceExisting, const AuditSegments* segments = nullptr);

} // namespace ui
