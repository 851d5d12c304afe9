// SPDX-License-Identifier: Apache-2.0
#include "core/session/past/PastImports.h"

#include "core/edits/document/DocumentEdits.h"
#include "core/edits/kinds/imports/ImportMask.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace core {

std::vector<RowId> importRows(const History& history)
{
    std::vector<RowId> rows = history.pathTo(history.position());
    std::erase_if(rows, [&](RowId row) {
        const auto* mask = history.row(row).edit.as<ImportMask>();
        return !mask || !mask->segments;
    });
    return rows;
}

std::vector<DoneImport> doneImports(const History& history)
{
    std::vector<DoneImport> imports;
    const std::vector<RowId> path = history.pathTo(history.position());
    const bool any = std::any_of(path.begin(), path.end(),
        [&](RowId row) { return history.row(row).edit.as<ImportMask>() != nullptr; });
    if (!any)
        return imports;
    // A new segment's label is that of its time: the rows tell it when they are counted again.
    Document then = initialDocument({});
    for (const RowId row : path) {
        const Edit& edit = history.row(row).edit;
        const auto* mask = edit.as<ImportMask>();
        if (mask && mask->segments) {
            if (const Result<ImportTargets> where = importTargets(*mask, then)) {
                DoneImport done{.edit = std::make_shared<const ImportMask>(*mask), .labels = {}};
                for (const LabelTarget& target : where->targets)
                    done.labels.push_back(target.label);
                imports.push_back(std::move(done));
            }
        }
        static_cast<void>(applyToDocument(edit, then));
    }
    return imports;
}

} // namespace core
