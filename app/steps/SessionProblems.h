// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

namespace core {
struct SessionContents;
}

namespace app {

// How commands treat a damaged session: they deliver the sound part of what was requested, name the
// rest in one sentence on stderr, and end with 0 if nothing that was requested is lost, else with
// 1.

/// Reports what core::checkSession() found damaged, if anything.
void reportProblems(const QString& file, const core::SessionContents& contents);

} // namespace app
