// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/Result.h"

#include <QJsonObject>

namespace core {

/// Reads the JSON object of a recipe's file, without checking its contents. Blocks; any thread.
/// Errors: FileNotFound, FileUnreadable (also if it is not a regular file but a pipe or device),
/// InvalidRecipe (not JSON: with the line; no object; a key that occurs twice in one object).
[[nodiscard]] Result<QJsonObject> readRecipeJson(const QString& path);

} // namespace core
