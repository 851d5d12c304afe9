// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace core {

/// A name in a form that fits into one line of a file; never empty.
[[nodiscard]] QString oneLine(const QString& name);

} // namespace core
