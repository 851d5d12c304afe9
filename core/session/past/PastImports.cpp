// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/PastImports.h"

namespace core {

std::vector<ImportMask> importsOf(const History& history)
{
    std::vector<ImportMask> imports;
    for (const RowId row : history.pathTo(history.position())) {
        const auto* mask = history.row(row).edit.as<ImportMask>();
        if (mask && mask->segments)
            imports.push_back(*mask);
    }
    return imports;
}

} // namespace core
