// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace core {
struct SessionContents;
}

namespace app {

// What commands do about a damaged session: they give what is sound of what was asked for, name the
// rest in one sentence on stderr, and end with 0 if nothing that was asked for is lost, else
// with 1.

/// Tells, where there is anything to tell, what core::checkSession() found damaged.
void tellProblems(const QString& file, const core::SessionContents& contents);

} // namespace app
