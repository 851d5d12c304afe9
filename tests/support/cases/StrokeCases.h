// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/kinds/Edit.h"
#include "core/volume/Volume.h"

#include <QByteArray>

#include <vector>

namespace test {

/// One edit as a user makes it, after some earlier edits.
struct StrokeCase {
    QByteArray name;
    core::LoadedVolume volume;
    std::vector<core::Edit> before;
    core::Edit edit;
};

[[nodiscard]] std::vector<StrokeCase> strokeCases(int randomCount);

} // namespace test
