// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"
#include "core/edits/kinds/Edit.h"

#include <QJsonObject>
#include <QJsonValue>

namespace core {

// The JSON form of edits: what recipes and session files hold. The fields of each edit stand in
// schema/ and nowhere else; `burin edits` prints them.

[[nodiscard]] QJsonObject editToJson(const Edit& edit);

/// Reads and checks an edit; numbers are not rounded (EditQuantise.h).
/// Errors: UnknownEdit; InvalidField, which names edit and field ("drill.mask.radiusMm"), for
/// fields that are missing, unknown, of another type or out of range.
[[nodiscard]] Result<Edit> editFromJson(const QJsonValue& json);

/// The ranges of editFromJson(), for edits made by tools. Errors: InvalidField.
[[nodiscard]] Result<void> checkFields(const Edit& edit);
/// The same for a stroke that is about to begin: it may have no samples yet.
[[nodiscard]] Result<void> checkFieldsAtBegin(const Edit& edit);

/// The word that stands for an edit in JSON, e.g. "grow".
[[nodiscard]] QString editName(const Edit& edit);

} // namespace core
