// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace ui {

/// The name under which the user's steps stand in the audit trail (a setting); empty until it is
/// set.
[[nodiscard]] QString authorName();
void setAuthorName(const QString& name);

} // namespace ui
