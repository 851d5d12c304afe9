// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QJsonObject>

namespace core {

/// The object that a recipe's file holds; what it says is not looked at. Any thread. Errors:
/// FileNotFound, FileUnreadable (also what is no file: a pipe, a device), InvalidRecipe (not JSON:
/// the line; no object; a key that stands twice in one object).
[[nodiscard]] Result<QJsonObject> readRecipeJson(const QString& path);

} // namespace core
