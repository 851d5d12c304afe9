// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QtGlobal>

namespace test {

/// Whether BURIN_LONG=1 is set: then tests use the counts that the issues name instead of moderate
/// ones.
[[nodiscard]] inline bool longRun()
{
    return qEnvironmentVariableIntValue("BURIN_LONG") > 0;
}

} // namespace test
