// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QtGlobal>

namespace test {

/// Whether BURIN_LONG is set to 1. Tests then use the counts that issues demand instead of moderate
/// ones.
[[nodiscard]] inline bool longRun()
{
    return qEnvironmentVariableIntValue("BURIN_LONG") > 0;
}

} // namespace test
