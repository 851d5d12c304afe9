// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace ui {

/// The name that the user's steps bear in the audit trail; empty until somebody gives one.
[[nodiscard]] QString authorName();
void setAuthorName(const QString& name);

} // namespace ui
