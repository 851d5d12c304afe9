// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/edits/kinds/Edit.h"

#include <QJsonObject>
#include <QJsonValue>

namespace core {

// The JSON form of edits, which recipes and session files contain. core/edits/schema defines the
// fields of each edit; `burin edits` prints them.

[[nodiscard]] QJsonObject editToJson(const Edit& edit);

/// Reads and checks an edit. Numbers are not rounded (EditQuantise.h). Errors: UnknownEdit;
/// InvalidField, which names edit and field ("drill.mask.radiusMm"), for fields that are missing,
/// unknown, of another type or out of range.
[[nodiscard]] Result<Edit> editFromJson(const QJsonValue& json);

/// Checks the same ranges for an edit that a tool has made. Errors: InvalidField.
[[nodiscard]] Result<void> checkFields(const Edit& edit);
/// The same for a stroke that is about to begin and may have no samples yet.
[[nodiscard]] Result<void> checkFieldsAtBegin(const Edit& edit);

/// The name of an edit in JSON, e.g. "grow".
[[nodiscard]] QString editName(const Edit& edit);

} // namespace core
